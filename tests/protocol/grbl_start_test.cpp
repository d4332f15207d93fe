// A controller that starts anew when its port is opened, and one that falls silent, on virtual time: the port is opened
// once and waited for.
#include <gtest/gtest.h>

#include "tests/protocol/grbl_bench.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

using Bench = GrblBench;

TEST(GrblStart, ABoardThatStartsAnewIsOpenedOnceAndWaitedFor) {
  for (const double boot : {0.4, 0.7, 1.2, 2.0, 3.0}) {
    Bench b(boot);
    ASSERT_TRUE(b.link->open().ok()) << boot;
    EXPECT_TRUE(b.run(2.0).valid) << boot;
    EXPECT_EQ(b.grbl.opened, 1) << boot;
    b.link->apply(b.gate.set(90.0), b.clock.now());
    b.run(1.0);
    EXPECT_EQ(b.grbl.spindle, 90);
    b.link->release(b.clock.now());
    EXPECT_EQ(b.grbl.spindle, 100);
    EXPECT_EQ(b.grbl.opened, 1) << boot;
  }
}

TEST(GrblStart, ThatItStartsIsSaidUntilItAnswers) {
  Bench b(2.0);
  const MachineState early = b.run(1.0);
  EXPECT_FALSE(early.valid);
  EXPECT_EQ(early.block, OverrideInhibit::Starting);
  const MachineState late = b.run(2.5);
  EXPECT_TRUE(late.valid);
  EXPECT_EQ(late.block, OverrideInhibit::None);
}

// Opened again it would start again, in the middle of a program.
TEST(GrblStart, SilenceOpensNoSerialPortAgain) {
  Bench b(1.0);
  ASSERT_TRUE(b.link->open().ok());
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  b.faults.hang();
  const MachineState silent = b.run(8.0);
  EXPECT_FALSE(silent.valid || silent.linkUp);
  EXPECT_NE(silent.block, OverrideInhibit::Starting) << "it hangs";
  b.faults.hang(false);
  EXPECT_TRUE(b.run(1.0).valid);
  EXPECT_EQ(b.grbl.opened, 1);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

// A TCP connection may be dead at its other end, and costs nothing to make anew.
TEST(GrblStart, SilenceMakesATcpConnectionAnew) {
  GrblSettings settings;
  settings.wire = {.host = "mill", .port = 23, .device = {}};
  Bench b(0.0, settings);
  ASSERT_TRUE(b.link->open().ok());
  b.faults.hang();
  b.run(6.0);
  EXPECT_GT(b.grbl.opened, 1);
  b.faults.hang(false);
  EXPECT_TRUE(b.run(6.0).valid);
}

TEST(GrblStart, APortWithNothingBehindItIsGivenUpAfterTheTimeABoardMayTake) {
  Bench b(0.0);
  b.faults.hang();
  const Instant began = b.clock.now();
  EXPECT_EQ(b.link->open().error().line(),
            "mill:5007: no GRBL status report (is this the controller's port, and the baud rate right?)");
  EXPECT_NEAR(secondsBetween(began, b.clock.now()).value, toSeconds(GrblLink::kBootTime).value, 0.3);
  EXPECT_EQ(b.grbl.opened, 1);
}

// FS is what is ordered: nothing is measured unless the controller says so in a third value.
TEST(GrblStart, ASpeedCountsAsMeasuredOnlyWhereTheControllerMeasuresOne) {
  Bench b(0.0);
  MachineState m = b.run(1.0);
  ASSERT_TRUE(m.valid);
  EXPECT_EQ(m.actualSpeed.value, 0.0);
  EXPECT_EQ(m.link.speed, Instant{});
  b.grbl.extra = ",8750";
  m = b.run(0.5);
  EXPECT_EQ(m.actualSpeed.value, 8750.0);
  EXPECT_GT(m.link.speed, Instant{});
}

}  // namespace
}  // namespace stillcut::cnc
