#include "tests/support/known_cuts/score.h"

#include <algorithm>
#include <cmath>

#include "tests/support/known_cuts/frequency_now.h"

namespace stillcut::bench {
namespace {

constexpr const char* kInCharge = "energy-ratio";
constexpr double kOthersLate = 0.15;
constexpr double kFrequencyBand = 0.005;
constexpr double kClear = 0.25;
constexpr double kStated = 2.0;  // standard deviations

struct Window {
  double from, to;
};

Window windowFor(const KnownCut& cut, const std::string& detector) {
  if (cut.rule == AlarmRule::Growth) return {cut.at1, detector == kInCharge ? cut.latest : cut.latest + kOthersLate};
  if (cut.rule == AlarmRule::Present) return {cut.at1 - 0.05, cut.at20 + 0.3};
  if (detector != kInCharge) return {cut.at1 - 0.05, cut.at20 + kOthersLate};
  switch (cut.rule) {
    case AlarmRule::Ramp:
      return {cut.at1, cut.at20 + 60.0 / cut.rpm};
    case AlarmRule::Weak:
      return {cut.at1 - 0.05, cut.at20 + kOthersLate};
    case AlarmRule::Slow:
      return {cut.at1, cut.at20 + 0.04};
    default:
      return {cut.at1 - 0.05, cut.at20 + 0.01};
  }
}

}  // namespace

Score score(const KnownCut& cut, const Trial& trial) {
  detect::testing::RunOptions options;
  options.teeth = cut.teeth;
  options.rpm = cut.rpm * (1.0 + trial.speedError);
  options.quantity = cut.quantity;
  options.channels = trial.channels;
  options.blockFrames = cut.blockFrames;
  if (!cut.machine.empty()) {
    options.machine = [&](double t) {
      const auto i = static_cast<std::size_t>(std::max(0.0, t / cut.machineStep - 0.5));
      MachineState m = cut.machine[std::min(i, cut.machine.size() - 1)];
      // What a machine reads back is ten times better than what a program says.
      m.actualSpeed = m.actualSpeed * (1.0 + 0.1 * trial.speedError);
      return m;
    };
  }
  const detect::testing::RunResult run = detect::testing::run(cut.recording, options, trial.detector);
  Score s;
  s.alarmed = run.firstAlarm >= 0.0;
  s.alarm = s.alarmed ? run.firstAlarm : kNever;
  if (cut.silentFrom > 0.0) s.falseAlarm = run.firstAlarmAfter(cut.silentFrom) >= 0.0;
  if (cut.rule == AlarmRule::Silent) {
    s.falseAlarm = s.falseAlarm || s.alarmed;
    return s;
  }
  s.missed = !s.alarmed;
  if (!s.alarmed) return s;
  Window window = windowFor(cut, trial.detector);
  window.to += cut.blockFrames / cut.recording.rate;  // a verdict speaks of a whole block
  s.after1 = s.alarm - cut.at1;
  s.after20 = s.alarm - cut.at20;
  s.before = std::any_of(cut.unstableBefore.begin(), cut.unstableBefore.end(),
                         [&](const auto& stretch) { return s.alarm >= stretch.first && s.alarm <= stretch.second; });
  if (s.before) return s;
  s.early = s.alarm < window.from;
  s.late = s.alarm > window.to;
  const Verdict& v = run.at(s.alarm + 0.05);
  s.kind = v.kind;
  s.kindWrong = v.kind != cut.kind;
  s.frequencyError =
      cut.chatterHz > 0.0 ? frequencyOffBy(cut, sinceEpoch(v.time), v.frequency, trial.channels) : kNever;
  // A sensor that cannot tell the chatter's line from its side lines has to say so.
  const double stated = cut.rule == AlarmRule::Weak ? kStated * v.frequencySd.value / cut.chatterHz : 0.0;
  s.frequencyOff = !(std::abs(s.frequencyError) <= std::max(kFrequencyBand, stated));
  if (cut.lastAbove > 0.0) {
    double last = 0.0;
    for (const Verdict& verdict : run.verdicts) {
      if (verdict.alarming()) last = sinceEpoch(verdict.time).value;
    }
    s.clearDelay = last - cut.lastAbove;
    s.clearLate = s.clearDelay > kClear;
  }
  return s;
}

}  // namespace stillcut::bench
