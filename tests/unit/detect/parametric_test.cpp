// The parametric detector's recursions against van Dijk 2010 written out plainly, equation by equation.
#include <Eigen/Dense>
#include <complex>
#include <random>

#include "core/detect/van_dijk/parametric.h"
#include "core/dsp/kernels/choose.h"
#include "core/dsp/line_phase.h"
#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

// A signal and the integrated spindle angle that belongs to it, the speed stepping and ramping on the way.
struct Turning {
  std::vector<double> x, angle, step;
};

Turning turning(int frames, double rate, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  Turning t;
  double angle = 1.0;
  for (int k = 0; k < frames; ++k) {
    double spindle = 100.0;
    if (k > frames / 3) spindle = 108.0;                                               // a step
    if (k > 2 * frames / 3) spindle = 108.0 - 20.0 * (k - 2.0 * frames / 3) / frames;  // a ramp
    const double step = kTwoPi * spindle / rate;
    double x = 0.1 * normal(engine);
    for (int l = 1; l <= 12; ++l) x += std::cos(l * angle + l) / l;
    t.x.push_back(x);
    t.angle.push_back(angle);
    t.step.push_back(step);
    angle += step;
    if (angle > kTwoPi) angle -= kTwoPi;
  }
  return t;
}

// eq. 19 with phi = [cos(l angle), sin(l angle)], nothing rotated, nothing shared.
std::vector<double> plainNlms(const Turning& t, int harmonics, double mu, double lambda) {
  Eigen::VectorXd theta = Eigen::VectorXd::Zero(2 * harmonics);
  Eigen::VectorXd phi(2 * harmonics);
  std::vector<double> residual;
  for (std::size_t k = 0; k < t.x.size(); ++k) {
    for (int l = 1; l <= harmonics; ++l) {
      phi(2 * l - 2) = std::cos(l * t.angle[k]);
      phi(2 * l - 1) = std::sin(l * t.angle[k]);
    }
    const double e = t.x[k] - phi.dot(theta);
    theta = (lambda * theta + 2.0 * mu * e / phi.squaredNorm() * phi).eval();
    residual.push_back(e);
  }
  return residual;
}

TEST(Parametric, NlmsAgreesWithEquation19ThroughSpeedChanges) {
  constexpr int kHarmonics = 20;  // not whole lanes
  const Turning t = turning(20000, 10000.0, 3);
  const std::vector<double> plain = plainNlms(t, kHarmonics, 0.1, 0.9999);
  ParametricRecursions recursions;
  recursions.prepare(1, kHarmonics, {}, dsp::kernels::bestKernels());
  recursions.tune(kHarmonics, 0.1, 0.9999);
  ArCoefficients sum{};
  for (std::size_t k = 0; k < t.x.size();) {
    std::size_t n = 1;  // frames of one turn per frame, at most a block
    while (n < 256 && k + n < t.x.size() && t.step[k + n] == t.step[k]) ++n;
    recursions.align(t.angle[k], t.step[k]);
    std::vector<double> rest(n);
    recursions.process(0, t.x.data() + k, rest.data(), n, 1.0, sum);
    recursions.advance(n);
    // 256 turns and 20 products leave a few hundred roundings of 1e-16.
    for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(rest[i], plain[k + i], 1e-10) << k + i;
    k += n;
  }
}

TEST(Parametric, NlmsLeavesTheLeaksShareOfAHarmonic) {
  // (1 - lambda) L / mu of the amplitude stays: methods.md's 6 % at L = 60 with the paper's mu and lambda.
  constexpr double kStep = kTwoPi * 70.0 / 10000.0;
  ParametricRecursions recursions;
  recursions.prepare(1, 60, {}, dsp::kernels::bestKernels());
  recursions.tune(60, 0.5, 0.9995);
  recursions.align(0.0, kStep);
  ArCoefficients sum{};
  double last = 0.0;
  for (int k = 0; k < 10000; ++k) {
    const double x = std::cos(7.0 * kStep * k);
    double e = 0.0;
    recursions.process(0, &x, &e, 1, 0.0, sum);
    if (k >= 9000) last = std::max(last, std::abs(e));
  }
  EXPECT_NEAR(last, 0.0005 * 60 / 0.5, 0.01);
}

