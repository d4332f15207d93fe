// LinuxCNC's manners on a scripted peer, on virtual time. The real one: tests/protocol/linuxcnc_peer_test.cpp.
// Over 400 lines: every end of one link, and every cause of an order that does not act, on one bench.
#include "core/cnc/linuxcnc_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/protocol/commands.h"
#include "tests/protocol/fake_emc.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

struct Bench {
  Bench() {
    auto make = [&](FakeEmcClient& client, ScriptedWire*& seen) {
      auto wire = std::make_unique<ScriptedWire>(clock, faults, client);
      seen = wire.get();
      return wire;
    };
    LinuxCncLink::Wires wires;
    wires.control = make(control, controlWire);
    wires.watch = make(watch, watchWire);
    wires.hal = make(hal, halWire);
    link = std::make_unique<LinuxCncLink>(LinuxCncSettings{}, std::move(wires), clock);
  }
  // The link thread's ticks; the spindle follows with a time constant of 0.1 s.
  MachineState run(double seconds) {
    const Instant until = clock.now() + toDuration(Seconds(seconds));
    MachineState m;
    while (clock.now() < until) {
      const Instant before = clock.now();
      m = link->read(before);
      clock.advance(Seconds(0.005));
      mill.actual += (mill.commanded() - mill.actual) * secondsBetween(before, clock.now()).value / 0.1;
    }
    return m;
  }

  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults;
  FakeMill mill;
  FakeEmcClient control{mill}, watch{mill}, hal{mill}, other{mill};
  ScriptedWire *controlWire = nullptr, *watchWire = nullptr, *halWire = nullptr;
  CommandMaker gate;
  std::unique_ptr<LinuxCncLink> link;
};

TEST(LinuxCnc, ReadsTheMachineAndTakesNoControlUnasked) {
  Bench b;
  ASSERT_TRUE(b.link->open().ok());
  const MachineState m = b.run(1.0);
  ASSERT_TRUE(m.valid && m.linkUp);
  EXPECT_TRUE(m.programRunning && m.atSpeed && m.overridesEnabled && m.controlOurs);
  EXPECT_EQ(m.programmedSpeed.value, 8000.0);
  EXPECT_NEAR(toMmPerMin(m.programmedFeed), 600.0, 1e-6);
  EXPECT_NEAR(m.actualSpeed.value, 8000.0, 1.0);
  EXPECT_NEAR(toMmPerMin(m.actualFeed), 600.0, 1e-3);
  EXPECT_LT(secondsBetween(m.time, b.clock.now()).value, 0.03);
  EXPECT_EQ(b.mill.owner, nullptr);
  EXPECT_EQ(b.mill.sets, 0);
  EXPECT_FALSE(b.link->describe().machineWatchdog);  // the overrides stay when we die
}

TEST(LinuxCnc, CommandMovesBothOverridesAndReleaseGivesControlBack) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  MachineState m = b.run(1.5);
  EXPECT_EQ(b.mill.spindle, 90);
  EXPECT_EQ(b.mill.feed, 90);
  EXPECT_NEAR(m.speedOverride.value, 0.9, 1e-6);
  EXPECT_NEAR(m.actualSpeed.value, 7200.0, 5.0);
  EXPECT_EQ(m.operatorSpeed.value, 1.0);  // that part is ours
  b.link->release(b.clock.now());
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
  EXPECT_EQ(b.mill.owner, nullptr);
  m = b.run(1.0);
  EXPECT_EQ(m.speedOverride.value, 1.0);
}

