#include "tests/support/field_cases/idle_spindle.h"

#include <array>

#include "core/milling/simulation/noise.h"
#include "tests/support/field_cases/tone.h"

namespace stillcut::field {

FieldCase idleSpindle(const IdleSpindle& s) {
  milling::NoiseSource random(s.seed);
  const double spindle = s.speed / 60.0;
  auto x = sampled(static_cast<std::size_t>(s.length * s.rate), s.rate,
                   [&](double /*t*/) { return 0.02 * random.normal(); });
  constexpr std::array<double, 3> kOrders{0.2, 0.14, 0.06};
  for (std::size_t n = 0; n < kOrders.size(); ++n) {
    const double order = static_cast<double>(n + 1);
    addTone(x, s.rate, {kOrders[n], order * spindle, order});
  }
  addTone(x, s.rate, {0.12, s.bearing * spindle, 0.0});
  addTone(x, s.rate, {0.05, 2.0 * s.bearing * spindle, 1.0});
  addTone(x, s.rate, {0.08, s.fan, 0.0});
  return {{s.rate, SensorQuantity::Acceleration, {inSinglePrecision(x)}}, s.teeth, s.speed, {}};
}

}  // namespace stillcut::field
