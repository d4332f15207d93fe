#include "core/detect/timed_floor.h"

#include <algorithm>

namespace stillcut::detect {
namespace {

constexpr double kDoublesIn = 10.0;  // s
constexpr double kFallTurns = 10.0;

}  // namespace

void TimedFloor::follow(double share, double energy, double turns, Hertz spindle) noexcept {
  if (share < share_) {
    share_ += turns / kFallTurns * (share - share_);
    energy_ += turns / kFallTurns * (energy - energy_);
  } else if (share > share_ && spindle.value > 0.0) {
    raise(1.0 + turns * (std::min(share / share_ - 1.0, 1.0) / (kDoublesIn * spindle.value)));
  }
}

}  // namespace stillcut::detect
