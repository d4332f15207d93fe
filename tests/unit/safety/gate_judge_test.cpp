// What the gate makes of moves that did not help: it counts them, takes back what made the cut louder, and is at the
// end of Auto after two.
#include <gtest/gtest.h>

#include "tests/support/gate_harness.h"

namespace stillcut::safety {
namespace {

using testing::GateHarness;
using testing::judgingLimits;

int said(const GateHarness& h, ReasonCode code) {
  int count = 0;
  for (const Event& e : h.events) count += e.reason.code == code ? 1 : 0;
  return count;
}

TEST(GateJudge, TwoMovesThatDidNotHelpEndInAdviseWithTheProgrammedValues) {
  GateHarness h(judgingLimits());
  h.settleAt(9000, 900);  // and it chatters on
  h.run(1.0);
  EXPECT_EQ(said(h, ReasonCode::InterventionNoHelp), 1);
  EXPECT_EQ(h.last.authority, Authority::Auto);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  h.ask(8500, 850);
  h.run(1.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.85, 1e-9);
  const std::size_t first = h.commands.size() + 150;
  h.run(3.0);
  EXPECT_EQ(said(h, ReasonCode::InterventionNoHelp), 2);
  EXPECT_EQ(said(h, ReasonCode::AutoWithoutHelp), 1);
  EXPECT_EQ(h.last.authority, Authority::Advise);
  EXPECT_FALSE(h.last.commanding);
  EXPECT_EQ(h.lastCommand().kind, CommandKind::Release);
  ASSERT_GT(h.commands.size(), first - 150);
  // What is asked for now is advice.
  EXPECT_TRUE(h.last.adviceOpen);
}

TEST(GateJudge, TheWayHomeGoesByTheRamp) {
  GateHarness h(judgingLimits());
  h.settleAt(9000, 900);
  h.run(1.0);
  h.ask(8500, 850);
  while (h.last.authority == Authority::Auto && h.commands.size() < 1000) h.step();
  h.run(2.0);
  std::size_t leaves = h.commands.size() - 1;
  while (leaves > 0 && h.commands[leaves].speed.value != 0.85) --leaves;
  ASSERT_GT(leaves, 0U);
  h.expectHomeByRamp(leaves);
}

TEST(GateJudge, AMoveThatHelpsIsNotCounted) {
  GateHarness h(judgingLimits());
  for (int i = 0; i < 4; ++i) {
    h.settleAt(i % 2 == 0 ? 9000 : 8500, 850);
    h.verdict.state = CutState::Stable;
    h.run(12.0);
  }
  EXPECT_EQ(said(h, ReasonCode::InterventionNoHelp), 0);
  EXPECT_EQ(h.last.authority, Authority::Auto);
}

TEST(GateJudge, ALouderCutIsTakenBackAndNotTriedAgain) {
  GateHarness h(judgingLimits());
  h.vibration = 2.0;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Auto);
  h.ask(9000, 900);
  h.run(0.5);
  ASSERT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  h.vibration = 20.0;
  h.run(3.5);
  ASSERT_EQ(said(h, ReasonCode::InterventionLouder), 1);
  EXPECT_FALSE(h.last.commanding);
  EXPECT_EQ(h.last.reason.code, ReasonCode::InterventionNotAgain);
  const std::size_t commands = h.commands.size();
  h.run(5.0);
  EXPECT_EQ(h.commands.size(), commands) << "it is asked for again and again";
  h.vibration = 2.0;
  h.ask(8000, 800);  // another place
  h.run(1.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.8, 1e-9);
}

TEST(GateJudge, ALouderCutGoesBackToWhatHelpedBefore) {
  GateHarness h(judgingLimits());
  h.vibration = 2.0;
  h.settleAt(9500, 950);
  h.verdict.state = CutState::Stable;
  h.run(3.0);
  h.verdict.state = CutState::Chatter;
  h.run(0.5);
  h.ask(8000, 800);
  h.run(1.0);
  ASSERT_NEAR(h.lastCommand().speed.value, 0.8, 1e-9);
  h.vibration = 20.0;
  h.run(3.0);
  EXPECT_EQ(said(h, ReasonCode::InterventionLouder), 1);
  EXPECT_TRUE(h.last.commanding);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.95, 1e-3);
}

