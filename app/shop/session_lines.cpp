#include "app/shop/session_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "core/base/conversions.h"
#include "core/model/judged_cut.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_rows.h"
#include "core/session/file/session_table.h"
#include "core/storage/hdf5_file.h"
#include "core/storage/journal.h"

namespace stillcut::shop {
namespace {

using nlohmann::json;
using namespace record;

std::string text(std::span<const char> field) {
  return {field.data(), ::strnlen(field.data(), field.size())};
}
json positive(double value) {
  return value > 0.0 && std::isfinite(value) ? json(value) : json();
}
std::string hashOf(const std::string& words) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : words) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

// Beside a writer as well as of a file that was closed. No lock is left behind: the file is closed after every look.
Hdf5Id openToRead(const std::string& path) {
  quietHdf5();
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS));
  const hbool_t yes = 1;
  H5Pset(access.get(), "skip_eof_check", &yes);
  H5Pset_metadata_read_attempts(access.get(), 4);
  for (const unsigned mode : {H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, H5F_ACC_RDONLY}) {
    Hdf5Id file(H5Fopen(path.c_str(), mode, access.get()));
    if (file) return file;
  }
  return Hdf5Id();
}

// When it began, ns since 1970 UTC; 0: it is no session.
std::int64_t beginOf(const std::string& path) {
  const Hdf5Id file = openToRead(path);
  if (!file || readText(file.get(), "format") != kSessionFormat) return 0;
  return readInteger(file.get(), "started_utc_ns").value_or(0);
}

}  // namespace

// Sessions below the folder, by when they began. Not by when they were changed: a marker set in an old one does not
// make it newer than the one that is being recorded.
std::vector<SessionLines::Known> SessionLines::look() {
  std::map<std::string, Known> now;
  std::error_code ignored;
  for (auto entry = std::filesystem::recursive_directory_iterator(folder_, ignored);
       entry != std::filesystem::recursive_directory_iterator(); entry.increment(ignored)) {
    if (entry->path().extension() != ".h5" || !entry->is_regular_file(ignored)) continue;
    const std::string path = entry->path().string();
    const auto changed = entry->last_write_time(ignored);
    const auto before = known_.find(path);
    // When it began does not change; what was none may have become one.
    const bool read = before != known_.end() && (before->second.began_ns > 0 || before->second.changed == changed);
    now[path] = {read ? before->second.began_ns : beginOf(path), changed, path};
  }
  known_ = std::move(now);
  std::vector<Known> all;
  for (const auto& [path, known] : known_) {
    if (known.began_ns > 0) all.push_back(known);
  }
  std::sort(all.begin(), all.end(), [](const Known& a, const Known& b) {
    return std::tie(a.began_ns, a.changed, a.path) < std::tie(b.began_ns, b.changed, b.path);
  });
  return all;
}

// How far one session was told; the whole of it is the cursor.
struct SessionLines::Place {
  std::string file;
  std::uint64_t steps = 0, verdicts = 0, events = 0, markers = 0, lines = 0;
  std::int64_t startedUtcMs = 0, firstNs = 0, lastNs = 0, saidUtcMs = 0;
  double inCut = 0.0, judged = 0.0, chatter = 0.0, chatterMm = 0.0;
  std::string state{};  // of the step before
  bool cut = false;     // the tool was in the material then
  bool over = false;    // its end was told

  json asJson() const {
    return {{"file", file},       {"steps", steps},    {"verdicts", verdicts},    {"events", events},
            {"markers", markers}, {"lines", lines},    {"started", startedUtcMs}, {"first", firstNs},
            {"last", lastNs},     {"said", saidUtcMs}, {"in_cut", inCut},         {"judged", judged},
            {"chatter", chatter}, {"mm", chatterMm},   {"state", state},          {"cut", cut},
            {"over", over}};
  }
  static Place from(const std::string& words) {
    Place p;
    const json j = json::parse(words, nullptr, false);
    if (!j.is_object()) return p;
    p.file = j.value("file", "");
    p.state = j.value("state", "");
    p.cut = j.value("cut", false);
    p.over = j.value("over", false);
    const auto whole = [&j](const char* key, auto& to) {
      to = static_cast<std::remove_reference_t<decltype(to)>>(j.value(key, std::int64_t{0}));
    };
    whole("steps", p.steps);
    whole("verdicts", p.verdicts);
    whole("events", p.events);
    whole("markers", p.markers);
    whole("lines", p.lines);
    whole("started", p.startedUtcMs);
    whole("first", p.firstNs);
    whole("last", p.lastNs);
    whole("said", p.saidUtcMs);
    const auto number = [&j](const char* key, double& to) { to = j.value(key, 0.0); };
    number("in_cut", p.inCut);
    number("judged", p.judged);
    number("chatter", p.chatter);
    number("mm", p.chatterMm);
    return p;
  }
  std::int64_t utcMs(std::int64_t ns) const { return startedUtcMs + (ns - firstNs) / 1'000'000; }
  double since(std::int64_t ns) const { return 1e-9 * static_cast<double>(ns - firstNs); }
};

