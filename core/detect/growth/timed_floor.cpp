#include "core/detect/growth/timed_floor.h"

#include <algorithm>

namespace stillcut::detect {
namespace {

constexpr double kRisesIn = 10.0;  // s, an e-fold
constexpr double kFallTurns = 10.0;

double followed(double floor, double now, double turns, Hertz spindle) {
  if (now < floor) return floor + turns / kFallTurns * (now - floor);
  if (!(now > floor) || !(spindle.value > 0.0)) return floor;
  return floor * (1.0 + turns * (std::min(now / floor - 1.0, 1.0) / (kRisesIn * spindle.value)));
}

}  // namespace

void TimedFloor::follow(double share, double energy, double turns, Hertz spindle) {
  share_ = followed(share_, share, turns, spindle);
  energy_ = followed(energy_, energy, turns, spindle);
}

}  // namespace stillcut::detect
