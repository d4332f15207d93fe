// bench_real_cuts [--each] [DETECTOR ...]: every shared real recording, every detector (or those named), told speed
// exact, 2 % low, 2 % high and not at all. Per line: delay of the first alarm in the chatter segment, part of it that
// is in alarm and in full chatter, alarm outside of it [s] and where the first one began. --each: every channel alone
// as well.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/detect/conditioner.h"
#include "core/detect/registry.h"
#include "core/record/open_recording.h"
#include "tests/bench/real_cuts.h"

namespace stillcut::bench {
namespace {

constexpr double kBlockSeconds = 0.005;
constexpr double kErrors[] = {0.0, -0.02, 0.02, -1.0};  // of the told speed; -1: not told

struct Tally {
  std::unique_ptr<detect::Detector> detector;
  std::string id;
  double delay = -1.0;  // s; -1: no alarm
  double alarm = 0.0, chatter = 0.0;
  double falseAlarm = 0.0, firstFalse = -1.0;
  double invalid = 0.0;
};

std::vector<Tally> tallies(const std::vector<std::string>& wanted, const CutSetup& setup) {
  config::ParamCatalog catalog;
  catalog.add(detect::conditionerParams());
  std::vector<Tally> all;
  for (const detect::DetectorRow& row : detect::detectorTable()) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), row.id) == wanted.end()) continue;
    Tally t;
    t.detector = row.make();
    t.id = row.id;
    t.detector->prepare(setup, {});
    all.push_back(std::move(t));
  }
  return all;
}

void count(Tally& t, const Verdict& v, const RealCut& cut, double time, double length) {
  const TruthSegment* inside = nullptr;
  for (const TruthSegment& s : cut.segments) {
    if (time >= s.from && time <= s.to) inside = &s;
  }
  if (!v.valid) t.invalid += length;
  if (inside != nullptr && inside->chatter()) {
    if (!v.alarming()) return;
    if (t.delay < 0.0) t.delay = time - inside->from;
    t.alarm += length;
    if (v.state == CutState::Chatter) t.chatter += length;
    return;
  }
  // What is not labelled beside a chatter segment is neither: it begins and ends somewhere there.
  const bool beside = std::any_of(cut.segments.begin(), cut.segments.end(), [&](const TruthSegment& s) {
    return s.chatter() && time > s.from - 0.5 && time < s.to + 0.6;
  });
  if (!v.alarming() || (inside == nullptr && beside)) return;
  t.falseAlarm += length;
  if (t.firstFalse < 0.0) t.firstFalse = time;
}

double chatterLength(const RealCut& cut) {
  double sum = 0.0;
  for (const TruthSegment& s : cut.segments) sum += s.chatter() ? s.to - s.from : 0.0;
  return sum;
}

void print(const RealCut& cut, const std::vector<int>& channels, double error, const std::vector<Tally>& all) {
  char told[16];
  std::snprintf(told, sizeof told, error <= -1.0 ? "none" : "%+.0f %%", 100.0 * error);
  std::string which;
  for (const int c : channels) which += std::to_string(c);
  for (const Tally& t : all) {
    std::printf("%-38.38s %-5s %4s %-12s", cut.file.filename().c_str(), which.empty() ? "all" : which.c_str(), told,
                t.id.c_str());
    const double length = chatterLength(cut);
    if (length > 0.0 && t.delay >= 0.0) {
      std::printf(" delay %5.2f s, alarm %5.1f %%, chatter %5.1f %%", t.delay, 100.0 * t.alarm / length,
                  100.0 * t.chatter / length);
    } else if (length > 0.0) {
      std::printf(" missed                                     ");
    }
    if (t.falseAlarm > 0.0) std::printf("  FALSE %.2f s from %.2f s", t.falseAlarm, t.firstFalse);
    if (t.invalid > 0.0) std::printf("  invalid %.2f s", t.invalid);
    std::printf("\n");
  }
  std::fflush(stdout);
}

bool judge(const RealCut& cut, const std::vector<int>& channels, double error, const std::vector<std::string>& wanted) {
  record::ReadOptions options;
  options.quantity = cut.quantity;
  options.channels = channels;
  if (cut.rate > 0.0) options.rate = Hertz(cut.rate);
  auto reader = record::openRecording(cut.file.string(), options);
  if (!reader) {
    std::fprintf(stderr, "%s\n", reader.error().line().c_str());
    return false;
  }
  const record::RecordingFormat& format = (*reader)->format();
  CutSetup setup;
  setup.teeth = cut.teeth;
  setup.nominalSpeed = Rpm(error <= -1.0 ? 0.0 : cut.rpm * (1.0 + error));
  setup.rate = format.rate;
  setup.blockFrames = std::max(1, static_cast<int>(format.rate.value * kBlockSeconds));
  for (const record::RecordedChannel& c : format.channels) setup.channels.push_back(c.info);
  detect::Conditioner conditioner;
  conditioner.prepare(setup, {});
  std::vector<Tally> all = tallies(wanted, setup);
  SampleBlock block;
  block.allocate(static_cast<int>(setup.channels.size()), setup.blockFrames);
  for (;;) {
    const Result<bool> more = (*reader)->read(block);
    if (!more || !*more) break;
    const detect::ConditionedBlock& conditioned = conditioner.process(block, {});
    const double time = sinceEpoch(block.end()).value;
    for (Tally& t : all) count(t, t.detector->process(conditioned), cut, time, block.frames / setup.rate.value);
  }
  print(cut, channels, error, all);
  return true;
}

int table(const std::vector<std::string>& wanted, bool each) {
  const std::vector<RealCut> cuts = realCuts(std::filesystem::path(STILLCUT_SHARED_DIR) / "recordings");
  if (cuts.empty()) {
    std::printf("no recordings at %s\n", STILLCUT_SHARED_DIR);
    return 0;
  }
  for (const RealCut& cut : cuts) {
    std::vector<std::vector<int>> sets{cut.channels};
    if (each && cut.channels.empty() && cut.file.filename() != "audio_T2503") sets.insert(sets.end(), {{0}, {1}, {2}});
    for (const auto& channels : sets) {
      for (const double error : kErrors) {
        if (!judge(cut, channels, error, wanted)) return 1;
      }
    }
  }
  return 0;
}

}  // namespace
}  // namespace stillcut::bench

int main(int argc, char** argv) {
  std::vector<std::string> wanted(argv + 1, argv + argc);
  const bool each = std::erase(wanted, "--each") > 0;
  return stillcut::bench::table(wanted, each);
}