// eq. 25 a to e with matrices.
TEST(Parametric, KalmanAgreesWithEquation25) {
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  constexpr double kRv = 3e-5;
  constexpr double kRw = 8e-4;
  ParametricRecursions recursions;
  recursions.prepare(1, 8, {kRv, kRw, 1.0}, dsp::kernels::bestKernels());
  recursions.tune(8, 0.0, 1.0);  // nothing is taken out
  ArCoefficients sum{};
  Eigen::Vector4d theta = Eigen::Vector4d::Zero();
  Eigen::Vector4d past = Eigen::Vector4d::Zero();
  Eigen::Matrix4d p = Eigen::Matrix4d::Identity();
  double x1 = 0.0;
  double x2 = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double size = k < 10000 ? 0.1 : 1.0;  // ten times louder on the way
    const double x = 1.8 * x1 - 0.97 * x2 + 0.1 * size * normal(engine);
    x2 = x1;
    x1 = x;
    const Eigen::Vector4d t = p * past;
    const double s = past.dot(t) + kRw;
    const Eigen::Vector4d gain = t / s;
    theta += gain * (x - past.dot(theta));
    p += kRv * Eigen::Matrix4d::Identity() - gain * s * gain.transpose();
    past = Eigen::Vector4d(x, past(0), past(1), past(2));
    double rest = 0.0;
    recursions.process(0, &x, &rest, 1, 1.0, sum);
    for (std::size_t n = 0; n < 4; ++n) ASSERT_NEAR(recursions.theta(0)[n], theta(static_cast<int>(n)), 1e-7) << k;
  }
}

TEST(Parametric, ComesBackFromAnInfiniteValue) {
  ParametricRecursions recursions;
  recursions.prepare(1, 8, {3e-5, 8e-4, 1.0}, dsp::kernels::bestKernels());
  recursions.tune(8, 0.1, 1.0);
  recursions.align(0.0, 0.1);
  ArCoefficients sum{};
  for (int k = 0; k < 200; ++k) {
    const double x = k == 50 ? std::numeric_limits<double>::infinity() : std::sin(0.3 * k);
    double rest = 1.0;
    recursions.process(0, &x, &rest, 1, 1.0, sum);
    EXPECT_TRUE(std::isfinite(rest));
  }
  for (const double t : recursions.theta(0)) EXPECT_TRUE(std::isfinite(t));
  for (const double t : sum) EXPECT_TRUE(std::isfinite(t));
  EXPECT_NE(recursions.theta(0)[0], 0.0);
}

TEST(Parametric, RootsAreTheEigenvaluesOfTheCompanionMatrix) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> size(0.3, 1.1);
  std::uniform_real_distribution<double> angle(0.05, 3.0);
  for (int trial = 0; trial < 200; ++trial) {
    const std::complex<double> a = std::polar(size(engine), angle(engine));
    const std::complex<double> b = std::polar(size(engine), angle(engine));
    const ArCoefficients theta = thetaOf({a, std::conj(a), b, std::conj(b)});
    Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
    for (int n = 0; n < 4; ++n) companion(0, n) = theta[static_cast<std::size_t>(n)];
    for (int n = 1; n < 4; ++n) companion(n, n - 1) = 1.0;
    const Eigen::Vector4cd expected = companion.eigenvalues();
    for (const auto& root : rootsOf(theta)) {
      double nearest = 1.0;
      for (int n = 0; n < 4; ++n) nearest = std::min(nearest, std::abs(expected(n) - root));
      EXPECT_LT(nearest, 1e-6);
    }
    const double largest = std::max(std::abs(a), std::abs(b));
    EXPECT_NEAR(std::abs(dominantRoot(rootsOf(theta))), largest, 1e-6);
  }
}

TEST(Parametric, UnstableMeansARootOutsideTheUnitCircle) {
  std::mt19937 engine(17);
  std::uniform_real_distribution<double> size(0.3, 1.3);
  std::uniform_real_distribution<double> angle(0.0, 3.1);
  int out = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const std::complex<double> a = std::polar(size(engine), angle(engine));
    const std::complex<double> b = std::polar(size(engine), angle(engine));
    const bool expected = std::abs(a) > 1.0 || std::abs(b) > 1.0;
    EXPECT_EQ(unstable(thetaOf({a, std::conj(a), b, std::conj(b)})), expected) << std::abs(a) << " " << std::abs(b);
    out += expected ? 1 : 0;
  }
  EXPECT_GT(out, 50);
  EXPECT_LT(out, 350);
}

