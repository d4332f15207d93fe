// The override register that we share with the operator: whose value stands in it, and that the operator always wins.
#include "core/cnc/shared_override.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <random>

namespace stillcut::cnc {
namespace {

Instant at(double seconds) {
  return Instant{} + toDuration(Seconds(seconds));
}

SharedOverride seenAt100() {
  SharedOverride knob(0, 200);
  knob.seen(100, at(0.0));
  return knob;
}

TEST(SharedOverride, SendsNothingBeforeTheRegisterHasBeenSeen) {
  SharedOverride knob(0, 200);
  knob.want(Ratio(0.8), 1);
  EXPECT_FALSE(knob.known());
  EXPECT_FALSE(knob.due().has_value());
  knob.seen(100, at(0.0));
  EXPECT_EQ(knob.due(), 80);
}

TEST(SharedOverride, OursMultipliesWhatTheOperatorLeftThere) {
  SharedOverride knob(0, 200);
  knob.seen(90, at(0.0));
  EXPECT_DOUBLE_EQ(knob.base().value, 0.9);
  knob.want(Ratio(0.8), 1);
  EXPECT_EQ(knob.due(), 72);
  knob.sent(72, at(0.1));
  EXPECT_FALSE(knob.due().has_value());  // under way
  knob.seen(72, at(0.2));
  EXPECT_DOUBLE_EQ(knob.base().value, 0.9);
  knob.relinquish();
  EXPECT_EQ(knob.due(), 90);
}

TEST(SharedOverride, StaysWithinTheRegistersRange) {
  SharedOverride knob(50, 120);
  knob.seen(100, at(0.0));
  knob.want(Ratio(3.0), 1);
  EXPECT_EQ(knob.due(), 120);
  knob.want(Ratio(0.0), 1);
  EXPECT_EQ(knob.due(), 50);
}

TEST(SharedOverride, IgnoresFactorsThatAreNone) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.9), 1);
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -0.5}) {
    knob.want(Ratio(bad), 1);
    EXPECT_EQ(knob.target(), 90);
  }
}

TEST(SharedOverride, AForeignValueIsTheOperatorsHandUntilTheEngagementEnds) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.8), 1);
  knob.sent(80, at(0.1));
  knob.seen(80, at(0.2));
  knob.seen(60, at(1.0));  // nobody here sent this
  EXPECT_TRUE(knob.grabbed());
  EXPECT_DOUBLE_EQ(knob.base().value, 0.6);
  knob.want(Ratio(0.8), 1);
  EXPECT_FALSE(knob.due().has_value());
  knob.want(Ratio(0.5), 2);  // the next engagement works on the operator's value
  EXPECT_FALSE(knob.grabbed());
  EXPECT_EQ(knob.due(), 30);
}

// After a hand our own values are no longer ours: turned back to one of them, it is still the operator's.
// The second turn of the hand is no leave to go on with the engagement that the first one ended.
TEST(SharedOverride, AHandThatTurnsTwiceHasNotGivenWay) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.8), 1);
  knob.sent(80, at(0.1));
  knob.seen(80, at(0.2));
  for (const int hand : {70, 117}) {
    knob.seen(hand, at(0.01 * hand));
    knob.want(Ratio(0.5), 1);
    EXPECT_TRUE(knob.grabbed());
    EXPECT_FALSE(knob.due().has_value()) << hand;
  }
  knob.want(Ratio(0.5), 2);
  EXPECT_EQ(knob.due(), 59) << "another engagement begins at what the hand chose";
}

// Where a hand counts at the second sight, our factor may pass 100 % between the two.
TEST(SharedOverride, AHandThatIsBelievedAsOursPassesHundredIsAHand) {
  SharedOverride knob(50, 120, {.sightings = 2});
  knob.seen(100, at(0.0));
  knob.want(Ratio(1.2), 1);
  knob.sent(120, at(0.1));
  knob.seen(120, at(0.2));
  knob.seen(55, at(0.3));
  EXPECT_TRUE(knob.doubted());
  knob.want(Ratio(1.0), 1);
  knob.seen(55, at(0.4));
  knob.want(Ratio(1.02), 1);
  EXPECT_TRUE(knob.grabbed());
  EXPECT_FALSE(knob.due().has_value()) << "sent over it";
  knob.want(Ratio(1.02), 2);
  EXPECT_EQ(knob.due(), 56) << "another engagement begins at what the hand chose";
}

