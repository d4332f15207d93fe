// GRBL's manners on a scripted controller, on virtual time.
#include "core/cnc/grbl/grbl_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "core/safety/release_watch.h"
#include "tests/protocol/commands.h"
#include "tests/protocol/grbl_bench.h"
#include "tests/support/grbl/fake_grbl.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

using Bench = GrblBench;

TEST(GrblStatus, TakesTheReportOfTheManual) {
  GrblReport r;
  GrblWords w;
  ASSERT_EQ(readGrblLine("<Run|MPos:0.000,0.000,0.000|FS:1200,8800|Ov:110,100,95|A:S>", r, w), GrblLine::Report);
  EXPECT_EQ(r.state, GrblState::Run);
  EXPECT_EQ(r.feed, 1200.0);
  EXPECT_EQ(r.speed, 8800.0);
  EXPECT_EQ(r.feedOverride, 110);
  EXPECT_EQ(r.speedOverride, 95);
  EXPECT_FALSE(r.measuredSpeed);
}

TEST(GrblStatus, PassesOverUnknownFieldsAndRefusesNonsense) {
  GrblReport r;
  GrblWords w;
  ASSERT_EQ(readGrblLine("<Hold:0|WPos:1,2,3|Bf:15,128|FS:10,20,19|MPG:0|Sc:|H:1|Ov:bad,100,x|FW:grblHAL>", r, w),
            GrblLine::Report);
  EXPECT_EQ(r.state, GrblState::Hold);
  EXPECT_EQ(r.measuredSpeed, 19.0);
  EXPECT_FALSE(r.speedOverride);
  for (const char* line : {"<", "<>", "<Run|FS:1e999,nan", "ok", "error:9", "[GC:G0]", "[GC:", "Run|FS:1,2>"}) {
    EXPECT_NE(readGrblLine(line, r, w), GrblLine::Report) << line;
  }
}

TEST(GrblSteps, ReachEveryPercentageFromEveryOther) {
  for (int from = kGrblLowest; from <= kGrblHighest; ++from) {
    for (int to = kGrblLowest; to <= kGrblHighest; ++to) {
      int at = from;
      int rounds = 0;
      while (at != to && rounds < 30) {
        const GrblSteps s = stepToward(to, at, kGrblFeedBytes);
        ASSERT_TRUE(s.coarse != 0 || s.fine != 0) << from << " to " << to << " stuck at " << at;
        ASSERT_GE(s.percent, kGrblLowest);
        ASSERT_LE(s.percent, kGrblHighest);
        for (const int part : {s.percent, s.coarseAlone, s.fineAlone}) {
          ASSERT_TRUE(part >= std::min(at, to) && part <= std::max(at, to)) << from << " to " << to << " by " << part;
        }
        at = s.percent;
        ++rounds;
      }
      ASSERT_EQ(at, to) << "from " << from;
    }
  }
}

TEST(Grbl, ReadsTheMachine) {
  Bench b;
  ASSERT_TRUE(b.link->open().ok());
  const MachineState m = b.run(1.0);
  ASSERT_TRUE(m.valid && m.linkUp && m.programRunning);
  EXPECT_EQ(m.programmedSpeed.value, 8800.0);
  EXPECT_NEAR(toMmPerMin(m.programmedFeed), 1200.0, 1e-6);
  EXPECT_EQ(m.actualSpeed.value, 0.0);  // FS is what is programmed: nothing here measures
  EXPECT_FALSE(b.link->describe().machineWatchdog);
}

TEST(Grbl, BelievesNothingBeforeTheOverridesWereSeen) {
  Bench b;
  b.grbl.spindle = 120;
  EXPECT_FALSE(b.run(0.02).valid);
  const MachineState m = b.run(1.0);
  ASSERT_TRUE(m.valid);
  EXPECT_NEAR(m.operatorSpeed.value, 1.2, 1e-9);
}

TEST(Grbl, CommandStepsBothOverridesThereAndReleaseBack) {
  Bench b;
  b.run(0.5);
  b.link->apply(b.gate.set(93.0), b.clock.now());
  const MachineState m = b.run(0.5);
  EXPECT_EQ(b.grbl.spindle, 93);
  EXPECT_EQ(b.grbl.feed, 93);
  EXPECT_NEAR(m.speedOverride.value, 0.93, 1e-9);
  EXPECT_EQ(m.operatorSpeed.value, 1.0);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

TEST(Grbl, FeedFallsBeforeSpeedAndRisesAfterIt) {
  Bench b;
  b.run(1.0);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  ASSERT_EQ(b.grbl.moved, "fs");
  b.grbl.moved.clear();
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.moved, "sf");
}

