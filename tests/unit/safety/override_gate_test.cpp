// The gate's rules, one by one, in virtual time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/gate_harness.h"

namespace stillcut::safety {
namespace {

using testing::GateHarness;
using testing::promptLimits;

TEST(OverrideGate, AuthorityIsOffAfterEveryStartAndNothingIsCommanded) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.ask(9000, 900);
  h.run(1.0);
  EXPECT_EQ(h.last.authority, Authority::Off);
  EXPECT_TRUE(h.commands.empty());
  EXPECT_EQ(h.last.reason.code, ReasonCode::AuthorityOff);

  h.authority(Authority::Auto);
  h.run(1.0);
  ASSERT_TRUE(h.gate.commanding());
  h.gate.prepare(promptLimits());
  EXPECT_EQ(h.gate.authority(), Authority::Off);
  EXPECT_EQ(h.step().command->kind(), CommandKind::Release);  // what was in force is not forgotten
}

TEST(OverrideGate, AutoIsRefusedWhereTheSetUpDidNotGrantIt) {
  GateLimits limits = promptLimits();
  limits.autoAllowed = false;
  GateHarness h(limits);
  h.ask(9000, 900);
  const GateOutput out = h.authority(Authority::Auto);
  EXPECT_EQ(out.authority, Authority::Off);
  EXPECT_TRUE(h.said(ReasonCode::AutoNotAllowed));
  EXPECT_TRUE(out.flight);
  h.run(1.0);
  EXPECT_TRUE(h.commands.empty());
}

TEST(OverrideGate, AutoReachesTheWishAndRenewsItsLeaseEveryStep) {
  GateHarness h;
  h.settleAt(9000, 900);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  EXPECT_NEAR(h.lastCommand().feed.value, 0.9, 1e-9);
  const std::uint64_t before = h.lastCommand().sequence;
  h.run(0.1);
  EXPECT_EQ(h.lastCommand().sequence, before + 10);
  EXPECT_EQ(h.lastCommand().lease, toDuration(Seconds(0.2)));
  EXPECT_EQ(h.last.reason.code, ReasonCode::GateInForce);
}

TEST(OverrideGate, HoldKeepsThePresentOverridesUntilItEnds) {
  GateHarness h;
  h.settleAt(9000, 900);
  h.act(OperatorAction::Hold);
  h.ask(8000, 800);
  h.run(2.0);
  EXPECT_TRUE(h.last.operatorHold);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  h.act(OperatorAction::EndHold);
  h.run(1.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.8, 1e-9);
}

TEST(OverrideGate, TrimsToTheOverrideRangeAndSaysSo) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Auto);
  h.ask(13000, 1300);
  h.step();
  EXPECT_EQ(h.last.reason.code, ReasonCode::GateLimited);
  h.run(2.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 1.2, 1e-9);
  EXPECT_NEAR(h.lastCommand().feed.value, 1.2, 1e-9);
}

TEST(OverrideGate, NeverExceedsTheToolsSpeed) {
  GateLimits limits = promptLimits();
  limits.overrides.fastest = Rpm(10500.0);
  GateHarness h(limits);
  h.settleAt(11800, 1000);
  EXPECT_NEAR(h.lastCommand().speed.value, 1.05, 1e-9);
}

TEST(OverrideGate, TheProductWithTheOperatorsKnobStaysInside) {
  GateHarness h;
  h.machine.operatorSpeed = Ratio(1.1);
  h.run(3.0);
  h.settleAt(12500, 1000);
  EXPECT_NEAR(h.lastCommand().speed.value * 1.1, 1.2, 1e-9);
}

TEST(OverrideGate, OurOverridesNeverRaiseTheFeedPerTooth) {
  GateHarness h;
  h.settleAt(9000, 1000);  // slower spindle, same feed: more per tooth
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  EXPECT_NEAR(h.lastCommand().feed.value, 0.9, 1e-9);
  for (const CommandRecord& c : h.commands) EXPECT_LE(c.feed.value, c.speed.value + 1e-12);

  GateLimits limits = promptLimits();
  limits.overrides.feedPerTooth = 1.2;
  GateHarness allowed(limits);
  allowed.settleAt(9000, 1000);
  EXPECT_NEAR(allowed.lastCommand().feed.value, 1.0, 1e-9);
}

TEST(OverrideGate, WaitsForSpeedCutAndFeedBeforeTakingTheOverrides) {
  const auto commandsWhen = [](void (*bend)(GateHarness&)) {
    GateHarness h;
    h.machineFollows = false;
    bend(h);
    h.verdict.valid = true;
    h.authority(Authority::Auto);
    h.ask(9000, 900);
    h.run(1.0);
    return h.commands.size();
  };
  EXPECT_EQ(commandsWhen([](GateHarness& h) { h.machine.atSpeed = false; }), 0U);
  EXPECT_EQ(commandsWhen([](GateHarness& h) { h.machine.actualSpeed = Rpm(6000); }), 0U);
  EXPECT_EQ(commandsWhen([](GateHarness& h) { h.verdict.state = CutState::AirCutting; }), 0U);
  EXPECT_EQ(commandsWhen([](GateHarness& h) { h.machine.programRunning = false; }), 0U);
  EXPECT_EQ(commandsWhen([](GateHarness& h) { h.machine.feedHold = true; }), 0U);
  EXPECT_GT(commandsWhen([](GateHarness&) {}), 0U);
}

