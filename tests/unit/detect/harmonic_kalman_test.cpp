// The kernel against the paper's own recursion (Caliskan 2018 eq. 17-20) with its full covariance.
#include "core/detect/turning_harmonics.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/base/units.h"
#include "core/detect/caliskan/full_harmonic_kalman.h"
#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {
namespace {

// Equation by equation, O(N^2) per sample. Phi is that of the step from the last frame to this one (turn()).
class Oracle {
 public:
  Oracle(int harmonics, double step, double lambda)
      : q_(Eigen::VectorXd::Zero(2 * harmonics)),
        p_(Eigen::MatrixXd::Identity(2 * harmonics, 2 * harmonics)),
        phi_(Eigen::MatrixXd::Zero(2 * harmonics, 2 * harmonics)),
        h_(Eigen::VectorXd::Zero(2 * harmonics)),
        lambda_(lambda) {
    for (int n = 0; n < harmonics; ++n) h_(2 * n) = 1.0;
    turn(step);
  }
  void turn(double step) {  // eq. 19
    for (int n = 0; 2 * n < phi_.rows(); ++n) {
      const double a = (n + 1) * step;
      phi_.block<2, 2>(2 * n, 2 * n) << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
    }
  }
  double process(double x) {
    q_ = phi_ * q_;
    if (started_) {  // P is that of the first frame before anything is known
      p_ = phi_ * p_ * phi_.transpose();
      p_.diagonal().array() += lambda_;  // R = 1: only the ratio matters
    }
    started_ = true;
    const Eigen::VectorXd k = p_ * h_ / (h_.dot(p_ * h_) + 1.0);
    q_ += k * (x - h_.dot(q_));
    p_ -= k * (h_.transpose() * p_);
    return x - h_.dot(q_);  // eq. 22
  }
  double power(int n) const { return q_.segment<2>(2 * (n - 1)).squaredNorm(); }

 private:
  Eigen::VectorXd q_;
  Eigen::MatrixXd p_, phi_;
  Eigen::VectorXd h_;
  double lambda_;
  bool started_ = false;
};

TEST(HarmonicKalman, GainAndLambdaAreInverse) {
  for (const double lambda : {1e-7, 1e-6, 1e-4}) {
    for (const int n : {1, 8, 32}) EXPECT_NEAR(lambdaForGain(harmonicGain(lambda, n), n) / lambda, 1.0, 1e-9);
  }
}

TEST(HarmonicKalman, AgreesWithTheFullCovarianceOnceThatHasSettled) {
  constexpr int kHarmonics = 8;
  const double step = kTwoPi * 100.0 / 10000.0;
  const double lambda = 1e-5;
  Oracle oracle(kHarmonics, step, lambda);
  RotatingHarmonicFilter kalman;
  kalman.prepare(1, kHarmonics, dsp::kernels::bestKernels());
  kalman.setGain(harmonicGain(lambda, kHarmonics));
  kalman.align(0.0, step);
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  double difference = 0.0;
  double reference = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double x =
        std::cos(step * k + 0.3) + 0.5 * std::sin(3.0 * step * k) + 0.4 * std::sin(0.21 * k) + 0.2 * normal(engine);
    double rest = 0.0;
    kalman.process(0, &x, &rest, 1, kalman.afterCorrection());
    kalman.advance(1);
    const double truth = oracle.process(x);
    if (k < 10000) continue;
    difference += (rest - truth) * (rest - truth);
    reference += truth * truth;
  }
  // The settled covariance is p I up to the coupling of neighbouring harmonics, of the order of the gain.
  EXPECT_LT(std::sqrt(difference / reference), 0.02);
  for (int n = 1; n <= kHarmonics; ++n) EXPECT_NEAR(kalman.power(0, n), oracle.power(n), 0.02) << n;
  EXPECT_NEAR(kalman.power(0, 1), 1.0, 0.05);
  EXPECT_NEAR(kalman.power(0, 3), 0.25, 0.03);
}