TEST(SharedOverride, AHandThatTurnsToWhatWeSentOnceIsAHand) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.8), 1);
  knob.sent(80, at(0.1));
  knob.seen(80, at(0.2));
  knob.seen(60, at(1.0));
  knob.seen(80, at(2.0));
  EXPECT_DOUBLE_EQ(knob.base().value, 0.8);
  EXPECT_FALSE(knob.due().has_value());
}

TEST(SharedOverride, ALateEchoOfOursIsNobodysHand) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.9), 1);
  knob.sent(90, at(0.1));
  knob.want(Ratio(0.8), 1);
  knob.sent(80, at(0.2));
  knob.seen(90, at(2.0));  // in order, late
  EXPECT_FALSE(knob.grabbed());
  knob.seen(80, at(2.1));
  EXPECT_FALSE(knob.grabbed());
  EXPECT_DOUBLE_EQ(knob.base().value, 1.0);
  knob.seen(90, at(20.0));  // after all that time it is somebody's
  EXPECT_TRUE(knob.grabbed());
}

TEST(SharedOverride, WhatWasRefusedIsSentAgain) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.8), 1);
  knob.sent(80, at(0.1));
  EXPECT_FALSE(knob.due().has_value());
  knob.refused();
  EXPECT_EQ(knob.due(), 80);
}

TEST(SharedOverride, AfterALostConnectionItIsSeenAnew) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.8), 1);
  knob.sent(80, at(0.1));
  knob.seen(80, at(0.2));
  knob.lost();
  EXPECT_FALSE(knob.known());
  EXPECT_FALSE(knob.due().has_value());
  knob.relinquish();
  knob.seen(80, at(1.0));
  EXPECT_EQ(knob.due(), 100);
  EXPECT_FALSE(knob.atBase());
}

// However long it stood: a hand that chose the same while the wire was down cannot be told apart.
TEST(SharedOverride, WhatWeLeftThereIsOursAfterAnyBreak) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.9), 1);
  knob.sent(90, at(0.1));
  knob.seen(90, at(0.2));
  knob.seen(90, at(60.0));
  knob.lost();
  knob.lost();  // the first try to come back failed
  knob.relinquish();
  knob.seen(90, at(100.0));
  EXPECT_FALSE(knob.atBase());
  EXPECT_DOUBLE_EQ(knob.base().value, 1.0);
  EXPECT_EQ(knob.due(), 100);
}

TEST(SharedOverride, AnotherValueAfterABreakIsAHand) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.9), 1);
  knob.sent(90, at(0.1));
  knob.seen(90, at(0.2));
  knob.lost();
  knob.seen(70, at(100.0));
  EXPECT_TRUE(knob.grabbed());
  EXPECT_FALSE(knob.due().has_value());
}

TEST(SharedOverride, WhatAPeerShowsThatBeganAnewIsItsOwn) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.9), 1);
  knob.sent(90, at(0.1));
  knob.seen(90, at(0.2));
  knob.restarted();
  knob.want(Ratio(0.8), 1);
  knob.seen(90, at(100.0));
  EXPECT_TRUE(knob.grabbed());
}

