// The LinuxCNC link with stillcut-hal beside the machine, on virtual time: what the machine is left with, whoever dies.
// Over 400 lines: every end of one link, on one bench; the words between link and component are tested with them.
// The real ones: tests/protocol/linuxcnc_hal_peer_test.cpp.
#include <gtest/gtest.h>

#include <memory>

#include "core/cnc/linuxcnc_link.h"
#include "tests/protocol/commands.h"
#include "tests/protocol/fake_hal.h"

namespace stillcut::cnc {
namespace {

using namespace testing;
using hal::OverrideKeeper;

constexpr double kStep = 0.002;

struct Bench {
  explicit Bench(bool adaptiveFeed = false) {
    LinuxCncLink::Wires wires;
    const auto wire = [&](Peer& peer, WireFaults& its) { return std::make_unique<ScriptedWire>(clock, its, peer); };
    auto control = wire(hal, faults);
    component = control.get();
    wires.control = std::move(control);
    auto seen = wire(watch, watchFaults);
    watchWire = seen.get();
    wires.watch = std::move(seen);
    wires.hal = wire(halrmt, faults);
    LinuxCncSettings settings;
    settings.component.port = 5008;
    settings.adaptiveFeed = adaptiveFeed;
    link = std::make_unique<LinuxCncLink>(settings, std::move(wires), clock);
    for (int i = 0; i < 700; ++i) machine();  // long enough for the watchdog to be seen acting
  }
  void machine() {
    clock.advance(Seconds(kStep));
    hal.tick();
  }
  MachineState run(double seconds) {
    MachineState m;
    for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end; machine()) {
      m = link->read(clock.now());
    }
    return m;
  }
  // The machine alone: Stillcut hangs.
  void leave(double seconds) {
    for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end;) machine();
  }
  void engage(double percent) {
    run(0.2);
    link->apply(gate.set(percent), clock.now());
    run(0.3);
  }

  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults, watchFaults;
  FakeMill mill;
  FakeEmcClient watch{mill}, halrmt{mill};
  FakeHal hal{mill, clock};
  ScriptedWire *component = nullptr, *watchWire = nullptr;
  CommandMaker gate;
  std::unique_ptr<LinuxCncLink> link;
};

TEST(LinuxCncHal, WatchdogIsProvenBeforeAnythingIsTakenAndNothingMoves) {
  Bench b;
  EXPECT_FALSE(b.link->describe().machineWatchdog);  // not heard yet
  b.run(0.2);
  EXPECT_TRUE(b.link->describe().machineWatchdog);
  const int ms = b.hal.keeper.report(FakeHal::kOurs).watchdogMs;
  EXPECT_GE(ms, 25);
  EXPECT_LE(ms, 40);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.owner, nullptr);
}

TEST(LinuxCncHal, WithoutAWiredWatchdogNothingIsTakenAndItIsSaid) {
  Bench b;
  b.hal.watchdog.wired = false;
  b.hal.keeper = {};
  b.leave(2.0);
  b.engage(90.0);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_FALSE(b.link->describe().machineWatchdog);
  EXPECT_FALSE(b.run(0.1).controlOurs);
  const Status opened = b.link->open();
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().line().find("watchdog was not seen to act"), std::string::npos) << opened.error().line();
}

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
    b.link->apply(b.gate.letGo(), b.clock.now());
    b.run(0.3);
    EXPECT_EQ(b.mill.spindle, 100);
    EXPECT_EQ(b.mill.feed, 100);
    b.watchFaults.refuse(false);
    const MachineState m = b.run(2.0);
    EXPECT_TRUE(m.valid);
    EXPECT_EQ(m.operatorSpeed.value, 1.0);
    EXPECT_EQ(b.mill.spindle, 100);
    EXPECT_EQ(b.hal.keeper.report(FakeHal::kOurs).standing, HalStanding::Home);
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
  EXPECT_EQ(b.hal.keeper.report(FakeHal::kOurs).standing, HalStanding::Home);
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
  b.link->apply(b.gate.letGo(), b.clock.now());
  b.run(1.2);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
}