// Orders with every tick: each replaces what has not been sent, and no step is sent before the one before it has shown.
TEST(Grbl, LatestWinsAndNothingQueuesUp) {
  Bench b;
  b.run(1.0);
  for (const double percent : {80.0, 105.0, 85.0, 95.0}) b.link->apply(b.gate.set(percent), b.clock.now());
  const std::size_t atOnce = b.grbl.moved.size();
  EXPECT_LE(atOnce, 2U);  // one step of each knob is under way, whatever was asked since
  b.run(2.0);
  EXPECT_EQ(b.grbl.spindle, 95);
  EXPECT_EQ(b.grbl.feed, 95);
}

TEST(Grbl, OperatorsKnobIsTheBaseOfOurs) {
  Bench b;
  b.grbl.spindle = 120;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  EXPECT_EQ(b.grbl.spindle, 108);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.spindle, 120);
}

TEST(Grbl, LostBytesAreSentAgain) {
  Bench b;
  b.run(0.5);
  b.grbl.ignores = true;
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  ASSERT_EQ(b.grbl.spindle, 100);
  b.grbl.ignores = false;
  b.run(2.0);
  EXPECT_EQ(b.grbl.spindle, 90);
  EXPECT_EQ(b.grbl.feed, 90);
}

// The report that is due with its "Ov:" just then was written before the step: it must not be stepped again.
TEST(Grbl, AReportOlderThanTheStepIsNoLostStep) {
  for (int reports = 0; reports < 10; ++reports) {
    Bench b;
    b.run(0.5);
    const int until = b.grbl.reports + reports;
    while (b.grbl.reports < until) b.run(0.005);
    b.link->apply(b.gate.set(91.0), b.clock.now());
    const MachineState m = b.run(1.0);
    EXPECT_EQ(b.grbl.moved.size(), 18U) << reports;  // nine times one down, of speed and feed
    EXPECT_EQ(b.grbl.spindle, 91) << reports;
    EXPECT_EQ(m.operatorSpeed.value, 1.0) << reports;
    b.link->release(b.clock.now());
    EXPECT_EQ(b.grbl.spindle, 100) << reports;
    EXPECT_EQ(b.grbl.feed, 100) << reports;
  }
}

// Answers that are on their way when a step goes out come after it and tell of before: no step is taken for lost, and
// the overrides never leap back to 100 %.
TEST(Grbl, ASlowWireLosesNoStep) {
  for (const double roundTrip : {0.02, 0.1, 0.2, 0.3}) {
    Bench b;
    b.faults.latency = Seconds(roundTrip);
    b.run(5.0);
    b.link->apply(b.gate.set(91.0), b.clock.now());
    int last = 100;
    for (int k = 0; k < 2000; ++k) {
      b.run(0.005);
      EXPECT_LE(b.grbl.feed, last) << roundTrip;
      last = b.grbl.feed;
    }
    EXPECT_EQ(b.grbl.moved.size(), 18U) << roundTrip;  // nine times one down, of speed and feed
    EXPECT_EQ(b.grbl.spindle, 91) << roundTrip;
    b.link->release(b.clock.now());
    b.run(3.0);
    EXPECT_EQ(b.grbl.spindle, 100) << roundTrip;
    EXPECT_EQ(b.grbl.feed, 100) << roundTrip;
  }
}

// Whenever it is released: once that counts as read back, it is home.
TEST(Grbl, OnASlowWireWhatIsSaidToBeHomeIsHome) {
  for (const double roundTrip : {0.05, 0.2}) {
    for (int tick = 0; tick < 200; tick += 3) {
      Bench b;
      b.faults.latency = Seconds(roundTrip);
      b.run(5.0);
      safety::ReleaseWatch watch;
      watch.set();
      b.link->apply(b.gate.set(83.0), b.clock.now());
      b.run(0.005 * tick);
      b.link->release(b.clock.now());
      watch.release(b.clock.now());
      for (int k = 0; k < 1000 && watch.notYetBack(); ++k) watch.look(b.run(0.005));
      EXPECT_FALSE(watch.notYetBack()) << roundTrip << " " << tick;
      EXPECT_EQ(b.grbl.spindle, 100) << roundTrip << " " << tick;
      EXPECT_EQ(b.grbl.feed, 100) << roundTrip << " " << tick;
    }
  }
}

