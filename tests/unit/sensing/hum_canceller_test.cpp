// Hum that was there in air is taken out; the spindle's orders and what grows beside the mains are not.
#include "core/sensing/hum_canceller.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stillcut::detect {
namespace {

constexpr double kRate = 10000.0;
constexpr int kBlock = 100;

struct Bench {
  Bench() { canceller.prepare(Hertz(kRate)); }
  // Mean square after it, over the last second of `seconds` of a tone.
  double run(double hertz, double amplitude, double seconds, Hertz spindle, bool air) {
    double sum = 0.0;
    const auto blocks = static_cast<int>(seconds * kRate / kBlock);
    for (int b = 0; b < blocks; ++b) {
      std::vector<double> x(kBlock);
      for (double& v : x) v = amplitude * std::sin(kTwoPi * hertz * n++ / kRate);
      canceller.process(x, spindle, air);
      for (const double v : x) sum += (blocks - b) * kBlock <= kRate ? v * v / kRate : 0.0;
    }
    return sum;
  }
  HumCanceller canceller;
  double n = 0.0;
};

TEST(HumCanceller, WhatStoodOnTheMainsInAirIsTakenOutOfTheCut) {
  Bench bench;
  bench.run(150.03, 0.5, 5.0, Hertz(83.0), true);
  EXPECT_TRUE(bench.canceller.active());
  EXPECT_LT(bench.run(150.03, 0.5, 2.0, Hertz(83.0), false), 0.01 * 0.125);
}

TEST(HumCanceller, WhatBeginsInTheCutIsNot) {
  Bench bench;
  EXPECT_NEAR(bench.run(150.0, 0.5, 5.0, Hertz(83.0), false), 0.125, 1e-3);
  EXPECT_FALSE(bench.canceller.active());
}

TEST(HumCanceller, AnOrderOfTheSpindleIsNot) {
  Bench bench;
  EXPECT_NEAR(bench.run(150.0, 0.5, 5.0, Hertz(50.0), true), 0.125, 1e-3);
}

TEST(HumCanceller, AToneBesideTheMainsPassesTheNotch) {
  Bench bench;
  bench.run(150.0, 0.5, 5.0, Hertz(83.0), true);
  bench.run(150.0, 0.0, 3.0, Hertz(83.0), false);  // ... and forgets the hum where it ends
  EXPECT_NEAR(bench.run(156.0, 0.5, 3.0, Hertz(83.0), false), 0.125, 0.125 * 0.05);
}

}  // namespace
}  // namespace stillcut::detect