TEST(FullHarmonicKalman, IsThePapersRecursionThroughSpeedChanges) {
  for (const int harmonics : {5, 16, 27}) {
    const double lambda = 1e-5;
    const double rate = 10000.0;
    Oracle oracle(harmonics, 0.0, lambda);
    FullHarmonicKalman kalman;
    kalman.prepare(2, harmonics, dsp::kernels::bestKernels());
    kalman.setLambda(lambda);
    std::mt19937 engine(5);
    std::normal_distribution<double> normal;
    double angle = 0.3;
    for (int block = 0; block < 60; ++block) {
      // A step, then a ramp.
      const double spindle = block < 20 ? 100.0 : block < 40 ? 108.0 : 108.0 - 0.5 * (block - 40);
      const double step = kTwoPi * spindle / rate;
      constexpr int kFrames = 50;
      std::vector<double> x(2 * kFrames);
      std::vector<double> rest(2 * kFrames);
      for (int k = 0; k < kFrames; ++k) {
        const double theta = angle + step * k;
        x[static_cast<std::size_t>(k)] = std::cos(theta) + 0.5 * std::sin(3.0 * theta) + 0.2 * normal(engine);
        x[static_cast<std::size_t>(kFrames + k)] = normal(engine);
      }
      kalman.align(angle, step);
      kalman.process(x.data(), kFrames, rest.data(), kFrames, kFrames);
      for (int k = 0; k < kFrames; ++k) {
        ASSERT_NEAR(rest[static_cast<std::size_t>(k)], oracle.process(x[static_cast<std::size_t>(k)]), 1e-9)
            << harmonics << " harmonics, block " << block << " frame " << k;
        oracle.turn(step);
      }
      angle += step * kFrames;
    }
    // The states are for the frame to come; turning does not change their size.
    for (int n = 1; n <= harmonics; ++n) EXPECT_NEAR(kalman.power(0, n), oracle.power(n), 1e-9) << n;
    const std::vector<double> ones(dsp::kernels::wholeLanes(static_cast<std::size_t>(harmonics)), 1.0);
    double all = 0.0;
    for (int n = 1; n <= harmonics; ++n) all += oracle.power(n);
    EXPECT_NEAR(kalman.weightedPower(0, ones.data()), all, 1e-9);
  }
}

TEST(FullHarmonicKalman, ComesBackFromAnInfiniteValue) {
  FullHarmonicKalman kalman;
  kalman.prepare(1, 8, dsp::kernels::bestKernels());
  kalman.setLambda(1e-5);
  kalman.align(0.0, 0.05);
  double last = 1.0;
  for (int k = 0; k < 2000; ++k) {
    const double x = k == 100 ? std::numeric_limits<double>::infinity() : std::cos(0.05 * k);
    kalman.process(&x, 0, &last, 0, 1);
    ASSERT_TRUE(std::isfinite(last)) << k;
  }
  EXPECT_LT(std::abs(last), 1e-2);
}

TEST(HarmonicKalman, FollowsASpeedChangeWithoutLosingTheHarmonics) {
  RotatingHarmonicFilter kalman;
  kalman.prepare(1, 16, dsp::kernels::bestKernels());
  kalman.setGain(harmonicGain(1e-6, 16));
  double angle = 0.0;
  double worst = 0.0;
  for (int k = 0; k < 40000; ++k) {
    const double step = kTwoPi * (100.0 + (k > 20000 ? 5.0 * (k - 20000) / 20000.0 : 0.0)) / 10000.0;
    kalman.align(angle, step);
    const double x = std::cos(angle) + 0.5 * std::cos(2.0 * angle + 1.0);
    double rest = 0.0;
    kalman.process(0, &x, &rest, 1, kalman.afterCorrection());
    kalman.advance(1);
    if (k > 19000) worst = std::max(worst, std::abs(rest));
    angle += step;
  }
  EXPECT_LT(worst, 1e-3);
}

}  // namespace
}  // namespace stillcut::detect
