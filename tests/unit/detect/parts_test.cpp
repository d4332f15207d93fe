// The detector's parts, one at a time: turn difference, onset test, line finder.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>

#include "core/detect/caliskan/line_finder.h"
#include "core/detect/growth/energy_growth.h"
#include "core/detect/growth/onset_test.h"
#include "core/detect/growth/turn_difference.h"
#include "core/dsp/window.h"

namespace stillcut::detect {
namespace {

constexpr double kRate = 25600.0;

double tone(double hertz, int k) {
  return std::sin(kTwoPi * hertz * k / kRate);
}

double meanSquareOfDifference(double f, double spindle, double growthPerTurn) {
  RevolutionDifference turns;
  turns.prepare(1, Hertz(kRate), Hertz(50.0));
  turns.setTurn(Hertz(spindle));
  double sum = 0.0;
  int count = 0;
  for (int k = 0; k < 12800; ++k) {
    const double x = (1.0 + growthPerTurn * k * spindle / kRate) * tone(f, k);
    double d = 0.0;
    turns.process(&x, 1, 1, &d, nullptr, 1);
    if (k > 6400) sum += d * d;
    if (k > 6400) ++count;
  }
  return sum / count;
}

TEST(RevolutionDifference, RemovesEveryOrderAlsoWhileItGrows) {
  for (const int order : {1, 2, 7, 32}) {
    EXPECT_LT(meanSquareOfDifference(order * 183.33, 183.33, 0.0), 1e-5) << order;
    EXPECT_LT(meanSquareOfDifference(order * 183.33, 183.33, 0.05), 1e-3) << order;
  }
}

TEST(RevolutionDifference, PassesLinesBetweenTheOrdersWithItsStatedGain) {
  for (const double part : {0.1, 0.25, 0.5}) {
    const double gain = std::pow(2.0 * std::sin(0.5 * kTwoPi * part), 2.0) / std::sqrt(6.0);
    EXPECT_NEAR(meanSquareOfDifference((5.0 + part) * 183.33, 183.33, 0.0), 0.5 * gain * gain, 0.02) << part;
  }
}

TEST(RevolutionDifference, ItsNewsPassesLinesWithItsStatedGain) {
  constexpr double kSpindle = 100.0;
  for (const double part : {0.05, 0.1, 0.25, 0.4, 0.5}) {
    RevolutionDifference turns;
    turns.prepare(1, Hertz(kRate), Hertz(50.0));
    turns.setTurn(Hertz(kSpindle));
    double sum = 0.0;
    for (int k = 0; k < 12800; ++k) {
      const double x = tone((5.0 + part) * kSpindle, k);
      double d = 0.0;
      double n = 0.0;
      turns.process(&x, 1, 1, &d, &n, 1);
      if (k >= 6400) sum += n * n;
    }
    EXPECT_NEAR(2.0 * sum / 6400.0, RevolutionDifference::newsGain(part), 0.02) << part;
  }
}

TEST(EnergyGrowth, ALevelThatStandsIsNewsNoLongerGrowthIs) {
  constexpr double kStep = 0.02;
  bool stood = false;
  const auto watch = [&](double perTurn) {
    stood = false;
    EnergyGrowth growth;
    growth.prepare({1e-4, 12.0}, {RevolutionDifference::kNewsArrival});
    growth.setSpindle(Hertz(100.0));
    for (int hop = 0; hop < 100 * kHopsPerTurn; ++hop) {
      const double turns = static_cast<double>(hop) / kHopsPerTurn - 30.0;
      const double level = turns < 0.0 ? 1e-3 : kStep * std::exp(perTurn * turns);
      growth.add(std::array<double, 1>{1.0}, std::array<double, 1>{std::sqrt(level)});
      growth.endHop(kHopsPerTurn, Seconds(0.01 / kHopsPerTurn));
      growth.test(kHopsPerTurn, true);
      stood = stood || growth.standsStill();
    }
  };
  watch(0.0);
  EXPECT_TRUE(stood);
  watch(0.03);  // a slow growth: threefold in amplitude within seventy turns
  EXPECT_FALSE(stood);
}

// Sixty turns of noise of a thousandth, `uneven` of it in one hop of each turn, then growth on top as well; turns from
// there to the alarm, 20 where there is none.
double turnsToAlarm(unsigned seed, bool atOnce, double uneven, double grown) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  EnergyGrowth growth;
  growth.prepare({1e-4, 15.0}, {RevolutionDifference::kDifferenceArrival, atOnce});
  growth.setSpindle(Hertz(100.0));
  for (int hop = 0; hop < 80 * kHopsPerTurn; ++hop) {
    const double turns = static_cast<double>(hop) / kHopsPerTurn - 60.0;
    const double part = 1.0 - uneven + (hop % kHopsPerTurn == 3 ? uneven * kHopsPerTurn : 0.0);
    const double floor = 1e-3 * part * std::exp(0.4 * normal(engine));
    const double level = floor + (turns < 0.0 ? 0.0 : grown * std::exp(2.0 * turns));
    growth.add(std::array<double, 1>{1.0}, std::array<double, 1>{std::sqrt(level)});
    growth.endHop(kHopsPerTurn, Seconds(0.01 / kHopsPerTurn));
    growth.test(kHopsPerTurn, true);
    if (growth.onset().alarm()) return turns;
  }
  return 20.0;
}

// A mean over a turn follows growth of two e-folds a turn half a turn late. The same evidence, hop by hop, is there at
// least a quarter of a turn sooner; and where nothing grows, never, though half of the noise is in one hop of the turn.
TEST(EnergyGrowth, EvidenceOfEveryHopComesBeforeThatOfTheTurn) {
  for (const unsigned seed : {9U, 10U, 11U, 12U}) {
    const double mean = turnsToAlarm(seed, false, 0.0, 1e-4);
    EXPECT_LT(mean, 5.0) << "seed " << seed;
    const double atOnce = turnsToAlarm(seed, true, 0.0, 1e-4);
    EXPECT_GT(atOnce, 0.0) << "seed " << seed;
    EXPECT_LE(atOnce, mean - 0.25) << "seed " << seed;
    EXPECT_EQ(turnsToAlarm(seed, true, 0.5, 0.0), 20.0) << "seed " << seed;
  }
}

TEST(OnsetTest, StaysCalmOnItsOwnScatterAndSeesGrowth) {
  OnsetTest test;
  test.prepare({1e-4, 16.0});
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 80000; ++k) {
    test.update(1e-3 * std::exp(0.2 * normal(engine)), 0.125, true);
    ASSERT_FALSE(test.alarm()) << k;
  }
  EXPECT_NEAR(std::log(test.floor() / 1e-3), 0.0, 0.15);
  int steps = 0;
  while (!test.alarm() && steps < 1000) test.update(1e-3 * std::exp(0.1 * ++steps), 0.125, true);
  // Doubled amplitude is at step 14; a few turns of evidence later it must be out.
  EXPECT_GT(steps, 13);
  EXPECT_LT(steps, 40);
  for (int k = 0; k < 64; ++k) test.update(1e-3, 0.125, true);
  EXPECT_FALSE(test.alarm());
}