TEST(LinePhase, FindsALineAmongItsSideLinesAndNoneInNoise) {
  constexpr double kLineRate = 10000.0;
  constexpr double kSpindle = 105.0;
  constexpr double kLine = 806.0;
  const auto kernels = dsp::kernels::bestKernels();
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  std::vector<double> line(static_cast<std::size_t>(3.2 * kLineRate / kSpindle));
  std::vector<double> noise(line.size());
  for (std::size_t k = 0; k < line.size(); ++k) {
    const double t = kTwoPi * static_cast<double>(k) / kLineRate;
    line[k] = std::sin(kLine * t) + 0.2 * normal(engine);
    for (const int order : {-6, -3, -1, 1, 3, 6}) line[k] += 0.3 * std::sin((kLine + order * kSpindle) * t + order);
    noise[k] = normal(engine);
  }
  for (const double rough : {kLine - 40.0, kLine, kLine + 40.0}) {
    const Hertz found = linePhaseFrequency(line, Hertz(rough), Hertz(kSpindle), Hertz(kLineRate), kernels);
    EXPECT_NEAR(found.value, kLine, 0.002 * kLine) << rough;
  }
  int none = 0;
  for (double rough = 400.0; rough < 4000.0; rough += 100.0) {
    const Hertz found = linePhaseFrequency(noise, Hertz(rough), Hertz(kSpindle), Hertz(kLineRate), kernels);
    none += found.value > 0.0 ? 0 : 1;
  }
  EXPECT_GE(none, 30);
  EXPECT_EQ(
      linePhaseFrequency(std::span(line).first(200), Hertz(kLine), Hertz(kSpindle), Hertz(kLineRate), kernels).value,
      0.0);
}

TEST(Parametric, UnstableRootsAreReflectedAndTheirFrequencyKept) {
  const std::complex<double> a = std::polar(1.2, 0.9);
  const std::complex<double> b = std::polar(0.5, 2.0);
  ArRoots roots = rootsOf(thetaOf({a, std::conj(a), b, std::conj(b)}));
  EXPECT_TRUE(reflect(roots, 0.001));
  const std::complex<double> dominant = dominantRoot(roots);
  EXPECT_NEAR(std::abs(dominant), 0.999, 1e-9);
  EXPECT_NEAR(rootFrequency(dominant, Hertz(10000.0)).value, 10000.0 * 0.9 / kTwoPi, 1e-6);
  EXPECT_FALSE(reflect(roots, 0.001));
  // eq. 26 at that frequency: near the pole 1/|D| is about 1 / (0.001 times the distances to the other roots).
  const ArCoefficients theta = thetaOf(roots);
  std::complex<double> product = 1.0;
  for (const auto& root : roots) product *= 1.0 - root * std::polar(1.0, -0.9);
  EXPECT_NEAR(modelDensity(theta, Hertz(10000.0 * 0.9 / kTwoPi), Hertz(10000.0)) * std::norm(product), 1.0, 1e-6);
}

TEST(Parametric, ReportsAllThreeCriteriaOfASimulatedChatter) {
  CutSignal s;
  s.growthStart = 1.5;
  s.seconds = 2.2;
  RunOptions options;
  options.teeth = s.teeth;
  options.rpm = 60.0 * s.spindle * 1.01;
  const RunResult r = run(makeCut(s), options, "parametric");
  EXPECT_GT(r.firstAlarm, s.growthStart);
  EXPECT_LT(r.firstAlarm, s.growthStart + 0.15);
  const Verdict& calm = r.at(1.4);
  const Verdict& late = r.at(2.1);
  EXPECT_GT(late.indicators[0], 10.0 * calm.indicators[0]);  // variance
  EXPECT_GT(late.indicators[1], 10.0 * calm.indicators[1]);  // H
  EXPECT_GT(late.indicators[2], calm.indicators[2]);         // |alpha|
  // Four coefficients in noise: within 2 %.
  EXPECT_NEAR(late.indicators[3], s.chatterHertz, 0.02 * s.chatterHertz);
  EXPECT_EQ(late.state, CutState::Chatter);
  EXPECT_EQ(late.kind, ChatterKind::Hopf);
}

}  // namespace
}  // namespace stillcut::detect::testing
