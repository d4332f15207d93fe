#include "core/spindle/speed_motion.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kRecentSeconds = 0.05;  // at least, and
constexpr double kRecentTurns = 2.0;
constexpr double kRide = 2e-3;    // from the mean of the recent past: faster than the phases can be followed
constexpr double kMoving = 1e-2;  // ... than turns can be compared
constexpr double kSwift = 4e-3;   // the same of the speed that is heard, which lags
constexpr double kArrived = 1e-3;
constexpr double kStands = 0.5 * kSwift / kRecentSeconds;  // a second: half of the slowest such change

double share(double seconds, double memory) noexcept {
  return 1.0 - std::exp(-seconds / memory);
}

}  // namespace

void SpeedMotion::reset(double told) noexcept {
  *this = {};
  retell(told);
}

bool SpeedMotion::followMachine(double told, double sd, double seconds) noexcept {
  // Teeth and chatter shake a slow spindle within its turn: there it is told by the mean over one.
  const double longer = 1.0 / told - kRecentSeconds;
  turning_ = longer > 0.0 ? turning_ + share(seconds, longer) * (told - turning_) : told;
  recent_ += share(seconds, std::max(kRecentSeconds, kRecentTurns / told)) * (told - recent_);
  const double away = std::abs(turning_ / recent_ - 1.0);
  const double doubt = sd / told;
  toldMoving_ = away > (toldMoving_ ? kArrived : kMoving) || doubt > kMoving;
  moving_ = toldMoving_;
  const bool rode = riding_;
  riding_ = away > (riding_ ? kArrived : kRide) || doubt > kRide;
  return rode && !riding_;
}

void SpeedMotion::followCombs(double change, double seconds) noexcept {
  stands_ = std::abs(change) < kStands * seconds;
}

// Of this moment only: what was heard while a lock settled is no change that the machine has begun and is to end.
void SpeedMotion::followSignal(double hertz, double drift, double seconds) noexcept {
  heard_ *= 1.0 + drift * seconds;
  heard_ += share(seconds, kRecentSeconds) * (hertz - heard_);
  moving_ = moving_ || std::abs(hertz / heard_ - 1.0) > kSwift;
}

}  // namespace stillcut::detect
