// The LinuxCNC link with stillcut-hal beside the machine, on virtual time: what the machine is left with, whoever dies.
// The real ones: tests/protocol/linuxcnc_hal_peer_test.cpp.
#include <gtest/gtest.h>

#include "tests/protocol/hal_bench.h"

namespace stillcut::cnc {
namespace {

using namespace testing;
using Bench = HalBench;

TEST(LinuxCncHal, MovesBothOverridesWithoutTakingControlAndBringsThemBack) {
  Bench b;
  b.engage(90.0);
  EXPECT_EQ(b.mill.spindle, 90);
  EXPECT_EQ(b.mill.feed, 90);
  EXPECT_EQ(b.mill.owner, nullptr);  // the operator's screen keeps control
  b.link->release(b.clock.now());
  b.leave(0.15);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

TEST(LinuxCncHal, AdaptiveFeedIsAFactorOfItsOwn) {
  Bench b(true);
  EXPECT_EQ(b.link->describe().highestFeed.value, 1.0);
  b.engage(90.0);
  EXPECT_EQ(b.mill.feed, 100);
  EXPECT_NEAR(b.hal.pins.adaptiveFeed, 0.9, 1e-3);
  b.link->release(b.clock.now());
  b.leave(0.01);
  EXPECT_EQ(b.hal.pins.adaptiveFeed, 1.0);
}

// Never more feed per tooth than at either end of the way.
TEST(LinuxCncHal, FeedRisesWithTheSpeedThatShowsAndIsThereInTheEnd) {
  for (const bool adaptive : {false, true}) {
    Bench b(adaptive);
    b.engage(80.0);
    const auto feed = [&] { return adaptive ? 100.0 * b.hal.pins.adaptiveFeed : b.mill.feed; };
    ASSERT_NEAR(feed(), 80.0, 0.1);
    ASSERT_EQ(b.mill.spindle, 80);
    for (const double percent : {84.0, 88.0, 95.0, 100.0}) {
      b.link->apply(b.gate.set(percent), b.clock.now());
      for (int i = 0; i < 15; ++i) {  // a ramp: the next order comes before this one shows
        b.link->read(b.clock.now());
        b.machine();
        EXPECT_LE(feed(), b.mill.spindle + 1e-9) << "adaptive " << adaptive << " at " << percent;
      }
    }
    b.run(0.5);
    EXPECT_EQ(b.mill.spindle, 100);
    EXPECT_NEAR(feed(), 100.0, 0.1);
  }
}

// Back within the lease of 0.2 s, whoever falls silent.
TEST(LinuxCncHal, KilledComponentIsTheMachinesOwnWayHome) {
  Bench b;
  b.engage(90.0);
  b.hal.killed = true;
  b.leave(0.19);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
  EXPECT_FALSE(b.run(1.0).controlOurs);
}

TEST(LinuxCncHal, HungProgramIsHomeWithinTheLease) {
  Bench b;
  b.engage(90.0);
  b.leave(0.19);
  EXPECT_EQ(b.mill.spindle, 100);
}

// The lease of the component is 60 ms, an answer may be later than that: then the override would go home and out again
// with every answer, and a hand on the knob with it.
TEST(LinuxCncHal, LeaseIsKeptThoughAnswersAreLaterThanIt) {
  for (const double late : {0.001, 0.05, 0.15}) {
    Bench b;
    b.faults.delay(late);
    b.run(1.5);
    b.engage(90.0);
    b.run(1.0);
    ASSERT_EQ(b.mill.spindle, 90) << late;
    for (int i = 0; i < 500; ++i) {
      b.run(0.004);
      ASSERT_EQ(b.mill.spindle, 90) << late << ", " << i;
    }
    b.mill.spindle = b.mill.shownSpindle = 40;
    b.run(2.0);
    EXPECT_EQ(b.mill.spindle, 40) << late << ": the operator's hand";
    b.link->release(b.clock.now());
    b.run(2.0);
    EXPECT_EQ(b.mill.spindle, 40) << late;
  }
}

TEST(LinuxCncHal, AHandBeforeOursHasShownIsNotSentOver) {
  for (const double late : {0.001, 0.1, 0.2}) {
    Bench b;
    b.watchFaults.delay(late);
    b.run(2.0);
    b.link->apply(b.gate.set(90.0), b.clock.now());
    for (int i = 0; i < 2000 && !(b.mill.spindle == 90 && b.mill.feed == 90); ++i) b.run(0.002);
    ASSERT_EQ(b.mill.feed, 90) << late;
    b.mill.spindle = b.mill.shownSpindle = 40;
    b.mill.feed = b.mill.shownFeed = 0;
    for (int i = 0; i < 1500; ++i) {
      b.run(0.002);
      ASSERT_EQ(b.mill.spindle, 40) << late << ", " << i;
      ASSERT_EQ(b.mill.feed, 0) << late << ", " << i;
    }
  }
}

// And nothing that is under way holds it up.
TEST(LinuxCncHal, AReleaseWaitsForNoAnswer) {
  Bench b;
  b.faults.delay(0.15);
  b.run(1.5);
  b.engage(90.0);
  b.run(1.0);
  ASSERT_EQ(b.mill.spindle, 90);
  const Instant began = b.clock.now();
  b.link->apply(b.gate.relinquish(), b.clock.now());
  while (b.mill.spindle != 100 && b.clock.now() - began < std::chrono::seconds(1)) b.run(0.002);
  // As long as halui takes, and a tick of the link.
  EXPECT_LT(secondsBetween(began, b.clock.now()).value, 0.14);
}

TEST(LinuxCncHal, KilledProgramOrPulledCableIsHomeWithinTheLease) {
  Bench b;
  b.engage(90.0);
  b.component->hangUp();
  b.leave(0.15);
  EXPECT_EQ(b.mill.spindle, 100);
}

// The component still hears us while linuxcncrsh is gone: what cannot be seen stays as ordered, and comes home.
TEST(LinuxCncHal, OverridesComeHomeThoughLinuxcncrshAloneIsGone) {
  for (const bool adaptive : {false, true}) {
    Bench b(adaptive);
    const OverrideCommand command = b.gate.set(90.0);
    b.run(0.2);
    b.link->apply(command, b.clock.now());
    b.run(10.0);
    ASSERT_EQ(b.mill.spindle, 90);
    b.watchFaults.refuse();
    b.watchWire->hangUp();
    EXPECT_FALSE(b.run(0.1).valid);
    EXPECT_EQ(b.mill.spindle, 90);
    b.link->apply(b.gate.relinquish(), b.clock.now());
    b.run(0.3);
    EXPECT_EQ(b.mill.spindle, 100);
    EXPECT_EQ(b.mill.feed, 100);
    b.watchFaults.refuse(false);
    const MachineState m = b.run(2.0);
    EXPECT_TRUE(m.valid);
    EXPECT_EQ(m.operatorSpeed.value, 1.0);
    EXPECT_EQ(b.mill.spindle, 100);
    EXPECT_EQ(b.hal.keeper.report(FakeHal::kOurs).standing, HalLeaseState::Home);
  }
}

// An order of halui's on the way home was lost, and the way is over: the knob that is seen to stray is fetched.
TEST(LinuxCncHal, KnobThatStrayedIsHeldAgainAndBroughtHome) {
  Bench b;
  b.engage(90.0);
  b.component->hangUp();
  b.hal.lost = 2;
  b.leave(0.4);
  ASSERT_EQ(b.mill.spindle, 90);
  b.link->release(b.clock.now());
  b.run(2.0);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
  EXPECT_EQ(b.hal.keeper.report(FakeHal::kOurs).standing, HalLeaseState::Home);
}

// The order home is lost, and with it the lease, because the program stood still at that moment: nobody waits for an
// order that will not come.
TEST(LinuxCncHal, AnOrderHomeThatIsLostWithTheLeaseIsGivenAgainAtOnce) {
  Bench b;
  b.engage(83.0);
  ASSERT_EQ(b.mill.spindle, 83);
  b.hal.lost = 2;
  b.link->apply(b.gate.relinquish(), b.clock.now());
  b.leave(0.4);
  b.hal.lost = 0;
  b.run(1.5);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

TEST(LinuxCncHal, OperatorsHandIsLeftAloneAndSurvivesTheRelease) {
  Bench b;
  b.engage(90.0);
  b.run(7.0);
  b.mill.spindle = b.mill.shownSpindle = 70;
  const OverrideCommand command = b.gate.set(90.0);
  b.link->apply(command, b.clock.now());
  const MachineState m = b.run(0.5);
  EXPECT_NEAR(m.operatorSpeed.value, 0.7, 1e-9);
  EXPECT_EQ(b.mill.spindle, 70);
  b.link->release(b.clock.now());
  b.leave(0.4);
  EXPECT_EQ(b.mill.spindle, 70);
  EXPECT_EQ(b.mill.feed, 100);
}

TEST(LinuxCncHal, OrderThatGetsLostIsGivenAgainOnTheWayOutAndHome) {
  Bench b;
  b.run(0.2);
  b.hal.lost = 2;
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.4);
  EXPECT_EQ(b.mill.spindle, 100);
  b.run(1.0);
  EXPECT_EQ(b.mill.spindle, 90);
  EXPECT_EQ(b.mill.feed, 90);
  b.hal.lost = 2;
  b.link->apply(b.gate.relinquish(), b.clock.now());
  b.run(1.2);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

TEST(LinuxCncHal, AbortedProgramIsNotRunningAndTheReleaseBringsBack) {
  Bench b;
  b.engage(90.0);
  b.mill.running = false;
  EXPECT_FALSE(b.run(0.6).programRunning);
  b.link->release(b.clock.now());
  b.leave(0.19);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

// With the machine its component begins anew: the watchdog is proven again before anything is taken.
TEST(LinuxCncHal, RestartedMachineIsHomeAndItsWatchdogProvenAnew) {
  Bench b;
  b.engage(90.0);
  b.faults.refuse();
  b.component->hangUp();
  b.mill = {};
  b.hal.keeper = {};
  b.run(0.4);
  b.faults.refuse(false);
  b.link->apply(b.gate.relinquish(), b.clock.now());  // the lease ran out meanwhile
  const OverrideCommand command = b.gate.set(91.0);
  b.link->apply(command, b.clock.now());
  for (int i = 0; i < 2000 && b.mill.spindle == 100; ++i) b.run(Bench::kStep);
  EXPECT_EQ(b.mill.spindle, 91);
  EXPECT_GT(b.hal.keeper.report(FakeHal::kOurs).watchdogMs, 0);
}

}  // namespace
}  // namespace stillcut::cnc
