// Fault scripts in virtual time: each bad thing is held, then released, and is remembered.
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/gate_harness.h"

namespace stillcut::safety {
namespace {

using testing::GateHarness;
using testing::promptLimits;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Settled at 90 %, then something goes wrong: nothing moves, and within the hold time plus `patience` it is released.
void expectHoldThenRelease(void (*bend)(GateHarness&), ReasonCode reason, double patience = 0.0) {
  SCOPED_TRACE(identifier(reason));
  GateHarness h;
  h.settleAt(9000, 900);
  h.commands.clear();
  bend(h);
  bool released = false;
  bool held = false;
  for (int i = 0; i < static_cast<int>((0.6 + patience) / GateHarness::kDt) && !released; ++i) {
    h.step();
    released = h.lastCommand().kind == CommandKind::Release;
    if (released) continue;
    held = true;
    EXPECT_EQ(h.lastCommand().speed.value, h.commands.front().speed.value);
  }
  EXPECT_TRUE(held);
  EXPECT_TRUE(released);
  EXPECT_TRUE(h.said(reason));
  h.commands.clear();
  h.run(1.0);
  EXPECT_TRUE(h.commands.empty());
}

TEST(GateFaults, StaleMachineState) {
  expectHoldThenRelease([](GateHarness& h) { h.freshMachine = false; }, ReasonCode::GateStaleMachine, 0.4);
}
TEST(GateFaults, StaleVerdict) {
  expectHoldThenRelease([](GateHarness& h) { h.freshVerdict = false; }, ReasonCode::GateStaleVerdict, 0.4);
}
TEST(GateFaults, StaleRequest) {
  expectHoldThenRelease([](GateHarness& h) { h.freshRequest = false; }, ReasonCode::GateStaleRequest, 0.4);
}
TEST(GateFaults, LinkDown) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.linkUp = false; }, ReasonCode::LinkLost);
}
TEST(GateFaults, MachineNeverRead) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.valid = false; }, ReasonCode::GateMachineInvalid);
}
TEST(GateFaults, OverridesLocked) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.overridesEnabled = false; }, ReasonCode::GateMachineLocked);
}
TEST(GateFaults, AnotherClientTookControl) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.controlOurs = false; }, ReasonCode::GateControlLost);
}
TEST(GateFaults, ProgramStopped) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.programRunning = false; }, ReasonCode::GateMachineNotReady);
}
TEST(GateFaults, DetectorFails) {
  expectHoldThenRelease([](GateHarness& h) { h.verdict.valid = false; }, ReasonCode::GateVerdictInvalid);
}
TEST(GateFaults, DetectorSaysNaN) {
  expectHoldThenRelease([](GateHarness& h) { h.verdict.frequency = Hertz(kNan); }, ReasonCode::GateVerdictInvalid);
}
TEST(GateFaults, StrategyReturnsNaN) {
  expectHoldThenRelease([](GateHarness& h) { h.ask(kNan, 900); }, ReasonCode::GateNotFinite);
  expectHoldThenRelease([](GateHarness& h) { h.ask(9000, kNan); }, ReasonCode::GateNotFinite);
}
TEST(GateFaults, StrategyAsksForTheMoon) {
  expectHoldThenRelease([](GateHarness& h) { h.ask(1e7, 900); }, ReasonCode::GateNotFinite);
  expectHoldThenRelease([](GateHarness& h) { h.ask(-9000, 900); }, ReasonCode::GateNotFinite);
}
TEST(GateFaults, MachineStateIsNotANumber) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.operatorFeed = Ratio(kNan); }, ReasonCode::GateMachineInvalid);
}
TEST(GateFaults, MeasuredTimeIsNotANumber) {
  expectHoldThenRelease([](GateHarness& h) { h.dt = Seconds(kNan); }, ReasonCode::GateClockFault);
}
TEST(GateFaults, SpeedReadbackFreezes) {
  // The spindle goes on reporting the programmed speed although the override was taken.
  GateHarness h;
  h.settleAt(9000, 900);
  h.commands.clear();
  h.machineFollows = false;
  h.machine.actualSpeed = Rpm(10000.0);
  h.run(5.7);
  EXPECT_TRUE(h.said(ReasonCode::GateNotFollowing));
  EXPECT_TRUE(h.released());
}
TEST(GateFaults, ProgramResetsTheOverride) {
  GateHarness h;
  h.settleAt(9000, 900);
  h.commands.clear();
  h.machineFollows = false;
  h.machine.speedOverride = h.machine.feedOverride = Ratio(1.0);
  h.machine.actualSpeed = Rpm(10000.0);
  h.run(1.6);
  EXPECT_TRUE(h.said(ReasonCode::GateOverrideNotTaken));
  EXPECT_TRUE(h.released());
}

TEST(GateFaults, LinkDiesMidRamp) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Auto);
  h.ask(8000, 800);
  h.run(0.05);
  const double there = h.lastCommand().speed.value;
  ASSERT_GT(there, 0.81);
  ASSERT_LT(there, 1.0);
  h.machine.linkUp = false;
  h.freshMachine = false;
  h.run(0.4);
  EXPECT_EQ(h.lastCommand().speed.value, there);
  h.run(0.2);
  EXPECT_EQ(h.lastCommand().kind, CommandKind::Release);
  EXPECT_GT(h.flights, 1);
}