TEST(OnsetTest, NothingBelowTheResolutionIsGrowth) {
  OnsetTest test;
  test.prepare({1e-4, 16.0});
  for (int k = 0; k < 800; ++k) test.update(1e-7, 0.125, true);
  for (int k = 0; k < 800; ++k) test.update(9e-5, 0.125, true);
  EXPECT_FALSE(test.alarm());
}

// While the speed drifts a mode's flank may make more of what was learned, step by step; growth beyond that is growth.
TEST(OnsetTest, HasItsFloorRaisedWithoutGoingDeaf) {
  constexpr double kStep = 1.35;
  const auto learn = [](OnsetTest& test) {
    test.prepare({1e-6, 12.0});
    for (int k = 0; k < 800; ++k) test.update(1e-3, 0.125, true);
  };
  OnsetTest raised;
  learn(raised);
  double by = 1.0;
  for (int step = 0; step < 8; ++step) {
    by *= raised.raise(kStep);
    for (int k = 0; k < 24; ++k) raised.update(1e-3 * by, 0.125, true);
    ASSERT_FALSE(raised.alarm()) << step;
  }
  EXPECT_DOUBLE_EQ(by, std::pow(kStep, 8));
  for (int k = 0; k < 24 && !raised.alarm(); ++k) raised.update(8e-3 * by, 0.125, true);
  EXPECT_TRUE(raised.alarm());
  // A drift right through the range, of which nothing came: growth is heard as far above as a mode may have lifted it,
  // and by the old floor again within eighty turns.
  OnsetTest drifted;
  learn(drifted);
  for (int step = 0; step < 100; ++step) drifted.raise(kStep);
  EXPECT_NEAR(drifted.floor(), 0.1, 1e-3);
  for (int k = 0; k < 640; ++k) drifted.update(1e-3, 0.125, true);
  EXPECT_NEAR(drifted.floor(), 1e-3, 5e-4);
  EXPECT_DOUBLE_EQ(drifted.raise(kStep), kStep) << "it was learned anew";
}

