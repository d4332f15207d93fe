// Hop 6 in virtual time: a command is sent while its lease lives, and however the run ends the machine is left with its
// programmed values.

#include "core/pipeline/link_runner.h"

#include <gtest/gtest.h>

#include <deque>
#include <optional>

#include "tests/support/gate_harness.h"
#include "tests/support/scripted_parts.h"

namespace stillcut::pipeline {
namespace {

// A gate that has been driven to a Set in force; every step gives a fresh one.
class CommandMaker {
 public:
  CommandMaker() { harness_.settleAt(9700.0, 970.0); }
  OverrideCommand next() { return *harness_.step().command; }
  // The last command of the way home.
  OverrideCommand release() {
    safety::GateOutput out = harness_.act(OperatorAction::BackToProgrammed);
    while (out.commanding) out = harness_.step();
    return *out.command;
  }

 private:
  safety::testing::GateHarness harness_;
};

class LinkRunnerTest : public ::testing::Test {
 protected:
  Instant at(double ms) const { return Instant(toDuration(Seconds(ms * 1e-3))); }
  void tickUntil(double ms) {
    for (; now_ <= ms; now_ += 5.0) {
      if (link_.state.valid) link_.state.link.overrides = at(now_);
      runner_->tick(at(now_));
    }
  }
  void show(Ratio speed, Ratio feed) {
    link_.state.valid = link_.state.linkUp = true;
    link_.state.speedOverride = speed;
    link_.state.feedOverride = feed;
  }

  rt::Mailbox<OverrideCommand> commands_;
  rt::Mailbox<MachineState> states_;
  test::CountingLink link_;
  std::optional<LinkRunner> runner_{std::in_place, link_, commands_, states_};
  CommandMaker maker_;
  double now_ = 0.0;
};

TEST_F(LinkRunnerTest, SendsEachCommandOnceAndReadsEveryTick) {
  tickUntil(10.0);
  commands_.post(maker_.next());
  tickUntil(50.0);
  EXPECT_EQ(link_.applied(), 1);
  EXPECT_EQ(link_.reads(), 11);
  EXPECT_EQ(link_.released(), 0);
  ASSERT_TRUE(states_.latest().has_value());
  EXPECT_EQ(states_.latest()->endedEngagement, 0U);
}

TEST_F(LinkRunnerTest, AStalledWorkerLosesTheMachineWhenTheLeaseRunsOut) {
  tickUntil(10.0);
  const OverrideCommand command = maker_.next();
  const double lease = toSeconds(command.lease()).value * 1e3;
  commands_.post(command);
  tickUntil(10.0 + lease - 10.0);
  EXPECT_EQ(link_.released(), 0);
  tickUntil(10.0 + lease + 10.0);  // no renewal came
  EXPECT_EQ(link_.released(), 1);
  EXPECT_EQ(runner_->leasesExpired(), 1U);
  EXPECT_EQ(states_.latest()->endedEngagement, command.engagement());  // the gate must hear of it
  const int applied = link_.applied();
  commands_.post(maker_.next());  // the worker wakes up and goes on where it was
  tickUntil(10.0 + lease + 100.0);
  EXPECT_EQ(link_.applied(), applied);  // that engagement is over
}

// The steady clock sleeps with the computer: by it, the worker renews in time.
TEST_F(LinkRunnerTest, ASleepOfTheComputerEndsTheLeaseAsTheTimeThatItIs) {
  ManualClock boot;
  runner_.emplace(link_, commands_, states_, Seconds(), &boot);
  const auto tick = [&](double aheadMs) {
    boot.set(at(now_ + aheadMs));
    runner_->tick(at(now_));
    now_ += 5.0;
  };
  for (int i = 0; i < 20; ++i) tick(7000.0);  // slept before the run began
  commands_.post(maker_.next());
  for (int i = 0; i < 20; ++i) tick(i % 2 == 0 ? 7000.0 : 7050.0);  // kept waiting between two looks
  EXPECT_EQ(link_.released(), 0);
  EXPECT_EQ(runner_->tally().stalls, 0U);
  const OverrideCommand command = maker_.next();
  commands_.post(command);
  tick(7000.0 + 3.6e6);
  EXPECT_EQ(link_.released(), 1);
  EXPECT_EQ(runner_->tally().leasesExpired, 1U);
  EXPECT_EQ(runner_->tally().stalls, 1U);
  EXPECT_EQ(states_.latest()->endedEngagement, command.engagement());
  const int applied = link_.applied();
  commands_.post(maker_.next());
  for (int i = 0; i < 20; ++i) tick(7000.0 + 3.6e6);
  EXPECT_EQ(link_.applied(), applied) << "that engagement is over";
  EXPECT_EQ(runner_->tally().stalls, 1U) << "slept once";
}

TEST_F(LinkRunnerTest, AThreadThatStoodStillIsCountedAndItsLastTickTold) {
  tickUntil(100.0);
  EXPECT_EQ(runner_->tally().stalls, 0U);
  EXPECT_EQ(runner_->tally().lastTick, at(100.0));
  now_ += 600.0;
  tickUntil(now_);
  EXPECT_EQ(runner_->tally().stalls, 1U);
  EXPECT_EQ(runner_->tally().leasesExpired, 0U) << "nothing was in force";
}

TEST_F(LinkRunnerTest, RenewedLeasesStayInForce) {
  tickUntil(10.0);
  for (int i = 0; i < 100; ++i) {
    commands_.post(maker_.next());
    tickUntil(now_ + 10.0);
  }
  EXPECT_EQ(link_.released(), 0);
  EXPECT_EQ(link_.applied(), 100);
}

TEST_F(LinkRunnerTest, TheEndOfTheRunReleases) {
  tickUntil(10.0);
  commands_.post(maker_.next());
  tickUntil(20.0);
  runner_.reset();
  EXPECT_EQ(link_.released(), 1);
}

// A machine whose overrides follow 80 ms late.
class LateLink final : public cnc::CncLink {
 public:
  static constexpr double kLate_s = 0.080;
  cnc::LinkInfo describe() const override { return {.id = "late", .label = "Late"}; }
  Status open() override { return Done{}; }
  MachineState read(Instant now) noexcept override {
    while (!orders_.empty() && secondsBetween(orders_.front().time, now).value >= kLate_s) {
      inForce_ = orders_.front();
      orders_.pop_front();
    }
    MachineState m;
    m.time = now;
    m.valid = m.linkUp = true;
    m.speedOverride = inForce_.speed;
    m.feedOverride = inForce_.feed;
    if (tells) m.link.overrides = now;
    return m;
  }
  void apply(const OverrideCommand& command, Instant now) noexcept override {
    orders_.push_back(command.record());
    orders_.back().time = now;
  }
  void release(Instant now) noexcept override {
    orders_.emplace_back();
    orders_.back().time = now;
  }

