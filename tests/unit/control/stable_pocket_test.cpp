// stable-pocket behind the gate on a plant that knows only pockets: chatter sits at a fixed frequency and is quiet
// where the speed is near 60 f / (p Z). What is asserted is the conduct: few moves, no reaction to what is not chatter,
// a speed that chattered is not tried again, giving up with the reason.
#include "core/control/stable_pocket.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/control/registry.h"

namespace stillcut::control {
namespace {

constexpr Seconds kBlock{0.01};

// 8500 rpm, four teeth, a mode whose chatter is heard at 936 Hz; pockets at 7020 (p = 2) and 4680 rpm (p = 3).
class StablePocketTest : public ::testing::Test {
 protected:
  void SetUp() override {
    setup_.teeth = 4;
    in_.dt = kBlock;
    in_.machine.valid = true;
    in_.machine.programmedSpeed = in_.machine.actualSpeed = Rpm(8500.0);
    in_.machine.programmedFeed = fromMmPerMin(2720.0);
    in_.verdict.valid = true;
    in_.verdict.state = CutState::Stable;
    strategy_.prepare(setup_, {});
  }
  // One block; the spindle follows within about 0.2 s. Counts the targets.
  OverrideRequest step() {
    in_.now += toDuration(kBlock);
    const OverrideRequest r = strategy_.decide(in_);
    const Rpm goal = r.kind == RequestKind::Set ? r.speed : in_.machine.programmedSpeed;
    if (r.kind == RequestKind::Set && (targets_.empty() || std::abs((targets_.back() - goal).value) > 1.0)) {
      targets_.push_back(goal);
    }
    if (r.kind != RequestKind::Hold) in_.machine.actualSpeed += 0.2 * (goal - in_.machine.actualSpeed);
    return r;
  }
  OverrideRequest run(double seconds) {
    OverrideRequest last;
    for (double t = 0.0; t < seconds; t += kBlock.value) last = step();
    return last;
  }
  void chatter(double hz, double severity = 0.5, CutState state = CutState::Chatter) {
    in_.verdict.state = state;
    in_.verdict.frequency = Hertz(hz);
    in_.verdict.severity = Ratio(severity);
  }
  void quiet() { chatter(0.0, 0.0, CutState::Stable); }

