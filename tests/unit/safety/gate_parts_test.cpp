// What the gates are made of, each by itself: how often the machine may be moved, where it is on its way to, and
// whether an adaptive loop runs away.
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <random>

#include "core/safety/change_budget.h"
#include "core/safety/divergence_watch.h"
#include "core/safety/override_setpoint.h"

namespace stillcut::safety {
namespace {

// The same with a list of times and nothing else.
TEST(ChangeBudget, AgreesWithAListOfTimes) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> pause(0.0, 8.0);
    const int perMinute = 1 + static_cast<int>(random() % 20);
    const double coolDown = 5.0 + static_cast<double>(random() % 30);
    ChangeBudget budget;
    budget.prepare(perMinute, Seconds(coolDown));
    std::deque<double> made;
    double now = 0.0, coolUntil = 0.0;
    int usedUp = 0;
    for (int i = 0; i < 400; ++i) {
      const double dt = pause(random);
      budget.advance(dt);
      now += dt;
      while (!made.empty() && now - made.front() >= ChangeBudget::kWindow) made.pop_front();
      ASSERT_EQ(budget.inLastMinute(), static_cast<int>(made.size()));
      ASSERT_EQ(budget.cooling(), now < coolUntil);
      ASSERT_NEAR(budget.coolDownLeft(), std::max(0.0, coolUntil - now), 1e-9);
      if (random() % 10 == 0) {
        budget.count();
        made.push_back(now);
        continue;
      }
      const bool room = static_cast<int>(made.size()) < perMinute;
      const bool allowed = now >= coolUntil && room;
      if (now >= coolUntil && !room) {
        coolUntil = now + coolDown;
        ++usedUp;
      }
      ASSERT_EQ(budget.take(), allowed) << seed << " " << i;
      if (allowed) made.push_back(now);
      ASSERT_EQ(budget.timesUsedUp(), usedUp);
    }
    budget.clear();
    EXPECT_EQ(budget.inLastMinute(), 0);
    EXPECT_EQ(budget.timesUsedUp(), 0);
    EXPECT_FALSE(budget.cooling());
  }
}

TEST(ChangeBudget, AsksForAtLeastOneAndAtMostWhatItCanCount) {
  ChangeBudget budget;
  budget.prepare(0, Seconds(1.0));
  EXPECT_EQ(budget.perMinute(), 1);
  budget.prepare(100000, Seconds(1.0));
  EXPECT_EQ(budget.perMinute(), ChangeBudget::kMost);
}

class Target : public testing::Test {
 protected:
  Target() {
    limits_.deadband = 0.01;
    limits_.changesPerMinute = 3;
    limits_.coolDown = Seconds(10.0);
    keeper_.prepare(limits_);
  }
  GateLimits limits_;
  OverrideSetpoint keeper_;
};

TEST_F(Target, WhatLiesInTheDeadBandIsTheSame) {
  EXPECT_EQ(keeper_.propose({1.005, 0.995}, false), Proposal::Same);
  EXPECT_EQ(keeper_.budget().inLastMinute(), 0);
  EXPECT_TRUE(keeper_.near({1.009, 1.0}));
  EXPECT_FALSE(keeper_.near({1.02, 1.0}));
}

TEST_F(Target, GoingOnTheSameWayIsOneChange) {
  for (int i = 1; i <= 20; ++i) {
    EXPECT_EQ(keeper_.propose({1.0 - 0.02 * i, 1.0}, false), i == 1 ? Proposal::Taken : Proposal::GoesOn);
    keeper_.advance(0.1, false);
  }
  EXPECT_EQ(keeper_.budget().inLastMinute(), 1);
  EXPECT_DOUBLE_EQ(keeper_.target().speed, 0.6);
}

TEST_F(Target, TurningBackAndStartingFromRestCost) {
  EXPECT_EQ(keeper_.propose({0.8, 1.0}, false), Proposal::Taken);
  EXPECT_EQ(keeper_.propose({0.9, 1.0}, false), Proposal::Taken);
  EXPECT_EQ(keeper_.budget().inLastMinute(), 2);
  keeper_.advance(0.6, true);  // at rest
  EXPECT_EQ(keeper_.propose({0.95, 1.0}, false), Proposal::Taken);
  EXPECT_EQ(keeper_.budget().inLastMinute(), 3);
  EXPECT_EQ(keeper_.propose({0.7, 1.0}, false), Proposal::Refused);
  EXPECT_DOUBLE_EQ(keeper_.target().speed, 0.95);
}

TEST_F(Target, TheWayBackIsNeverRefused) {
  for (int i = 0; i < 10; ++i) keeper_.propose({i % 2 == 0 ? 0.8 : 0.9, 1.0}, false);
  EXPECT_TRUE(keeper_.budget().cooling());
  keeper_.goBack();
  EXPECT_EQ(keeper_.target().speed, 1.0);
  EXPECT_EQ(keeper_.target().feed, 1.0);
  // From inside the dead band as well: exactly 100 %.
  keeper_.stopAt({1.004, 0.997});
  keeper_.goBack();
  EXPECT_EQ(keeper_.target().speed, 1.0);
  EXPECT_EQ(keeper_.target().feed, 1.0);
}

