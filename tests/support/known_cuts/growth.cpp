#include "tests/support/known_cuts/growth.h"

#include <array>
#include <cmath>

#include "core/milling/simulation/noise.h"
#include "tests/support/signals.h"

namespace stillcut::bench {
namespace {

using detect::testing::CutSignal;

CutSignal scatteredSignal(unsigned seed) {
  constexpr std::array<double, 4> kRates{25600.0, 20480.0, 51200.0, 12800.0};
  milling::NoiseSource random(seed * 977 + 3);
  CutSignal s;
  s.seed = seed;
  s.rate = kRates[seed % kRates.size()];
  // Two in three at the speed and with the teeth of the specification, the others anywhere.
  if (seed % 3 == 0) {
    s.spindle = 80.0 + 80.0 * random.uniform();
    s.teeth = 2 + static_cast<int>(3.0 * random.uniform());
  }
  const double order = std::floor(5.0 + 15.0 * random.uniform());
  const double offset = 0.1 + 0.4 * random.uniform();
  s.chatterHertz = s.spindle * (order + (random.uniform() < 0.5 ? -offset : offset));
  return s;
}

KnownCut known(const CutSignal& s) {
  KnownCut cut;
  cut.recording = detect::testing::makeCut(s);
  cut.teeth = s.teeth;
  cut.rpm = 60.0 * s.spindle;
  cut.toldErrors = {-0.01, 0.01};
  cut.name = "seed " + std::to_string(s.seed) + " Z" + std::to_string(s.teeth) + " order " +
             std::to_string(s.chatterHertz / s.spindle).substr(0, 5) + " rate " +
             std::to_string(static_cast<int>(s.rate));
  return cut;
}

}  // namespace

KnownCut growingCut(double constant, unsigned seed) {
  CutSignal s = scatteredSignal(seed);
  s.growthStart = 2.0;
  s.growthConstant = constant;
  s.seconds = 2.7;
  KnownCut cut = known(s);
  cut.family = "growth " + std::to_string(static_cast<int>(std::lround(1e3 * constant))) + " ms";
  cut.rule = AlarmRule::Growth;
  cut.at1 = cut.at20 = s.growthStart;
  cut.latest = s.growthStart + 4.4 * constant;
  cut.chatterHz = s.chatterHertz;
  cut.kind = ChatterKind::Hopf;
  return cut;
}

KnownCut minuteWithoutGrowth(unsigned seed) {
  CutSignal s = scatteredSignal(seed + 500);
  s.seconds = 60.0;
  KnownCut cut = known(s);
  cut.family = "no growth, 60 s";
  return cut;
}

}  // namespace stillcut::bench
