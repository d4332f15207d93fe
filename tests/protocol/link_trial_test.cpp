// What a person is told of a link, step by step.
#include "core/cnc/link_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/support/virtual_clock.h"

namespace stillcut::cnc {
namespace {

class Machine final : public CncLink {
 public:
  explicit Machine(test::VirtualClock& clock) : clock_(clock) {}
  bool there = true, readable = true, watchdog = false, kept = false, measures = true;
  int lostLooks = 0, closed = 0, moved = 0;

  LinkInfo describe() const override {
    LinkInfo info;
    info.label = "Mill";
    info.machineWatchdog = watchdog;
    info.kept = kept;
    return info;
  }
  Status open() override {
    return there ? Status(Done{}) : Status(Error{message("mill:1"), message("no answer"), message("is it on?")});
  }
  MachineState read(Instant) noexcept override {
    MachineState m;
    m.time = clock_.now();
    clock_.advance(Seconds(readable ? 0.004 : 0.5));
    m.valid = readable && (looks_++ == 0 || lostLooks-- <= 0);
    m.programmedSpeed = Rpm(8000.0);
    m.actualSpeed = Rpm(measures ? 7200.0 : 0.0);
    m.speedOverride = Ratio(0.9);
    return m;
  }
  void apply(const OverrideCommand&, Instant) noexcept override { ++moved; }
  void release(Instant) noexcept override {}
  void close() noexcept override { ++closed; }

 private:
  test::VirtualClock& clock_;
  int looks_ = 0;
};

struct Bench {
  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  Machine machine{clock};
  LinkTrial trial{machine, clock};
  const LinkTrialStep& run() {
    while (trial.next()) {
    }
    return trial.steps().back();
  }
};

TEST(LinkTrial, GoodLinkPassesEveryStepIsMeasuredAndNothingMoves) {
  Bench b;
  b.run();
  ASSERT_EQ(b.trial.steps().size(), LinkTrial::kSteps);
  EXPECT_TRUE(b.trial.passed());
  EXPECT_NEAR(b.trial.look().value, 0.004, 1e-9);
  EXPECT_NEAR(b.trial.age().value, 0.004, 1e-9);
  EXPECT_EQ(text(b.trial.steps()[1].said),
            "no program running; spindle 7200 rpm, programmed 8000; overrides 90 % speed, 100 % feed");
  EXPECT_EQ(b.machine.closed, 1);
  EXPECT_EQ(b.machine.moved, 0);
}

TEST(LinkTrial, ASpeedThatNothingMeasuresIsNoSpeed) {
  Bench b;
  b.machine.measures = false;
  b.run();
  EXPECT_NE(text(b.trial.steps()[1].said).find("spindle programmed 8000 rpm, not measured"), std::string::npos);
}

TEST(LinkTrial, SaysWhetherTheMachineWatches) {
  Bench without;
  EXPECT_NE(text(without.run().said).find("no watchdog"), std::string::npos);
  Bench with;
  with.machine.watchdog = true;
  EXPECT_NE(text(with.run().said).find("goes back by itself"), std::string::npos);
  Bench kept;
  kept.machine.kept = true;
  EXPECT_NE(text(kept.run().said).find("they stay where both are killed at once"), std::string::npos);
}

// Where a run holds the machine nothing more is asked of it: the run tells the same, and says so.
TEST(LinkTrial, AsTheRunTells) {
  Bench b;
  MachineState m = b.machine.read(b.clock.now());
  m.link.roundTrip = Seconds(0.0048);
  const auto steps = LinkTrial::ofRun(b.machine.describe(), m, Seconds(0.012), Seconds(0.096));
  ASSERT_EQ(steps.size(), LinkTrial::kSteps);
  EXPECT_EQ(text(steps[0].said), "Mill answers; as the run that holds the machine tells: nothing more was asked");
  EXPECT_EQ(text(steps[2].said), "a look takes 4.8 ms, and what it shows is 12.0 ms old");
  b.run();
  EXPECT_EQ(text(steps[1].said), text(b.trial.steps()[1].said));
  EXPECT_NE(text(steps[3].said).find("an order was seen to act, and to be taken back, after 96 ms"), std::string::npos);
  m.valid = false;
  const auto silent = LinkTrial::ofRun(b.machine.describe(), m, Seconds(3.0), {});
  EXPECT_EQ(silent.size(), 2U);
  EXPECT_FALSE(silent.back().good);
}

// What a machine can do is what it was told it can, until an order has shown it.
TEST(LinkTrial, SaysWhetherAnOrderHasShownWhatItCanDo) {
  Bench b;
  EXPECT_NE(text(b.run().said).find("no order has shown it yet"), std::string::npos);
  Bench proved;
  while (!proved.trial.atLast()) ASSERT_TRUE(proved.trial.next());
  proved.trial.proved(Seconds(0.0962));
  EXPECT_NE(text(proved.run().said).find("an order was seen to act, and to be taken back, after 96 ms"),
            std::string::npos);
}

TEST(LinkTrial, StopsAtTheStepThatFailsAndSaysWhy) {
  Bench absent;
  absent.machine.there = false;
  EXPECT_EQ(text(absent.run().said), "mill:1: no answer (is it on?)");
  EXPECT_EQ(absent.trial.steps().size(), 1U);
  EXPECT_FALSE(absent.trial.passed());
  EXPECT_EQ(absent.machine.closed, 1);

  Bench mute;
  mute.machine.readable = false;
  EXPECT_EQ(mute.run().what, "Read the machine");
  EXPECT_FALSE(mute.trial.passed());
}

TEST(LinkTrial, LostLooksAreCountedAndTooManyFail) {
  Bench b;
  b.machine.lostLooks = 40;
  const LinkTrialStep& last = b.run();
  EXPECT_FALSE(last.good);
  EXPECT_NE(text(last.said).find("40 of 60 looks were lost"), std::string::npos) << text(last.said);
}

// A sentence that is missing there would reach a German screen in English.
TEST(LinkTrial, EverythingThatItSaysIsListedForTranslation) {
  const auto listed = [](const std::string& form) {
    return std::ranges::any_of(LinkTrial::words(), [&form](const char* word) { return form == word; });
  };
  Bench plain, kept, doubtful, mute, blind;
  kept.machine.kept = true;
  blind.machine.measures = false;
  doubtful.machine.watchdog = true;
  doubtful.trial.proved(Seconds(0.1));
  doubtful.machine.lostLooks = 20;
  mute.machine.readable = false;
  for (Bench* b : {&plain, &kept, &doubtful, &mute, &blind}) {
    b->run();
    for (const LinkTrialStep& step : b->trial.steps()) {
      for (const Message& phrase : step.said) EXPECT_TRUE(listed(phrase.form)) << phrase.form;
    }
  }
}

}  // namespace
}  // namespace stillcut::cnc