TEST_F(Target, WhateverIsAskedNoMoreChangesAreMadeThanAllowed) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> factor(0.5, 1.2);
  std::deque<double> taken;
  double now = 0.0;
  for (int i = 0; i < 20000; ++i) {
    now += 0.05;
    keeper_.advance(0.05, random() % 3 == 0);
    const int before = keeper_.budget().inLastMinute();
    keeper_.propose({factor(random), factor(random)}, false);
    if (keeper_.budget().inLastMinute() > before) taken.push_back(now);
    while (!taken.empty() && now - taken.front() >= 60.0) taken.pop_front();
    ASSERT_LE(taken.size(), 3U) << now;
  }
}

// A loop as numbers: what the watch says of it within `seconds`.
constexpr Hertz kRate{5000.0};

template <class Error, class Without, class Output>
LoopHealth watchFor(double seconds, const Error& error, const Without& without, const Output& output,
                    bool limited = false, double limitedFrom = 0.0) {
  DivergenceWatch watch;
  watch.prepare(kRate, 1.0);
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  for (int n = 0; n < static_cast<int>(seconds * kRate.value); ++n) {
    const double t = n / kRate.value;
    const double r = noise(random);
    const LoopHealth health =
        watch.watch(error(t) * r, without(t) * r, output(t) * noise(random), limited && t >= limitedFrom);
    if (health != LoopHealth::Fine) return health;
  }
  return LoopHealth::Fine;
}

const auto kOne = [](double) { return 1.0; };

TEST(DivergenceWatch, ASteadyLoopIsFine) {
  EXPECT_EQ(watchFor(20.0, kOne, kOne, kOne), LoopHealth::Fine);
}

TEST(DivergenceWatch, ALoopThatQuietensIsFine) {
  EXPECT_EQ(watchFor(
                5.0, [](double t) { return std::exp(-t); }, kOne, [](double t) { return 0.2 + 0.1 * t; }),
            LoopHealth::Fine);
}

// Error and output growing together by a factor of e in 8 ms: given up within the promised time.
TEST(DivergenceWatch, ErrorAndOutputThatGrowTogetherAreDivergence) {
  const auto grows = [](double t) { return t < 0.5 ? 1.0 : std::exp((t - 0.5) / 0.008); };
  EXPECT_EQ(watchFor(0.6, grows, grows, [&](double t) { return 0.02 * grows(t); }), LoopHealth::Diverging);
}

TEST(DivergenceWatch, ALouderCutAloneIsNoDivergence) {
  const auto grows = [](double t) { return t < 0.5 ? 1.0 : std::min(50.0, std::exp((t - 0.5) / 0.008)); };
  EXPECT_EQ(watchFor(3.0, grows, grows, [](double) { return 0.3; }), LoopHealth::Fine);
}

TEST(DivergenceWatch, AnErrorTwiceWhatItWouldBeWithoutIsWorse) {
  EXPECT_EQ(watchFor(
                2.0, [](double t) { return t < 1.0 ? 0.5 : 2.0; }, kOne, kOne),
            LoopHealth::Worse);
  // Not for the while that a loop takes to learn something else.
  EXPECT_EQ(watchFor(
                2.0, [](double t) { return t < 1.0 || t > 1.1 ? 0.5 : 2.0; }, kOne, kOne),
            LoopHealth::Fine);
  // Not where the output is too small to be the reason.
  EXPECT_EQ(watchFor(
                2.0, [](double t) { return t < 1.0 ? 0.5 : 1.7; }, kOne, [](double) { return 0.001; }),
            LoopHealth::Fine);
}

TEST(DivergenceWatch, AtItsLimitWithoutSuccessIsSaturated) {
  const auto louder = [](double t) { return t < 0.5 ? 1.0 : 4.0; };
  EXPECT_EQ(watchFor(1.0, louder, louder, kOne, true, 0.5), LoopHealth::Saturated);
  EXPECT_EQ(watchFor(1.0, louder, louder, kOne, false), LoopHealth::Fine);
}

TEST(DivergenceWatch, AReadingThatStandsStillWhileSomethingGoesOutIsADeadSensor) {
  DivergenceWatch watch;
  watch.prepare(kRate, 1.0);
  int n = 0;
  while (n < 1000 && watch.watch(0.25, 0.25, 0.5, false) != LoopHealth::DeadSensor) ++n;
  EXPECT_LE(n, static_cast<int>(0.006 * kRate.value));
  watch.reset();
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(watch.watch(0.25, 0.25, 0.0, false), LoopHealth::Fine);
}

}  // namespace
}  // namespace stillcut::safety