  bool tells = true;

 private:
  std::deque<CommandRecord> orders_;
  CommandRecord inForce_;
};

// While the gate's ramp goes from 100 % to its target.
Seconds measuredEffect(bool tells) {
  LateLink late;
  late.tells = tells;
  rt::Mailbox<OverrideCommand> commands;
  rt::Mailbox<MachineState> states;
  LinkRunner runner(late, commands, states);
  safety::testing::GateHarness harness;
  harness.verdict.state = CutState::Chatter;
  harness.authority(Authority::Auto);
  harness.ask(9500.0, 950.0);
  const Duration tick = toDuration(Seconds(0.005));
  Instant now{};
  for (int i = 0; i < 400; ++i, now += tick) {
    if (i % 2 == 0) {  // a block is two ticks long
      if (const auto step = harness.step(); step.command) commands.post(*step.command);
    }
    runner.tick(now);
  }
  return states.latest()->link.effect;
}

TEST(LinkRunnerMeasures, HowLongOrdersTakeToAct) {
  EXPECT_NEAR(measuredEffect(true).value, LateLink::kLate_s, 0.005);  // looked at every 5 ms
}

TEST(LinkRunnerMeasures, NothingWhereTheMachineTellsNothing) {
  EXPECT_EQ(measuredEffect(false).value, 0.0);
}

// The strategies wait as long before the first order as they would after it.
TEST(LinkRunnerMeasures, WhatAnEarlierRunMeasuredIsToldFromTheStart) {
  rt::Mailbox<OverrideCommand> commands;
  rt::Mailbox<MachineState> states;
  test::CountingLink link;
  LinkRunner runner(link, commands, states, Seconds(0.096));
  runner.tick(Instant(toDuration(Seconds(1.0))));
  ASSERT_TRUE(states.latest().has_value());
  EXPECT_EQ(states.latest()->link.effect.value, 0.096);
}

TEST_F(LinkRunnerTest, TheEndOfAnIdleRunSendsNothing) {
  tickUntil(20.0);
  runner_.reset();
  EXPECT_EQ(link_.released(), 0);
  EXPECT_EQ(link_.applied(), 0);
}

TEST_F(LinkRunnerTest, AReleaseReachesTheMachine) {
  tickUntil(10.0);
  commands_.post(maker_.next());
  tickUntil(20.0);
  commands_.post(maker_.release());
  tickUntil(30.0);
  EXPECT_EQ(link_.released(), 1);
  runner_.reset();
  EXPECT_EQ(link_.released(), 1);
}

// A link that goes on showing ours: what was released is not back before the machine shows it.
TEST_F(LinkRunnerTest, WhatWasReleasedIsNotBackUntilTheMachineShowsIt) {
  tickUntil(10.0);
  EXPECT_FALSE(runner_->tally().notYetBack) << "nothing was ever moved";
  const OverrideCommand ours = maker_.next();
  commands_.post(ours);
  show(ours.speed(), ours.feed());
  tickUntil(20.0);
  EXPECT_FALSE(runner_->tally().notYetBack) << "ours is in force, and meant to be";
  commands_.post(maker_.release());
  tickUntil(200.0);
  EXPECT_TRUE(runner_->tally().notYetBack);
  show(Ratio(1.0), ours.feed());
  tickUntil(300.0);
  EXPECT_TRUE(runner_->tally().notYetBack) << "one of two is back";
  show(Ratio(1.0), Ratio(1.0));
  tickUntil(310.0);
  EXPECT_FALSE(runner_->tally().notYetBack);
}

}  // namespace
}  // namespace stillcut::pipeline
