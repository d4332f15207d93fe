// The way home: how the programmed values come back while machine and link are well.
#include <gtest/gtest.h>

#include "tests/support/gate_harness.h"

namespace stillcut::safety {
namespace {

using testing::GateHarness;

// The way home begins in the step in which it is asked for, by the rates and in the order of every other move.
TEST(GateHome, BackToProgrammedTurnsAuthorityOffAndGoesHomeByTheRamp) {
  GateHarness h;
  h.settleAt(9000, 900);
  h.commands.clear();
  const GateOutput out = h.act(OperatorAction::BackToProgrammed);
  EXPECT_EQ(out.authority, Authority::Off);
  ASSERT_TRUE(out.command.has_value());
  EXPECT_NEAR(out.command->speed().value, 0.91, 1e-9);
  h.run(1.0);
  h.expectHomeByRamp(0);
  EXPECT_LT(h.commands.size(), 40U);  // 10 points at 100 %/s, and the feed waits for the spindle
  h.commands.clear();
  h.run(2.0);
  EXPECT_TRUE(h.commands.empty());
}

// What a run that was killed has left in the machine is not the gate's to know: the link brings it home.
TEST(GateHome, BackToProgrammedWithNothingInForceGivesOneReleaseAndTakesNothing) {
  GateHarness h;
  h.run(1.0);
  ASSERT_TRUE(h.commands.empty());
  h.act(OperatorAction::BackToProgrammed);
  h.run(1.0);
  ASSERT_EQ(h.commands.size(), 1U);
  EXPECT_EQ(h.commands[0].kind, CommandKind::Release);
  EXPECT_EQ(h.commands[0].reason.code, ReasonCode::BackToProgrammed);
  EXPECT_FALSE(h.gate.commanding());
  EXPECT_EQ(h.gate.authority(), Authority::Off);
  h.settleAt(9000, 900);
  EXPECT_TRUE(h.gate.commanding()) << "and may be asked again";
}

TEST(GateHome, FromAboveTheFeedGoesHomeFirst) {
  GateHarness h;
  h.settleAt(11500, 1150);
  const std::size_t first = h.commands.size() - 1;
  h.authority(Authority::Off);
  h.run(2.0);
  h.expectHomeByRamp(first);
  EXPECT_LT(h.commands[first + 1].feed.value, 1.15);
  EXPECT_NEAR(h.commands[first + 1].speed.value, 1.15, 1e-9);
}

TEST(GateHome, NothingButGoingHomeHappensOnTheWayThere) {
  GateHarness h;
  h.settleAt(8000, 800);
  h.authority(Authority::Off);
  h.act(OperatorAction::Hold);
  h.authority(Authority::Auto);
  h.machine.operatorSpeed = Ratio(0.95);
  const std::size_t first = h.commands.size() - 1;
  while (!h.released() && h.commands.size() < 1000) h.step();
  h.expectHomeByRamp(first);
}

// A link that dies on the way: nothing is left to be steered.
TEST(GateHome, GoingHomeEndsAtOnceWhenTheMachineIsLost) {
  GateHarness h;
  h.settleAt(8000, 800);
  h.authority(Authority::Off);
  h.run(0.05);
  ASSERT_TRUE(h.last.commanding);
  h.causes.clear();
  h.machine.linkUp = false;
  EXPECT_EQ(h.step().command->kind(), CommandKind::Release);
  EXPECT_TRUE(h.said(ReasonCode::LinkLost));
  EXPECT_EQ(h.causes, std::vector<ReasonCode>{ReasonCode::LinkLost});
}

TEST(GateHome, ASpindleThatNeverComesIsNotWaitedForForever) {
  GateHarness h;
  h.settleAt(8000, 800);
  h.spindleStands = true;  // the drive does not speed up again
  h.authority(Authority::Off);
  h.run(4.0);
  EXPECT_TRUE(h.last.commanding);
  EXPECT_NEAR(h.lastCommand().feed.value, 0.8 * 1.02, 1e-4) << "no more feed than the spindle can take";
  h.run(2.0);
  EXPECT_FALSE(h.last.commanding);
}

}  // namespace
}  // namespace stillcut::safety
