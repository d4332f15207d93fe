#include "core/detect/arc_pull.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kStandingTurns = 16.0;  // of the mean while the engagement stands
constexpr double kForgetTurns = 6.0;     // the memory of what an order turns by
constexpr double kMostPull = 5e-3;       // relative; further off is a speed that has changed

}  // namespace

void ArcPull::endTurn(Hertz spindle, bool moving) noexcept {
  least_ -= least_ / kForgetTurns;
  most_ -= most_ / kForgetTurns;
  if (!(spindle.value > 0.0)) return;
  if (before_ == 0.0 || std::abs(spindle.value / before_ - 1.0) > kMostPull) before_ = spindle.value;
  if (!moving) {
    before_ += (spindle.value - before_) / kStandingTurns;
    return;
  }
  const double pull = spindle.value / before_ - 1.0;
  least_ = std::min(least_, pull);
  most_ = std::max(most_, pull);
}

double ArcPull::beyond(int order, double drift) const noexcept {
  return drift - std::clamp(drift, -order * most_, -order * least_);
}

}  // namespace stillcut::detect
