// stillcut-hal's keeper alone, on virtual time: when the machine's watchdog counts as proven, and whose the knobs are.
#include "app/hal/override_arbiter.h"

#include <gtest/gtest.h>

#include "tests/protocol/fake_hal.h"

namespace stillcut::hal {
namespace {

using cnc::HalLeaseState;
using cnc::testing::FakeWatchdog;

constexpr int kFirst = 1, kSecond = 2;
constexpr const char* kHold = "set 90 90 1 100 100";
constexpr const char* kHome = "home 100 100";

struct Bench {
  explicit Bench(std::chrono::milliseconds patience = std::chrono::milliseconds{30}) : watchdog(patience) {}
  void tick() { watchdog.look(pins = keeper.tick({watchdog.ok, permit}, clock.now()), clock.now()); }
  void run(double seconds) {
    for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end;) {
      clock.advance(Seconds(0.002));
      tick();
    }
  }
  // Says so every 10 ms, as a link does.
  void insist(int client, const char* line, double seconds) {
    for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end; run(0.01)) {
      keeper.take(*cnc::readHalRequest(line), client, clock.now());
    }
  }
  // The first holds, and the operator's switch takes it out.
  void holdAndFall() {
    run(1.5);
    insist(kFirst, kHold, 0.1);
    ASSERT_EQ(standing(kFirst), HalLeaseState::Held);
    permit = false;
  }
  HalLeaseState standing(int client) const { return keeper.report(client).standing; }

  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  FakeWatchdog watchdog;
  OverrideArbiter keeper;
  ArbiterPins pins;
  bool permit = true;
};

// What would be home later than the lease is no proof.
TEST(OverrideArbiter, WatchdogThatIsTooSlowForTheLeaseIsNotTaken) {
  for (const int ms : {30, 60, 90, 400}) {
    Bench b(std::chrono::milliseconds{ms});
    b.run(5.0);
    EXPECT_EQ(b.standing(kFirst), ms < 70 ? HalLeaseState::Home : HalLeaseState::Unproven) << ms;
  }
}

// Held up by the host, it sees a watchdog that has let go some time or other: that is measured again.
TEST(OverrideArbiter, AProofThatWasSeenTooLateIsMeasuredAgain) {
  Bench b;
  for (int i = 0; i < 1000 && !b.watchdog.ok; ++i) b.run(0.002);
  b.run(0.01);
  ASSERT_TRUE(b.watchdog.ok);
  b.clock.advance(Seconds(0.1));
  b.watchdog.look(b.pins, b.clock.now());
  ASSERT_FALSE(b.watchdog.ok);
  b.tick();
  EXPECT_EQ(b.standing(kFirst), HalLeaseState::Unproven);
  EXPECT_EQ(b.keeper.report(kFirst).watchdogMs, 0);
  b.run(1.5);
  EXPECT_EQ(b.standing(kFirst), HalLeaseState::Home);
  EXPECT_LE(b.keeper.report(kFirst).watchdogMs, 40);
}

// Who fell and lives keeps the others out until it has let go: in the time of a tick, when the gate does.
TEST(OverrideArbiter, OneThatHasFallenIsToldSoAndTheOthersWhoseTheyAre) {
  Bench b;
  b.holdAndFall();
  b.insist(kFirst, kHold, 0.3);
  EXPECT_EQ(b.standing(kFirst), HalLeaseState::Fallen);
  EXPECT_EQ(b.standing(kSecond), HalLeaseState::Taken);
  b.permit = true;
  b.insist(kFirst, kHold, 0.3);
  EXPECT_EQ(b.standing(kFirst), HalLeaseState::Fallen) << "not by itself";
  b.insist(kFirst, kHome, 0.02);
  b.insist(kSecond, kHold, 0.02);
  EXPECT_EQ(b.standing(kSecond), HalLeaseState::Held);
}

// Its cable was pulled, so nobody hangs up: the lease ends a fall as it ends a hold.
TEST(OverrideArbiter, OneThatFellAndDiedKeepsNobodyOut) {
  Bench b;
  b.holdAndFall();
  b.run(0.01);
  ASSERT_EQ(b.standing(kFirst), HalLeaseState::Fallen);
  b.permit = true;
  b.run(toSeconds(OverrideArbiter::kLease).value + 0.02);
  b.insist(kSecond, "set 95 95 1 100 100", 0.1);
  EXPECT_EQ(b.standing(kSecond), HalLeaseState::Held);
  EXPECT_EQ(b.pins.speed, 95);
}

// It was only held up: what it went on holding has ended, and it has to let go before it takes again.
TEST(OverrideArbiter, OneThatFellAndComesBackHasToLetGoFirst) {
  Bench b;
  b.holdAndFall();
  b.run(0.2);
  b.permit = true;
  b.insist(kFirst, kHold, 0.2);
  EXPECT_EQ(b.standing(kFirst), HalLeaseState::Fallen);
  EXPECT_EQ(b.standing(kSecond), HalLeaseState::Home);
  EXPECT_EQ(b.pins.speed, 100);
  b.insist(kFirst, kHome, 0.02);
  EXPECT_EQ(b.standing(kFirst), HalLeaseState::Home);
  b.insist(kFirst, kHold, 0.1);
  EXPECT_EQ(b.standing(kFirst), HalLeaseState::Held);
  EXPECT_EQ(b.pins.speed, 90);
}

}  // namespace
}  // namespace stillcut::hal
