#include "core/dsp/order.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stillcut::dsp {
namespace {

TEST(Order, OffsetIsTheDistanceToTheNearestHarmonic) {
  EXPECT_NEAR(orderOffset(Hertz(198.5), Hertz(40.0 / 3.0)), -0.1125, 1e-9);
  EXPECT_NEAR(std::abs(orderOffset(Hertz(150.0), Hertz(100.0))), 0.5, 1e-12);
}

TEST(Order, AnglesWrap) {
  EXPECT_NEAR(wrapPhase(6.0), 6.0 - kTwoPi, 1e-12);
}

// Whatever the turn: a wrapped angle points the same way, lies in its range, and wrapping it again changes nothing.
TEST(Order, WrappingKeepsTheDirection) {
  for (int i = -4000; i <= 4000; ++i) {
    const double a = 0.0137 * i;
    const double phase = wrapPhase(a);
    EXPECT_LE(std::abs(phase), kTwoPi / 2.0 + 1e-12);
    EXPECT_NEAR(std::cos(phase), std::cos(a), 1e-12) << a;
    EXPECT_NEAR(std::sin(phase), std::sin(a), 1e-12) << a;
    EXPECT_EQ(wrapPhase(phase), phase);
  }
}

TEST(Order, TheOffsetIsNeverMoreThanHalfAndForgetsWholeOrders) {
  const Hertz spindle{37.3};
  for (int i = 1; i < 3000; ++i) {
    const Hertz f(0.731 * i);
    const double offset = orderOffset(f, spindle);
    EXPECT_LE(std::abs(offset), 0.5);
    EXPECT_NEAR(std::remainder((f / spindle) - offset, 1.0), 0.0, 1e-9);
    EXPECT_NEAR(orderOffset(f + 7.0 * spindle, spindle), offset, 1e-9);
  }
}

}  // namespace
}  // namespace stillcut::dsp
