// linuxcncrsh as LinuxCNC 2.9 speaks it, and both newer ways, on virtual time: both overrides act and go home in each,
// and none is ever spoken to in another's way where that does harm.
#include <gtest/gtest.h>

#include "tests/protocol/emc_bench.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

class LinuxCncDialect : public ::testing::TestWithParam<Dialect> {
 protected:
  LinuxCncDialect() { b.mill.dialect = GetParam(); }
  EmcBench b;
};

TEST_P(LinuxCncDialect, BothOverridesActAndGoHome) {
  ASSERT_TRUE(b.link->open().ok());
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  const MachineState m = b.run(1.5);
  EXPECT_EQ(b.mill.spindle, 90);
  EXPECT_EQ(b.mill.feed, 90);
  EXPECT_NEAR(m.speedOverride.value, 0.9, 1e-6);
  EXPECT_TRUE(m.controlOurs);
  EXPECT_GT(m.link.acknowledged, Instant{});
  b.link->release(b.clock.now());
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
  EXPECT_EQ(b.mill.owner, nullptr);
  EXPECT_FALSE(b.mill.crashed) << "the order of a newer server ends an old one";
  EXPECT_EQ(b.mill.complaints, 0) << "the order of an old server is refused by a newer one";
}

TEST_P(LinuxCncDialect, EveryEndBringsBack) {
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.5);
  ASSERT_EQ(b.mill.spindle, 90);
  b.link.reset();
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

// The commands keep coming while it is found out which one it is: nothing is taken for the answer to something else.
TEST_P(LinuxCncDialect, AcknowledgementsAreThoseOfWhatWasAsked) {
  b.faults.delay(0.02);
  b.run(1.0);
  for (int i = 0; i < 300; ++i) {
    b.link->apply(b.gate.set(i < 150 ? 90.0 : 95.0), b.clock.now());
    b.run(0.01);
  }
  EXPECT_EQ(b.mill.spindle, 95);
  EXPECT_EQ(b.mill.feed, 95);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

TEST_P(LinuxCncDialect, AServerOfAnotherAgeAfterARestartIsSpokenToInItsOwnWay) {
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.5);
  b.link->release(b.clock.now());
  for (const Dialect next : {Dialect::Ten, Dialect::Old, Dialect::Master, Dialect::Old}) {
    for (ScriptedWire* w : {b.controlWire, b.watchWire, b.halWire}) w->hangUp();
    b.mill = {};
    b.mill.dialect = next;
    b.run(2.0);
    b.link->apply(b.gate.set(90.0), b.clock.now());
    b.run(1.5);
    EXPECT_EQ(b.mill.spindle, 90);
    b.link->release(b.clock.now());
    EXPECT_EQ(b.mill.spindle, 100);
    EXPECT_FALSE(b.mill.crashed);
    EXPECT_EQ(b.mill.complaints, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, LinuxCncDialect, ::testing::Values(Dialect::Old, Dialect::Ten, Dialect::Master));

// They take no more than 100 %: what could not be given back is not taken away, and the feed does not go alone.
TEST(LinuxCncNewer, ASpeedThatCouldNotBeGivenBackIsNotMoved) {
  for (const Dialect dialect : {Dialect::Ten, Dialect::Master}) {
    EmcBench b;
    b.mill.dialect = dialect;
    b.run(0.5);
    b.link->apply(b.gate.set(90.0), b.clock.now());
    b.run(1.0);
    b.link->release(b.clock.now());
    b.run(1.0);
    EXPECT_EQ(b.link->describe().highestSpeed.value, 1.0);
    b.mill.spindle = b.mill.shownSpindle = 120;  // by hand
    b.run(1.0);
    b.link->apply(b.gate.set(91.0), b.clock.now());
    b.run(2.0);
    EXPECT_EQ(b.mill.spindle, 120);
    EXPECT_EQ(b.mill.feed, 100);
    b.link->release(b.clock.now());
    EXPECT_EQ(b.mill.spindle, 120);
    EXPECT_EQ(b.mill.feed, 100);
  }
}

TEST(LinuxCncNewer, NothingAboveAHundredPerCentIsAskedFor) {
  EmcBench b;
  b.mill.dialect = Dialect::Ten;
  b.run(0.5);
  b.link->apply(b.gate.set(104.0), b.clock.now());
  b.run(2.0);
  EXPECT_EQ(b.mill.complaints, 0);
  EXPECT_EQ(b.mill.spindle, 100);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.mill.feed, 100);
}

}  // namespace
}  // namespace stillcut::cnc
