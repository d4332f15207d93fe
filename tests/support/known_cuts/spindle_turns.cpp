#include "tests/support/known_cuts/spindle_turns.h"

#include <algorithm>

namespace stillcut::bench {

double rpmAt(const KnownCut& cut, double time) {
  if (cut.spindleRpm.empty()) return cut.rpm;
  const auto i = static_cast<std::size_t>(std::max(0.0, time / cut.machineStep));
  return cut.spindleRpm[std::min(i, cut.spindleRpm.size() - 1)];
}

std::vector<double> turnsOf(const KnownCut& cut, std::size_t frames) {
  std::vector<double> turns(frames);
  double sum = 0.0;
  for (std::size_t i = 0; i < frames; ++i) {
    turns[i] = sum;
    sum += rpmAt(cut, static_cast<double>(i) / cut.recording.rate) / (60.0 * cut.recording.rate);
  }
  return turns;
}

}  // namespace stillcut::bench