TEST(LinuxCnc, MultipliesWithTheOperatorsOwnKnobAndBringsItBack) {
  Bench b;
  b.mill.spindle = b.mill.shownSpindle = 110;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  const MachineState m = b.run(1.0);
  EXPECT_EQ(b.mill.spindle, 99);
  EXPECT_NEAR(m.operatorSpeed.value, 1.1, 1e-9);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.mill.spindle, 110);
}

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
  EXPECT_EQ(m.block, OrderBlock::OverridesLocked);
  EXPECT_EQ(m.feedOverride.value, 1.0);
  b.mill.lock(false);  // M48
  m = b.run(1.0);
  EXPECT_TRUE(m.overridesEnabled);
  EXPECT_EQ(m.block, OrderBlock::None);
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
    EXPECT_EQ(m.block, speed ? OrderBlock::SpeedLocked : OrderBlock::FeedLocked);
    EXPECT_NEAR(m.speedOverride.value, speed ? 1.0 : 0.9, 1e-6);
    EXPECT_NEAR(m.feedOverride.value, speed ? 0.9 : 1.0, 1e-6);
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
  EXPECT_EQ(m.block, OrderBlock::OtherClient);
  EXPECT_EQ(b.mill.owner, &b.other);
}

TEST(LinuxCnc, RefusedControlIsNoOtherClient) {
  Bench b;
  b.run(0.2);
  b.mill.refusesControl = true;
  b.link->apply(b.gate.set(90.0), b.clock.now());
  const MachineState m = b.run(1.0);
  EXPECT_FALSE(m.controlOurs);
  EXPECT_EQ(m.block, OrderBlock::ControlRefused);
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
  EXPECT_EQ(m.block, OrderBlock::MachineOff);
  EXPECT_EQ(b.mill.sets, 0);
  EXPECT_EQ(b.mill.owner, nullptr);  // nothing could be done with it
  b.mill.machineOn = true;
  b.mill.running = false;
  EXPECT_EQ(b.run(0.3).block, OrderBlock::NoProgram);
}

// It takes no override then, so nothing is waited for: what stands there goes home once it is on again, if we are
// there.
TEST(LinuxCnc, QuittingWhileTheMachineIsOffIsAtOnceAndTheOverrideGoesHomeWhenItIsOn) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  b.mill.machineOn = b.mill.running = false;
  b.run(0.2);
  const Instant began = b.clock.now();
  b.link->release(began);
  EXPECT_LT(secondsBetween(began, b.clock.now()).value, 0.3);  // control is given back
  const MachineState m = b.run(0.5);
  EXPECT_EQ(m.block, OrderBlock::MachineOff);
  EXPECT_NEAR(m.speedOverride.value, 0.9, 1e-6);  // said, for it stays where we go now
  EXPECT_EQ(b.mill.owner, nullptr);
  b.mill.machineOn = true;
  b.run(1.0);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

// The end of a run lets go three times (release, close, the destructor); a server that hangs is waited for once.
TEST(LinuxCnc, HungPeerHoldsTheEndOnce) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  b.faults.hang();
  const Instant began = b.clock.now();
  b.link->release(b.clock.now());
  b.link->close();
  b.link.reset();
  EXPECT_LT(secondsBetween(began, b.clock.now()).value, 0.75);
}

TEST(LinuxCnc, HungPeerIsDownWithinASecondAndItsCommandsAreNotBelieved) {
  Bench b;
  b.run(0.2);
  b.faults.hang();
  const MachineState m = b.run(1.0);
  EXPECT_FALSE(m.valid);
  EXPECT_FALSE(m.linkUp);
}

TEST(LinuxCnc, PulledCableComesBackAndTheOverridesWithIt) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(10.0);
  ASSERT_EQ(b.mill.spindle, 90);
  b.faults.refuse();
  for (ScriptedWire* w : {b.controlWire, b.watchWire, b.halWire}) w->hangUp();
  EXPECT_FALSE(b.run(0.3).linkUp);
  b.link->release(b.clock.now());  // the lease ran out; nothing gets through
  EXPECT_EQ(b.mill.spindle, 90);
  b.faults.refuse(false);
  const MachineState m = b.run(2.0);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(b.mill.spindle, 100);  // as soon as the wire is back
  EXPECT_EQ(b.mill.feed, 100);
  EXPECT_EQ(b.mill.owner, nullptr);
}

