// Calibration of the spectrum: Parseval, the amplitude of a sine, the density of white noise.
#include "core/dsp/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace stillcut::dsp {
namespace {

constexpr Hertz kRate{8192.0};

std::vector<double> sine(int n, double amplitude, double f) {
  std::vector<double> x(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) x[static_cast<std::size_t>(i)] = amplitude * std::cos(kTwoPi * f * i / kRate.value + 0.7);
  return x;
}

std::vector<double> noise(int n, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<double> x(static_cast<std::size_t>(n));
  for (double& v : x) v = normal(engine);
  return x;
}

TEST(Fft, RefusesSizesThatWouldAllocateLater) {
  RealFft fft;
  EXPECT_THROW(fft.prepare(2 * 11), std::runtime_error);
  EXPECT_THROW(fft.prepare(1), std::runtime_error);
  EXPECT_THROW(fft.prepare(105), std::runtime_error);
  EXPECT_NO_THROW(fft.prepare(2 * 3 * 5 * 7));
  EXPECT_EQ(goodFftSize(1021), 1024);
  EXPECT_EQ(goodFftSize(2401), 2430);  // 2401 = 7^4 is odd
  for (const int n : {2, 33, 1000, 2917, 8749, 11565, 40000}) {
    const int fast = fastFftSize(n);
    EXPECT_GE(fast, n);
    EXPECT_LE(fast, n + n / 4 + 32);
    EXPECT_EQ(goodFftSize(fast), fast);
    EXPECT_NE(fast % 9, 0);
  }
}

TEST(Fft, ParsevalHolds) {
  for (const int n : {2, 64, 210, 1024}) {
    RealFft fft;
    fft.prepare(n);
    const std::vector<double> x = noise(n, 3);
    double time = 0.0;
    for (int i = 0; i < n; ++i) {
      fft.input()[static_cast<std::size_t>(i)] = x[static_cast<std::size_t>(i)];
      time += x[static_cast<std::size_t>(i)] * x[static_cast<std::size_t>(i)];
    }
    const auto bins = fft.forward();
    double frequency = 0.0;
    for (std::size_t k = 0; k < bins.size(); ++k) {
      const bool single = k == 0 || 2 * k == static_cast<std::size_t>(n);
      frequency += (single ? 1.0 : 2.0) * std::norm(bins[k]);
    }
    EXPECT_NEAR(frequency / n, time, 1e-9 * time);
  }
}

TEST(Spectrum, AUnitSineHasAmplitudeOneAndMeanSquareOneHalf) {
  for (const WindowKind kind : {WindowKind::Rectangular, WindowKind::Hann, WindowKind::FlatTop}) {
    Spectrum s;
    s.prepare(1024, kRate, kind);
    s.transform(sine(1024, 1.0, 100 * s.binWidth()));
    EXPECT_NEAR(s.amplitude(100), 1.0, 1e-6);
    double meanSquare = 0.0;
    for (int k = 0; k < s.bins(); ++k) meanSquare += s.density(k) * s.binWidth();
    EXPECT_NEAR(meanSquare, 0.5, 1e-6);
  }
}

TEST(Spectrum, WhiteNoiseHasItsDensity) {
  Spectrum s;
  s.prepare(512, kRate, WindowKind::Hann);
  const std::vector<double> x = noise(512 * 200, 11);
  double mean = 0.0;
  for (int i = 0; i < 200; ++i) {
    s.transform(std::span(x).subspan(static_cast<std::size_t>(512 * i), 512));
    for (int k = 10; k < 240; ++k) mean += s.density(k) / (200.0 * 230.0);
  }
  // variance 1 spread over rate/2; 46 000 values, Hann neighbours correlated: about 1 % standard error
  EXPECT_NEAR(mean * kRate.value / 2.0, 1.0, 0.03);
}

}  // namespace
}  // namespace stillcut::dsp