// One look at the open file.
struct SessionLines::Reading {
  Hdf5Id file;
  TableReader<BlockRow> blocks;
  TableReader<MachineRow> machine;
  TableReader<DecisionRow> decisions;
  TableReader<VerdictRow> verdicts;
  TableReader<EventRow> events;
  TableReader<MarkerRow> markers;
  ReasonCodes reasons{""};
  bool damaged = false;

  bool open(const std::string& path) {
    file = openToRead(path);
    if (!file || readText(file.get(), "format") != kSessionFormat) return false;
    reasons = ReasonCodes(readText(file.get(), "reason_codes").value_or(""));
    const hid_t f = file.get();
    // The blocks first: whoever sees a block finds everything that belongs to it.
    return blocks.open(f, kBlocksPath) && machine.open(f, kMachinePath) && decisions.open(f, kDecisionsPath) &&
           verdicts.open(f, kVerdictsPath) && events.open(f, kEventsPath) && markers.open(f, kMarkersPath);
  }
  Reason reason(const ReasonRow& row) const { return {reasons.fromFile(static_cast<ReasonCode>(row.code)), row.n}; }

  json line(Place& p, const char* type, std::int64_t utcMs, json t) const {
    return {{"schema", "stillcut-cli/1"}, {"command", "run"}, {"type", type},
            {"sequence", ++p.lines},      {"utc_ms", utcMs},  {"t", std::move(t)}};
  }
  json start(Place& p) const {
    const Hdf5Id setup(H5Gopen2(file.get(), "setup", H5P_DEFAULT));
    const auto words = [](hid_t object, const char* name) {
      const std::string value = readText(object, name).value_or("");
      return value.empty() ? json() : json(value);
    };
    json l = line(p, "start", p.startedUtcMs, json());
    l["version"] = words(file.get(), "program_version");
    l["profile_hash"] = hashOf(readText(file.get(), "configuration").value_or(""));
    l["operator"] = words(file.get(), "operator");
    l["job"] = words(file.get(), "job");
    l["machine_name"] = words(setup.get(), "machine");
    l["tool"] = words(setup.get(), "tool");
    l["teeth"] = readInteger(setup.get(), "teeth").value_or(0);
    l["rate_hz"] = readNumber(setup.get(), "rate_hz").value_or(0.0);
    l["live"] = readInteger(file.get(), "simulated").value_or(0) == 0;
    l["channels"] = json::array();
    for (std::int64_t c = 0; c < readInteger(setup.get(), "channels").value_or(0); ++c) {
      const Hdf5Id samples(H5Dopen2(file.get(), samplesPath(static_cast<int>(c)).c_str(), H5P_DEFAULT));
      l["channels"].push_back({{"name", words(samples.get(), "name")},
                               {"quantity", words(samples.get(), "quantity")},
                               {"unit", words(samples.get(), "unit")},
                               {"axis", words(samples.get(), "axis")},
                               {"place", words(samples.get(), "place")}});
    }
    return l;
  }
  // The verdict of the detector in charge at this step.
  const VerdictRow* verdictOf(Place& p, int inCharge) {
    const VerdictRow* found = nullptr;
    for (; const VerdictRow* row = verdicts.at(p.verdicts, damaged); ++p.verdicts) {
      if (row->step > p.steps) break;
      if (row->step == p.steps && row->detector == inCharge) held_ = *row, found = &held_;
    }
    return found;
  }
  VerdictRow held_;
};