// Limits bound what we ask for: what the operator chose beyond them stands, 0 included.
TEST(SharedOverride, AHandBeyondTheLimitsIsNeverSentOver) {
  for (const int hand : {0, 20, 40, 49, 151, 180, 200}) {
    SharedOverride knob(50, 150);
    knob.seen(100, at(0.0));
    knob.want(Ratio(0.83), 1);
    knob.sent(83, at(0.1));
    knob.seen(83, at(0.2));
    knob.seen(hand, at(1.0));
    EXPECT_TRUE(knob.grabbed()) << hand;
    EXPECT_FALSE(knob.due().has_value()) << hand;
    knob.relinquish();
    EXPECT_FALSE(knob.due().has_value()) << hand;
    knob.want(Ratio(0.83), 2);
    EXPECT_LE(knob.target(), hand) << "slower is asked for, and never faster comes of it";
    EXPECT_GE(knob.target(), std::min(hand, 50)) << hand;
    knob.want(Ratio(1.2), 2);
    EXPECT_GE(knob.target(), hand);
    EXPECT_LE(knob.target(), std::max(hand, 150)) << hand;
  }
}

// Our own ramp leads through values that a hand may choose a moment later.
TEST(SharedOverride, AValueOlderThanOneThatHasShownIsAHand) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.83), 1);
  double t = 0.1;
  for (const int step : {95, 90, 83}) {
    knob.sent(step, at(t));
    knob.seen(step, at(t + 0.05));
    t += 0.1;
  }
  knob.seen(90, at(0.6));
  EXPECT_TRUE(knob.grabbed());
  EXPECT_DOUBLE_EQ(knob.base().value, 0.9);
  EXPECT_FALSE(knob.due().has_value());
}

TEST(SharedOverride, WhatWasOnItsWayWhenAHandTurnedGoesHomeToTheHand) {
  SharedOverride knob = seenAt100();
  knob.want(Ratio(0.83), 1);
  knob.sent(83, at(0.1));
  knob.seen(60, at(0.12));
  EXPECT_TRUE(knob.grabbed());
  EXPECT_FALSE(knob.due().has_value()) << "a hand that still turns is not sent over";
  knob.seen(83, at(0.2));  // ours, sent before
  EXPECT_DOUBLE_EQ(knob.base().value, 0.6);
  EXPECT_FALSE(knob.atBase());
  EXPECT_EQ(knob.due(), 60);
  knob.sent(60, at(0.25));
  knob.seen(60, at(0.3));
  EXPECT_TRUE(knob.baseConfirmed());
}

// A report without a checksum: one flipped bit is no hand.
TEST(SharedOverride, AForeignValueReadOnceIsDoubtedAndNothingIsSentMeanwhile) {
  SharedOverride knob(10, 200, {.sightings = 2, .lateAfterHand = false, .inOrder = false});
  knob.seen(100, at(0.0));
  knob.want(Ratio(0.83), 1);
  knob.sent(83, at(0.1));
  knob.seen(83, at(0.2));
  knob.seen(93, at(0.4));
  EXPECT_FALSE(knob.grabbed());
  EXPECT_EQ(knob.shown(), 83) << "a step from there would lead astray";
  knob.relinquish();
  EXPECT_FALSE(knob.due().has_value());
  EXPECT_FALSE(knob.baseConfirmed());
  knob.seen(83, at(0.6));
  EXPECT_EQ(knob.due(), 100);
  knob.seen(93, at(0.8));
  knob.seen(39, at(1.0));
  EXPECT_DOUBLE_EQ(knob.base().value, 1.0) << "two different lies are no hand";
  knob.seen(70, at(1.2));
  knob.seen(70, at(1.4));
  EXPECT_DOUBLE_EQ(knob.base().value, 0.7);
}

TEST(SharedOverride, AHandThatGivesWayToWhatWeSentWasALie) {
  SharedOverride knob(10, 200, {.sightings = 2, .lateAfterHand = false, .inOrder = false});
  knob.seen(100, at(0.0));
  knob.want(Ratio(0.83), 1);
  knob.sent(83, at(0.1));
  knob.seen(83, at(0.2));
  knob.relinquish();  // and the machine lies for a while
  for (double t = 0.3; t < 3.0; t += 0.1) knob.seen(183, at(t));
  EXPECT_FALSE(knob.due().has_value());
  for (double t = 3.0; t < 3.3; t += 0.1) knob.seen(83, at(t));
  EXPECT_DOUBLE_EQ(knob.base().value, 1.0);
  EXPECT_EQ(knob.due(), 100) << "home, and not to what the lie showed";
}

