// The comb search and the phase tracker, one at a time, on forced vibration of a spindle that drifts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/spindle/phase_tracker.h"
#include "core/spindle/speed_search.h"

namespace stillcut::detect {
namespace {

constexpr double kRate = 10240.0;
constexpr int kTeeth = 3;

// Tooth passings 1 .. 8, the second loudest, of a spindle at `hertz` at time 0 that drifts by `drift` a second.
double forced(double hertz, double drift, double t) {
  const double angle = kTwoPi * hertz * (t + 0.5 * drift * t * t);
  double x = 0.0;
  for (int h = 1; h <= 8; ++h) x += std::cos(h * kTeeth * angle + h * h) / (1.0 + std::abs(h - 2));
  return x;
}

std::vector<double> window(int size, double hertz, double drift) {
  std::vector<double> x(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i) {
    const double t = (i - 0.5 * (size - 1)) / kRate;
    x[static_cast<std::size_t>(i)] = forced(hertz, drift, t);
  }
  return x;
}

// 24 turns in which the speed changes by 2 %: the lines of the upper orders are many bins broad.
TEST(SpeedSearch, ReadsADriftingSpindleAsIfItTurnedEvenly) {
  constexpr double kSpindle = 60.0, kDrift = 0.05;
  const int size = static_cast<int>(24.0 * kRate / kSpindle);
  SpeedSearch search;
  search.prepare(size, Hertz(kRate), kTeeth);
  const std::vector<double> x = window(size, kSpindle, kDrift);
  const auto found = [&](double drift) {
    search.begin(drift);
    search.add(x);
    return search.search(Hertz(0.97 * kSpindle), Hertz(1.03 * kSpindle));
  };
  const SpeedCandidate smeared = found(0.0);
  const SpeedCandidate sharp = found(kDrift);
  EXPECT_LT(smeared.part, 0.8);
  EXPECT_GT(sharp.part, 0.95);
  EXPECT_NEAR(sharp.spindle.value, kSpindle, 1e-4 * kSpindle);
}

// Runout of two teeth on a mode at order 5, four times as loud as the tooth passings, while the tool enters within
// three turns. The line of an amplitude that grows is broad, and so is twice its frequency in the square; what is
// beside that lies on the spindle's comb. Chatter at 5.4 orders is no part of one.
TEST(SpeedSearch, RunoutOnAModeMayBeForcedWhileTheToolEnters) {
  constexpr double kSpindle = 175.0, kTold = 0.036;
  const int size = static_cast<int>(12.0 * kRate / kSpindle);
  SpeedSearch search;
  search.prepare(size, Hertz(kRate), 2);
  const auto mayBeForced = [&](double order) {
    std::vector<double> x(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
      const double turns = i / kRate * kSpindle;
      double v = std::cos(kTwoPi * order * turns);
      for (int h = 2; h <= 8; h += 2) v += 0.25 * std::cos(kTwoPi * h * turns + h * h);
      x[static_cast<std::size_t>(i)] = v * std::clamp((turns - 3.0) / 3.0, 0.0, 1.0);
    }
    search.begin();
    search.add(x);
    const Hertz line = search.strongest().frequency;
    EXPECT_NEAR(line.value, order * kSpindle, 0.1 * kSpindle);
    return search.mayBeForced(line, Hertz(kSpindle * (1.0 - kTold)), Hertz(kSpindle * (1.0 + kTold)));
  };
  EXPECT_TRUE(mayBeForced(5.0));
  EXPECT_FALSE(mayBeForced(5.4));
}

// The same of a spindle that has run away by 6 % since it was told: at any order it is one line of a comb.
TEST(SpeedSearch, RunoutOnAModeMayBeAmongOthersOfASpindleThatRanAway) {
  constexpr double kSpindle = 175.0, kFurther = 0.086;
  const int size = static_cast<int>(12.0 * kRate / kSpindle);
  SpeedSearch search;
  search.prepare(size, Hertz(kRate), 3);
  const auto mayBeAmongOthers = [&](double others) {
    std::vector<double> x(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
      const double turns = i / kRate * kSpindle;
      double v = std::cos(kTwoPi * 7.0 * turns);
      for (int h = 3; h <= 12; h += 3) v += others * std::cos(kTwoPi * h * turns + h * h);
      x[static_cast<std::size_t>(i)] = v;
    }
    search.begin();
    search.add(x);
    const Hertz line = search.strongest().frequency;
    EXPECT_NEAR(line.value, 7.0 * kSpindle, 0.1 * kSpindle);
    const double told = 0.94 * kSpindle;
    return search.mayBeAmongOthers(line, Hertz(told * (1.0 - kFurther)), Hertz(told * (1.0 + kFurther)));
  };
  EXPECT_TRUE(mayBeAmongOthers(0.25));
  EXPECT_FALSE(mayBeAmongOthers(0.0));
}

// An accelerometer read at 1 kHz without a filter: order 11 of 52.05 Hz is folded down to 427.5 Hz, the strongest line
// of all and eight times 53.43 Hz. The others are the spindle's.
TEST(SpeedSearch, AFoldedOrderAloneIsNoComb) {
  constexpr double kSlowRate = 1000.0, kSpindle = 52.05, kFolded = kSlowRate - 11.0 * kSpindle;
  const int size = static_cast<int>(24.0 * kSlowRate / kSpindle);
  SpeedSearch search;
  search.prepare(size, Hertz(kSlowRate), 0);
  const auto found = [&](double folded, double others) {
    std::vector<double> x(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
      const double turn = kTwoPi * kSpindle * i / kSlowRate;
      double v = folded * std::cos(kTwoPi * kFolded * i / kSlowRate);
      for (int h : {2, 3, 4, 6}) v += others * std::cos(h * turn + h * h);
      x[static_cast<std::size_t>(i)] = v;
    }
    search.begin();
    search.add(x);
    return search.search(Hertz(0.965 * kSpindle), Hertz(1.035 * kSpindle)).spindle.value;
  };
  EXPECT_NEAR(found(1.0, 0.25), kSpindle, 1e-3 * kSpindle);
  // Where nothing else makes a comb, that line is all there is to go by.
  EXPECT_NEAR(found(1.0, 0.0), kFolded / 8.0, 1e-3 * kSpindle);
}

// One tooth passing of eight teeth, nearly alone, and a tone that is nothing of the spindle's: it fits some speed
// within what was told as well.
TEST(SpeedSearch, AToothPassingAloneIsKeptBesideATone) {
  constexpr double kSpindle = 20.0;
  for (const double hertz : {250.0, 431.0, 731.0}) {
    for (const double turns : {12.0, 24.0}) {
      const int size = static_cast<int>(turns * kRate / kSpindle);
      SpeedSearch search;
      search.prepare(size, Hertz(kRate), 8);
      std::mt19937 engine(5);
      std::normal_distribution<double> noise(0.0, 0.03);
      std::vector<double> x(static_cast<std::size_t>(size));
      for (int i = 0; i < size; ++i) {
        const double turn = kTwoPi * kSpindle * i / kRate;
        x[static_cast<std::size_t>(i)] = std::cos(8.0 * turn) + 0.1 * std::cos(16.0 * turn) + 0.03 * std::cos(turn) +
                                         0.35 * std::cos(kTwoPi * hertz * i / kRate) + noise(engine);
      }
      search.begin();
      search.add(x);
      const SpeedCandidate found = search.search(Hertz(0.964 * kSpindle), Hertz(1.036 * kSpindle));
      EXPECT_NEAR(found.spindle.value, kSpindle, 5e-3 * kSpindle) << hertz << ' ' << turns;
    }
  }
}

// A line half way between two orders is on no comb, but twice its frequency, in the square, is.
TEST(SpeedSearch, ALineBetweenTwoOrdersIsNoComb) {
  constexpr double kSpindle = 123.2;
  const int size = static_cast<int>(24.0 * kRate / kSpindle);
  SpeedSearch search;
  search.prepare(size, Hertz(kRate), 3);
  std::vector<double> x(static_cast<std::size_t>(size));
  std::mt19937 engine(3);
  std::normal_distribution<double> noise(0.0, 0.02);
  for (int i = 0; i < size; ++i) {
    x[static_cast<std::size_t>(i)] = std::cos(kTwoPi * 2.5 * kSpindle * i / kRate) + noise(engine);
  }
  search.begin();
  search.add(x);
  EXPECT_GT(search.partsAt(Hertz(kSpindle)).square, 0.5);  // the reason why
  EXPECT_FALSE(search.search(Hertz(0.95 * kSpindle), Hertz(1.05 * kSpindle)).stands());
}

// Chatter ten times as loud as the tooth passings: of what is not its line the spindle's comb has nearly all.
TEST(SpeedSearch, WhatChatterLeavesIsOnTheSpindlesComb) {
  constexpr double kSpindle = 60.0;
  const int size = static_cast<int>(24.0 * kRate / kSpindle);
  SpeedSearch search;
  search.prepare(size, Hertz(kRate), kTeeth);
  std::vector<double> x = window(size, kSpindle, 0.0);
  for (int i = 0; i < size; ++i)
    x[static_cast<std::size_t>(i)] += 10.0 * std::cos(kTwoPi * 17.4 * kSpindle * i / kRate);
  search.begin();
  search.add(x);
  EXPECT_GT(search.restPartAt(Hertz(kSpindle)), 0.5);
  EXPECT_LT(search.restPartAt(Hertz(17.4 / 17.0 * kSpindle)), 0.1) << "it has the line alone";
}

// Nearly every comb lies on the line that is left out: the others alone say how much a comb holds by chance.
TEST(SpeedSearch, CombsThatAreLeftOutAreNoMeasure) {
  constexpr double kSpindle = 60.0, kLine = 8.2 * kSpindle;
  const int size = static_cast<int>(24.0 * kRate / kSpindle);
  SpeedSearch search;
  search.prepare(size, Hertz(kRate), kTeeth);
  search.begin();
  search.add(window(size, kSpindle, 0.0));
  const SpeedCandidate found = search.search(Hertz(0.997 * kSpindle), Hertz(1.044 * kSpindle), Hertz(kLine));
  EXPECT_NEAR(found.spindle.value, kSpindle, 1e-3 * kSpindle);
  EXPECT_GT(found.contrast, 1.0);
}

// What `signal` makes of the time, from `from` on for `seconds`, one sample after the other.
template <class Signal>
void follow(PhaseTracker& tracker, double from, double seconds, const Signal& signal) {
  double angle = 0.0;
  double slew = 0.0;
  std::array<double, 1> x{};
  const std::array<const double*, 1> samples{x.data()};
  for (int k = 0; k < static_cast<int>(seconds * kRate); ++k) {
    const double step = kTwoPi * tracker.spindle().value / kRate + slew;
    x[0] = signal(from + k / kRate);
    tracker.accumulate(angle, step, samples.data(), 0, 1);
    angle += step;
    if (angle < kTwoPi) continue;
    angle -= kTwoPi;
    slew = tracker.completeTurn() * tracker.spindle().value / kRate;
  }
}

// A spindle slowed by a tenth or a twentieth at once, untold: its lines turn against the old ones, past their old
// places as well, and louder. However long that lasts the lock stays lost.
TEST(PhaseTracker, IsNotFoundAgainByPhasesThatTurnPast) {
  constexpr double kSpindle = 105.0;
  for (const double louder : {1.0, 3.0}) {
    for (const double slowed : {0.91, 0.95}) {
      PhaseTracker tracker;
      tracker.prepare(1, Hertz(kRate), kTeeth);
      tracker.start(Hertz(kSpindle), Hertz(0.1));
      follow(tracker, 0.0, 0.5, [](double t) { return forced(kSpindle, 0.0, t); });
      ASSERT_TRUE(tracker.clean());
      ASSERT_FALSE(tracker.lost());
      const auto moved = [&](double t) { return louder * forced(slowed * kSpindle, 0.0, t); };
      follow(tracker, 0.5, 0.6, moved);
      int found = 0;
      for (int k = 0; k < 100; ++k) {
        follow(tracker, 1.1 + 0.02 * k, 0.02, moved);
        found += tracker.lost() || tracker.scattered() ? 0 : 1;
      }
      EXPECT_EQ(found, 0) << louder << ' ' << slowed;
    }
  }
}

// Once it is known why nothing repeats, it is doubted again after a while.
TEST(PhaseTracker, WhatStaysIsDoubtedAgainOnlyAfterAWhile) {
  constexpr double kSpindle = 105.0;
  PhaseTracker tracker;
  tracker.prepare(1, Hertz(kRate), kTeeth);
  tracker.start(Hertz(kSpindle), Hertz(0.1));
  const auto calm = [](double t) { return forced(kSpindle, 0.0, t); };
  const auto drowned = [&](double t) { return 3.0 * forced(0.95 * kSpindle, 0.0, t); };
  follow(tracker, 0.0, 0.5, calm);
  follow(tracker, 0.5, 0.4, drowned);
  ASSERT_TRUE(tracker.scattered());
  tracker.stay();
  follow(tracker, 0.9, 0.4, drowned);
  EXPECT_FALSE(tracker.scattered());
  follow(tracker, 1.3, 0.6, drowned);
  EXPECT_TRUE(tracker.scattered());
}

// Started on the speed of the middle of a search's window, of a spindle that runs away by 5 % a second, and in doubt by
// as much as it is off: within thirty turns it is known to six parts in ten thousand, and most of its drift.
TEST(PhaseTracker, FollowsASpindleThatRunsAway) {
  for (const double drift : {-0.05, 0.05}) {
    constexpr double kSpindle = 105.0, kAgo = 0.057;
    PhaseTracker tracker;
    tracker.prepare(1, Hertz(kRate), kTeeth);
    tracker.start(Hertz(kSpindle * (1.0 - drift * kAgo)), Hertz(std::abs(drift) * kAgo * kSpindle));
    double angle = 0.0;
    double slew = 0.0;
    std::array<double, 1> x{};
    const std::array<const double*, 1> samples{x.data()};
    for (int k = 0; k < static_cast<int>(0.6 * kRate); ++k) {
      const double t = k / kRate;
      const double hertz = tracker.spindle().value;
      const double step = kTwoPi * (hertz + 0.5 * tracker.drift()) / kRate + slew;
      x[0] = forced(kSpindle, drift, t);
      tracker.accumulate(angle, step, samples.data(), 0, 1);
      angle += step;
      if (angle < kTwoPi) continue;
      angle -= kTwoPi;
      slew = tracker.completeTurn() * tracker.spindle().value / kRate;
      if (tracker.turns() < 30) continue;
      const double now = kSpindle * (1.0 + drift * t);
      EXPECT_NEAR(tracker.spindle().value, now, 6e-4 * now) << t;
      EXPECT_LT(tracker.scatter(), 0.2) << t;
    }
    EXPECT_NEAR(tracker.drift(), drift, 0.02);
  }
}

}  // namespace
}  // namespace stillcut::detect
