// A trend is what windows of a drifting speed say one after the other; not their scatter, nor what a spindle wanders.
#include "core/spindle/speed_trend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stillcut::detect {
namespace {

constexpr double kSpindle = 105.0;        // Hz
constexpr double kStep = 2.0 / kSpindle;  // s, from window to window: a sixth of 12 turns
constexpr int kLooks = 6;

TEST(SpeedTrend, TellsTheDriftOnceTheFirstWindowAndTheLastHaveNothingInCommon) {
  for (const double drift : {-0.05, 0.05}) {
    std::mt19937 random(3);
    std::normal_distribution<double> scatter(0.0, 2e-4);
    SpeedTrend trend;
    trend.prepare(kLooks);
    for (int n = 0; n <= kLooks; ++n) {
      EXPECT_EQ(trend.drift(), 0.0) << n;
      trend.add(Seconds(n * kStep), Hertz(kSpindle * (1.0 + drift * n * kStep + scatter(random))));
    }
    EXPECT_NEAR(trend.drift(), drift, 0.2 * std::abs(drift));
  }
}

// In an hour, one of windows that scatter by 0.05 % as well.
TEST(SpeedTrend, TakesNoWanderingForADrift) {
  constexpr double kWander = 2e-6;  // of the square of the speed per second: 0.1 % with one second of memory
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  SpeedTrend trend;
  trend.prepare(kLooks);
  double away = 0.0;
  for (int n = 0; n * kStep < 3600.0; ++n) {
    away += std::sqrt(kWander * kStep) * normal(random) - away * kStep;
    trend.add(Seconds(n * kStep), Hertz(kSpindle * (1.0 + away + 5e-4 * normal(random))));
    ASSERT_EQ(trend.drift(), 0.0) << n;
  }
}

TEST(SpeedTrend, IsBrokenByASpeedThatIsElsewhereAtOnce) {
  SpeedTrend trend;
  trend.prepare(kLooks);
  trend.add(Seconds(0.0), Hertz(kSpindle));
  EXPECT_FALSE(trend.unbroken());
  trend.mark();
  for (int n = 1; n < 40; ++n) trend.add(Seconds(n * kStep), Hertz(kSpindle * (1.0 + 0.05 * n * kStep)));
  EXPECT_TRUE(trend.unbroken());  // 4 % on by now, step by step
  trend.add(Seconds(40 * kStep), Hertz(kSpindle * 1.06));
  EXPECT_FALSE(trend.unbroken());
  EXPECT_EQ(trend.drift(), 0.0);
}

// Nobody looks while a lock is sure. What was said before is not where the speed is when it is lost.
TEST(SpeedTrend, IsBrokenByAPause) {
  SpeedTrend trend;
  trend.prepare(kLooks);
  for (int n = 0; n <= kLooks; ++n) trend.add(Seconds(n * kStep), Hertz(kSpindle * (1.0 + 0.05 * n * kStep)));
  trend.mark();
  EXPECT_GT(trend.drift(), 0.0);
  trend.add(Seconds(60.0), Hertz(kSpindle * (1.0 + 0.05 * (kLooks + 1) * kStep)));
  EXPECT_EQ(trend.drift(), 0.0);
  EXPECT_FALSE(trend.unbroken());
}

}  // namespace
}  // namespace stillcut::detect
