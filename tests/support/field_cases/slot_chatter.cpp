#include "tests/support/field_cases/slot_chatter.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/milling/simulation/noise.h"
#include "tests/support/field_cases/tone.h"

namespace stillcut::field {
namespace {

constexpr double kAmplitude = 0.18;    // of the chatter's strongest line, at the resonance, of full scale
constexpr double kSeries = 0.126;      // -18 dB
constexpr double kSidebands = 0.224;   // -13 dB
constexpr double kSecond = 0.08;       // of the chatter's second harmonic
constexpr double kModeHertz = 1450.0;  // resonance that all lines pass through
constexpr double kModeWidth = 0.24;
constexpr double kEntry_s = 0.05, kGrowth_s = 0.3;

double throughMode(double hertz) {
  const double ratio = hertz / kModeHertz;
  return kModeWidth / std::hypot(1.0 - ratio * ratio, kModeWidth * ratio);
}

void addSeries(std::vector<double>& x, const SlotChatter& s, const std::vector<double>& inCut,
               milling::NoiseSource& random) {
  const double spindle = s.speed / 60.0;
  for (int k = 1; k < 30; ++k) {
    const double runout = k % 2 == 0 ? 1.0 : 0.5;
    addTone(x, s.rate,
            {kAmplitude * throughMode(k * spindle) * kSeries * runout, k * spindle, kTwoPi * random.uniform()}, inCut);
  }
}

void addChatter(std::vector<double>& x, const SlotChatter& s, const std::vector<double>& grown,
                milling::NoiseSource& random) {
  constexpr double kLowest = 200.0;  // Hz
  const double spindle = s.speed / 60.0;
  const double chatter = s.order * spindle;
  for (int k = -2; k <= 3; ++k) {
    for (const int sideband : {0, 1}) {
      const double hertz = chatter + (2 * k + sideband) * spindle;
      const double phase = kTwoPi * random.uniform();
      if (hertz <= kLowest) continue;
      addTone(x, s.rate, {kAmplitude * throughMode(hertz) * (sideband == 0 ? 1.0 : kSidebands), hertz, phase}, grown);
    }
  }
  addTone(x, s.rate, {kAmplitude * kSecond, 2.0 * chatter, 1.0}, grown);
}

// Air cutting: the spindle's own sound, a hum, noise that the cut makes stronger.
void addAirCutting(std::vector<double>& x, const SlotChatter& s, const std::vector<double>& inCut,
                   milling::NoiseSource& random) {
  const double spindle = s.speed / 60.0;
  addTone(x, s.rate, {0.004, spindle, 0.0});
  addTone(x, s.rate, {0.0064, 2.0 * spindle, 1.0});
  addTone(x, s.rate, {0.0024, 150.0, 0.0});
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += (0.002 + 0.006 * inCut[i]) * random.normal();
}

AlarmTruth truthOf(const SlotChatter& s) {
  if (s.begin == ChatterBegin::Never) return {};
  constexpr double kAfterEntry = 0.3, kAfterGrowth = 0.5, kBeforeExit = 0.2;  // s
  const bool late = s.begin == ChatterBegin::Late;
  const double begin = late ? s.entry + s.stable : s.entry;
  return {true, begin, begin + (late ? kAfterGrowth : kAfterEntry), s.exit - kBeforeExit};
}

}  // namespace

FieldCase slotChatter(const SlotChatter& s) {
  milling::NoiseSource random(s.seed);
  const auto frames = static_cast<std::size_t>(s.length * s.rate);
  const auto inCut =
      sampled(frames, s.rate, [&](double t) { return ramp(t, s.entry, kEntry_s) * ramp(-t, -s.exit, kEntry_s); });
  std::vector<double> x(frames, 0.0);
  addSeries(x, s, inCut, random);
  if (s.begin != ChatterBegin::Never) {
    auto grown = inCut;
    const auto growth = sampled(frames, s.rate, [&](double t) { return ramp(t, s.entry + s.stable, kGrowth_s); });
    if (s.begin == ChatterBegin::Late)
      std::transform(grown.begin(), grown.end(), growth.begin(), grown.begin(), std::multiplies<>());
    addChatter(x, s, grown, random);
  }
  addAirCutting(x, s, inCut, random);
  return {{s.rate, SensorQuantity::Sound, {inSixteenBits(x)}}, 2, s.speed, truthOf(s)};
}

}  // namespace stillcut::field
