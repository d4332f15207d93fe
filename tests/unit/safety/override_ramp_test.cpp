// How the factors travel: order of speed and feed, rates, edges.
#include "core/safety/override_ramp.h"

#include <gtest/gtest.h>

#include <limits>

namespace stillcut::safety {
namespace {

class OverrideRampTest : public ::testing::Test {
 protected:
  void SetUp() override {
    limits_.filter = Seconds(0.0);
    ramp_.prepare(limits_);
    in_.dt = 0.01;
    in_.speed = {0.5, 1.2};
    in_.feed = {0.5, 1.2};
  }
  Factors go(double speed, double feed, int steps = 1) {
    in_.wanted = {speed, feed};
    for (int i = 0; i < steps; ++i) ramp_.advance(in_);
    return ramp_.now();
  }

  GateLimits limits_;
  OverrideRamp ramp_;
  RampInput in_;
};

TEST_F(OverrideRampTest, GoingDownFeedGoesFirst) {
  const Factors first = go(0.9, 0.9);
  EXPECT_LT(first.feed, 1.0);
  EXPECT_EQ(first.speed, 1.0);
  for (int i = 0; i < 40; ++i) {
    const Factors before = ramp_.now();
    const Factors now = go(0.9, 0.9);
    EXPECT_GE(now.speed, before.feed - 1e-12);  // never below the feed already sent
  }
  EXPECT_NEAR(ramp_.now().speed, 0.9, 1e-9);
}

TEST_F(OverrideRampTest, GoingUpSpeedGoesFirst) {
  const Factors first = go(1.1, 1.1);
  EXPECT_GT(first.speed, 1.0);
  EXPECT_EQ(first.feed, 1.0);
  for (int i = 0; i < 40; ++i) {
    const Factors before = ramp_.now();
    EXPECT_LE(go(1.1, 1.1).feed, before.speed + 1e-12);
  }
  EXPECT_NEAR(ramp_.now().feed, 1.1, 1e-9);
}

TEST_F(OverrideRampTest, FeedWaitsForTheSpindleItself) {
  in_.actualSpeed = 1.0;  // inertia: commanded, not there yet
  const Factors waiting = go(1.1, 1.1, 100);
  EXPECT_NEAR(waiting.speed, 1.1, 1e-9);
  EXPECT_NEAR(waiting.feed, 1.0 + limits_.speedTolerance, 1e-9);
  in_.actualSpeed = 1.1;
  EXPECT_NEAR(go(1.1, 1.1, 100).feed, 1.1, 1e-9);
}

TEST_F(OverrideRampTest, SpeedWaitsForTheFeedThatIsInForce) {
  in_.feedInForce = 1.0;  // sent, not taken yet
  const Factors waiting = go(0.8, 0.8, 100);
  EXPECT_NEAR(waiting.feed, 0.8, 1e-9);
  EXPECT_NEAR(waiting.speed, 1.0 - limits_.speedTolerance - kReadbackRounding, 1e-9);
  in_.feedInForce = 0.8;
  EXPECT_NEAR(go(0.8, 0.8, 100).speed, 0.8, 1e-9);
}

TEST_F(OverrideRampTest, FeedPerToothStaysAboveItsLowestAllTheWay) {
  limits_.overrides.lowestFeedPerTooth = 0.8;
  ramp_.prepare(limits_);
  const auto perTooth = [&] { return ramp_.now().feed / ramp_.now().speed; };
  for (int i = 0; i < 100; ++i) {
    go(1.0, 0.5);  // a wish for a feed that would rub
    EXPECT_GE(perTooth(), 0.8 - 1e-12);
  }
  EXPECT_NEAR(ramp_.now().feed, 0.8, 1e-9);
  for (int i = 0; i < 100; ++i) {  // both up: the feed has to come along
    go(1.2, 1.2);
    EXPECT_GE(perTooth(), 0.8 - 1e-12);
  }
  EXPECT_NEAR(ramp_.now().speed, 1.2, 1e-9);
  EXPECT_NEAR(ramp_.now().feed, 1.2, 1e-9);
}

TEST_F(OverrideRampTest, StepAndSlewBoundEachStep) {
  in_.dt = 0.01;
  EXPECT_NEAR(go(0.5, 0.5).feed, 1.0 - 0.02, 1e-12);  // 200 %/s for 10 ms
  in_.dt = 10.0;                                      // a late step: the step bound holds
  EXPECT_NEAR(go(0.5, 0.5).feed, 0.98 - 0.05, 1e-12);
  in_.dt = 0.0;
  const Factors before = ramp_.now();
  EXPECT_EQ(go(1.2, 1.2).speed, before.speed);
}

TEST_F(OverrideRampTest, RecoveryIsAFifthTowardHundredAndFullAway) {
  go(0.8, 0.8, 500);
  in_.recovering = true;
  const double back = go(1.0, 1.0).speed - 0.8;
  EXPECT_NEAR(back, 0.2 * 0.01, 1e-12);
  go(0.8, 0.8, 500);
  const double before = ramp_.now().feed;
  EXPECT_NEAR(before - go(0.7, 0.7).feed, 0.02, 1e-9);
}

TEST_F(OverrideRampTest, FilterSmoothsAStepAndArrives) {
  limits_.filter = Seconds(0.2);
  ramp_.prepare(limits_);
  EXPECT_GT(go(1.0, 0.9).feed, 1.0 - 0.006);  // slew alone would give 2 %
  EXPECT_EQ(go(0.9, 0.9, 1000).speed, 0.9);
}

TEST_F(OverrideRampTest, NumbersThatAreNoneChangeNothing) {
  go(0.9, 0.9, 100);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  in_.wanted = {nan, nan};
  ramp_.advance(in_);
  EXPECT_NEAR(ramp_.now().speed, 0.9, 1e-9);
  EXPECT_NEAR(ramp_.now().feed, 0.9, 1e-9);
}

TEST_F(OverrideRampTest, AnEdgeThatMovesTakesTheFactorAlong) {
  go(1.2, 1.2, 200);
  ramp_.keepInside({0.5, 1.05}, {0.5, 1.2});
  EXPECT_EQ(ramp_.now().speed, 1.05);
  EXPECT_LE(ramp_.now().feed, 1.05);
}

}  // namespace
}  // namespace stillcut::safety