// A register behind a wire that takes its time, an operator who turns whenever he likes, and factors that change. When
// all is quiet again the register holds what the operator chose last, whoever wrote before.
TEST(SharedOverride, InTheEndTheRegisterIsTheOperators) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    const auto chance = [&](int oneIn) { return random() % static_cast<unsigned>(oneIn) == 0; };
    SharedOverride knob(0, 200);
    int registered = 100;  // what the machine holds
    int operators = 100;   // what a person chose last
    std::deque<std::pair<double, int>> wire;
    std::uint64_t engagement = 1;
    double now = 0.0;
    for (int step = 0; step < 400; ++step) {
      now += 0.05;
      while (!wire.empty() && wire.front().first <= now) {
        registered = wire.front().second;
        wire.pop_front();
      }
      const bool quiet = step >= 200;  // from here on nobody does anything new
      // A person turns by hand what stands there while nothing of ours is on its way.
      if (!quiet && chance(40) && wire.empty()) {
        operators = registered = 40 + static_cast<int>(random() % 17) * 10;
      }
      knob.seen(registered, at(now));
      if (!quiet && chance(25)) ++engagement;
      if (quiet) {
        knob.relinquish();
      } else if (chance(4)) {
        knob.want(Ratio(0.5 + 0.01 * static_cast<double>(random() % 71)), engagement);
      }
      if (const auto due = knob.due()) {
        knob.sent(*due, at(now));
        const double begin = wire.empty() ? now : wire.back().first;
        wire.emplace_back(std::max(now, begin) + 0.001 * static_cast<double>(random() % 200), *due);
      }
      EXPECT_GE(knob.target(), 0);
      EXPECT_LE(knob.target(), 200);
    }
    EXPECT_TRUE(knob.atBase()) << seed;
    EXPECT_EQ(registered, static_cast<int>(std::lround(knob.base().value * 100.0))) << seed;
    // What a hand turned to what we had just sent looks like ours: the one case that cannot be told apart.
    if (registered != operators) {
      EXPECT_EQ(operators % 10, 0) << seed;
    }
  }
}

// Where nothing came for a while nothing could show: what shows then and was sent before is still ours.
TEST(SharedOverride, WhatShowsAfterASilenceIsNoHand) {
  for (const bool silent : {false, true}) {
    SharedOverride knob(
        10, 200, {.sightings = 2, .lateAfterHand = false, .inOrder = false, .latestEcho = std::chrono::seconds(1)});
    const auto at = [](double t) { return Instant{} + toDuration(Seconds(10.0 + t)); };
    knob.seen(100, at(0.0));
    knob.want(Ratio(0.94), 1);
    knob.sent(94, at(0.1));
    knob.relinquish();
    if (silent) knob.blind(std::chrono::milliseconds(1900), at(2.0));
    knob.seen(94, at(2.0));
    knob.seen(94, at(2.1));
    EXPECT_NEAR(knob.base().value, silent ? 1.0 : 0.94, 1e-9);
    EXPECT_EQ(knob.target(), silent ? 100 : 94);
  }
}

// Found by the random sequences: while the hand was doubted nothing had been sent, and its number was taken for ours.
TEST(SharedOverride, AHandThatChoosesTheNumberThatWeWantAndHaveNotSentIsAHand) {
  SharedOverride knob(50, 120, {.sightings = 2});
  Instant now = instantFromNs(1'000'000'000);
  knob.seen(100, now);
  knob.want(Ratio(1.02), 1);
  for (int i = 0; i < 2; ++i) knob.seen(102, now += std::chrono::milliseconds(20));
  EXPECT_TRUE(knob.grabbed());
  EXPECT_DOUBLE_EQ(knob.base().value, 1.02);
  knob.relinquish();
  EXPECT_FALSE(knob.due().has_value());
}

}  // namespace
}  // namespace stillcut::cnc
