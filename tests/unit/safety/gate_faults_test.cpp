// Fault scripts in virtual time: each bad thing is held, then released, and is remembered.
#include <gtest/gtest.h>

#include <limits>

#include "core/safety/gate_checks.h"
#include "tests/support/gate_harness.h"

namespace stillcut::safety {
namespace {

using testing::GateHarness;
using testing::promptLimits;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// How the programmed values come back: by the ramp, or at once where nothing can be steered any more.
enum class Home { ByRamp, AtOnce };

// Settled at 90 %, then something goes wrong: nothing moves for the hold time (and `patience`), then it is given back.
void expectHoldThenRelease(void (*bend)(GateHarness&), ReasonCode reason, Home home, double patience = 0.0) {
  SCOPED_TRACE(identifier(reason));
  GateHarness h;
  h.settleAt(9000, 900);
  h.commands.clear();
  bend(h);
  while (!h.released() && h.commands.size() < 500) h.step();
  ASSERT_TRUE(h.released());
  EXPECT_TRUE(h.said(reason));
  std::size_t held = 0;
  while (h.commands[held].kind == CommandKind::Set && h.commands[held].speed == h.commands[0].speed) ++held;
  EXPECT_NEAR(static_cast<double>(held) * GateHarness::kDt, 0.5 + patience, 0.05);
  if (home == Home::ByRamp) {
    h.expectHomeByRamp(held - 1);
  } else {
    EXPECT_EQ(h.commands[held].kind, CommandKind::Release);
  }
  h.commands.clear();
  h.run(1.0);
  EXPECT_TRUE(h.commands.empty());
}

TEST(GateFaults, StaleMachineState) {
  expectHoldThenRelease([](GateHarness& h) { h.freshMachine = false; }, ReasonCode::GateStaleMachine, Home::AtOnce,
                        0.3);
}
// Read while the block still waited in a sound card's buffer.
TEST(GateFaults, AMachineStateAFewTenthsAheadIsFresh) {
  MachineState m = GateHarness().machine;
  m.valid = m.linkUp = m.programRunning = m.overridesEnabled = m.controlOurs = true;
  const Instant now = instantFromNs(10'000'000'000);
  m.time = now + toDuration(Seconds(0.26));
  EXPECT_EQ(checkMachine(m, now, Seconds(0.1)).code, ReasonCode::None);
  m.time = now + toDuration(Seconds(1.5));
  EXPECT_EQ(checkMachine(m, now, Seconds(0.1)).code, ReasonCode::GateStaleMachine);
  m.time = now - toDuration(Seconds(0.26));
  EXPECT_EQ(checkMachine(m, now, Seconds(0.1)).code, ReasonCode::GateStaleMachine);
}
TEST(GateFaults, StaleVerdict) {
  expectHoldThenRelease([](GateHarness& h) { h.freshVerdict = false; }, ReasonCode::GateStaleVerdict, Home::ByRamp,
                        0.3);
}
TEST(GateFaults, StaleRequest) {
  expectHoldThenRelease([](GateHarness& h) { h.freshRequest = false; }, ReasonCode::GateStaleRequest, Home::ByRamp,
                        0.3);
}
TEST(GateFaults, LinkDown) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.linkUp = false; }, ReasonCode::LinkLost, Home::AtOnce);
}
TEST(GateFaults, MachineNeverRead) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.valid = false; }, ReasonCode::GateMachineInvalid, Home::AtOnce);
}
TEST(GateFaults, OverridesLocked) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.overridesEnabled = false; }, ReasonCode::GateMachineLocked,
                        Home::AtOnce);
}
TEST(GateFaults, AnotherClientTookControl) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.controlOurs = false; }, ReasonCode::GateControlLost,
                        Home::AtOnce);
}
TEST(GateFaults, ProgramStopped) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.programRunning = false; }, ReasonCode::GateMachineNotReady,
                        Home::ByRamp);
}
TEST(GateFaults, DetectorFails) {
  expectHoldThenRelease([](GateHarness& h) { h.verdict.valid = false; }, ReasonCode::GateVerdictInvalid, Home::ByRamp);
}
TEST(GateFaults, DetectorSaysNaN) {
  expectHoldThenRelease([](GateHarness& h) { h.verdict.frequency = Hertz(kNan); }, ReasonCode::GateVerdictInvalid,
                        Home::ByRamp);
}
TEST(GateFaults, StrategyReturnsNaN) {
  expectHoldThenRelease([](GateHarness& h) { h.ask(kNan, 900); }, ReasonCode::GateNotFinite, Home::ByRamp);
  expectHoldThenRelease([](GateHarness& h) { h.ask(9000, kNan); }, ReasonCode::GateNotFinite, Home::ByRamp);
}
TEST(GateFaults, StrategyAsksForTheMoon) {
  expectHoldThenRelease([](GateHarness& h) { h.ask(1e7, 900); }, ReasonCode::GateNotFinite, Home::ByRamp);
  expectHoldThenRelease([](GateHarness& h) { h.ask(-9000, 900); }, ReasonCode::GateNotFinite, Home::ByRamp);
}
TEST(GateFaults, MachineStateIsNotANumber) {
  expectHoldThenRelease([](GateHarness& h) { h.machine.operatorFeed = Ratio(kNan); }, ReasonCode::GateMachineInvalid,
                        Home::AtOnce);
}
TEST(GateFaults, MeasuredTimeIsNotANumber) {
  expectHoldThenRelease([](GateHarness& h) { h.dt = Seconds(kNan); }, ReasonCode::GateClockFault, Home::AtOnce, 0.5);
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
// Never taken: from where would it be moved? Given back at once.
TEST(GateFaults, AnOverrideThatIsNeverTakenIsGivenBack) {
  GateHarness h;
  h.machineFollows = false;
  h.settleAt(9000, 900);
  h.run(1.0);
  EXPECT_TRUE(h.said(ReasonCode::GateOverrideNotTaken));
  EXPECT_FALSE(h.said(ReasonCode::GateOverrideReset));
  ASSERT_TRUE(h.released());
}

// A script puts the overrides back to 100 %: they are the machine's, nothing is locked.
class OverridesGone : public ::testing::Test {
 protected:
  void SetUp() override {
    h_.settleAt(9000, 900);
    h_.commands.clear();
    h_.events.clear();
    h_.causes.clear();
    h_.machineFollows = false;
    h_.machine.speedOverride = h_.machine.feedOverride = Ratio(1.0);
    h_.machine.actualSpeed = Rpm(10000.0);
  }
  GateHarness h_;
};

TEST_F(OverridesGone, AResetIsSaidAsOneAndNotFought) {
  h_.run(2.1);
  EXPECT_TRUE(h_.said(ReasonCode::GateOverrideReset));
  EXPECT_FALSE(h_.said(ReasonCode::GateMachineLocked));
  EXPECT_FALSE(h_.said(ReasonCode::GateOverrideNotTaken));
  EXPECT_EQ(h_.causes, std::vector<ReasonCode>{ReasonCode::GateOverrideReset});
  ASSERT_TRUE(h_.released());
  EXPECT_FALSE(h_.last.commanding);
}

TEST_F(OverridesGone, M49IsALockAlsoWhereTheLinkHasToFindOutByItself) {
  h_.run(1.55);  // as long as that takes (cnc/lock_judge.h); until then both look the same
  EXPECT_TRUE(h_.events.empty());
  h_.machine.overridesEnabled = false;
  h_.run(2.0);
  EXPECT_TRUE(h_.said(ReasonCode::GateMachineLocked));
  EXPECT_FALSE(h_.said(ReasonCode::GateOverrideReset));
  EXPECT_FALSE(h_.said(ReasonCode::GateOverrideNotTaken));
  ASSERT_TRUE(h_.released());
  h_.machine.overridesEnabled = true;  // M48: it does not jump back to where it was
  h_.step();
  EXPECT_FALSE(h_.last.commanding);
}

TEST_F(OverridesGone, AResetOfTheSpeedAloneIsOneToo) {
  h_.machine.feedOverride = Ratio(0.9);
  h_.run(2.1);
  EXPECT_TRUE(h_.said(ReasonCode::GateOverrideReset));
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
  EXPECT_TRUE(h.said(ReasonCode::GateOperatorOverrideMoved));
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
  limits.reengageDelay = Seconds(1.0);
  GateHarness h(limits);
  h.settleAt(9000, 900);
  h.run(1.0);
  h.machine.linkUp = false;
  h.run(1.0);
  ASSERT_FALSE(h.last.commanding);
  h.machine.linkUp = true;
  h.run(0.9);
  EXPECT_FALSE(h.last.commanding);
  EXPECT_EQ(h.last.reason.code, ReasonCode::GateReengageDelay);
  h.run(0.3);
  EXPECT_TRUE(h.last.commanding);
}

TEST(GateFaults, AStrategyThatFailedLosesTheMachineForGood) {
  GateHarness h;
  h.settleAt(9000, 900);
  h.causes.clear();
  h.events.clear();
  h.commands.clear();
  h.strategyFailed = true;
  h.request = {};
  h.run(1.0);
  h.expectHomeByRamp(0);
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
