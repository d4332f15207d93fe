// Transforms and windows against their definitions, term by term.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/base/units.h"
#include "core/dsp/fft.h"
#include "core/dsp/spectrum.h"
#include "core/dsp/window.h"

namespace stillcut::dsp {
namespace {

std::vector<double> noiseOf(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> x(static_cast<std::size_t>(n));
  for (double& v : x) v = normal(random);
  return x;
}

// X[k] = sum x[n] exp(-2 pi i k n / N), one term after the other.
std::complex<double> plainBin(const std::vector<double>& x, int k) {
  std::complex<double> sum = 0.0;
  const auto size = static_cast<double>(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) {
    // The product modulo N keeps the angle exact.
    const double turns = std::fmod(static_cast<double>(k) * static_cast<double>(n), size) / size;
    sum += x[n] * std::polar(1.0, -kTwoPi * turns);
  }
  return sum;
}

bool hasOnlySmallPrimes(int n) {
  for (int p : {2, 3, 5, 7}) {
    while (n % p == 0) n /= p;
  }
  return n == 1;
}

TEST(RealFft, AgreesWithTheSumWrittenOut) {
  for (int size : {2, 4, 6, 10, 14, 30, 64, 98, 210, 256, 500}) {
    RealFft fft;
    fft.prepare(size);
    ASSERT_EQ(fft.size(), size);
    const std::vector<double> x = noiseOf(size, static_cast<unsigned>(size));
    std::copy(x.begin(), x.end(), fft.input().begin());
    const auto bins = fft.forward();
    ASSERT_EQ(static_cast<int>(bins.size()), fft.bins());
    for (int k = 0; k < fft.bins(); ++k) {
      EXPECT_LT(std::abs(bins[static_cast<std::size_t>(k)] - plainBin(x, k)), 1e-11) << size << " " << k;
    }
    EXPECT_TRUE(std::equal(x.begin(), x.end(), fft.input().begin()));  // the input is left as it is
  }
}

TEST(RealFft, IsLinearAndShiftsTurnThePhase) {
  constexpr int kSize = 120;
  RealFft a, b, both;
  for (RealFft* fft : {&a, &b, &both}) fft->prepare(kSize);
  const std::vector<double> x = noiseOf(kSize, 1), y = noiseOf(kSize, 2);
  for (std::size_t n = 0; n < kSize; ++n) {
    a.input()[n] = x[n];
    b.input()[n] = x[(n + 1) % kSize];
    both.input()[n] = 2.0 * x[n] - 3.0 * y[n];
  }
  const auto first = a.forward();
  const auto shifted = b.forward();
  const auto sum = both.forward();
  for (int k = 0; k < a.bins(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_LT(std::abs(shifted[i] - first[i] * std::polar(1.0, kTwoPi * k / kSize)), 1e-11);
    EXPECT_LT(std::abs(sum[i] - (2.0 * first[i] - 3.0 * plainBin(y, k))), 1e-11);
  }
}

TEST(RealFft, AMovedPlanGoesOnWorking) {
  RealFft fft;
  fft.prepare(16);
  fft.input()[1] = 1.0;
  RealFft moved = std::move(fft);
  EXPECT_EQ(moved.size(), 16);
  EXPECT_LT(std::abs(moved.forward()[4] - std::complex<double>(0.0, -1.0)), 1e-15);
}

TEST(RealFft, RefusesSizesWithLargePrimes) {
  for (int size : {-4, 0, 1, 11, 22, 13 * 4, 2 * 17}) {
    RealFft fft;
    EXPECT_THROW(fft.prepare(size), std::runtime_error) << size;
  }
}

TEST(FftSizes, AreTheSmallestThatWillDo) {
  for (int n = 2; n < 5000; ++n) {
    const int good = goodFftSize(n);
    ASSERT_GE(good, n);
    ASSERT_EQ(good % 2, 0);
    ASSERT_TRUE(hasOnlySmallPrimes(good));
    for (int smaller = n + n % 2; smaller < good; smaller += 2) ASSERT_FALSE(hasOnlySmallPrimes(smaller)) << n;
    const int fast = fastFftSize(n);
    ASSERT_GE(fast, n);
    if (n <= 32) {
      ASSERT_EQ(fast, good);  // nothing to gain
      continue;
    }
    ASSERT_EQ(fast % 32, 0);
    ASSERT_NE(fast % 9, 0);
    ASSERT_TRUE(hasOnlySmallPrimes(fast));
  }
}

constexpr WindowKind kKinds[] = {WindowKind::Rectangular, WindowKind::Hann, WindowKind::FlatTop, WindowKind::Recent};

TEST(Windows, TheirSumsAreTheirSums) {
  for (WindowKind kind : kKinds) {
    for (std::size_t n : {8U, 33U, 500U}) {
      std::vector<double> w(n, -1.0);
      const WindowSums sums = fillWindow(kind, w);
      double sum = 0.0, squares = 0.0;
      for (double v : w) {
        sum += v;
        squares += v * v;
      }
      EXPECT_NEAR(sums.sum, sum, 1e-12 * static_cast<double>(n));
      EXPECT_NEAR(sums.squares, squares, 1e-12 * static_cast<double>(n));
    }
  }
}

TEST(Windows, HannIsItsFormulaAndPeriodic) {
  std::vector<double> w(64);
  fillWindow(WindowKind::Hann, w);
  for (std::size_t n = 0; n < 64; ++n)
    EXPECT_NEAR(w[n], 0.5 - 0.5 * std::cos(kTwoPi * static_cast<double>(n) / 64.0), 1e-15);
  for (std::size_t n = 1; n < 64; ++n) EXPECT_NEAR(w[n], w[64 - n], 1e-15);  // even about n = N/2, w[0] its own mirror
}

TEST(Windows, TheRecentOneHasItsPeakNearItsEnd) {
  std::vector<double> w(1000);
  fillWindow(WindowKind::Recent, w);
  const auto peak = std::max_element(w.begin(), w.end()) - w.begin();
  EXPECT_NEAR(static_cast<double>(peak), 900.0, 2.0);
  for (std::size_t n = 1; n < 899; ++n) EXPECT_GE(w[n], w[n - 1]);
  for (std::size_t n = 902; n < 1000; ++n) EXPECT_LE(w[n], w[n - 1]);
}

// A flat top's use: the amplitude of a line is right wherever it lies between two bins.
TEST(Windows, AFlatTopHoldsTheAmplitudeBetweenBins) {
  for (double place : {0.0, 0.1, 0.25, 0.5}) {
    const Hertz rate{1024.0};
    Spectrum flat, hann;
    flat.prepare(1024, rate, WindowKind::FlatTop);
    hann.prepare(1024, rate, WindowKind::Hann);
    std::vector<double> x(1024);
    for (std::size_t n = 0; n < x.size(); ++n) {
      x[n] = 3.0 * std::sin(kTwoPi * (100.0 + place) * static_cast<double>(n) / rate.value);
    }
    flat.transform(x);
    hann.transform(x);
    const double largest = std::max(flat.amplitude(100), flat.amplitude(101));
    EXPECT_NEAR(largest, 3.0, 0.005) << place;
    if (place == 0.5) {
      EXPECT_LT(std::max(hann.amplitude(100), hann.amplitude(101)), 2.6);
    }
  }
}

TEST(Spectrum, TwoPartsOfARingAreTheWhole) {
  Spectrum whole, parts;
  for (Spectrum* s : {&whole, &parts}) s->prepare(200, Hertz(1000.0), WindowKind::Hann, 400);
  const std::vector<double> x = noiseOf(200, 7);
  for (std::size_t cut : {1U, 77U, 199U}) {
    whole.transform(x);
    parts.transform(std::span(x).first(cut), std::span(x).subspan(cut));
    for (std::size_t k = 0; k < whole.values().size(); ++k) EXPECT_EQ(whole.values()[k], parts.values()[k]) << cut;
  }
}

TEST(Spectrum, PowersAreTheSquaresOfTheValues) {
  Spectrum s;
  s.prepare(256, Hertz(1000.0), WindowKind::Hann);
  s.transform(noiseOf(256, 8));
  std::vector<double> powers(s.values().size());
  s.powers(powers);
  for (std::size_t k = 0; k < powers.size(); ++k) EXPECT_NEAR(powers[k], std::norm(s.values()[k]), 1e-9 * powers[k]);
}

}  // namespace
}  // namespace stillcut::dsp