  CutSetup setup_;
  StrategyInput in_;
  StablePocket strategy_;
  std::vector<Rpm> targets_;
};

TEST_F(StablePocketTest, GoesToTheRulesSpeedAndStaysThereWhenQuiet) {
  chatter(936.0);
  run(0.3);
  quiet();
  const OverrideRequest r = run(20.0);
  ASSERT_EQ(targets_.size(), 1u);
  EXPECT_NEAR(targets_[0].value, 60.0 * 936.0 / 8.0, 1e-6);  // van Dijk 2010 eq. 29, 30: p = 2
  EXPECT_EQ(r.reason.code, ReasonCode::KeepingSpeed);
  EXPECT_NEAR(toMmPerMin(r.feed) / r.speed.value, 2720.0 / 8500.0, 1e-9);
}

TEST_F(StablePocketTest, AShortAlarmIsNotWorthAMove) {
  chatter(936.0);
  run(0.03);
  quiet();
  run(2.0);
  EXPECT_TRUE(targets_.empty());
}

TEST_F(StablePocketTest, ALineThatNeverStandsStillIsNoChatter) {
  // A rattling sensor: each verdict names a line a third of a spindle frequency further.
  for (int i = 0; i < 500; ++i) {
    chatter(2200.0 + 47.0 * (i % 3), 0.4);
    step();
  }
  EXPECT_TRUE(targets_.empty());
}

TEST_F(StablePocketTest, FrequencyJitterDoesNotMoveTheTarget) {
  for (int i = 0; i < 60; ++i) {
    chatter(936.0 + (i % 2 == 0 ? 2.0 : -2.0));
    step();
  }
  EXPECT_EQ(targets_.size(), 1u);
}

TEST_F(StablePocketTest, AnOnsetThatDoesNotGrowAfterTheMoveIsLeftAlone) {
  chatter(936.0);
  run(0.3);
  chatter(986.0, 0.05, CutState::Onset);
  run(30.0);
  EXPECT_EQ(targets_.size(), 1u);
}

TEST_F(StablePocketTest, AStandingAlarmAsLoudAsTheChatterWasIsChatter) {
  in_.vibration = 100.0;
  in_.verdict.phase = CutPhase::Steady;
  quiet();
  run(2.0);
  in_.vibration = 9000.0;
  chatter(936.0);
  run(0.5);
  in_.vibration = 6000.0;  // grown to its end: it neither grows nor falls
  chatter(1010.0, 0.12, CutState::Onset);
  run(4.0);
  const std::size_t moved = targets_.size();
  EXPECT_GE(moved, 2u);
  in_.vibration = 300.0;  // the same line in a cut that is quiet again: left alone
  run(10.0);
  EXPECT_EQ(targets_.size(), moved);
}

TEST_F(StablePocketTest, LoudChatterWithoutALineThatStandsIsChatter) {
  in_.vibration = 100.0;
  in_.verdict.phase = CutPhase::Steady;
  quiet();
  run(2.0);
  in_.vibration = 3000.0;
  chatter(936.0);
  run(0.5);
  const auto wander = [&](double seconds) {
    for (double t = 0.0; t < seconds; t += kBlock.value) {
      chatter(std::fmod(t, 0.1) < 0.05 ? 930.0 : 985.0);  // half a spindle frequency apart
      step();
    }
  };
  in_.vibration = 300.0;
  wander(3.0);
  EXPECT_EQ(targets_.size(), 1u) << "not louder than what was struck at";
  in_.vibration = 6000.0;
  wander(3.0);
  EXPECT_GE(targets_.size(), 2u);
}

TEST_F(StablePocketTest, AnOnsetThatGrowsAfterTheMoveIsChatter) {
  chatter(936.0);
  run(1.5);
  const std::size_t before = targets_.size();
  for (int i = 0; i < 100; ++i) {
    chatter(910.0, std::min(0.9, 0.02 * std::exp(0.06 * i)), CutState::Onset);
    step();
  }
  EXPECT_GT(targets_.size(), before);
}

TEST_F(StablePocketTest, WhatRingsDownIsNotJudged) {
  chatter(936.0);
  run(0.3);
  for (int i = 0; i < 300; ++i) {
    chatter(930.0, 0.8 * std::exp(-0.02 * i));
    step();
  }
  EXPECT_EQ(targets_.size(), 1u);
}

TEST_F(StablePocketTest, AToothHarmonicLeftByALaggingCombIsNotChatter) {
  chatter(936.0);
  run(0.3);
  for (int i = 0; i < 500; ++i) {
    chatter(2.0 * toothPassing(in_.machine.actualSpeed, 4).value, 0.6);
    step();
  }
  EXPECT_EQ(targets_.size(), 1u);
}

TEST_F(StablePocketTest, GivesUpAfterAFewSpeedsAndSaysSo) {
  for (int i = 0; i < 3000; ++i) {
    chatter(2.3 * toothPassing(in_.machine.actualSpeed, 4).value);  // wherever it goes, it chatters
    const OverrideRequest r = step();
    if (r.reason.code == ReasonCode::NoStableSpeedTried) {
      EXPECT_EQ(r.kind, RequestKind::Release);
    }
  }
  EXPECT_GE(targets_.size(), 2u);
  EXPECT_LE(targets_.size(), 3u);
  EXPECT_NEAR(in_.machine.actualSpeed.value, 8500.0, 1.0);
  const Reason said = step().reason;
  EXPECT_EQ(said.code, ReasonCode::NoStableSpeedTried);
  EXPECT_EQ(said.n[0], static_cast<double>(targets_.size()));
  for (std::size_t i = 1; i < targets_.size(); ++i) {
    EXPECT_GT(std::abs((targets_[i] - targets_[i - 1]).value), 0.01 * targets_[i].value);
  }
}

// What was cut without an alarm before counts for nothing; from the first alarm on every millimetre does.
TEST_F(StablePocketTest, GivingUpTellsHowFarBackTheDepthWasStillCarried) {
  in_.machine.actualFeed = fromMmPerMin(1200.0);  // 20 mm/s
  run(5.0);
  double seconds = 0.0;
  OverrideRequest r;
  while (r.reason.code != ReasonCode::NoStableSpeedTried && seconds < 30.0) {
    chatter(2.3 * toothPassing(in_.machine.actualSpeed, 4).value);
    r = step();
    seconds += kBlock.value;
  }
  ASSERT_EQ(r.reason.code, ReasonCode::NoStableSpeedTried);
  EXPECT_NEAR(r.reason.n[2], 20.0 * seconds, 0.5);
}

TEST_F(StablePocketTest, KnownLobesMoveTheTargetInside) {
  // The rule's 7020 rpm lies outside the stable range: the range's own best place is taken.
  setup_.stableSpeeds = StableSpeeds{Metres(1.5e-3), {{Rpm(6500.0), Rpm(6950.0), Rpm(6800.0)}}, {}, {}};
  strategy_.prepare(setup_, {});
  chatter(936.0);
  const OverrideRequest r = run(0.2);
  EXPECT_EQ(r.reason.code, ReasonCode::PocketByLobes);
  EXPECT_NEAR(r.speed.value, 6800.0, 1e-6);
  setup_.stableSpeeds->ranges[0] = {Rpm(6500.0), Rpm(7600.0), Rpm(7200.0)};
  strategy_.prepare(setup_, {});
  in_.machine.actualSpeed = Rpm(8500.0);
  EXPECT_NEAR(run(0.2).speed.value, 7020.0, 1e-6);
}

TEST_F(StablePocketTest, WhereTheLobesHaveNoSpeedItNamesTheDepthAndDoesNotMove) {
  setup_.stableSpeeds = StableSpeeds{Metres(1.5e-3), {}, Rpm(7100.0), Metres(1.1e-3)};
  strategy_.prepare(setup_, {});
  chatter(936.0);
  const OverrideRequest r = run(2.0);
  EXPECT_TRUE(targets_.empty());
  EXPECT_EQ(r.reason.code, ReasonCode::NoStableSpeed);
  EXPECT_NEAR(r.reason.n[1], 1.1, 1e-9);
  EXPECT_NEAR(r.reason.n[2], 7100.0, 1e-9);
}

TEST_F(StablePocketTest, ATargetDoesNotSurviveTheOperatorTakingTheMachineBack) {
  chatter(936.0);
  run(0.3);
  quiet();
  EXPECT_EQ(run(1.0).kind, RequestKind::Set);
  strategy_.relinquish();
  EXPECT_EQ(run(1.0).kind, RequestKind::None);
  chatter(936.0);  // it chatters again: that is a new decision
  EXPECT_EQ(run(0.3).kind, RequestKind::Set);
}

// At the new speed the chatter is so loud that the sensor is at its limit: the gate holds, then lets go, and takes up a
// wish again after its rest. That speed has been tried.
TEST_F(StablePocketTest, ASpeedThatTheGateHadToLetGoOfIsNotGoneToAgain) {
  chatter(936.0);
  run(0.4);
  ASSERT_EQ(targets_.size(), 1u);
  chatter(1010.0, 0.8);
  run(0.2);
  in_.verdict.valid = false;
  EXPECT_EQ(run(0.5).kind, RequestKind::Hold);
  in_.machine.actualSpeed = in_.machine.programmedSpeed;  // the gate's release
  EXPECT_EQ(run(0.1).kind, RequestKind::None);
  in_.verdict.valid = true;
  chatter(936.0);
  EXPECT_EQ(step().kind, RequestKind::None);
  run(3.0);
  ASSERT_GE(targets_.size(), 2u);
  for (std::size_t i = 1; i < targets_.size(); ++i) {
    EXPECT_GT(std::abs((targets_[i] - targets_[0]).value), 0.01 * targets_[0].value);
  }
}

// Chatter so hard that its torque shakes the spindle by 3 %: the speed was reached, and it is judged.
TEST_F(StablePocketTest, ChatterThatShakesTheSpindleIsJudgedAllTheSame) {
  chatter(936.0);
  run(0.4);
  ASSERT_EQ(targets_.size(), 1u);
  for (int i = 0; i < 300 && targets_.size() == 1u; ++i) {
    chatter(1010.0, 0.9);
    in_.machine.actualSpeed = targets_[0] * (1.0 + 0.03 * std::sin(0.9 * i));
    step();
  }
  EXPECT_GE(targets_.size(), 2u);
}

// Chatter so loud that the sensor is at its limit every tenth of a second: it is judged from what lies between.
TEST_F(StablePocketTest, ASensorAtItsLimitNowAndThenDoesNotHideTheChatter) {
  chatter(936.0);
  run(0.4);
  for (int i = 0; i < 300 && targets_.size() == 1u; ++i) {
    chatter(1010.0, 0.9);
    in_.verdict.valid = i % 10 < 7;
    if (!in_.verdict.valid) in_.verdict.reason = {ReasonCode::InputClipped, {}};
    const OverrideRequest r = step();
    if (!in_.verdict.valid) {
      EXPECT_NE(r.kind, RequestKind::Set);
    }
  }
  EXPECT_GE(targets_.size(), 2u);
}

// A spindle that loses 2 % under load never is where it was sent; it is judged where it stands.
TEST_F(StablePocketTest, ASpindleThatSlipsIsJudgedWhereItStands) {
  chatter(936.0);
  while (targets_.empty()) step();
  in_.machine.speedOverride = Ratio(targets_[0] / in_.machine.programmedSpeed);
  chatter(1010.0, 0.9);
  for (int i = 0; i < 400 && targets_.size() == 1u; ++i) {
    in_.machine.actualSpeed = targets_[0] * 0.98;
    step();
  }
  EXPECT_GE(targets_.size(), 2u);
}

// While the order is not in force yet, a spindle that stands is on its way all the same.
TEST_F(StablePocketTest, ASpindleThatWaitsHalfwayIsNotJudged) {
  chatter(936.0);
  while (targets_.empty()) step();
  chatter(1010.0, 0.9);
  in_.machine.speedOverride = Ratio(0.9);
  for (int i = 0; i < 400; ++i) {
    in_.machine.actualSpeed = in_.machine.programmedSpeed * 0.9;
    step();
  }
  EXPECT_EQ(targets_.size(), 1u);
}

// The operator's knob at 60 %: 7020 rpm is out of reach now, and chatter at the speed in force is judged for itself.
TEST_F(StablePocketTest, ATargetThatAKnobPutsOutOfReachIsGivenUp) {
  chatter(936.0);
  while (targets_.empty()) step();
  in_.machine.operatorSpeed = Ratio(0.6);
  in_.machine.speedOverride = Ratio(0.6);
  chatter(905.0, 0.9);
  const Rpm highest = in_.machine.programmedSpeed * (0.6 * 1.2);
  for (int i = 0; i < 400 && targets_.size() == 1u; ++i) {
    in_.machine.actualSpeed = in_.machine.programmedSpeed * 0.6;
    step();
  }
  ASSERT_GE(targets_.size(), 2u);
  EXPECT_LE(targets_[1].value, highest.value + 1e-6);
}

// A link that was lost at a speed that was quiet says nothing against that speed.
TEST_F(StablePocketTest, AQuietSpeedThatWasLetGoOfIsGoneToAgain) {
  chatter(936.0);
  run(0.4);
  quiet();
  run(1.0);
  in_.machine.valid = false;
  run(0.5);
  in_.machine.valid = true;
  in_.machine.actualSpeed = in_.machine.programmedSpeed;
  const OverrideRequest r = step();
  EXPECT_EQ(r.kind, RequestKind::Set);
  EXPECT_EQ(r.speed, targets_[0]);
  EXPECT_EQ(targets_.size(), 1u);
}

TEST_F(StablePocketTest, UnusableVerdictsAreNeverASet) {
  in_.verdict.valid = false;
  EXPECT_EQ(step().kind, RequestKind::None);
  in_.verdict.valid = true;
  chatter(936.0);
  run(0.2);
  in_.verdict.valid = false;
  EXPECT_EQ(step().kind, RequestKind::Hold);
}

TEST_F(StablePocketTest, AdviceThatNobodyTakesIsMadeUpAnewAndCostsNoTry) {
  chatter(936.0);
  for (int i = 0; i < 1500; ++i) {
    in_.now += toDuration(kBlock);
    const OverrideRequest r = strategy_.decide(in_);  // the spindle stays where it is
    ASSERT_NE(r.kind, RequestKind::Release);
    ASSERT_NE(r.reason.code, ReasonCode::KeepingSpeed) << "that nobody has reached";
  }
  EXPECT_EQ(strategy_.decide(in_).reason.code, ReasonCode::CentreOfNextPocket);
}

}  // namespace
}  // namespace stillcut::control