TEST(LinuxCncHal, OperatorsSwitchTakesUsOutUntilWeLetGo) {
  Bench b;
  b.engage(90.0);
  b.hal.permit = false;
  EXPECT_FALSE(b.run(0.2).controlOurs);
  EXPECT_EQ(b.mill.spindle, 100);
  b.hal.permit = true;
  b.run(0.3);
  EXPECT_EQ(b.mill.spindle, 100);  // not by itself
  b.link->apply(b.gate.letGo(), b.clock.now());
  EXPECT_TRUE(b.run(0.3).controlOurs);
  b.engage(90.0);
  EXPECT_EQ(b.mill.spindle, 90);
}

// linuxcncrsh belongs to somebody else: no control of it is needed.
TEST(LinuxCncHal, AnotherClientInControlOfLinuxcncrshChangesNothing) {
  Bench b;
  b.mill.owner = &b;
  b.engage(90.0);
  EXPECT_TRUE(b.run(0.1).controlOurs);
  EXPECT_EQ(b.mill.spindle, 90);
  EXPECT_EQ(b.mill.owner, &b);
}

// Two programs on one component: whoever came first holds, the other is told so and may go on looking.
TEST(LinuxCncHal, SecondClientLooksAndHoldsNothingUntilTheFirstHasLetGo) {
  Bench b;
  b.engage(90.0);
  constexpr int kOther = FakeHal::kOurs + 1;
  OverrideKeeper& keeper = b.hal.keeper;
  for (int i = 0; i < 50; ++i) {
    keeper.take(*readHalRequest("home 70 70"), kOther, b.clock.now());  // as a monitor says every 10 ms
    EXPECT_EQ(keeper.report(kOther).standing, HalStanding::Taken);
    keeper.take(*readHalRequest("set 50 50 1 70 70"), kOther, b.clock.now());
    EXPECT_TRUE(b.run(0.01).controlOurs);
  }
  EXPECT_EQ(b.mill.spindle, 90);
  EXPECT_EQ(b.hal.pins.homeSpeed, 100);
  keeper.clientGone(kOther, b.clock.now());
  b.run(0.2);
  EXPECT_EQ(b.mill.spindle, 90) << "somebody else's end is not ours";
  b.link->release(b.clock.now());
  b.run(0.3);
  ASSERT_EQ(b.mill.spindle, 100);
  keeper.take(*readHalRequest("set 95 95 1 100 100"), kOther, b.clock.now());
  const MachineState m = b.run(0.02);
  EXPECT_EQ(m.block, OrderBlock::OtherClient);
  EXPECT_EQ(keeper.report(kOther).standing, HalStanding::Held);
}

