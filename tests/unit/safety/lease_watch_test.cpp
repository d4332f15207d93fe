// The link thread's lease, in virtual time. Commands come from a real gate: nothing else can make one.
#include "core/safety/lease_watch.h"

#include <gtest/gtest.h>

#include "core/safety/release_watch.h"
#include "tests/support/gate_harness.h"

namespace stillcut::safety {
namespace {

using testing::GateHarness;

// A worker (the harness) and a link thread that polls every 5 ms on its own clock, 100 s ahead of the stream.
class LeaseWatchTest : public ::testing::Test {
 protected:
  void SetUp() override { poll(); }

  void work() {
    const GateOutput out = worker_.step();
    if (out.command) mailbox_ = out.command;
  }
  LinkAction poll(double after = 0.005) {
    linkNow_ += toDuration(Seconds(after));
    const LinkAction action = lease_.poll(mailbox_ ? &*mailbox_ : nullptr, linkNow_);
    if (action == LinkAction::Release) ++releases_;
    if (action == LinkAction::Apply) ++applied_;
    return action;
  }
  void bothRun(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / 0.01 + 0.5); ++i) {
      work();
      poll();
      poll();
    }
  }
  void settle() {
    worker_.verdict.state = CutState::Chatter;
    worker_.authority(Authority::Auto);
    worker_.ask(9000, 900);
    bothRun(1.0);
    ASSERT_TRUE(lease_.inForce());
    ASSERT_EQ(releases_, 0);
  }

  GateHarness worker_;
  LeaseWatch lease_;
  std::optional<OverrideCommand> mailbox_;
  Instant linkNow_ = Instant(std::chrono::seconds(100));
  int releases_ = 0;
  int applied_ = 0;
};

TEST_F(LeaseWatchTest, EachNewCommandIsAppliedOnce) {
  settle();
  const int before = applied_;
  work();
  EXPECT_EQ(poll(), LinkAction::Apply);
  EXPECT_EQ(poll(), LinkAction::Nothing);
  EXPECT_EQ(applied_, before + 1);
}

TEST_F(LeaseWatchTest, AStalledWorkerLosesItsLease) {
  settle();
  double waited = 0.0;
  while (releases_ == 0 && waited < 1.0) {
    poll();
    waited += 0.005;
  }
  EXPECT_NEAR(waited, 0.2, 0.0051);
  EXPECT_EQ(lease_.expiries(), 1U);
  EXPECT_FALSE(lease_.inForce());
  for (int i = 0; i < 100; ++i) EXPECT_EQ(poll(), LinkAction::Nothing);  // once is enough, and nothing comes back
}

TEST_F(LeaseWatchTest, AWokenWorkerCannotJumpBackWhereItWas) {
  settle();
  for (int i = 0; i < 60; ++i) poll();
  ASSERT_EQ(releases_, 1);
  // To the worker no time has passed: it goes on renewing the old engagement at 90 %.
  work();
  ASSERT_EQ(mailbox_->kind(), CommandKind::Set);
  ASSERT_NEAR(mailbox_->speed().value, 0.9, 1e-9);
  EXPECT_NE(poll(), LinkAction::Apply);
  EXPECT_FALSE(lease_.inForce());
  // The machine reads 100 %: the gate lets go, rests, and starts from 100 % under a new number, which is obeyed.
  worker_.machineFollows = false;
  worker_.machine.speedOverride = worker_.machine.feedOverride = Ratio(1.0);
  worker_.machine.actualSpeed = Rpm(10000.0);
  applied_ = 0;
  double first = 0.0;
  for (int i = 0; i < 400 && applied_ == 0; ++i) {
    work();
    if (poll() == LinkAction::Apply) first = mailbox_->speed().value;
    poll();
  }
  EXPECT_GT(first, 0.94);
}

TEST_F(LeaseWatchTest, ReleaseIsPassedOn) {
  settle();
  worker_.act(OperatorAction::BackToProgrammed);
  while (worker_.last.commanding) {
    work();
    if (!worker_.last.commanding) break;
    EXPECT_EQ(poll(), LinkAction::Apply);  // the way home
  }
  ASSERT_EQ(worker_.lastCommand().kind, CommandKind::Release);
  EXPECT_EQ(poll(), LinkAction::Release);
  EXPECT_FALSE(lease_.inForce());
  EXPECT_EQ(lease_.expiries(), 0U);
}

TEST_F(LeaseWatchTest, ALinkThreadThatStoodStillReleases) {
  settle();
  for (int i = 0; i < 30; ++i) work();  // the worker goes on, nobody polls
  EXPECT_EQ(poll(0.3), LinkAction::Release);
  work();
  EXPECT_NE(poll(), LinkAction::Apply);  // same engagement
}

TEST_F(LeaseWatchTest, ACommandOfUnknownAgeIsNotObeyed) {
  // Nothing in force, nobody polled for long: the Set in the mailbox may be from then.
  worker_.verdict.state = CutState::Chatter;
  worker_.authority(Authority::Auto);
  worker_.ask(9000, 900);
  work();
  ASSERT_TRUE(mailbox_.has_value());
  EXPECT_EQ(poll(10.0), LinkAction::Nothing);
  work();
  EXPECT_EQ(poll(), LinkAction::Apply);

  LeaseWatch fresh;  // a restarted link finds an old mailbox
  EXPECT_EQ(fresh.poll(&*mailbox_, linkNow_), LinkAction::Nothing);
}

// Long blocks: one tick a block, and leases of at least two of them.
TEST_F(LeaseWatchTest, TicksAreAllowedToBeAsFarApartAsTheLease) {
  GateLimits limits = testing::promptLimits();
  limits.lease = Seconds(1.0);
  limits.machineAge = limits.verdictAge = Seconds(1.0);
  worker_.gate.prepare(limits);
  worker_.verdict.state = CutState::Chatter;
  worker_.authority(Authority::Auto);
  worker_.ask(9000, 900);
  poll(0.4);
  work();
  EXPECT_EQ(poll(0.4), LinkAction::Apply);
  work();
  EXPECT_EQ(poll(0.4), LinkAction::Apply);
  EXPECT_EQ(releases_, 0);
}

TEST_F(LeaseWatchTest, AClockThatGoesBackReleases) {
  settle();
  EXPECT_EQ(poll(-1.0), LinkAction::Release);
}

TEST_F(LeaseWatchTest, AnEmptyMailboxIsNothing) {
  LeaseWatch lease;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(lease.poll(nullptr, instantFromNs(i)), LinkAction::Nothing);
}

// A way home that takes a second ends with what was read before it still at hand.
TEST(ReleaseWatch, WhatWasHeardBeforeTellsNothingEvenWhereNothingIsReadBack) {
  for (const bool readable : {false, true}) {
    ReleaseWatch watch;
    MachineState m;
    m.valid = m.linkUp = m.overridesEnabled = true;
    m.speedOverride = m.feedOverride = m.operatorSpeed = m.operatorFeed = Ratio(1.0);
    const auto heard = [&](int ms) {
      m.time = instantFromNs(1'000'000L * ms);
      if (readable) m.link.overrides = m.time;
      watch.look(m);
    };
    watch.set();
    watch.release(instantFromNs(1'000'000L * 100));
    heard(90);
    EXPECT_TRUE(watch.notYetBack()) << readable;
    heard(1100);
    EXPECT_FALSE(watch.notYetBack()) << readable;
  }
}

}  // namespace
}  // namespace stillcut::safety