namespace {

json machineJson(const MachineRow& m, std::int64_t now_ns) {
  return {{"link_up", m.linkUp != 0},
          {"valid", m.valid != 0},
          {"program_running", m.programRunning != 0},
          {"feed_hold", m.feedHold != 0},
          {"programmed_rpm", m.programmedSpeed},
          {"actual_rpm", m.actualSpeed},
          {"programmed_feed_mm_min", 6e4 * m.programmedFeed},
          {"actual_feed_mm_min", 6e4 * m.actualFeed},
          {"operator_speed_percent", 100.0 * m.operatorSpeed},
          {"operator_feed_percent", 100.0 * m.operatorFeed},
          {"speed_override_percent", 100.0 * m.speedOverride},
          {"feed_override_percent", 100.0 * m.feedOverride},
          {"age_s", m.time > 0 ? json(1e-9 * static_cast<double>(now_ns - m.time)) : json()}};
}

// What decides whether the row's state may be shown.
Verdict verdictIn(const VerdictRow& row, const Reason& reason) {
  Verdict v;
  v.state = static_cast<CutState>(std::min<int>(row.state, 3));
  v.phase = static_cast<CutPhase>(std::min<int>(row.phase, 4));
  v.valid = row.valid != 0;
  v.reason = reason;
  v.spindle = Hertz(row.spindle);
  return v;
}

std::string shown(const Verdict& v) {
  return hasState(v) ? std::string(name(v.state)) : "not-judged";
}

void addVerdict(json& l, const VerdictRow& v, const Verdict& verdict) {
  const bool judged = hasState(verdict);
  const Reason reason = judged ? verdict.reason : whyNotJudged(verdict);
  const bool none = reason.code == ReasonCode::None;
  l["state"] = shown(verdict);
  l["phase"] = std::string(name(verdict.phase));
  l["valid"] = judged;
  l["reason"] = none ? json() : json(std::string(identifier(reason.code)));
  l["sentence"] = none ? json() : json(sentence(reason));
  l["frequency_hz"] = positive(v.frequency);
  l["frequency_sd_hz"] = v.frequency > 0.0 ? positive(v.frequencySd) : json();
  l["kind"] = std::string(name(static_cast<ChatterKind>(std::min<int>(v.kind, 3))));
  l["early_warning"] = v.earlyWarning != 0;
  l["energy_ratio"] = judged && std::isfinite(v.severity) ? json(v.severity) : json();
  l["speed_rpm"] = positive(60.0 * v.spindle);
}

// What one look tells, each line with the place after it.
class Teller {
 public:
  Teller(std::vector<SourceLine>& lines, std::size_t atMost) : lines_(lines), atMost_(atMost) {}
  bool room() const { return lines_.size() < atMost_; }
  void tell(const json& line, const json& after) {
    lines_.push_back({line.dump(-1, ' ', false, json::error_handler_t::replace), after.dump()});
  }