// The line has no checksum: one flipped bit is no hand, moves nothing and ends nothing. One that is shown for long is
// taken for a hand until the truth comes back, and the machine is brought home to what it was.
TEST(Grbl, AFalseReportMovesNothing) {
  for (const int lie : {93, 19, 183}) {
    for (const int times : {1, 2, 30}) {
      Bench b;
      b.run(0.5);
      b.link->apply(b.gate.set(90.0), b.clock.now());
      b.run(1.0);
      ASSERT_EQ(b.grbl.feed, 90);
      const std::size_t moved = b.grbl.moved.size();
      b.grbl.lies = times;
      b.grbl.liedFeed = lie;
      b.run(5.0);
      EXPECT_EQ(b.grbl.moved.size(), moved) << lie << " said " << times << " times";
      b.link->release(b.clock.now());
      EXPECT_EQ(b.grbl.feed, 100) << lie << " said " << times << " times";
      EXPECT_EQ(b.grbl.spindle, 100);
    }
  }
}

// Let go of before the first step went out: it must not go out after all.
TEST(Grbl, AReleaseBeforeTheFirstStepIsObeyed) {
  Bench b;
  b.run(0.5);
  b.grbl.ignores = true;
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.link->release(b.clock.now());
  b.grbl.ignores = false;
  b.run(3.0);
  EXPECT_EQ(b.grbl.feed, 100);
  EXPECT_EQ(b.grbl.spindle, 100);
}

// Never more than the operator chose, not for one step of ten.
TEST(Grbl, TheWayHomeLeadsNowhereBeyond) {
  for (const int operators : {40, 66, 97, 116, 135}) {
    Bench b;
    b.grbl.feed = b.grbl.spindle = operators;
    b.run(0.5);
    b.link->apply(b.gate.set(90.0), b.clock.now());
    int highest = 0;
    for (int k = 0; k < 200; ++k) {
      b.run(0.01);
      highest = std::max({highest, b.grbl.feed, b.grbl.spindle});
    }
    b.link->apply(b.gate.relinquish(), b.clock.now());
    for (int k = 0; k < 200; ++k) {
      b.run(0.01);
      highest = std::max({highest, b.grbl.feed, b.grbl.spindle});
    }
    EXPECT_EQ(highest, operators);
    EXPECT_EQ(b.grbl.feed, operators);
    EXPECT_EQ(b.grbl.spindle, operators);
  }
}

// There is no acknowledgement that could lie: what was ordered counts once "Ov:" shows it. Home it goes all the same.
TEST(Grbl, ControllerThatTakesNoOverrideIsSeenToTakeNone) {
  Bench b;
  b.run(0.5);
  b.grbl.ignores = true;
  b.link->apply(b.gate.set(90.0), b.clock.now());
  const MachineState m = b.run(2.0);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.speedOverride.value, 1.0);
  EXPECT_EQ(m.feedOverride.value, 1.0);
  b.link->release(b.clock.now());
  EXPECT_TRUE(b.run(0.5).valid);
}

// The sender's own override buttons: the operator's hand, and not fought over.
TEST(Grbl, AnotherSendersOverrideEndsOursAndStays) {
  Bench b;
  b.run(0.5);
  const OverrideCommand command = b.gate.set(90.0);
  b.link->apply(command, b.clock.now());
  b.run(7.0);
  b.grbl.spindle = 120;
  b.run(1.0);
  b.link->apply(command, b.clock.now());  // the lease is renewed before the gate has seen it
  const MachineState m = b.run(1.0);
  EXPECT_NEAR(m.operatorSpeed.value, 1.2, 1e-9);
  EXPECT_EQ(b.grbl.spindle, 120);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.spindle, 120);
  EXPECT_EQ(b.grbl.feed, 100);
}

// On a slow wire a hand may come before our step has shown: it is no step that was lost on the way.
TEST(Grbl, AHandBeforeOurStepHasShownIsNotSentOver) {
  for (const double late : {0.01, 0.1, 0.2}) {
    Bench b;
    b.faults.delay(late);
    b.run(3.0);
    const OverrideCommand command = b.gate.set(90.0);
    const auto engaged = [&] {
      b.link->apply(command, b.clock.now());
      b.run(0.01);
    };
    for (int i = 0; i < 1500 && !(b.grbl.spindle == 90 && b.grbl.feed == 90); ++i) engaged();
    ASSERT_EQ(b.grbl.feed, 90) << late;
    b.grbl.turn(40, 10);
    for (int i = 0; i < 600; ++i) {
      engaged();
      ASSERT_EQ(b.grbl.spindle, 40) << late << ", " << i;
      ASSERT_EQ(b.grbl.feed, 10) << late << ", " << i;
    }
    b.link->release(b.clock.now());
    b.run(2.0);
    EXPECT_EQ(b.grbl.spindle, 40) << late;
    EXPECT_EQ(b.grbl.feed, 10) << late;
  }
}

