// Why an order to LinuxCNC does not act, each cause told from the others: locked, taken by another, refused, off, the
// operator's own hand. On virtual time.
#include <gtest/gtest.h>

#include "tests/protocol/emc_bench.h"

namespace stillcut::cnc {
namespace {

using namespace testing;
using Bench = EmcBench;

TEST(LinuxCnc, OperatorsHandEndsOursAndIsNotFoughtOver) {
  Bench b;
  b.run(0.2);
  const OverrideCommand command = b.gate.set(90.0);
  b.link->apply(command, b.clock.now());
  b.run(8.0);
  b.mill.spindle = b.mill.shownSpindle = 70;
  b.run(0.1);
  b.link->apply(command, b.clock.now());  // the lease is renewed before the gate has seen it
  const MachineState m = b.run(2.0);
  EXPECT_EQ(b.mill.spindle, 70);
  EXPECT_NEAR(m.operatorSpeed.value, 0.7, 1e-9);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.mill.spindle, 70);
  EXPECT_EQ(b.mill.feed, 100);
}

// Whatever the hand chose, also beyond our limits: it stands at every later moment, and after we have gone.
TEST(LinuxCnc, NoHandIsEverSentOver) {
  for (const int hand : {0, 20, 40, 49, 70, 95, 101, 120, 151, 180}) {
    for (const bool ofSpeed : {true, false}) {
      Bench b;
      b.run(0.3);
      double t = 0.0;
      const auto engaged = [&](double seconds) {
        for (double end = t + seconds; t < end; t += 0.005) {
          b.link->apply(b.gate.set(90.0), b.clock.now());
          b.run(0.005);
        }
      };
      engaged(1.5);
      ASSERT_EQ(b.mill.spindle, 90);
      (ofSpeed ? b.mill.spindle : b.mill.feed) = (ofSpeed ? b.mill.shownSpindle : b.mill.shownFeed) = hand;
      for (int k = 0; k < 20; ++k) {
        engaged(0.1);
        ASSERT_EQ(ofSpeed ? b.mill.spindle : b.mill.feed, hand) << ofSpeed;
      }
      b.link->release(b.clock.now());
      EXPECT_EQ(ofSpeed ? b.mill.spindle : b.mill.feed, hand) << ofSpeed;
      EXPECT_EQ(ofSpeed ? b.mill.feed : b.mill.spindle, 100) << "the other goes home";
    }
  }
}

TEST(LinuxCnc, AcknowledgedWithoutEffectIsALockNotASuccess) {
  Bench b;
  b.run(0.2);
  b.mill.lock(true);  // M49: ACK, read-back 90, and the spindle stays at S
  b.link->apply(b.gate.set(90.0), b.clock.now());
  MachineState m = b.run(1.0);
  EXPECT_NEAR(m.speedOverride.value, 1.0, 1e-9);  // what is in force, not what is read back
  m = b.run(2.0);
  EXPECT_TRUE(m.valid);
  EXPECT_FALSE(m.overridesEnabled);
  EXPECT_EQ(m.block, OverrideInhibit::OverridesLocked);
  EXPECT_EQ(m.feedOverride.value, 1.0);
  b.mill.lock(false);  // M48
  m = b.run(1.0);
  EXPECT_TRUE(m.overridesEnabled);
  EXPECT_EQ(m.block, OverrideInhibit::None);
  EXPECT_NEAR(m.feedOverride.value, 0.9, 1e-9);
}

// M51 P0 and M50 P0: one of the two acts, and which does not is said.
TEST(LinuxCnc, SpeedAndFeedThatAreLockedAreToldApart) {
  for (const bool speed : {true, false}) {
    Bench b;
    b.run(0.2);
    (speed ? b.mill.speedLocked : b.mill.feedLocked) = true;
    b.link->apply(b.gate.set(90.0), b.clock.now());
    const MachineState m = b.run(3.0);
    EXPECT_FALSE(m.overridesEnabled);
    EXPECT_EQ(m.block, speed ? OverrideInhibit::SpeedLocked : OverrideInhibit::FeedLocked);
    EXPECT_NEAR(m.speedOverride.value, speed ? 1.0 : 0.9, 1e-6);
    EXPECT_NEAR(m.feedOverride.value, speed ? 0.9 : 1.0, 1e-6);
  }
}

// A spindle at its own limit stands where a locked one stands: above 100 % nobody can tell, and nobody claims to.
TEST(LinuxCnc, AboveTheProgrammedSpeedALimitIsNotTakenForM49) {
  for (const bool locked : {true, false}) {
    Bench b;
    b.run(0.2);
    b.mill.lock(locked);
    b.mill.highest = locked ? 1e9 : b.mill.s;
    b.mill.fastest = locked ? 1e9 : b.mill.f;
    b.link->apply(b.gate.set(104.0), b.clock.now());
    const MachineState m = b.run(3.0);
    EXPECT_FALSE(m.overridesEnabled);
    EXPECT_EQ(m.block, OverrideInhibit::SpeedLocked) << "whose sentence names both";
    EXPECT_NEAR(m.speedOverride.value, 1.0, 1e-6);
    EXPECT_NEAR(m.feedOverride.value, 1.0, 1e-6);
    b.link->apply(b.gate.relinquish(), b.clock.now());
    b.run(0.5);
    b.link->apply(b.gate.set(90.0), b.clock.now());
    EXPECT_EQ(b.run(3.0).block, locked ? OverrideInhibit::OverridesLocked : OverrideInhibit::None);
  }
}

// Rapid moves and corners are no lock: the velocity stands nowhere near the programmed feed for long.
TEST(LinuxCnc, AFeedThatPassesTheProgrammedOneIsNotLocked) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  for (int move = 0; move < 200; ++move) {
    b.mill.moves = move % 5 == 0 ? 1.0 : 0.3 * (move % 7);  // of the programmed feed
    EXPECT_TRUE(b.run(0.02).overridesEnabled) << move;
  }
}

