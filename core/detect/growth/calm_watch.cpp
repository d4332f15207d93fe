#include "core/detect/growth/calm_watch.h"

#include <algorithm>
#include <cmath>

#include "core/detect/growth/energy_growth.h"

namespace stillcut::detect {
namespace {

constexpr double kCalmTurns = 4.0;    // what is left of an alarm has not grown for this many turns ...
constexpr double kCalmSeconds = 0.1;  // ... and so long, where the speed has changed since,
constexpr double kLongCalm = 0.15;    // ... and so long, where it has not
constexpr double kLittle = 2.5e-3;    // 5 % of the amplitude
constexpr double kCalmGrowth = 3.0;   // in energy: more is growth, not scatter of noise

}  // namespace

void CalmWatch::reset() {
  floorGone_ = false;
  seconds_ = level_ = 0.0;
}

void CalmWatch::watch(double changed, bool quiet, double seconds) {
  slow_ += (1.0 - std::exp(-1.0 / (kCalmTurns * kHopsPerTurn))) * (changed - slow_);
  const bool little = quiet && (floorGone_ || changed < kLittle);
  if (!(seconds > 0.0) || !little || slow_ > kCalmGrowth * level_) {
    seconds_ = 0.0;
    level_ = slow_;
    return;
  }
  seconds_ += seconds;
  level_ = std::min(level_, slow_);
}

bool CalmWatch::calm(Hertz spindle) const {
  return seconds_ > std::max(floorGone_ ? kCalmSeconds : kLongCalm, kCalmTurns / spindle.value);
}

}  // namespace stillcut::detect
