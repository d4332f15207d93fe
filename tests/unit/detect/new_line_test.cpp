// The frequency of a line that has just come, beside a harmonic that is as strong.
#include "core/detect/growth/new_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/detect/caliskan/line_finder.h"
#include "core/detect/growth/turn_difference.h"

namespace stillcut::detect {
namespace {

constexpr double kRate = 25600.0;
constexpr Hertz kSpindle(97.0);  // a turn is no whole number of frames
constexpr int kWindow = 16 * 264;

struct Made {
  double offset = 0.13;    // orders above the twelfth harmonic
  double constant = 0.01;  // s of growth; 0: the line is there from the begin
  double ramp = 0.0;       // of the twelfth harmonic's amplitude, per second
  double seconds = 0.07;   // since the line came
};

constexpr double kBefore = 1.0;  // s without the line

double lineAt(const Made& made, double t) {
  const double grown = made.constant > 0.0 ? 0.02 * std::exp((t - kBefore) / made.constant) : 3.0;
  const double size = made.constant > 0.0 && t < kBefore ? 0.0 : std::min(3.0, grown);
  return size * std::sin(kTwoPi * (12.0 + made.offset) * kSpindle.value * t);
}

std::vector<double> signal(const Made& made) {
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0.0, 0.07);
  std::vector<double> x(static_cast<std::size_t>((kBefore + made.seconds) * kRate));
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t = static_cast<double>(n) / kRate;
    x[n] = noise(engine) + lineAt(made, t);
    for (const int order : {1, 4, 8, 11, 12, 13, 16}) {
      const double size = order == 12 ? 1.0 + made.ramp * t : 1.0;
      x[n] += size * std::cos(kTwoPi * order * kSpindle.value * t + 0.7 * order);
    }
  }
  return x;
}

Hertz found(const std::vector<double>& x, Hertz rough) {
  NewLine line;
  line.prepare(1, kWindow, Hertz(kRate));
  for (std::size_t n = 0; n < x.size(); n += 100) line.push(x.data() + n, 0, std::min<std::size_t>(100, x.size() - n));
  return line.frequency(rough, kSpindle);
}

Hertz topOfTheDifference(const std::vector<double>& x) {
  RevolutionDifference turns;
  turns.prepare(1, Hertz(kRate), kSpindle * 0.5);
  turns.setTurn(kSpindle);
  std::vector<double> difference(x.size());
  turns.process(x.data(), 0, x.size(), difference.data(), nullptr, 0);
  LineFinder lines;
  lines.prepare(1, kWindow, Hertz(kRate));
  lines.push(difference.data(), 0, difference.size());
  return lines.find(Hertz(50.0), Hertz(3000.0)).frequency;
}

TEST(NewLine, IsRightWhereTheSpectrumIsPulledAway) {
  double worstOfSpectrum = 0.0;
  for (const double offset : {-0.3, -0.18, -0.13, 0.1, 0.13, 0.25, 0.4}) {
    for (const double constant : {0.005, 0.01, 0.02}) {
      const Made made{offset, constant, 0.0, 5.0 * constant + 0.035};  // just at its full size
      const std::vector<double> x = signal(made);
      const double truth = (12.0 + offset) * kSpindle.value;
      const Hertz rough = topOfTheDifference(x);
      EXPECT_NEAR(found(x, rough).value, truth, 0.02 * kSpindle.value) << offset << " " << constant;
      worstOfSpectrum = std::max(worstOfSpectrum, std::abs(rough.value - truth));
    }
  }
  EXPECT_GT(worstOfSpectrum, 0.06 * kSpindle.value);  // or there would be nothing to cure
}

TEST(NewLine, ARoughFrequencyMayBeAThirdOfAnOrderOff) {
  const std::vector<double> x = signal({});
  const double truth = 12.13 * kSpindle.value;
  for (const double off : {-0.33, 0.0, 0.33}) {
    EXPECT_NEAR(found(x, Hertz(truth + off * kSpindle.value)).value, truth, 0.03 * kSpindle.value) << off;
  }
}

TEST(NewLine, SaysNothingOfALineThatWasThereBefore) {
  EXPECT_EQ(found(signal({0.13, 0.0, 0.0, 0.1}), Hertz(12.13 * kSpindle.value)).value, 0.0);
}

TEST(NewLine, SaysNothingWhereNoLineHasCome) {
  EXPECT_EQ(found(signal({0.13, 0.01, 0.0, 0.0}), Hertz(12.13 * kSpindle.value)).value, 0.0);
}

// A spindle that slows down by 5 % a second, and a line of fixed frequency that an order is just passing.
TEST(NewLine, IsRightWhileTheSpeedChanges) {
  constexpr double kSlowing = 0.05;
  constexpr double kEnd = 1.12;
  const auto turns = [](double t) { return kSpindle.value * t * (1.0 - 0.5 * kSlowing * t); };
  const double passes = 1.05;  // s: where the order is on the line
  const double truth = 8.0 * kSpindle.value * (1.0 - kSlowing * passes);
  std::mt19937 engine(7);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::vector<double> x(static_cast<std::size_t>(kEnd * kRate));
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t = static_cast<double>(n) / kRate;
    x[n] = noise(engine) +
           (t < 1.0 ? 0.0 : std::min(3.0, 0.02 * std::exp((t - 1.0) / 0.015))) * std::sin(kTwoPi * truth * t);
    for (const int order : {1, 3, 6, 8, 9, 12}) x[n] += std::cos(kTwoPi * order * turns(t) + 0.7 * order);
  }
  NewLine line;
  line.prepare(1, 25 * 290, Hertz(kRate));
  for (std::size_t n = 0; n < x.size(); n += 100) line.push(x.data() + n, 0, std::min<std::size_t>(100, x.size() - n));
  NewLine::TurnsAgo ago{};
  const double end = static_cast<double>(x.size()) / kRate;
  for (std::size_t k = 0; k < ago.size(); ++k) {
    const double then = turns(end) - static_cast<double>(k);
    ago[k] = (end - (1.0 - std::sqrt(1.0 - 2.0 * kSlowing * then / kSpindle.value)) / kSlowing) * kRate;
  }
  const Hertz spindle = kSpindle * (1.0 - kSlowing * kEnd);
  for (const double off : {-0.2, 0.0, 0.2}) {
    const Hertz rough(truth + off * spindle.value);
    EXPECT_NEAR(line.frequency(rough, spindle, ago).value, truth, 0.002 * truth) << off;
    // As if it stood, there is nothing to be said, or nothing right.
    EXPECT_GT(std::abs(line.frequency(rough, spindle).value - truth), 0.005 * truth) << off;
  }
}

// What a harmonic grows by is no line beside it.
TEST(NewLine, SaysNothingOfAHarmonicThatChanges) {
  EXPECT_EQ(found(signal({0.13, 0.01, 5.0, 0.0}), Hertz(12.13 * kSpindle.value)).value, 0.0);
}

}  // namespace
}  // namespace stillcut::detect
