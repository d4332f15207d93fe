#include "core/evaluate/recorded_truth.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/session/file/session_markers.h"
#include "core/session/file/session_reader.h"
#include "core/session/open_recording.h"

namespace stillcut::evaluate {
namespace {

namespace fs = std::filesystem;

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
constexpr double kAlways = std::numeric_limits<double>::infinity();

// The cells of a line of CSV, quotes dropped.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

std::optional<double> numberFrom(const std::string& text) {
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

using Row = std::map<std::string, std::string>;
using Take = std::function<Status(const Row&, const std::string& where)>;

Status readTable(const std::string& path, const std::string& needed, const Take& take) {
  std::ifstream in(path);
  if (!in) return Error{path, message("cannot be opened")};
  std::string line;
  std::getline(in, line);
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  const std::vector<std::string> header = cellsOf(line);
  if (std::find(header.begin(), header.end(), needed) == header.end()) {
    return Error{path + ":1", message("has no column '%1'", needed), message("names parted by commas were expected")};
  }
  for (int number = 2; std::getline(in, line); ++number) {
    if (line.empty() || line == "\r") continue;
    const std::vector<std::string> cells = cellsOf(line);
    Row row;
    for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = i < cells.size() ? cells[i] : "";
    if (Status s = take(row, path + ":" + std::to_string(number)); !s) return s;
  }
  return Done{};
}

// The one speed that all rows of a recording tell; a speed that changes is left to the signal.
Rpm onlySpeed(const std::set<std::string>& programmed_rpm, const std::set<std::string>& measured_Hz) {
  if (programmed_rpm.size() == 1) return Rpm(numberFrom(*programmed_rpm.begin()).value_or(0.0));
  if (programmed_rpm.empty() && measured_Hz.size() == 1)
    return toRpm(Hertz(numberFrom(*measured_Hz.begin()).value_or(0.0)));
  return Rpm();
}

Result<std::optional<RecordedTruth>> fromTable(const fs::path& recording, const std::string& table) {
  RecordedTruth truth;
  truth.from = table;
  std::set<std::string> programmed, measured;
  const Status read = readTable(table, "file", [&](const Row& row, const std::string& where) -> Status {
    const auto cell = [&row](const char* name) {
      const auto found = row.find(name);
      return found == row.end() ? std::string() : found->second;
    };
    if (cell("file") != recording.filename().string()) return Done{};
    const auto begin = numberFrom(cell("t0_s"));
    const auto end = numberFrom(cell("t1_s"));
    if (!begin || !end || !(*begin < *end))
      return Error{where, message("t0_s and t1_s must be times, one after the other")};
    truth.spans.push_back({Seconds(*begin), Seconds(*end), kindOf(cell("label")), cell("label")});
    if (const auto teeth = numberFrom(cell("teeth")); teeth && truth.teeth == 0) truth.teeth = static_cast<int>(*teeth);
    if (!cell("programmed_rpm").empty()) programmed.insert(cell("programmed_rpm"));
    if (!cell("measured_spindle_hz").empty()) measured.insert(cell("measured_spindle_hz"));
    return Done{};
  });
  if (!read) return read.error();
  if (truth.spans.empty()) return std::optional<RecordedTruth>();
  truth.speed = onlySpeed(programmed, measured);
  return std::optional(std::move(truth));
}

// NAME_acc.wav -> NAME; empty: no case's recording.
std::string caseName(const fs::path& recording) {
  const std::string stem = recording.stem().string();
  for (const char* ending : {"_acc", "_disp"}) {
    if (stem.ends_with(ending)) return (recording.parent_path() / stem.substr(0, stem.rfind('_'))).string();
  }
  return {};
}

Result<std::optional<RecordedTruth>> fromCase(const fs::path& recording, const std::string& name) {
  RecordedTruth truth;
  truth.from = name + "_truth.csv";
  std::vector<Seconds> times;
  std::vector<double> ratios;
  const Status read = readTable(truth.from, "t_s", [&](const Row& row, const std::string& where) -> Status {
    const auto time = row.find("t_s");
    const auto ratio = row.find("ratio_chatter_to_forced");
    if (time == row.end() || ratio == row.end() || !numberFrom(time->second) || !numberFrom(ratio->second)) {
      return Error{where, message("needs the numbers t_s and ratio_chatter_to_forced")};
    }
    times.emplace_back(*numberFrom(time->second));
    ratios.push_back(*numberFrom(ratio->second));
    return Done{};
  });
  if (!read) return read.error();
  std::ifstream in(name + ".json");
  const nlohmann::json about = nlohmann::json::parse(in, nullptr, false);
  if (!about.is_object())
    return Error{name + ".json", message("is missing or no object in JSON"), message("it says teeth and speed")};
  const auto number = [&about](const char* key) {
    const auto found = about.find(key);
    return found != about.end() && found->is_number() ? found->get<double>() : kNever;
  };
  // Nobody controlled it, and its ratio knows no growth: without an onset all of it was quiet.
  const double slight = number("onset_1pct_s");
  const Onsets onsets{Seconds(std::isnan(slight) ? kAlways : slight), Seconds(number("onset_20pct_s"))};
  truth.spans = spansOfRatio(times, ratios, onsets);
  if (const double hz = number("chatter_hz_at_onset"); hz > 0.0) truth.chatter = Hertz(hz);
  if (const double teeth = number("teeth"); teeth >= 1.0) truth.teeth = static_cast<int>(teeth);
  if (const double speed = number("spindle_rpm"); speed > 0.0) truth.speed = Rpm(speed);
  const bool displacement = recording.stem().string().ends_with("_disp");
  truth.quantity = displacement ? SensorQuantity::Displacement : SensorQuantity::Acceleration;
  constexpr double kMicrometre = 1e-6;
  truth.scale = displacement ? kMicrometre : 1.0;
  return std::optional(std::move(truth));
}

// What the detector in charge said then.
Result<std::vector<Alarm>> recordedAlarms(const std::string& path) {
  auto reader = record::openRecording(path);
  if (!reader) return reader.error();
  const record::RecordingFormat& format = (*reader)->format();
  SampleBlock block;
  block.allocate(static_cast<int>(format.channels.size()), format.blockFrames);
  AlarmList list;
  std::optional<Instant> begin;
  while (true) {
    const Result<bool> more = (*reader)->read(block);
    if (!more) return more.error();
    if (!*more) return list.alarms();
    if (!begin) begin = block.firstSample;
    const StepOutput& output = (*reader)->recordedStep()->output;
    if (output.inCharge < 0 || output.inCharge >= output.verdictCount) continue;
    const Verdict& verdict = output.verdicts[static_cast<std::size_t>(output.inCharge)];
    list.observe(secondsBetween(*begin, verdict.time), verdict);
  }
}

Result<std::optional<RecordedTruth>> fromSession(const std::string& path) {
  const auto counts = record::countSession(path);
  if (!counts) return counts.error();
  const auto series = record::readTruthSeries(path);
  if (!series) return series.error();
  RecordedTruth truth;
  truth.from = path;
  const Instant begin = counts.value().begin;
  if (!counts.value().markers.empty()) {
    const auto alarms = recordedAlarms(path);
    if (!alarms) return alarms.error();
    truth.spans = spansOfMarkers(counts.value().markers, begin, alarms.value());
  }
  std::vector<Seconds> times;
  std::vector<double> ratios;
  for (const record::RecordedTruthSample& sample : series.value()) {
    if (sample.name != "chatter_counted") continue;
    times.push_back(secondsBetween(begin, sample.time));
    ratios.push_back(sample.value);
  }
  const auto known = [&counts](const std::string& name) {
    std::optional<double> found;
    for (const auto& [key, value] : counts.value().truthValues) {
      if (key == name) found = value;
    }
    return found;
  };
  // Notes and entries say nothing about chatter. A simulation that was killed had not yet said when it began.
  const bool judged = std::any_of(truth.spans.begin(), truth.spans.end(),
                                  [](const TruthSpan& s) { return s.kind != SpanKind::Ignored; });
  const auto slight = known("onset_1pct_s");
  const auto clear = known("onset_20pct_s");
  if (!judged && slight && clear) truth.spans = spansOfRatio(times, ratios, {Seconds(*slight), Seconds(*clear)});
  if (truth.spans.empty()) return std::optional<RecordedTruth>();
  if (const double hz = known("chatter_hz").value_or(0.0); hz > 0.0) truth.chatter = Hertz(hz);
  return std::optional(std::move(truth));
}

}  // namespace

std::vector<TruthSpan> spansOfRatio(const std::vector<Seconds>& times, const std::vector<double>& ratios,
                                    const Onsets& onsets) {
  constexpr double kChatter = 0.1;
  constexpr double kQuiet = 0.01;
  constexpr Seconds kBeat{0.25};  // a pause of the same chatter
  std::vector<TruthSpan> spans;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool before = times[i] < onsets.slight;
    const bool chatter = times[i] >= onsets.clear && ratios[i] > kChatter;
    const bool grew = std::isnan(onsets.slight.value) && ratios[i] >= kQuiet;
    TruthSpan span{times[i], times[i], SpanKind::Quiet, "stable"};
    if (chatter) {
      span.kind = SpanKind::Chatter;
      span.label = "chatter";
    } else if (grew) {
      span.kind = SpanKind::Grew;
      span.label = "growth";
    } else if (!before && ratios[i] >= kQuiet) {
      continue;
    }
    const bool goesOn = !spans.empty() && spans.back().kind == span.kind && times[i] - spans.back().end <= kBeat;
    if (!goesOn) spans.push_back(span);
    spans.back().end = times[i];
  }
  std::erase_if(spans, [](const TruthSpan& s) { return s.end <= s.begin; });
  return spans;
}

std::vector<TruthSpan> spansOfMarkers(const std::vector<Marker>& markers, Instant begin,
                                      const std::vector<Alarm>& alarms) {
  constexpr Seconds kHeard{1.0};  // reaction time of the operator
  std::vector<TruthSpan> spans;
  for (const Marker& marker : markers) {
    const Seconds from = secondsBetween(begin, marker.begin);
    const Seconds to = secondsBetween(begin, marker.end);
    const SpanKind kind = kindOf(marker.label);
    if (to > from) {
      spans.push_back({from, to, kind, marker.label});
    } else if (marker.label == kLabelOperatorChatter) {
      spans.push_back({std::max(Seconds(), from - kHeard), from, kind, marker.label, true});
    } else if (marker.label == kLabelTrueAlarm || marker.label == kLabelFalseAlarm) {
      const auto after = std::find_if(alarms.begin(), alarms.end(), [from](const Alarm& a) { return a.begin > from; });
      if (after == alarms.begin()) continue;
      const Alarm& meant = *std::prev(after);
      spans.push_back({meant.begin, std::max(meant.end, meant.begin + Seconds(1e-3)), kind, marker.label, true});
    }
  }
  return spans;
}

Result<std::optional<RecordedTruth>> truthIn(const std::string& recording) {
  if (!record::isHdf5File(recording)) return std::optional<RecordedTruth>();
  const auto reader = record::openRecording(recording);
  if (!reader) return reader.error();
  if (!(*reader)->format().setup) return std::optional<RecordedTruth>();
  return fromSession(recording);
}

Result<std::optional<RecordedTruth>> truthOf(const std::string& recording) {
  auto inside = truthIn(recording);
  if (!inside || *inside) return inside;
  const fs::path path(recording);
  std::error_code ignored;
  const std::string table = (path.parent_path() / "TRUTH.csv").string();
  if (fs::exists(table, ignored)) {
    auto found = fromTable(path, table);
    if (!found || *found) return found;
  }
  const std::string name = caseName(path);
  if (!name.empty() && fs::exists(name + "_truth.csv", ignored)) return fromCase(path, name);
  return std::optional<RecordedTruth>();
}

}  // namespace stillcut::evaluate