// What would be home later than the lease is no proof.
TEST(LinuxCncHal, WatchdogThatIsTooSlowForTheLeaseIsNotTaken) {
  for (const int ms : {30, 60, 90, 400}) {
    test::VirtualClock clock{instantFromNs(1'000'000'000)};
    OverrideKeeper keeper;
    FakeWatchdog watchdog(std::chrono::milliseconds{ms});
    for (int i = 0; i < 2500; ++i) {
      watchdog.look(keeper.tick({watchdog.ok, true}, clock.now()), clock.now());
      clock.advance(Seconds(kStep));
    }
    EXPECT_EQ(keeper.report(1).standing, ms < 70 ? HalStanding::Home : HalStanding::Unproven) << ms;
  }
}

TEST(LinuxCncHal, LockedOverrideIsSaid) {
  Bench b;
  b.mill.lock(true);  // M49: read back, without effect
  b.engage(90.0);
  const MachineState m = b.run(2.0);
  EXPECT_FALSE(m.overridesEnabled);
  EXPECT_EQ(m.block, OrderBlock::OverridesLocked);
  EXPECT_NEAR(m.speedOverride.value, 1.0, 1e-9);
  EXPECT_NEAR(m.feedOverride.value, 1.0, 1e-9);
}

// The pin shows 0.9 and the program has not said M52 P1: only the path's velocity tells.
TEST(LinuxCncHal, AdaptiveFeedThatIsNotHeededIsSaid) {
  for (const bool heeded : {false, true}) {
    Bench b(true);
    b.mill.adaptiveHeeded = heeded;
    b.engage(90.0);
    const MachineState m = b.run(2.0);
    EXPECT_EQ(m.block, heeded ? OrderBlock::None : OrderBlock::AdaptiveLocked);
    EXPECT_EQ(m.overridesEnabled, heeded);
    EXPECT_NEAR(m.feedOverride.value, heeded ? 0.9 : 1.0, 1e-3);
    EXPECT_NEAR(m.speedOverride.value, 0.9, 1e-6);
  }
}

// Why the knobs are not ours: silent, or not proven, or taken out.
TEST(LinuxCncHal, WhyTheKnobsAreNotOursIsToldApart) {
  Bench b;
  b.engage(90.0);
  EXPECT_EQ(b.run(0.1).block, OrderBlock::None);
  b.hal.permit = false;
  EXPECT_EQ(b.run(0.1).block, OrderBlock::ComponentOut);
  b.hal.permit = true;
  b.link->release(b.clock.now());
  EXPECT_EQ(b.run(0.2).block, OrderBlock::None);
  b.hal.keeper = {};  // loaded anew
  b.hal.watchdog.wired = false;
  EXPECT_EQ(b.run(1.5).block, OrderBlock::ComponentDown);
  b.hal.killed = true;
  EXPECT_EQ(b.run(0.5).block, OrderBlock::ComponentSilent);
}

TEST(LinuxCncHal, AbortedProgramIsNotRunningAndTheReleaseBringsBack) {
  Bench b;
  b.engage(90.0);
  b.mill.running = false;
  EXPECT_FALSE(b.run(0.1).programRunning);
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
  b.run(0.1);
  b.faults.refuse(false);
  b.link->apply(b.gate.letGo(), b.clock.now());  // the lease ran out meanwhile
  const OverrideCommand command = b.gate.set(91.0);
  b.link->apply(command, b.clock.now());
  for (int i = 0; i < 2000 && b.mill.spindle == 100; ++i) b.run(kStep);
  EXPECT_EQ(b.mill.spindle, 91);
  EXPECT_GT(b.hal.keeper.report(FakeHal::kOurs).watchdogMs, 0);
}

TEST(LinuxCncHal, ReportsThatComeTogetherAreHeard) {
  Bench b;
  b.faults.merge(0.015);
  b.engage(90.0);
  EXPECT_EQ(b.mill.spindle, 90);
}

// A report that is kept back is silence: the machine may go home, and nowhere else.
TEST(LinuxCncHal, ReportsInTheWrongOrderAreOursOrHome) {
  Bench b;
  b.engage(90.0);
  b.faults.wrongOrder(37);
  for (int i = 0; i < 1000; ++i) {
    b.run(kStep);
    EXPECT_TRUE(b.mill.spindle == 90 || b.mill.spindle == 100) << b.mill.spindle;
  }
  b.faults = {};
  b.link->apply(b.gate.letGo(), b.clock.now());
  b.run(1.0);
  EXPECT_EQ(b.mill.spindle, 100);
  b.engage(92.0);
  EXPECT_EQ(b.mill.spindle, 92);
}

TEST(LinuxCncHal, SplitAndGarbledLinesAreNoOrders) {
  Bench b;
  b.faults.split(3).garbage("HELD 9999 1 1 1\n\x01zz\n");
  b.engage(90.0);
  EXPECT_EQ(b.mill.spindle, 90);
  for (const char* line : {"set", "set 90", "set 90 90 1", "set 90 90 2 100 100", "set 1e9 90 1 100 100", "home 100",
                           "set 90.5 90 1 100 100", "set nan 90 1 100 100", "home 100 100 100", "set -1 9 1 1 1"}) {
    EXPECT_FALSE(readHalRequest(line)) << line;
  }
}

TEST(LinuxCncHal, WordsAreReadAsTheyWereWritten) {
  std::array<char, kHalLine> text{};
  HalRequest r;
  r.hold = true;
  r.feed = 1000;
  r.adaptiveFeed = 0.25;
  r.homeSpeed = 70;
  std::string line(writeHalRequest(r, text));
  EXPECT_EQ(line, "set - 1000 0.250 70 100\n");
  line.pop_back();
  const auto back = readHalRequest(line);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->hold && !back->speed && back->feed == 1000 && back->homeSpeed == 70);
  const HalReport report{HalStanding::Fallen, 90, 95, 0.5, 71};
  line = writeHalReport(report, text);
  line.pop_back();
  const auto heard = readHalReport(line);
  ASSERT_TRUE(heard);
  EXPECT_TRUE(heard->standing == HalStanding::Fallen && heard->speed == 90 && heard->feed == 95 &&
              heard->adaptiveFeed == 0.5 && heard->watchdogMs == 71);
}

}  // namespace
}  // namespace stillcut::cnc
