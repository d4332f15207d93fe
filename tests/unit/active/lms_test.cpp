#include "core/active/lms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

const std::vector<double> kPath{0.0, 0.8, -0.4, 0.2, 0.05};

// d = kPath * x (without the delay of a path), plus noise of its own.
std::vector<double> wantedOf(const std::vector<double>& x, double noise) {
  std::vector<double> d = whiteNoise(x.size(), 77, noise);
  for (std::size_t n = 0; n < x.size(); ++n) {
    for (std::size_t k = 0; k < kPath.size(); ++k) d[n] += kPath[k] * past(x, n, k);
  }
  return d;
}

double distanceToPath(const Lms& lms) {
  double sum = 0.0;
  for (int k = 0; k < lms.taps(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double rest = lms.weights()[i] - (i < kPath.size() ? kPath[i] : 0.0);
    sum += rest * rest;
  }
  return std::sqrt(sum);
}

TEST(Lms, AgreesWithTheEquationWrittenOut) {
  const auto x = whiteNoise(500, 4);
  const auto d = wantedOf(x, 0.1);
  for (double leak : {1.0, 0.999}) {
    for (int taps : {3, 35}) {
      Lms lms;
      lms.prepare({.taps = taps, .step = 0.003, .leak = leak});
      for (std::size_t n = 0; n < x.size(); ++n) lms.process(x[n], d[n]);
      const auto plain = plainLms(x, d, static_cast<std::size_t>(taps), 0.003, leak);
      for (std::size_t k = 0; k < plain.size(); ++k) EXPECT_NEAR(lms.weights()[k], plain[k], 1e-12);
    }
  }
}

// White input: the Wiener solution is the path itself, and the misadjustment is about mu tr(R) (Widrow).
TEST(Lms, ConvergesToTheWienerSolution) {
  const auto x = whiteNoise(40000, 5);
  const auto d = wantedOf(x, 0.1);
  const double mu = 0.0005;
  const int taps = 16;
  Lms lms;
  lms.prepare({.taps = taps, .step = mu});
  double left = 0.0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double e = lms.process(x[n], d[n]);
    if (n >= 20000) left += e * e / 20000.0;
  }
  EXPECT_LT(distanceToPath(lms), 0.02);
  const double misadjustment = left / 0.01 - 1.0;
  EXPECT_GT(misadjustment, 0.2 * mu * taps);
  EXPECT_LT(misadjustment, 5.0 * mu * taps);
}

// The printed sign of eq. 1 is that of mu below zero: it runs away.
TEST(Lms, ThePrintedSignDiverges) {
  const auto x = whiteNoise(4000, 6);
  const auto d = wantedOf(x, 0.1);
  Lms lms;
  lms.prepare({.taps = 16, .step = -0.005});
  for (std::size_t n = 0; n < x.size(); ++n) lms.process(x[n], d[n]);
  EXPECT_GT(distanceToPath(lms), 1e6);
}

TEST(Lms, TheStepBoundSeparatesConvergenceFromDivergence) {
  const auto x = whiteNoise(20000, 7);
  const auto d = wantedOf(x, 0.0);
  const int taps = 32;
  for (const auto& [factor, converges] : {std::pair{0.5, true}, std::pair{6.0, false}}) {
    Lms lms;
    lms.prepare({.taps = taps, .step = factor / (3.0 * taps)});
    for (std::size_t n = 0; n < x.size(); ++n) lms.process(x[n], d[n]);
    EXPECT_EQ(distanceToPath(lms) < 1e-6, converges) << factor;
  }
}

// Coloured input: the weights converge along the eigenvectors of R, each at its own eigenvalue's pace; the slow ones
// last. With an eigenvalue spread of 10^2 and the same power the plain filter is still far off when the white one is
// there.
TEST(Lms, ALargeEigenvalueSpreadSlowsItDown) {
  const auto noise = whiteNoise(6000, 8);
  std::vector<double> coloured(noise.size());
  const double a = 0.9;
  for (std::size_t n = 0; n < noise.size(); ++n) {
    coloured[n] = a * past(coloured, n, 1) + std::sqrt(1.0 - a * a) * noise[n];
  }
  Lms white;
  Lms slow;
  white.prepare({.taps = 16, .step = 0.002});
  slow.prepare({.taps = 16, .step = 0.002});
  const auto dw = wantedOf(noise, 0.0);
  const auto dc = wantedOf(coloured, 0.0);
  for (std::size_t n = 0; n < noise.size(); ++n) {
    white.process(noise[n], dw[n]);
    slow.process(coloured[n], dc[n]);
  }
  EXPECT_LT(distanceToPath(white), 1e-6);
  EXPECT_GT(distanceToPath(slow), 100.0 * distanceToPath(white));
}

TEST(Lms, NormalisedDoesNotCareHowLoudTheInputIs) {
  const auto x = whiteNoise(3000, 9);
  for (double gain : {1e-6, 1.0, 1e6}) {
    auto loud = x;
    for (double& v : loud) v *= gain;
    const auto d = wantedOf(loud, 0.0);
    Lms lms;
    lms.prepare({.taps = 16, .step = 0.5, .normalised = true});
    for (std::size_t n = 0; n < x.size(); ++n) lms.process(loud[n], d[n]);
    EXPECT_LT(distanceToPath(lms), 1e-4) << gain;
  }
}

TEST(Lms, SilenceTeachesNothing) {
  Lms lms;
  lms.prepare({.taps = 16, .step = 0.5, .normalised = true});
  for (int n = 0; n < 100; ++n) lms.process(0.0, 1.0);
  for (int k = 0; k < 16; ++k) EXPECT_EQ(lms.weights()[static_cast<std::size_t>(k)], 0.0);
}

}  // namespace
}  // namespace stillcut::active
