// A drift is what goes on: not a wave, a step or a bend of the phases, and not what a spindle wanders.
#include "core/spindle/drift_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/units.h"

namespace stillcut::detect {
namespace {

constexpr double kSpindle = 105.0;  // Hz
constexpr double kOmega = kTwoPi * kSpindle;
constexpr double kWander = 2e-6 * kOmega * kOmega;  // 0.1 % with one second of memory

// Shown at any turn of this many, the spindle's angle beside an even motion being angle(t) [rad].
template <class Angle>
bool shows(int turns, const Angle& angle) {
  DriftWatch watch;
  bool shown = false;
  for (int n = 0; n < turns; ++n) {
    const double t = n / kSpindle;
    watch.add(t, kOmega * t + angle(t));
    shown = shown || watch.shown(kWander).has_value();
  }
  return shown;
}

TEST(DriftWatch, TellsSpeedAndDriftOfASpindleThatRunsAway) {
  for (const double drift : {-0.05, 0.03, 0.05}) {
    DriftWatch watch;
    for (int n = 0; n < DriftWatch::kTurns; ++n) {
      EXPECT_FALSE(watch.shown(kWander)) << n;
      const double t = n / kSpindle;
      watch.add(t, kOmega * (t + 0.5 * drift * t * t));
    }
    const auto shown = watch.shown(kWander);
    ASSERT_TRUE(shown) << drift;
    EXPECT_NEAR(shown->alpha, drift * kOmega, 1e-6 * kOmega);
    EXPECT_NEAR(shown->omega, kOmega * (1.0 + drift * (DriftWatch::kTurns - 1) / kSpindle), 1e-6 * kOmega);
    EXPECT_FALSE(watch.over(kWander));
  }
}

TEST(DriftWatch, IsOverWhenTheSpeedStands) {
  DriftWatch watch;
  double angle = 0.0;
  double omega = kOmega;
  for (int n = 0; n < 60; ++n) {
    watch.add(n / kSpindle, angle);
    angle += omega / kSpindle;
    if (n < 30) omega += 0.05 * kOmega / kSpindle;
    if (n == 40) {
      EXPECT_FALSE(watch.over(kWander));
    }
  }
  EXPECT_TRUE(watch.over(kWander));
  EXPECT_FALSE(watch.shown(kWander));
}

// The phases swing (by 0.4 % of the speed and more); they move with the arc of the cut, by half a radian within 0.8 s;
// the speed steps by one per cent.
TEST(DriftWatch, TakesNoWaveStepOrBendForADrift) {
  for (const double hertz : {8.0, 20.0}) {
    EXPECT_FALSE(shows(400, [&](double t) { return 0.05 * std::sin(kTwoPi * hertz * t); })) << hertz;
  }
  EXPECT_FALSE(shows(400, [](double t) { return 0.5 * std::clamp((t - 1.0) / 0.8, 0.0, 1.0); }));
  EXPECT_FALSE(shows(400, [](double t) { return 0.01 * kOmega * std::max(0.0, t - 1.0); }));
}

TEST(DriftWatch, TakesNoWanderingForADrift) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  double omega = 0.0;
  double angle = 0.0;
  EXPECT_FALSE(shows(100000, [&](double) {
    omega += std::sqrt(kWander / kSpindle) * normal(random) - omega / kSpindle;
    return angle += omega / kSpindle;
  }));
}

}  // namespace
}  // namespace stillcut::detect
