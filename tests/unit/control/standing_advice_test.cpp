// The advice by itself: one speed and one frequency that stand still, there without a machine and beside monitoring,
// and gone when the cut needs it no longer.
#include "core/control/standing_advice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stillcut::control {
namespace {

constexpr Seconds kBlock{0.01};

class StandingAdviceTest : public ::testing::Test {
 protected:
  void SetUp() override {
    setup_.teeth = 4;
    setup_.nominalSpeed = Rpm(8500.0);
    setup_.nominalFeed = fromMmPerMin(2720.0);
    strategy_.prepare(setup_, {});
    advice_.prepare(setup_, {}, "stable-pocket");
    in_.dt = kBlock;
    in_.verdict.valid = true;
    in_.verdict.phase = CutPhase::Steady;
    in_.verdict.state = CutState::Stable;
    in_.verdict.spindle = toHertz(Rpm(8500.0));
  }
  // A cut without a machine: nobody moves anything.
  void run(double seconds) {
    for (double t = 0.0; t < seconds; t += kBlock.value) {
      in_.now += toDuration(kBlock);
      in_.machine = machineAsSetUp(setup_, in_.verdict.spindle, in_.now);
      shown_ = advice_.look(in_, strategy_.decide(in_));
    }
  }
  void chatter(double hz) {
    in_.verdict.state = CutState::Chatter;
    in_.verdict.frequency = Hertz(hz);
    in_.verdict.severity = Ratio(0.6);
  }
  void quiet() {
    in_.verdict.state = CutState::Stable;
    in_.verdict.frequency = {};
    in_.verdict.severity = {};
  }

  CutSetup setup_;
  StrategyInput in_;
  StablePocket strategy_;
  StandingAdvice advice_;
  SpeedAdvice shown_;
};

TEST_F(StandingAdviceTest, WithoutAMachineTheSpeedFollowsFromTeethSpeedAndFrequency) {
  run(1.0);
  EXPECT_EQ(shown_.kind, SpeedAdvice::Kind::None);
  chatter(1250.0);
  run(0.5);
  ASSERT_EQ(shown_.kind, SpeedAdvice::Kind::Speed);
  EXPECT_NEAR(shown_.speed.value, 60.0 * 1250.0 / (2 * 4), 90.0) << "60 f / (p Z) with p = 2, van Dijk 2010 eq. 30";
  EXPECT_NEAR(shown_.chatter.value, 1250.0, 1.0);
  EXPECT_DOUBLE_EQ(shown_.base.value, 8500.0);
  EXPECT_NEAR(shown_.feed / shown_.baseFeed, shown_.speed / shown_.base, 1e-9) << "the feed per tooth stays";
}

// An estimate that wavers by a few tenths of a percent, for half a minute that nobody answers in.
TEST_F(StandingAdviceTest, StandsStillWhileNobodyFollowsIt) {
  chatter(1250.0);
  run(0.5);
  const SpeedAdvice first = shown_;
  ASSERT_EQ(first.kind, SpeedAdvice::Kind::Speed);
  for (int k = 0; k < 60; ++k) {
    chatter(1250.0 * (1.0 + 0.004 * std::sin(k)));
    run(0.5);
    ASSERT_EQ(shown_.speed.value, first.speed.value) << k;
    ASSERT_EQ(shown_.chatter.value, first.chatter.value) << k;
  }
}

TEST_F(StandingAdviceTest, GoesWhenTheCutHasBeenStableAsItIs) {
  chatter(1250.0);
  run(0.5);
  quiet();
  run(5.0);
  EXPECT_EQ(shown_.kind, SpeedAdvice::Kind::Speed) << "the next pass may need it";
  run(6.0);
  EXPECT_EQ(shown_.kind, SpeedAdvice::Kind::None);
  chatter(1250.0);
  run(0.5);
  EXPECT_EQ(shown_.kind, SpeedAdvice::Kind::Speed) << "again with the next alarm";
}

TEST_F(StandingAdviceTest, IsThereBesideAStrategyThatOnlyMonitors) {
  advice_.prepare(setup_, {}, "monitor");
  chatter(1250.0);
  for (double t = 0.0; t < 0.5; t += kBlock.value) {
    in_.now += toDuration(kBlock);
    in_.machine = machineAsSetUp(setup_, in_.verdict.spindle, in_.now);
    OverrideRequest none;
    none.kind = RequestKind::Release;
    shown_ = advice_.look(in_, none);
  }
  ASSERT_EQ(shown_.kind, SpeedAdvice::Kind::Speed);
  EXPECT_NEAR(shown_.speed.value, 9375.0, 90.0);
}

TEST_F(StandingAdviceTest, SaysTheDepthWhereNoSpeedWillDo) {
  in_.machine = machineAsSetUp(setup_, in_.verdict.spindle, in_.now);
  OverrideRequest none;
  none.reason = {ReasonCode::NoStableSpeed, {3.0, 1.8, 8900.0, 1250.0}};
  chatter(1250.0);
  shown_ = advice_.look(in_, none);
  ASSERT_EQ(shown_.kind, SpeedAdvice::Kind::LessDepth);
  EXPECT_NEAR(shown_.depth.value, 1.8e-3, 1e-12);
  EXPECT_DOUBLE_EQ(shown_.speed.value, 8900.0);
}

TEST_F(StandingAdviceTest, WithoutANominalSpeedNothingIsAssumed) {
  setup_.nominalSpeed = {};
  EXPECT_FALSE(machineAsSetUp(setup_, Hertz(140.0), in_.now).valid);
}

}  // namespace
}  // namespace stillcut::control