TEST(OverrideGate, ANewProgrammedSpeedStartsAgainFrom100Percent) {
  GateHarness h;
  h.settleAt(9000, 900);
  const std::uint64_t engagement = h.lastCommand().engagement;
  h.machine.programmedSpeed = Rpm(8000);
  h.request.kind = RequestKind::None;
  const std::size_t first = h.commands.size() - 1;
  h.step();
  EXPECT_TRUE(h.said(ReasonCode::GateProgramChanged));
  h.run(1.0);
  h.expectHomeByRamp(first);
  h.ask(7200, 900);
  h.run(1.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  EXPECT_EQ(h.lastCommand().engagement, engagement + 1);
}

TEST(OverrideGate, RecoversAtMostOneFifthAsFastAsItMovedAway) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Auto);
  h.ask(8000, 800);
  const auto stepsToArrive = [&](double speed) {
    int steps = 0;
    while (!h.last.commanding || std::abs(h.lastCommand().speed.value - speed) > 1e-9) {
      h.step();
      if (++steps > 10000) break;
    }
    return steps;
  };
  const int away = stepsToArrive(0.8);
  h.run(1.0);
  h.verdict.state = CutState::Stable;
  h.ask(9900, 990);
  const int back = stepsToArrive(0.99);
  EXPECT_LE(away, 22);  // 20 points at 100 %/s, a step to begin, a step for the feed to go first
  EXPECT_GE(back, 95);  // 19 points at 20 %/s
  EXPECT_LT(back, 110);
}

TEST(OverrideGate, AStrategysReleaseGoesBackSlowlyAndThenLetsGo) {
  GateHarness h;
  h.settleAt(9000, 900);
  h.verdict.state = CutState::Stable;
  h.request.kind = RequestKind::Release;
  h.run(0.25);
  EXPECT_LT(h.lastCommand().speed.value, 0.96);  // 20 % of 100 %/s
  h.run(1.5);
  EXPECT_FALSE(h.last.commanding);
  EXPECT_EQ(h.lastCommand().kind, CommandKind::Release);
}

TEST(OverrideGate, ChangesPerMinuteAreBoundedThenItCoolsDownThenOnlyAdvises) {
  GateLimits limits = promptLimits();
  limits.changesPerMinute = 4;
  limits.coolDown = Seconds(5.0);
  GateHarness h(limits);
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Auto);
  int turns = 0;
  double before = 1.0;
  int way = 0;
  for (int i = 0; i < 12000; ++i) {  // two minutes of a law that hunts
    h.ask(i / 100 % 2 == 0 ? 9000 : 9500, 900);
    h.step();
    if (h.commands.empty() || h.lastCommand().kind != CommandKind::Set) continue;
    const double d = h.lastCommand().speed.value - before;
    before = h.lastCommand().speed.value;
    const int now = d > 1e-9 ? 1 : d < -1e-9 ? -1 : way;
    if (now != way) ++turns;
    way = now;
  }
  EXPECT_LE(turns, 4);
  EXPECT_TRUE(h.said(ReasonCode::GateChangesPerMinute));
  EXPECT_TRUE(h.said(ReasonCode::AutoWithdrawn));
  EXPECT_EQ(h.last.authority, Authority::Advise);
}

TEST(OverrideGate, TheEdgeIsNotMadeToRubAndTheFeedStaysInItsOwnLimits) {
  GateLimits limits = promptLimits();
  limits.overrides.lowestFeed = Ratio(0.0);
  limits.overrides.lowestFeedPerTooth = 0.6;
  GateHarness h(limits);
  h.settleAt(9000, 0.0);  // a feed hold is the machine's and the operator's, not an override's
  EXPECT_NEAR(h.lastCommand().feed.value, 0.6 * 0.9, 1e-9);
  limits.overrides.slowestFeed = fromMmPerMin(800.0);
  GateHarness floor(limits);
  floor.settleAt(9000, 0.0);
  EXPECT_NEAR(floor.lastCommand().feed.value, 0.8, 1e-9);
}

// Xu's feed hold, where it is allowed: by the ramp and with the spindle turning.
TEST(OverrideGate, TheFeedStopsWhereBothOfItsLimitsAllowIt) {
  GateLimits limits = promptLimits();
  limits.overrides.lowestFeed = Ratio(0.0);
  limits.overrides.lowestFeedPerTooth = 0.0;
  GateHarness h(limits);
  h.settleAt(9000, 0.0);
  EXPECT_NEAR(h.lastCommand().feed.value, 0.0, 1e-9);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
}

