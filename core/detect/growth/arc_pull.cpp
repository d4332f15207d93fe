#include "core/detect/growth/arc_pull.h"

#include <algorithm>
#include <cmath>

#include "core/detect/growth/order_turns.h"

namespace stillcut::detect {
namespace {

constexpr double kStandingTurns = 16.0;  // of the mean while the engagement stands
constexpr double kMovingTurns = 128.0;   // ... and while it moves: a second at most speeds
constexpr double kMostPull = 5e-3;  // relative, half as much again as seen; further off is a speed that has changed

}  // namespace

void ArcPull::endTurn(Hertz spindle, bool moving) {
  least_ -= least_ / OrderTurns::kMemoryTurns;
  most_ -= most_ / OrderTurns::kMemoryTurns;
  if (!(spindle.value > 0.0)) return;
  if (before_ == 0.0 || std::abs(spindle.value / before_ - 1.0) > kMostPull) before_ = spindle.value;
  before_ += (spindle.value - before_) / (moving ? kMovingTurns : kStandingTurns);
  if (!moving) return;
  const double pull = spindle.value / before_ - 1.0;
  least_ = std::min(least_, pull);
  most_ = std::max(most_, pull);
}

double ArcPull::beyond(int order, double drift) const {
  return drift - std::clamp(drift, -order * most_, -order * least_);
}

}  // namespace stillcut::detect
