// Who holds the knobs through stillcut-hal: nobody before the watchdog was seen to act, then one, and why not we.
#include <gtest/gtest.h>

#include "tests/protocol/hal_bench.h"

namespace stillcut::cnc {
namespace {

using namespace testing;
using hal::OverrideArbiter;
using Bench = HalBench;

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

TEST(LinuxCncHal, OperatorsSwitchTakesUsOutUntilWeLetGo) {
  Bench b;
  b.engage(90.0);
  b.hal.permit = false;
  EXPECT_FALSE(b.run(0.2).controlOurs);
  EXPECT_EQ(b.mill.spindle, 100);
  b.hal.permit = true;
  b.run(0.3);
  EXPECT_EQ(b.mill.spindle, 100);  // not by itself
  b.link->apply(b.gate.relinquish(), b.clock.now());
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
  OverrideArbiter& keeper = b.hal.keeper;
  for (int i = 0; i < 50; ++i) {
    keeper.take(*readHalRequest("home 70 70"), kOther, b.clock.now());  // as a monitor says every 10 ms
    EXPECT_EQ(keeper.report(kOther).standing, HalLeaseState::Taken);
    keeper.take(*readHalRequest("set 50 50 1 70 70"), kOther, b.clock.now());
    EXPECT_TRUE(b.run(0.01).controlOurs);
  }
  EXPECT_EQ(b.mill.spindle, 90);
  EXPECT_EQ(b.hal.pins.restoreSpeed, 100);
  keeper.clientGone(kOther, b.clock.now());
  b.run(0.2);
  EXPECT_EQ(b.mill.spindle, 90) << "somebody else's end is not ours";
  b.link->release(b.clock.now());
  b.run(0.3);
  ASSERT_EQ(b.mill.spindle, 100);
  keeper.take(*readHalRequest("set 95 95 1 100 100"), kOther, b.clock.now());
  const MachineState m = b.run(0.02);
  EXPECT_EQ(m.block, OverrideInhibit::OtherClient);
  EXPECT_EQ(keeper.report(kOther).standing, HalLeaseState::Held);
}

TEST(LinuxCncHal, LockedOverrideIsSaid) {
  Bench b;
  b.mill.lock(true);  // M49: read back, without effect
  b.engage(90.0);
  const MachineState m = b.run(2.0);
  EXPECT_FALSE(m.overridesEnabled);
  EXPECT_EQ(m.block, OverrideInhibit::OverridesLocked);
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
    EXPECT_EQ(m.block, heeded ? OverrideInhibit::None : OverrideInhibit::AdaptiveLocked);
    EXPECT_EQ(m.overridesEnabled, heeded);
    EXPECT_NEAR(m.feedOverride.value, heeded ? 0.9 : 1.0, 1e-3);
    EXPECT_NEAR(m.speedOverride.value, 0.9, 1e-6);
  }
}

// Why the knobs are not ours: silent, or not proven, or taken out.
TEST(LinuxCncHal, WhyTheKnobsAreNotOursIsToldApart) {
  Bench b;
  b.engage(90.0);
  EXPECT_EQ(b.run(0.1).block, OverrideInhibit::None);
  b.hal.permit = false;
  EXPECT_EQ(b.run(0.1).block, OverrideInhibit::ComponentOut);
  b.hal.permit = true;
  b.link->release(b.clock.now());
  EXPECT_EQ(b.run(0.2).block, OverrideInhibit::None);
  b.hal.keeper = {};  // loaded anew
  b.hal.watchdog.wired = false;
  EXPECT_EQ(b.run(1.5).block, OverrideInhibit::ComponentDown);
  b.hal.killed = true;
  EXPECT_EQ(b.run(0.5).block, OverrideInhibit::ComponentSilent);
}

// Taken out by the operator's switch, the first has not let go yet: the second is told whose they are, and its own end
// waits for nothing.
TEST(LinuxCncHal, SecondClientOfOneThatHasFallenWaitsForNothingAtItsEnd) {
  Bench b;
  b.run(0.2);
  constexpr int kOther = FakeHal::kOurs + 1;
  const HalRequest holding = *readHalRequest("set 90 90 1 100 100");
  for (int i = 0; i < 20; ++i) {
    b.hal.permit = i < 10;
    b.hal.keeper.take(holding, kOther, b.clock.now());
    b.run(0.01);
  }
  ASSERT_EQ(b.hal.keeper.report(kOther).standing, HalLeaseState::Fallen);
  EXPECT_EQ(b.run(0.02).block, OverrideInhibit::OtherClient);
  const Instant began = b.clock.now();
  b.link->release(began);
  EXPECT_LT(secondsBetween(began, b.clock.now()).value, 0.05);
}

}  // namespace
}  // namespace stillcut::cnc