TEST(OverrideGate, ALinkThatGoesAndComesBackIsSaidWithNothingInForceToo) {
  GateHarness h;
  h.machine.linkUp = false;
  h.run(1.0);
  h.machine.linkUp = true;
  h.run(1.0);
  int lost = 0, back = 0;
  for (const Event& e : h.events) {
    lost += e.reason.code == ReasonCode::LinkLost ? 1 : 0;
    back += e.reason.code == ReasonCode::LinkBack ? 1 : 0;
  }
  EXPECT_EQ(lost, 1);
  EXPECT_EQ(back, 1);
}

TEST(OverrideGate, SmallWishesAreNotWorthMoving) {
  GateHarness h;
  h.settleAt(9000, 900);
  const double before = h.lastCommand().speed.value;
  h.ask(9040, 904);
  h.run(1.0);
  EXPECT_EQ(h.lastCommand().speed.value, before);
}

TEST(OverrideGate, StepsAreShorterThanTheMeasuredTimeAllows) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Auto);
  h.dt = Seconds(0.004);  // a block that came early: stream time says 10 ms, the measurement 4
  h.ask(8000, 800);
  h.run(0.3);
  for (std::size_t i = 1; i < h.commands.size(); ++i) {
    EXPECT_LE(std::abs(h.commands[i].speed.value - h.commands[i - 1].speed.value), 0.004 + 1e-12);
  }
  EXPECT_GT(h.commands.size(), 20U);
}

TEST(OverrideGate, ClaimsDecideWhatIsDriven) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Auto);
  h.ask(9000, 700);
  h.request.claimsSpeed = false;
  h.run(1.0);
  EXPECT_EQ(h.lastCommand().speed.value, 1.0);
  EXPECT_NEAR(h.lastCommand().feed.value, 0.7, 1e-9);
}

TEST(OverrideGate, ACoolDownIsSaidOnceAndKeepsOneFlight) {
  GateLimits limits = promptLimits();
  limits.changesPerMinute = 1;
  GateHarness h(limits);
  h.settleAt(9000, 900);  // the one change there is
  h.run(1.0);
  h.events.clear();
  h.causes.clear();
  h.ask(9500, 950);
  h.run(10.0);  // half of the cool-down
  EXPECT_EQ(h.last.reason.code, ReasonCode::GateCoolDown);
  EXPECT_EQ(h.events.size(), 1U);
  EXPECT_EQ(h.causes, std::vector<ReasonCode>{ReasonCode::GateChangesPerMinute});
}

// The minute may have room again: until the pause is over no change is made, and then one is.
TEST(OverrideGate, ACoolDownOutlastsTheMinuteThatWasUsedUp) {
  GateLimits limits = promptLimits();
  limits.changesPerMinute = 1;
  limits.coolDown = Seconds(20.0);
  GateHarness h(limits);
  h.settleAt(9000, 900);  // at 0 s
  h.run(53.0);
  h.ask(9500, 950);  // at 55 s: refused until 75 s, though the change of 0 s is forgotten at 60 s
  h.run(15.0);
  EXPECT_EQ(h.last.reason.code, ReasonCode::GateCoolDown);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-6);
  h.run(7.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.95, 1e-6);
  EXPECT_EQ(h.last.authority, Authority::Auto);
}

TEST(OverrideGate, AReleaseFromInsideTheDeadBandArrivesToo) {
  GateHarness h;
  h.settleAt(9000, 900);
  h.ask(9960, 960);  // the speed's way to 100 % is shorter than the dead band
  h.run(2.0);
  ASSERT_NEAR(h.lastCommand().speed.value, 0.996, 1e-9);
  h.request.kind = RequestKind::Release;
  h.run(2.0);
  EXPECT_FALSE(h.last.commanding);
  ASSERT_EQ(h.lastCommand().kind, CommandKind::Release);
  const CommandRecord& before = h.commands[h.commands.size() - 2];
  EXPECT_NEAR(before.speed.value, 1.0, 0.005);
  const std::size_t count = h.commands.size();
  h.run(1.0);
  EXPECT_EQ(h.commands.size(), count);
}

TEST(OverrideGate, AFlightNamesWhatCausedIt) {
  GateHarness h;
  h.settleAt(9000, 900);
  EXPECT_EQ(h.causes, std::vector<ReasonCode>{ReasonCode::AuthorityChanged});
  h.causes.clear();
  h.now += toDuration(Seconds(1.0));  // past the lease
  h.step();
  EXPECT_EQ(h.causes, std::vector<ReasonCode>{ReasonCode::LeaseExpired});
  h.causes.clear();
  GateLimits limits = promptLimits();
  limits.autoAllowed = false;
  GateHarness refused(limits);
  refused.authority(Authority::Auto);
  EXPECT_EQ(refused.causes, std::vector<ReasonCode>{ReasonCode::AutoNotAllowed});
}

}  // namespace
}  // namespace stillcut::safety