constexpr double kRisingPart = 0.15;  // of the energy

// A channel on which all is calm for thirty turns of 10 ms; then unrepeated(turns since) [power] beside the floor. What
// `seen` says of it, hop by hop, for five turns.
template <class Unrepeated, class Seen>
void goesOn(const Unrepeated& unrepeated, const Seen& seen) {
  constexpr double kFloor = 2e-4;
  EnergyGrowth growth;
  growth.prepare({1e-4, 12.0}, {.arrival = RevolutionDifference::kNewsArrival, .risingPart = kRisingPart});
  growth.setSpindle(Hertz(100.0));
  constexpr int kCalm = 30 * kHopsPerTurn;
  for (int hop = 0; hop < kCalm + 5 * kHopsPerTurn; ++hop) {
    const double turns = (hop - kCalm + 0.5) / kHopsPerTurn;
    const std::array<double, 1> all{1.0};
    const std::array<double, 1> changed{std::sqrt(kFloor + (turns > 0.0 ? unrepeated(turns) : 0.0))};
    growth.add(all, changed);
    growth.endHop(kHopsPerTurn, Seconds(0.01 / kHopsPerTurn));
    growth.test(kHopsPerTurn, true);
    if (turns > 0.0) seen(growth, turns);
  }
}

// From one instant on a forced vibration changes by the same in each turn, its energy does not: a ramp of the width of
// cut begins. Against the mean of two turns ago that is a slope, then less of one, then a level (turn_difference.h).
TEST(EnergyGrowth, AForcedVibrationThatBeginsToChangeDoesNotRise) {
  for (const double perTurn : {0.05, 0.1, 0.2}) {
    const auto news = [&](double t) { return perTurn * (t < 1.0 ? t : t < 2.0 ? 0.5 * (t + 1.0) : 1.5); };
    goesOn([&](double t) { return news(t) * news(t); },
           [&](const EnergyGrowth& g, double t) { EXPECT_FALSE(g.rising()) << perTurn << " a turn, turn " << t; });
    const auto bump = [&](double t) { return perTurn * (t < 1.0 ? t : t < 2.0 ? 2.0 - t : 0.0); };
    goesOn([&](double t) { return bump(t) * bump(t); },
           [&](const EnergyGrowth& g, double t) {
             EXPECT_FALSE(t > 2.0 && t < 3.0 && g.steadyGrowth()) << perTurn << " a turn, turn " << t;
           });
  }
}

TEST(EnergyGrowth, ExponentialGrowthRises) {
  for (const double constant : {0.5, 0.8, 1.2}) {  // turns
    bool rose = false;
    goesOn([&](double t) { return 1e-4 * std::expm1(2.0 * t / constant); },
           [&](const EnergyGrowth& g, double) { rose = rose || (g.rising() && g.steadyGrowth()); });
    EXPECT_TRUE(rose) << constant;
  }
}

// ... once it holds the part of the energy that it is asked for: what a forced vibration changes by stays below it.
TEST(EnergyGrowth, RisesFromItsPartOfTheEnergyOn) {
  constexpr double kConstant = 0.8;  // turns
  double least = 1.0;
  goesOn([](double t) { return 1e-4 * std::expm1(2.0 * t / kConstant); },
         [&](const EnergyGrowth& g, double) {
           if (g.rising()) least = std::min(least, g.changed());
         });
  EXPECT_GT(least, kRisingPart * RevolutionDifference::kNewsArrival);
  EXPECT_LT(least, 2.0 * kRisingPart * RevolutionDifference::kNewsArrival);
}

// A burst of narrow-band noise comes within a turn and stands for some; a line goes on growing, slowly as well.
TEST(EnergyGrowth, ABurstStandsAndALineGrowsOn) {
  goesOn([](double t) { return 3e-3 * std::min(1.0, t); },
         [](const EnergyGrowth& g, double t) { EXPECT_FALSE(t > 2.2 && g.growsOn()) << "turn " << t; });
  for (const double constant : {1.0, 4.0, 7.0}) {  // turns
    goesOn([&](double t) { return 1e-3 * std::exp(2.0 * t / constant); },
           [&](const EnergyGrowth& g, double t) {
             EXPECT_TRUE(t < 2.2 || g.growsOn()) << constant << " turns, turn " << t;
           });
  }
}