TEST(GateJudge, UnderAdviseNothingIsTakenBackUnasked) {
  GateHarness h(judgingLimits());
  h.vibration = 2.0;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Advise);
  h.ask(9000, 900);
  h.run(0.5);
  h.act(OperatorAction::Accept);
  h.run(0.5);
  h.vibration = 20.0;
  h.run(5.0);
  EXPECT_EQ(said(h, ReasonCode::InterventionLouder), 1);
  EXPECT_EQ(h.last.authority, Authority::Advise);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
}

TEST(GateJudge, TwoFaultsInARowEndAutoToo) {
  GateHarness h(judgingLimits());
  h.settleAt(9000, 900);
  h.machine.endedEngagement = h.lastCommand().engagement;  // its lease ran out on the way
  h.run(1.0);
  EXPECT_EQ(h.last.authority, Authority::Auto);
  ASSERT_TRUE(h.last.commanding);
  h.machine.endedEngagement = h.lastCommand().engagement;
  h.run(1.0);
  EXPECT_EQ(said(h, ReasonCode::AutoWithoutHelp), 1);
  EXPECT_EQ(h.last.authority, Authority::Advise);
  EXPECT_FALSE(h.last.commanding);
}

TEST(GateJudge, ANewGrantIsANewTrust) {
  GateHarness h(judgingLimits());
  for (int i = 0; i < 2; ++i) {
    h.settleAt(9000, 900);
    h.run(2.0);
    h.authority(Authority::Off);
    h.run(2.0);
  }
  h.settleAt(9000, 900);
  h.run(2.0);
  EXPECT_EQ(h.last.authority, Authority::Auto);
  EXPECT_EQ(said(h, ReasonCode::AutoWithoutHelp), 0);
}

// What was heard a quarter of a second ago tells of another cut: it holds what there is and moves nothing.
TEST(GateJudge, OldSamplesMoveNothing) {
  for (const bool byTheMachinesClock : {false, true}) {
    GateHarness h(judgingLimits());
    h.settleAt(9000, 900);
    h.ask(8000, 800);
    h.freshVerdict = h.freshMachine = false;
    h.machine.time = h.now + toDuration(Seconds(byTheMachinesClock ? 0.25 : 0.0));
    h.verdict.time = h.now - toDuration(Seconds(byTheMachinesClock ? 0.0 : 0.22));
    const double before = h.lastCommand().speed.value;
    for (int i = 0; i < 3; ++i) h.step();
    EXPECT_EQ(h.last.reason.code, ReasonCode::GateOldSamples);
    EXPECT_TRUE(h.last.commanding);
    EXPECT_EQ(h.lastCommand().speed.value, before);
    h.freshVerdict = h.freshMachine = true;
    h.run(1.0);
    EXPECT_NEAR(h.lastCommand().speed.value, 0.8, 1e-9);
  }
}

TEST(GateJudge, OldSamplesTakeNothing) {
  GateHarness h(judgingLimits());
  h.verdict.state = CutState::Chatter;
  h.ask(9000, 900);
  h.freshMachine = false;
  h.machine.time = h.now + toDuration(Seconds(0.3));
  h.authority(Authority::Auto);
  for (int i = 0; i < 50; ++i) {
    h.machine.time = h.now + toDuration(Seconds(0.3));
    h.step();
  }
  EXPECT_TRUE(h.commands.empty());
  EXPECT_EQ(h.last.reason.code, ReasonCode::GateOldSamples);
}

}  // namespace
}  // namespace stillcut::safety