 private:
  std::vector<SourceLine>& lines_;
  std::size_t atMost_;
};

template <class Place>
void reckon(Place& p, std::int64_t now_ns, const MachineRow& machine) {
  const double passed = std::max(0.0, 1e-9 * static_cast<double>(now_ns - p.lastNs));
  p.lastNs = std::max(p.lastNs, now_ns);
  if (p.cut) p.inCut += passed;
  if (p.state == "stable" || p.state == "onset" || p.state == "chatter") p.judged += passed;
  if (p.state != "chatter") return;
  p.chatter += passed;
  p.chatterMm += passed * 1e3 * machine.actualFeed;
}

template <class Reading, class Place>
void tellEvents(Reading& reading, Place& p, Teller& teller) {
  constexpr std::array<const char*, 3> kLevels{"info", "warning", "fault"};
  for (const EventRow* e = reading.events.at(p.events, reading.damaged); e != nullptr && e->step <= p.steps;
       e = reading.events.at(p.events, reading.damaged)) {
    const Reason reason = reading.reason(e->reason);
    json l = reading.line(p, "event", p.utcMs(e->time), p.since(e->time));
    l["number"] = e->number;
    l["level"] = kLevels[std::min<std::size_t>(e->level, 2)];
    l["reason"] = std::string(identifier(reason.code));
    l["sentence"] = sentence(reason);
    l["values"] = reason.n;
    ++p.events;
    teller.tell(l, p.asJson());
  }
}

// One step; false: there is no further one yet.
template <class Reading, class Place>
bool tellStep(Reading& reading, Place& p, Teller& teller) {
  const BlockRow* block = reading.blocks.at(p.steps, reading.damaged);
  const DecisionRow* decision = reading.decisions.at(p.steps, reading.damaged);
  const MachineRow* machine = reading.machine.at(p.steps, reading.damaged);
  if (block == nullptr || decision == nullptr || machine == nullptr) return false;
  tellEvents(reading, p, teller);
  const VerdictRow* v = reading.verdictOf(p, decision->inCharge);
  const std::int64_t now_ns = decision->time != 0 ? decision->time : block->firstSample;
  reckon(p, now_ns, *machine);
  ++p.steps;
  if (v == nullptr) return true;
  const std::int64_t utcMs = p.utcMs(now_ns);
  const Verdict verdict = verdictIn(*v, reading.reason(v->reason));
  const std::string state = shown(verdict);
  const bool changed = state != std::exchange(p.state, state);
  p.cut = inCut(verdict);
  // A whole session has a step a block: a state at once, a status once a second.
  if (!changed && utcMs - p.saidUtcMs < 950) return true;
  if (!changed) p.saidUtcMs = utcMs;
  json l = reading.line(p, changed ? "change" : "status", utcMs, p.since(now_ns));
  addVerdict(l, *v, verdict);
  l["mode"] = std::string(name(static_cast<Authority>(std::min<int>(decision->authority, 2))));
  l["machine"] = machine->valid != 0 ? machineJson(*machine, now_ns) : json();
  l["in_cut_s"] = p.inCut;
  l["judged_s"] = p.judged;
  l["chatter_s"] = p.chatter;
  l["chatter_mm"] = p.chatterMm;
  l["blocks"] = block->sequence + 1;
  l["lost_frames"] = block->lostFrames;
  teller.tell(l, p.asJson());
  return true;
}

template <class Reading, class Place>
void tellMarkers(Reading& reading, Place& p, Teller& teller) {
  while (teller.room()) {
    const MarkerRow* m = reading.markers.at(p.markers, reading.damaged);
    if (m == nullptr) return;
    json l = reading.line(p, "marker", m->made / 1'000'000, p.since(m->begin));
    l["number"] = m->number;
    l["label"] = text(m->label);
    l["author"] = text(m->author);
    l["note"] = text(m->note);
    l["begin_utc_ms"] = p.utcMs(m->begin);
    l["end_utc_ms"] = p.utcMs(m->end);
    l["removed"] = m->removed != 0;
    ++p.markers;
    teller.tell(l, p.asJson());
  }
}

}  // namespace

SessionLines::SessionLines(std::string folder, const std::string& cursor)
    : folder_(std::move(folder)), place_(std::make_unique<Place>(Place::from(cursor))) {}
SessionLines::~SessionLines() = default;

bool SessionLines::atEnd() const {
  return place_->over;
}

Result<std::vector<SourceLine>> SessionLines::read(std::size_t atMost) {
  std::vector<SourceLine> lines;
  Teller teller(lines, atMost);
  Place& p = *place_;
  const std::vector<Known> all = look();
  if (all.empty()) return lines;
  const auto here = std::find_if(all.begin(), all.end(), [&p](const Known& known) { return known.path == p.file; });
  if (here == all.end()) p = Place{.file = all.back().path};
  const auto goOn = [&] {  // to the first that began after this one
    if (here != all.end() && std::next(here) != all.end()) p = Place{.file = std::next(here)->path};
  };
  std::error_code ignored;
  const bool written = std::filesystem::exists(journalPath(p.file), ignored);  // asked before the look
  Reading reading;
  if (!reading.open(p.file)) return lines;  // not yet whole: looked at again
  if (p.lines == 0) {
    const BlockRow* first = reading.blocks.at(0, reading.damaged);
    if (first == nullptr) {
      goOn();
      return lines;
    }
    p.startedUtcMs = readInteger(reading.file.get(), "started_utc_ns").value_or(0) / 1'000'000;
    p.firstNs = p.lastNs = first->firstSample;
    const json l = reading.start(p);
    teller.tell(l, p.asJson());
  }
  while (teller.room() && tellStep(reading, p, teller)) {
  }
  tellMarkers(reading, p, teller);
  if (!lines.empty()) return lines;
  if (!written && !std::exchange(p.over, true)) {
    json l = reading.line(p, "end", p.utcMs(p.lastNs), p.since(p.lastNs));
    l["sentence"] = "the recording has ended";
    l["length_s"] = p.since(p.lastNs);
    l["in_cut_s"] = p.inCut;
    l["judged_s"] = p.judged;
    l["chatter_s"] = p.chatter;
    teller.tell(l, p.asJson());
  } else {
    goOn();
  }
  return lines;
}

}  // namespace stillcut::shop