// Nobody says when the program unlocks: once nothing of ours is told for some seconds, the lock is tried again.
TEST(LinuxCnc, ALockIsNotBelievedForEver) {
  Bench b;
  b.run(0.2);
  b.mill.lock(true);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(3.0);
  b.link->release(b.clock.now());
  EXPECT_FALSE(b.run(5.0).overridesEnabled);
  EXPECT_TRUE(b.run(8.0).overridesEnabled);
}

TEST(LinuxCnc, AnotherClientInControlIsSaidAndNotFought) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  b.mill.owner = &b.other;
  const OverrideCommand more = b.gate.set(95.0);
  b.link->apply(more, b.clock.now());
  const MachineState m = b.run(1.0);
  EXPECT_TRUE(m.valid);
  EXPECT_FALSE(m.controlOurs);
  EXPECT_EQ(m.block, OverrideInhibit::OtherClient);
  EXPECT_EQ(b.mill.owner, &b.other);
}

TEST(LinuxCnc, RefusedControlIsNoOtherClient) {
  Bench b;
  b.run(0.2);
  b.mill.refusesControl = true;
  b.link->apply(b.gate.set(90.0), b.clock.now());
  const MachineState m = b.run(1.0);
  EXPECT_FALSE(m.controlOurs);
  EXPECT_EQ(m.block, OverrideInhibit::ControlRefused);
}

TEST(LinuxCnc, MachineOffIsNotReadyAndNotLostControl) {
  Bench b;
  b.run(0.2);
  b.mill.machineOn = false;
  b.link->apply(b.gate.set(90.0), b.clock.now());
  const MachineState m = b.run(1.0);
  EXPECT_TRUE(m.valid);
  EXPECT_FALSE(m.programRunning);
  EXPECT_TRUE(m.controlOurs);
  EXPECT_EQ(m.block, OverrideInhibit::MachineOff);
  EXPECT_EQ(b.mill.sets, 0);
  EXPECT_EQ(b.mill.owner, nullptr);  // nothing could be done with it
  b.mill.machineOn = true;
  b.mill.running = false;
  EXPECT_EQ(b.run(0.6).block, OverrideInhibit::NoProgram);
}

}  // namespace
}  // namespace stillcut::cnc