TEST(GateFaults, AFlappingLinkDoesNotKeepTheOverridesForever) {
  GateHarness h;
  h.settleAt(9000, 900);
  bool released = false;
  for (int i = 0; i < 500 && !released; ++i) {
    h.machine.linkUp = i % 5 == 0;  // good one step in five
    h.step();
    released = !h.last.commanding;
  }
  EXPECT_TRUE(released);
}

TEST(GateFaults, OperatorGrabsTheKnob) {
  GateHarness h;
  h.settleAt(9000, 900);
  h.machine.operatorSpeed = Ratio(0.8);
  h.step();
  EXPECT_TRUE(h.said(ReasonCode::GateKnobMoved));
  h.verdict.state = CutState::Stable;
  h.run(1.0);
  // The knob scales the product; we do not work against it.
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  h.run(3.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  // Only chatter, and only with the knob at rest, justifies the absolute speed again: 9000 of 8000 is 112.5 %.
  h.verdict.state = CutState::Chatter;
  h.run(2.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 1.125, 1e-9);
}

TEST(GateFaults, AKnobThatPushesTheProductOutIsMetAtOnce) {
  GateHarness h;
  h.settleAt(11500, 1150);
  ASSERT_NEAR(h.lastCommand().speed.value, 1.15, 1e-9);
  h.machine.operatorSpeed = Ratio(1.1);
  h.step();
  EXPECT_NEAR(h.lastCommand().speed.value, 1.2 / 1.1, 1e-9);
  h.machine.operatorSpeed = Ratio(1.3);  // out by the operator's own hand: ours is 100 %, not less
  h.step();
  EXPECT_EQ(h.lastCommand().speed.value, 1.0);
}

TEST(GateFaults, AWorkerThatSleptThroughItsLeaseStartsAgain) {
  GateHarness h;
  h.settleAt(9000, 900);
  const std::uint64_t engagement = h.lastCommand().engagement;
  h.now += toDuration(Seconds(1.0));
  EXPECT_EQ(h.step().command->kind(), CommandKind::Release);
  EXPECT_TRUE(h.said(ReasonCode::LeaseExpired));
  h.run(3.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  EXPECT_GT(h.lastCommand().engagement, engagement);
}

TEST(GateFaults, TimeThatGoesBackOrStandsStillReleases) {
  for (const double jump : {-5.0, -GateHarness::kDt}) {
    GateHarness h;
    h.settleAt(9000, 900);
    h.now += toDuration(Seconds(jump));
    EXPECT_EQ(h.step().command->kind(), CommandKind::Release);
    EXPECT_TRUE(h.said(ReasonCode::GateClockFault));
  }
}

TEST(GateFaults, AfterAReleaseTheInputMustBeGoodForAWhile) {
  GateLimits limits = promptLimits();
  limits.restTime = Seconds(1.0);
  GateHarness h(limits);
  h.settleAt(9000, 900);
  h.run(1.0);
  h.machine.linkUp = false;
  h.run(1.0);
  ASSERT_FALSE(h.last.commanding);
  h.machine.linkUp = true;
  h.run(0.9);
  EXPECT_FALSE(h.last.commanding);
  EXPECT_EQ(h.last.reason.code, ReasonCode::GateResting);
  h.run(0.3);
  EXPECT_TRUE(h.last.commanding);
}

TEST(GateFaults, AStrategyThatFailedLosesTheMachineAtOnceAndForGood) {
  GateHarness h;
  h.settleAt(9000, 900);
  h.causes.clear();
  h.events.clear();
  h.strategyFailed = true;
  h.request = {};
  EXPECT_EQ(h.step().command->kind(), CommandKind::Release);  // not the slow way back
  EXPECT_EQ(h.causes, std::vector<ReasonCode>{ReasonCode::StrategyFault});
  ASSERT_FALSE(h.events.empty());
  EXPECT_EQ(h.events.front().reason.code, ReasonCode::StrategyFault);
  EXPECT_EQ(h.events.front().level, EventLevel::Fault);
  h.commands.clear();
  h.events.clear();
  h.run(3.0);
  EXPECT_TRUE(h.commands.empty());
  EXPECT_TRUE(h.events.empty());
}

TEST(GateFaults, AStrategyThatFailsWithNothingInForceIsSaidToo) {
  GateHarness h;
  h.strategyFailed = true;
  h.run(1.0);
  EXPECT_EQ(h.events.size(), 1U);
  EXPECT_EQ(h.causes, std::vector<ReasonCode>{ReasonCode::StrategyFault});
  EXPECT_TRUE(h.commands.empty());
}

TEST(GateFaults, AnEngagementThatTheLinkEndedIsOver) {
  GateHarness h;
  h.settleAt(9000, 900);
  const std::uint64_t engagement = h.lastCommand().engagement;
  h.causes.clear();
  h.machine.endedEngagement = engagement - 1;  // an older one
  h.run(0.1);
  EXPECT_TRUE(h.last.commanding);
  h.machine.endedEngagement = engagement;
  EXPECT_EQ(h.step().command->kind(), CommandKind::Release);
  EXPECT_TRUE(h.said(ReasonCode::LeaseExpired));
  EXPECT_EQ(h.causes, std::vector<ReasonCode>{ReasonCode::LeaseExpired});
  h.run(3.0);  // the link says so for ever; the next engagement is another one
  EXPECT_TRUE(h.last.commanding);
  EXPECT_EQ(h.lastCommand().engagement, engagement + 1);
  EXPECT_EQ(h.causes.size(), 1U);
}

}  // namespace
}  // namespace stillcut::safety
