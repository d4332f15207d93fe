// LinuxCNC's manners on a scripted peer, on virtual time: what is read, what an order does, what the machine is left
// with. The real one: tests/protocol/linuxcnc_peer_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/protocol/emc_bench.h"

namespace stillcut::cnc {
namespace {

using namespace testing;
using Bench = EmcBench;

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
  EXPECT_LT(secondsBetween(m.time, b.clock.now()).value, 0.25);
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

// It takes no override then, so nothing is waited for: what stands there goes home once it is on again, if we are
// there.
TEST(LinuxCnc, QuittingWhileTheMachineIsOffIsAtOnceAndTheOverrideGoesHomeWhenItIsOn) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  b.mill.machineOn = b.mill.running = false;
  b.run(0.6);
  const Instant began = b.clock.now();
  b.link->release(began);
  EXPECT_LT(secondsBetween(began, b.clock.now()).value, 0.3);  // control is given back
  const MachineState m = b.run(0.5);
  EXPECT_EQ(m.block, OverrideInhibit::MachineOff);
  EXPECT_NEAR(m.speedOverride.value, 0.9, 1e-6);  // said, for it stays where we go now
  EXPECT_EQ(b.mill.owner, nullptr);
  b.mill.machineOn = true;
  b.run(1.0);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

// Off is obeyed however slow the answers are: what the hand has to say goes before any question.
TEST(LinuxCnc, AReleaseReachesAMachineWhoseAnswersAreSlow) {
  for (const double delay : {0.0005, 0.003, 0.005, 0.02, 0.1}) {
    Bench b;
    b.faults.delay(delay);
    b.run(3.0);
    for (int i = 0; i < 600; ++i) {
      b.link->apply(b.gate.set(90.0), b.clock.now());
      b.run(0.005);
    }
    ASSERT_EQ(b.mill.spindle, 90) << delay;
    ASSERT_EQ(b.mill.feed, 90) << delay;
    const Instant began = b.clock.now();
    b.link->release(began);
    EXPECT_EQ(b.mill.spindle, 100) << delay;
    EXPECT_EQ(b.mill.feed, 100) << delay;
    EXPECT_EQ(b.mill.owner, nullptr) << delay;
    EXPECT_LT(secondsBetween(began, b.clock.now()).value, 0.4 + 8.0 * delay) << "two sets of 100 ms, read back";
  }
}

// linuxcncrsh's words of two clients were seen to get mixed up.
TEST(LinuxCnc, AnOrderHomeThatIsAcknowledgedAndLostIsGivenAgain) {
  Bench b;
  b.run(0.5);
  b.link->apply(b.gate.set(83.0), b.clock.now());
  b.run(1.0);
  ASSERT_EQ(b.mill.spindle, 83);
  b.mill.lost = 2;
  b.link->apply(b.gate.relinquish(), b.clock.now());
  b.run(2.5);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

// Each override goes home by itself.
TEST(LinuxCnc, ARefusedOverrideKeepsTheOtherFromNothing) {
  for (const bool feedRefused : {true, false}) {
    Bench b;
    b.run(0.3);
    b.link->apply(b.gate.set(90.0), b.clock.now());
    b.run(1.0);
    (feedRefused ? b.mill.refusesFeed : b.mill.refusesSpeed) = true;
    b.link->release(b.clock.now());
    b.run(1.0);
    EXPECT_EQ(feedRefused ? b.mill.spindle : b.mill.feed, 100);
    (feedRefused ? b.mill.refusesFeed : b.mill.refusesSpeed) = false;
    b.run(1.5);
    EXPECT_EQ(b.mill.spindle, 100);
    EXPECT_EQ(b.mill.feed, 100);
  }
}

// Its words are split with one strtok for all: the less is asked, the longer it lives.
TEST(LinuxCnc, AsksTwentyTimesASecondAtMost) {
  Bench b;
  b.run(1.0);
  b.mill.questions = 0;
  b.run(10.0);
  EXPECT_LE(b.mill.questions, 200);
  EXPECT_GE(b.mill.questions, 100);
  b.mill.questions = 0;
  for (int i = 0; i < 2000; ++i) {
    b.link->apply(b.gate.set(i % 100 < 50 ? 90.0 : 95.0), b.clock.now());
    b.run(0.005);
  }
  EXPECT_LE(b.mill.questions, 230) << "commands as well, and whether control is ours";
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
  EXPECT_LT(oldest, 0.5);  // two ACKs of 100 ms, one after the other, and as often as it may be asked
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
