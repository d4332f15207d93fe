#include "core/dsp/order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stillcut::dsp {
namespace {

constexpr Hertz kRate{10000.0};

TEST(Order, OffsetIsTheDistanceToTheNearestHarmonic) {
  EXPECT_NEAR(orderOffset(Hertz(198.5), Hertz(40.0 / 3.0)), -0.1125, 1e-9);
  EXPECT_NEAR(std::abs(orderOffset(Hertz(150.0), Hertz(100.0))), 0.5, 1e-12);
}

TEST(Order, AnglesWrap) {
  EXPECT_NEAR(wrapAngle(-0.1), kTwoPi - 0.1, 1e-12);
  EXPECT_NEAR(wrapAngle(3 * kTwoPi + 0.25), 0.25, 1e-12);
  EXPECT_NEAR(wrapPhase(6.0), 6.0 - kTwoPi, 1e-12);
}

TEST(Tone, AmplitudeAndPhaseOverWholePeriods) {
  std::vector<double> x(1000);
  for (std::size_t n = 0; n < x.size(); ++n) {
    x[n] = 3.0 * std::cos(kTwoPi * 200.0 * static_cast<double>(n) / kRate.value + 0.4) + 1.0;
  }
  const std::complex<double> a = toneAmplitude(x, Hertz(200.0), kRate);
  EXPECT_NEAR(std::abs(a), 3.0, 1e-9);
  EXPECT_NEAR(std::arg(a), 0.4, 1e-9);
}

TEST(Tone, PhaseDriftFindsTheTrueFrequency) {
  std::vector<double> x(2000);
  for (std::size_t n = 0; n < x.size(); ++n) x[n] = std::sin(kTwoPi * 901.3 * static_cast<double>(n) / kRate.value);
  // 1.3 Hz off, span 0.2 s: the drift between the halves is a small part of a turn; the mirror term costs < 0.05 Hz.
  EXPECT_NEAR(phaseDriftFrequency(x, Hertz(900.0), kRate).value, 901.3, 0.05);
}

}  // namespace
}  // namespace stillcut::dsp
