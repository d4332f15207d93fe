// What the gate tells: every fault, refusal and change of authority leaves an event and a flight.
#include <gtest/gtest.h>

#include "tests/support/gate_harness.h"

namespace stillcut::safety {
namespace {

using testing::GateHarness;
using testing::promptLimits;

// With nothing in force a fault is told as well: whoever gave authority counts on it.
TEST(GateTells, TroubleUnderAuthorityIsToldWithNothingInForceToo) {
  const auto told = [](Authority authority, void (*bend)(GateHarness&)) {
    GateHarness h;
    if (authority != Authority::Off) h.authority(authority);
    h.causes.clear();
    h.events.clear();
    bend(h);
    h.run(2.0);
    EXPECT_EQ(h.events.size(), h.causes.size());
    EXPECT_TRUE(h.commands.empty());
    return h.causes;
  };
  using Causes = std::vector<ReasonCode>;
  const auto stale = [](GateHarness& h) { h.freshMachine = false; };
  const auto locked = [](GateHarness& h) { h.machine.overridesEnabled = false; };
  const auto lost = [](GateHarness& h) { h.machine.linkUp = false; };
  const auto mute = [](GateHarness& h) { h.verdict.valid = false; };
  const auto wild = [](GateHarness& h) { h.ask(1e7, 900); };
  const auto timeless = [](GateHarness& h) { h.dt = Seconds(0.0); };
  for (const Authority a : {Authority::Auto, Authority::Advise}) {
    EXPECT_EQ(told(a, stale), Causes{ReasonCode::GateStaleMachine});
    EXPECT_EQ(told(a, locked), Causes{ReasonCode::GateMachineLocked});
    EXPECT_EQ(told(a, lost), Causes{ReasonCode::LinkLost});
    EXPECT_EQ(told(a, mute), Causes{ReasonCode::GateVerdictInvalid});
    EXPECT_EQ(told(a, wild), Causes{ReasonCode::GateNotFinite});
    EXPECT_EQ(told(a, timeless), Causes{ReasonCode::GateClockFault});
    // What belongs to every cut is no fault.
    EXPECT_EQ(told(a, [](GateHarness& h) { h.machine.programRunning = false; }), Causes{});
    EXPECT_EQ(told(a,
                   [](GateHarness& h) {
                     h.verdict.valid = false;
                     h.verdict.reason.code = ReasonCode::Learning;
                   }),
              Causes{});
  }
  EXPECT_EQ(told(Authority::Off, locked), Causes{});
  EXPECT_EQ(told(Authority::Off, lost), Causes{ReasonCode::LinkLost});
}

TEST(GateTells, TroubleIsToldAgainAfterItWasGood) {
  GateHarness h;
  h.authority(Authority::Auto);
  h.causes.clear();
  for (int i = 0; i < 3; ++i) {
    h.machine.overridesEnabled = false;
    h.run(2.0);
    h.machine.overridesEnabled = true;
    h.run(2.0);
  }
  EXPECT_EQ(h.causes, std::vector<ReasonCode>(3, ReasonCode::GateMachineLocked));
}

TEST(GateTells, TimeThatJumpsUnderAuthorityIsToldWithNothingInForce) {
  GateHarness h;
  h.authority(Authority::Auto);
  h.causes.clear();
  h.now += toDuration(Seconds(-5.0));
  h.step();
  EXPECT_EQ(h.causes, std::vector<ReasonCode>{ReasonCode::GateClockFault});
  EXPECT_TRUE(h.said(ReasonCode::GateClockFault));
}

// The limits leave nothing of what the strategy asks: nothing moves, and the reason is told once.
TEST(GateTells, AWishOfWhichNothingIsLeftIsRefusedAloud) {
  GateLimits limits = promptLimits();
  limits.overrides.slowest = Rpm(10000.0);
  limits.overrides.lowestFeed = Ratio(1.0);
  GateHarness h(limits);
  h.authority(Authority::Auto);
  h.causes.clear();
  h.verdict.state = CutState::Chatter;
  h.ask(8000, 800);
  h.run(5.0);
  EXPECT_TRUE(h.commands.empty());
  EXPECT_EQ(h.last.reason.code, ReasonCode::GateLimited);
  EXPECT_NEAR(h.last.reason.n[0], 80.0, 1e-9);
  EXPECT_NEAR(h.last.reason.n[1], 100.0, 1e-9);
  EXPECT_EQ(h.causes, std::vector<ReasonCode>{ReasonCode::GateLimited});
  EXPECT_TRUE(h.said(ReasonCode::GateLimited));
}

// More lines than there is room for: the loss is counted, and the fault is there.
TEST(GateTells, NothingImportantIsLostInACrowd) {
  GateHarness h;
  h.settleAt(9000, 900);
  h.strategyFailed = true;
  const OperatorInput grant{OperatorAction::GrantBySimulation}, off{OperatorAction::BackToProgrammed};
  const GateOutput out = h.step({off, grant, off, grant, off, grant, off});
  EXPECT_EQ(out.eventCount, kMaxGateEvents);
  EXPECT_EQ(out.eventCount + out.eventsLost, 7 * 2 + 1);
  EXPECT_EQ(out.events[kMaxGateEvents - 1].reason.code, ReasonCode::StrategyFault);
  EXPECT_TRUE(out.flight);
}

}  // namespace
}  // namespace stillcut::safety