TEST(LinuxCnc, CommandsWithEveryTickDoNotKeepTheWatchFromLooking) {
  Bench b;
  const OverrideCommand command = b.gate.set(90.0);
  double oldest = 0.0;
  for (int i = 0; i < 400; ++i) {
    b.link->apply(command, b.clock.now());
    const MachineState m = b.run(0.005);
    if (i > 20) oldest = std::max(oldest, m.valid ? secondsBetween(m.time, b.clock.now()).value : 1.0);
  }
  EXPECT_EQ(b.mill.spindle, 90);
  EXPECT_LT(oldest, 0.25);  // two ACKs of 100 ms, one after the other
}

TEST(LinuxCnc, LatestWinsAndNothingQueuesUp) {
  Bench b;
  b.run(0.2);
  const OverrideCommand low = b.gate.set(90.0);
  const OverrideCommand mid = b.gate.set(95.0);
  for (int i = 0; i < 400; ++i) {
    b.link->apply(i % 2 == 0 ? low : mid, b.clock.now());
    b.run(0.005);
  }
  EXPECT_LE(b.mill.sets, 45);  // two seconds and more, an ACK each 100 ms, on one connection
  b.link->apply(low, b.clock.now());
  b.run(0.5);
  EXPECT_EQ(b.mill.spindle, 90);
}

TEST(LinuxCnc, RepliesInPiecesWithNoiseBetweenThemAreRead) {
  Bench b;
  b.faults.split(3).garbage("\x01\xff garbage 12\r\n").delay(0.001);
  const MachineState m = b.run(2.0);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.programmedSpeed.value, 8000.0);
}

// Several in one piece, and one after the reply to the next question: never a number for another one.
TEST(LinuxCnc, RepliesThatComeTogetherOrInTheWrongOrderAreNoOtherAnswers) {
  for (const bool together : {true, false}) {
    Bench b;
    b.run(0.2);
    if (together) {
      b.faults.merge(0.015);
    } else {
      b.faults.wrongOrder(37);
    }
    int believed = 0;
    for (int i = 0; i < 400; ++i) {
      const MachineState m = b.run(0.005);
      if (!m.valid) continue;
      ++believed;
      EXPECT_EQ(m.programmedSpeed.value, 8000.0);
      EXPECT_EQ(m.speedOverride.value, 1.0);
      EXPECT_EQ(m.feedOverride.value, 1.0);
      EXPECT_NEAR(m.actualSpeed.value, 8000.0, 1.0);
    }
    EXPECT_GT(believed, 100) << "together " << together;
    b.faults = {};
    b.link->apply(b.gate.set(90.0), b.clock.now());
    EXPECT_NEAR(b.run(3.0).speedOverride.value, 0.9, 1e-6);
  }
}

// Started anew: nobody is in control, its overrides are at 100 %, and ours are not believed to stand there.
TEST(LinuxCnc, RestartedMachineIsFoundAgainAndHome) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  b.faults.refuse();
  for (ScriptedWire* w : {b.controlWire, b.watchWire, b.halWire}) w->hangUp();
  EXPECT_FALSE(b.run(0.3).linkUp);
  b.link->release(b.clock.now());  // the lease ran out meanwhile
  b.mill = {};
  b.faults.refuse(false);
  const MachineState m = b.run(2.0);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.speedOverride.value, 1.0);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
  EXPECT_EQ(b.mill.owner, nullptr);
}

// The override stays where the program left it: what brings it back is the release that follows.
TEST(LinuxCnc, AbortedProgramIsNotRunningAndTheReleaseBringsBack) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  b.mill.running = false;
  const MachineState m = b.run(0.5);
  EXPECT_TRUE(m.valid);
  EXPECT_FALSE(m.programRunning);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

TEST(LinuxCnc, NeverSaysWhatCrashesTheServer) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  b.link->release(b.clock.now());
  EXPECT_FALSE(b.mill.crashed);
}

TEST(LinuxCnc, NobodyThereIsOneLineThatNamesTheAddress) {
  Bench b;
  b.faults.refuse();
  const Status opened = b.link->open();
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().line(), "mill:5007: no answer (is linuxcncrsh running there?)");
}

TEST(LinuxCnc, EndOfTheLinkBringsTheOverridesBack) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  b.link.reset();
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

}  // namespace
}  // namespace stillcut::cnc
