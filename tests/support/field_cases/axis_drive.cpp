#include "tests/support/field_cases/axis_drive.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/milling/simulation/noise.h"
#include "tests/support/field_cases/tone.h"

namespace stillcut::field {
namespace {

constexpr int kTeeth = 3;
constexpr double kAccelerates_s = 0.3, kStands_s = 0.4;  // of each feed move
constexpr double kLowest = 20.0;                         // Hz, below which the drive is not received

double driveHertz(const AxisDrive& s, double time) {
  if (time < s.entry) return 0.0;
  const double inMove = std::fmod(time - s.entry, s.move);
  const double rise = inMove / kAccelerates_s;
  const double fall = (s.move - kStands_s - inMove) / kAccelerates_s;
  return s.highest * std::clamp(std::min(rise, fall), 0.0, 1.0);
}

}  // namespace

FieldCase axisDrive(const AxisDrive& s) {
  milling::NoiseSource random(s.seed);
  const double spindle = s.speed / 60.0;
  auto x = sampled(static_cast<std::size_t>(s.length * s.rate), s.rate,
                   [&](double /*t*/) { return 0.02 * random.normal(); });
  const auto inCut = sampled(x.size(), s.rate, [&](double t) { return t > s.entry && t < s.exit ? 1.0 : 0.0; });
  for (int k = 1; k < 20; ++k) {
    const double amplitude = k % kTeeth == 0 ? 1.0 / (1.0 + 0.15 * k) : 0.12 / (1.0 + 0.1 * k);
    addTone(x, s.rate, {amplitude, k * spindle, kTwoPi * random.uniform()}, inCut);
  }
  double phase = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double hertz = driveHertz(s, static_cast<double>(i) / s.rate);
    phase = std::fmod(phase + kTwoPi * hertz / s.rate, kTwoPi);
    if (hertz > kLowest) x[i] += s.amplitude * std::cos(phase);
  }
  return {{s.rate, SensorQuantity::Acceleration, {inSinglePrecision(x)}}, kTeeth, s.speed, {}};
}

}  // namespace stillcut::field
