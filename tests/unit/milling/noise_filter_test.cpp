// What the simulation is made of besides physics: random numbers that are random and repeat, and the filter before the
// converter, against its transfer function.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <set>
#include <vector>

#include "core/milling/simulation/low_pass.h"
#include "core/milling/simulation/noise.h"

namespace stillcut::milling {
namespace {

TEST(NoiseSource, TheSameSeedGivesTheSameNumbersAndAnotherOthers) {
  NoiseSource a(7), b(7), c(8);
  int same = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = a.normal();
    EXPECT_EQ(x, b.normal());
    same += x == c.normal() ? 1 : 0;
  }
  EXPECT_EQ(same, 0);
}

// chi-squared over 100 bins: mean 99, standard deviation 14; 5 of them is one in a million.
TEST(NoiseSource, UniformIsUniform) {
  NoiseSource noise(1);
  std::array<int, 100> bins{};
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double u = noise.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    ++bins[static_cast<std::size_t>(u * 100.0)];
  }
  double chi = 0.0;
  for (int count : bins) chi += (count - n / 100.0) * (count - n / 100.0) / (n / 100.0);
  EXPECT_LT(chi, 99.0 + 5.0 * 14.1);
  EXPECT_GT(chi, 99.0 - 5.0 * 14.1);
}

TEST(NoiseSource, NormalHasTheMomentsAndTailsOfANormal) {
  NoiseSource noise(2);
  const int n = 400000;
  double sum = 0.0, square = 0.0, fourth = 0.0;
  int beyondTwo = 0, beyondThree = 0;
  for (int i = 0; i < n; ++i) {
    const double x = noise.normal();
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
    beyondTwo += std::abs(x) > 2.0 ? 1 : 0;
    beyondThree += std::abs(x) > 3.0 ? 1 : 0;
  }
  const double root = std::sqrt(static_cast<double>(n));
  EXPECT_NEAR(sum / n, 0.0, 5.0 / root);
  EXPECT_NEAR(square / n, 1.0, 5.0 * std::sqrt(2.0) / root);
  EXPECT_NEAR(fourth / n, 3.0, 5.0 * std::sqrt(96.0) / root);
  EXPECT_NEAR(static_cast<double>(beyondTwo) / n, 0.0455, 0.002);
  EXPECT_NEAR(static_cast<double>(beyondThree) / n, 0.0027, 0.0005);
}

TEST(NoiseSource, IsWhite) {
  NoiseSource noise(3);
  std::vector<double> x(200000);
  for (double& v : x) v = noise.normal();
  for (std::size_t lag : {1U, 2U, 3U, 10U, 100U, 1000U}) {
    double sum = 0.0;
    for (std::size_t i = lag; i < x.size(); ++i) sum += x[i] * x[i - lag];
    EXPECT_NEAR(sum / static_cast<double>(x.size()), 0.0, 5.0 / std::sqrt(static_cast<double>(x.size()))) << lag;
  }
}

TEST(NoiseSource, SeedsThatLieTogetherStartFarApart) {
  std::set<double> first;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) first.insert(NoiseSource(seed).uniform());
  EXPECT_EQ(first.size(), 1000u);
  EXPECT_LT(*first.begin(), 0.01);
  EXPECT_GT(*first.rbegin(), 0.99);
}

// Gain at f, from the response to an impulse.
double gainAt(Hertz f, Hertz edge, Hertz rate) {
  LowPass4 filter;
  filter.prepare(edge, rate);
  std::complex<double> sum = 0.0;
  for (int n = 0; n < 20000; ++n) {
    sum += filter.run(n == 0 ? 1.0 : 0.0) * std::polar(1.0, -kTwoPi * f.value / rate.value * n);
  }
  return std::abs(sum);
}

// |H|^2 = 1 / (1 + (w/w_c)^8) in the warped frequency of the bilinear transform.
TEST(LowPass4, IsTheButterworthFilterOfFourthOrder) {
  const Hertz rate{51200.0};
  for (double edge : {200.0, 3000.0, 10000.0, 20000.0}) {
    for (double f : {0.0, 0.3 * edge, 0.9 * edge, edge, 1.1 * edge, 2.0 * edge}) {
      if (f >= 0.49 * rate.value) continue;
      const double w = std::tan(kTwoPi * 0.5 * f / rate.value);
      const double corner = std::tan(kTwoPi * 0.5 * edge / rate.value);
      const double wanted = 1.0 / std::sqrt(1.0 + std::pow(w / corner, 8.0));
      EXPECT_NEAR(gainAt(Hertz(f), Hertz(edge), rate), wanted, 1e-9 + 1e-6 * wanted) << edge << " " << f;
    }
  }
}

TEST(LowPass4, SettlesOnAConstantAndForgetsAnImpulse) {
  LowPass4 filter;
  filter.prepare(Hertz(1000.0), Hertz(25600.0));
  double y = 0.0, highest = 0.0;
  for (int n = 0; n < 5000; ++n) {
    y = filter.run(2.5);
    highest = std::max(highest, y);
  }
  EXPECT_NEAR(y, 2.5, 1e-12);
  EXPECT_LT(highest, 2.5 * 1.115);  // its step response overshoots by 10.9 %
  for (int n = 0; n < 5000; ++n) y = filter.run(0.0);
  EXPECT_NEAR(y, 0.0, 1e-12);
}

}  // namespace
}  // namespace stillcut::milling