TEST(EnergyGrowth, TellsHowItsVibrationFalls) {
  EnergyGrowth growth;
  const auto turn = [&](double size) {
    for (int hop = 0; hop < kHopsPerTurn; ++hop) {
      growth.add(std::array<double, 1>{size}, std::array<double, 1>{0.0});
      growth.endHop(kHopsPerTurn, Seconds(1e-3));
    }
  };
  EXPECT_DOUBLE_EQ(growth.levelTrend(), 1.0);
  for (int k = 0; k < 8; ++k) turn(2.0);
  EXPECT_DOUBLE_EQ(growth.levelTrend(), 1.0);
  turn(1.0);  // a quarter of the energy
  EXPECT_NEAR(growth.levelTrend(), 0.25 / ((7.0 + 0.25) / 8.0), 1e-12);
}

TEST(LineFinder, FindsALineAndItsPurity) {
  LineFinder lines;
  lines.prepare(1, 2048, Hertz(kRate));
  for (int k = 0; k < 4096; ++k) {
    const double x = tone(935.5, k) + 0.05 * tone(2200.0, k);
    lines.push(&x, 1, 1);
  }
  const FoundLine line = lines.find(Hertz(50.0), Hertz(5000.0));
  EXPECT_NEAR(line.frequency.value, 935.5, 0.5);
  EXPECT_GT(line.purity, 0.95);
}

// Against |X|^2 summed plainly, thirty-two frequencies to each 1 / window: two channels of tones and noise.
TEST(LineFinder, ReadsBetweenTheBinsWhatAPlainTransformSaysThere) {
  constexpr int kWindow = 1000;
  constexpr double kStep = kRate / kWindow / 32.0;
  constexpr double kLow = 200.0;
  constexpr double kHigh = 4000.0;
  std::vector<double> window(kWindow);
  dsp::fillWindow(dsp::WindowKind::Recent, window);
  std::mt19937 engine(3);
  std::normal_distribution<double> normal(0.0, 0.3);
  for (const double hertz : {931.0, 944.0}) {  // a bin is 25.6 Hz
    LineFinder lines;
    lines.prepare(2, kWindow, Hertz(kRate));
    std::vector<std::vector<double>> heard(2, std::vector<double>(kWindow));
    for (int k = 0; k < kWindow; ++k) {
      const std::array<double, 2> x{tone(hertz, k) + 0.5 * tone(1370.0, k) + normal(engine),
                                    20.0 * tone(hertz, k + 5) + 10.0 * normal(engine)};
      for (std::size_t c = 0; c < 2; ++c)
        heard[c][static_cast<std::size_t>(k)] = x[c] * window[static_cast<std::size_t>(k)];
      lines.push(x.data(), 1, 1);
    }
    const auto count = static_cast<std::size_t>((kHigh - kLow) / kStep);
    std::vector<double> plain(count, 0.0);
    for (const auto& channel : heard) {
      std::vector<double> power(count);
      double all = 0.0;
      for (std::size_t i = 0; i < count; ++i) {
        std::complex<double> x = 0.0;
        const double turn = -kTwoPi * (kLow + kStep * static_cast<double>(i)) / kRate;
        for (int k = 0; k < kWindow; ++k) x += channel[static_cast<std::size_t>(k)] * std::polar(1.0, turn * k);
        power[i] = std::norm(x);
        all += power[i];
      }
      for (std::size_t i = 0; i < count; ++i) plain[i] += power[i] / all;
    }
    const auto top = static_cast<std::size_t>(std::max_element(plain.begin(), plain.end()) - plain.begin());
    double lobe = 0.0;
    for (std::size_t i = top - 4 * 32; i <= top + 4 * 32; ++i) lobe += plain[i];
    const FoundLine line = lines.find(Hertz(kLow), Hertz(kHigh));
    EXPECT_NEAR(line.frequency.value, kLow + kStep * static_cast<double>(top), kStep) << hertz;
    EXPECT_NEAR(line.purity, lobe / 2.0, 0.02 * lobe) << hertz;
    // The weaker line, and its height against the stronger one.
    const LineFinder::Peak strong = lines.near(line.frequency, Hertz(60.0));
    const LineFinder::Peak weak = lines.near(Hertz(1370.0), Hertz(60.0));
    const auto at = [&](Hertz f) { return plain[static_cast<std::size_t>(std::lround((f.value - kLow) / kStep))]; };
    EXPECT_NEAR(strong.frequency.value, line.frequency.value, 1e-9);
    EXPECT_NEAR(weak.power / strong.power, at(weak.frequency) / at(strong.frequency), 0.02 * weak.power / strong.power)
        << hertz;
  }
}

}  // namespace
}  // namespace stillcut::detect
