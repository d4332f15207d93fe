// Zeros counted by the turns of a function's argument: against polynomials whose zeros are known; and the functions
// that carry a cell from one end to the other, against their series summed plainly.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "core/base/units.h"
#include "core/milling/stability/argument_principle.h"
#include "core/milling/stability/cell_map.h"

namespace stillcut::milling {
namespace {

using Complex = std::complex<double>;

double turnsAlong(const std::vector<Complex>& zeros, double radius) {
  const auto f = [&](double angle) {
    Complex value = 1.0;
    for (Complex zero : zeros) value *= std::polar(radius, angle) - zero;
    return value;
  };
  return argumentChange(f, 0.0, kTwoPi, 16) / kTwoPi;
}

TEST(ArgumentPrinciple, CountsTheZerosInside) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> size(0.0, 2.0), angle(0.0, kTwoPi);
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<Complex> zeros;
    int inside = 0;
    for (auto n = 1 + random() % 12; n > 0; --n) {
      const double r = size(random);
      zeros.push_back(std::polar(r, angle(random)));
      inside += r < 1.0 ? 1 : 0;
    }
    EXPECT_NEAR(turnsAlong(zeros, 1.0), inside, 1e-9) << trial;
  }
}

TEST(ArgumentPrinciple, CountsAZeroAHairInsideAndOutside) {
  for (double away : {1e-3, 1e-6, 1e-9}) {
    EXPECT_NEAR(turnsAlong({std::polar(1.0 - away, 0.7)}, 1.0), 1.0, 1e-9) << away;
    EXPECT_NEAR(turnsAlong({std::polar(1.0 + away, 0.7)}, 1.0), 0.0, 1e-9) << away;
  }
}

TEST(ArgumentPrinciple, AZeroOnTheArcIsSaidAndNotGuessed) {
  EXPECT_TRUE(std::isnan(turnsAlong({std::polar(1.0, 0.7)}, 1.0)));
}

TEST(ArgumentPrinciple, AMultipleZeroCountsAsOften) {
  EXPECT_NEAR(turnsAlong({0.5, 0.5, 0.5, Complex(0.0, 0.2)}, 1.0), 4.0, 1e-9);
}

// phi_k = sum Z^j / (j + k)!, as it stands; fine for the sizes here in long double.
Eigen::Matrix2d plainPhi(const Eigen::Matrix2d& z, int k) {
  using Long = Eigen::Matrix<long double, 2, 2>;
  Long term = Long::Identity(), sum = Long::Zero();
  for (int j = 1; j <= k; ++j) term /= static_cast<long double>(j);
  for (int j = 0; j < 120; ++j) {
    sum += term;
    term = (term * z.cast<long double>()).eval() / static_cast<long double>(j + k + 1);
  }
  return sum.cast<double>();
}

TEST(PhiFunctions, AgreeWithTheirSeries) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  for (double scale : {1e-6, 0.1, 0.69, 0.71, 3.0, 9.0}) {
    for (int trial = 0; trial < 50; ++trial) {
      Eigen::Matrix2d z;
      z << entry(random), entry(random), entry(random), entry(random);
      z *= scale;
      const PhiFunctions<Eigen::Matrix2d> phi(z);
      EXPECT_LT((phi.phi0 - plainPhi(z, 0)).norm(), 1e-12 * (1.0 + plainPhi(z, 0).norm())) << scale;
      EXPECT_LT((phi.phi1 - plainPhi(z, 1)).norm(), 1e-12 * (1.0 + plainPhi(z, 1).norm())) << scale;
      EXPECT_LT((phi.phi2 - plainPhi(z, 2)).norm(), 1e-12 * (1.0 + plainPhi(z, 2).norm())) << scale;
    }
  }
}

TEST(PhiFunctions, OfNothingAreOneOneAndAHalf) {
  const PhiFunctions<Eigen::Matrix2d> phi(Eigen::Matrix2d::Zero());
  EXPECT_LT((phi.phi0 - Eigen::Matrix2d::Identity()).norm(), 1e-15);
  EXPECT_LT((phi.phi1 - Eigen::Matrix2d::Identity()).norm(), 1e-15);
  EXPECT_LT((phi.phi2 - 0.5 * Eigen::Matrix2d::Identity()).norm(), 1e-15);
}

// A damped oscillator over one step: phi0 is its exact free motion.
TEST(PhiFunctions, CarryAnOscillatorExactly) {
  const double w = 5800.0, damping = 0.03, h = 2e-4;
  Eigen::Matrix2d a;
  a << 0.0, 1.0, -w * w, -2.0 * damping * w;
  const PhiFunctions<Eigen::Matrix2d> phi(a * h);
  const double damped = w * std::sqrt(1.0 - damping * damping);
  const double q = std::exp(-damping * w * h) * (std::cos(damped * h) + damping * w / damped * std::sin(damped * h));
  EXPECT_NEAR(phi.phi0(0, 0), q, 1e-11);
}

}  // namespace
}  // namespace stillcut::milling
