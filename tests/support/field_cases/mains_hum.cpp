#include "tests/support/field_cases/mains_hum.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/units.h"
#include "core/milling/simulation/noise.h"
#include "tests/support/field_cases/tone.h"

namespace stillcut::field {
namespace {

constexpr int kTeeth = 4;
constexpr double kEntry_s = 0.05, kGrowth_s = 0.3;

struct ChatterLine {
  int toothPassings;  // above the chatter frequency
  double amplitude;
};
constexpr auto kLines = std::to_array<ChatterLine>({{-1, 0.069}, {0, 0.69}, {1, 0.2277}, {2, 0.1035}});

}  // namespace

FieldCase mainsHum(const MainsHum& s) {
  milling::NoiseSource random(s.seed);
  const double spindle = s.speed / 60.0;
  auto x = sampled(static_cast<std::size_t>(s.length * s.rate), s.rate,
                   [&](double /*t*/) { return 0.02 * random.normal(); });
  addTone(x, s.rate, {s.hum, 3.0 * s.mains, 0.0});
  addTone(x, s.rate, {0.15 * s.hum, s.mains, 1.0});
  const auto inCut =
      sampled(x.size(), s.rate, [&](double t) { return ramp(t, s.entry, kEntry_s) * ramp(-t, -s.exit, kEntry_s); });
  for (int k = 1; k < 20; ++k) {
    const double amplitude = k % kTeeth == 0 ? 0.25 / std::sqrt(k) : 0.04;
    addTone(x, s.rate, {amplitude, k * spindle, kTwoPi * random.uniform()}, inCut);
  }
  auto grown = sampled(x.size(), s.rate, [&](double t) { return ramp(t, s.begin, kGrowth_s); });
  std::transform(grown.begin(), grown.end(), inCut.begin(), grown.begin(), std::multiplies<>());
  for (const ChatterLine& line : kLines) {
    const double hertz = s.chatter + line.toothPassings * kTeeth * spindle;
    addTone(x, s.rate, {line.amplitude, hertz, 1.0 * line.toothPassings}, grown);
  }
  return {{s.rate, SensorQuantity::Acceleration, {inSinglePrecision(x)}},
          kTeeth,
          s.speed,
          {true, s.begin, s.begin + 0.5, s.exit - 0.1}};
}

}  // namespace stillcut::field