// Once read, and not yet a second time: whoever lets go then sends nothing over it either.
TEST(Grbl, AHandThatWasReadOnceIsNotSentOverAtTheEnd) {
  Bench b;
  b.faults.delay(0.2);
  b.run(3.0);
  const OverrideCommand command = b.gate.set(90.0);
  for (int i = 0; i < 800; ++i) {
    b.link->apply(command, b.clock.now());
    b.run(0.01);
  }
  ASSERT_EQ(b.grbl.feed, 90);
  b.grbl.turn(40, 10);
  b.run(0.5);
  b.link->release(b.clock.now());
  b.run(5.0);
  EXPECT_EQ(b.grbl.spindle, 40);
  EXPECT_EQ(b.grbl.feed, 10);
}

TEST(Grbl, ReportsInPiecesTogetherOrInTheWrongOrderAreRead) {
  for (int script = 0; script < 4; ++script) {
    Bench b;
    if (script == 0) b.faults.split(3);
    if (script == 1) b.faults.merge(0.04);
    if (script == 2) b.faults.wrongOrder(5);
    if (script == 3) b.faults.garbage("\x01\xff<Run|Ov:\r\n").delay(0.03);
    b.run(1.0);
    b.link->apply(b.gate.set(93.0), b.clock.now());
    const MachineState m = b.run(2.0);
    EXPECT_TRUE(m.valid) << script;
    EXPECT_EQ(m.programmedSpeed.value, 8800.0) << script;
    EXPECT_EQ(b.grbl.spindle, 93) << script;
    b.link->release(b.clock.now());
    EXPECT_EQ(b.grbl.spindle, 100) << script;
  }
}

TEST(Grbl, HoldAbortAndAlarmAreSaid) {
  Bench b;
  b.run(0.5);
  b.grbl.state = "Hold:0";
  EXPECT_TRUE(b.run(0.1).feedHold);
  b.grbl.state = "Run";
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  b.grbl.state = "Idle";  // the program was aborted
  MachineState m = b.run(0.1);
  EXPECT_FALSE(m.programRunning);
  EXPECT_EQ(m.block, OverrideInhibit::NoProgram);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
  b.grbl.state = "Alarm";
  m = b.run(0.1);
  EXPECT_TRUE(m.valid);
  EXPECT_FALSE(m.programRunning);
  EXPECT_EQ(m.block, OverrideInhibit::MachineAlarm);
}

// Its real-time bytes are taken in every state.
TEST(Grbl, AlarmIsSaidAndTheOverridesComeBack) {
  Bench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  ASSERT_EQ(b.grbl.spindle, 90);
  b.grbl.state = "Alarm";
  EXPECT_EQ(b.run(0.1).block, OverrideInhibit::MachineAlarm);
  b.link.reset();
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

// release, close and the destructor in one go, and nobody answers: the time of one.
TEST(Grbl, HungControllerHoldsTheEndOnce) {
  Bench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  b.faults.hang();
  const Instant began = b.clock.now();
  b.link->release(began);
  b.link->close();
  b.link.reset();
  EXPECT_LT(secondsBetween(began, b.clock.now()).value, toSeconds(GrblLink::kReleaseTime).value + 0.05);
}

TEST(Grbl, RestartOfTheControllerIsNotMistakenForItsOldState) {
  Bench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  b.grbl.spindle = b.grbl.feed = 100;
  b.wire->say("\r\nGrbl 1.1h ['$' for help]\r\n");
  b.run(0.02);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

TEST(Grbl, SilenceIsInvalidWithinASecondAndOneLostReportIsNot) {
  Bench b;
  b.run(0.5);
  b.faults.hang();
  EXPECT_TRUE(b.run(0.1).valid);
  b.faults.hang(false);
  EXPECT_TRUE(b.run(0.5).valid);
  b.faults.hang();
  EXPECT_FALSE(b.run(1.0).valid);
}

TEST(Grbl, PulledCableIsBackAtTheProgrammedValuesOnceItIsIn) {
  Bench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(10.0);
  b.faults.refuse();
  b.wire->hangUp();
  EXPECT_FALSE(b.run(0.2).linkUp);
  b.link->release(b.clock.now());
  b.faults.refuse(false);
  EXPECT_TRUE(b.run(2.0).valid);
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

TEST(Grbl, EndOfTheLinkBringsTheOverridesBack) {
  Bench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  b.link.reset();
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

TEST(Grbl, ControllerThatAnswersNothingStillGetsTheBytesThatMeanProgrammed) {
  Bench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  b.faults.hang();
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

// What left us is not what arrived: the end waits until "Ov:" shows it, and sends again.
TEST(Grbl, BytesLostAtTheEndAreSentAgain) {
  Bench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  b.grbl.loses = 2;
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

TEST(Grbl, NobodyThereIsOneLine) {
  Bench b;
  b.faults.refuse();
  EXPECT_EQ(b.link->open().error().line(), "mill:5007: cannot be opened (is it there, and free?)");
}

}  // namespace
}  // namespace stillcut::cnc
