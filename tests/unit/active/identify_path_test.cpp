#include "core/active/identify_path.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/active/stability_margin.h"
#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

const Hertz kRate(5000.0);
const std::vector<double> kForward{0.0, 0.5, 0.3, -0.1};
const std::vector<double> kBackward{1.2, -0.85};  // rings for a while: too long for a finite response of 35 taps

TEST(PathIdentifier, AgreesWithFeintuchsEquationsWrittenOut) {
  const auto y = whiteNoise(600, 1);
  const auto r = plainPath(kForward, kBackward, y);
  const std::size_t taps = 5;
  const double mu = 0.002;
  std::vector<double> a(taps, 0.0), b(taps, 0.0), predicted(y.size(), 0.0);
  for (std::size_t n = 0; n < y.size(); ++n) {
    for (std::size_t k = 0; k < taps; ++k) predicted[n] += a[k] * past(y, n, k + 1) + b[k] * past(predicted, n, k + 1);
    const double e = r[n] - predicted[n];
    for (std::size_t k = 0; k < taps; ++k) {
      a[k] += 2.0 * mu * e * past(y, n, k + 1);
      b[k] += 2.0 * mu * e * past(predicted, n, k + 1);
    }
  }
  PathIdentifier identifier;
  identifier.prepare({.forward = 5, .backward = 5, .step = mu});
  for (std::size_t n = 0; n < y.size(); ++n) {
    identifier.reading(r[n]);
    identifier.output(y[n]);
  }
  const PathModel model = identifier.model();
  for (std::size_t k = 0; k < taps; ++k) {
    EXPECT_NEAR(model.forward[k], a[k], 1e-11);
    EXPECT_NEAR(model.backward[k], b[k], 1e-11);
  }
}

// A converter that works by blocks is late by more than a segment of the spectra that the fit is judged by.
TEST(IdentifyPath, ALateLoopIsHeardAndPromisesAsMuch) {
  for (const std::size_t late : {80U, 600U}) {
    const auto y = whiteNoise(20000, 2);
    std::vector<double> delayed = kForward;
    delayed.insert(delayed.begin(), late, 0.0);
    const auto r = plainPath(delayed, kBackward, y);
    const auto found = identifyPath(y, r, kRate, {}, "test");
    ASSERT_TRUE(found.ok()) << found.error().line();
    const std::array<Hertz, 2> lines{Hertz(339.0), Hertz(1024.0)};
    const ActivePath margin = stabilityMarginOf(*found, lines, kRate);
    EXPECT_TRUE(margin.predictedStable) << late;
    EXPECT_GT(margin.phaseMargin, 1.2) << late;
    EXPECT_NEAR(margin.delay.value * kRate.value, static_cast<double>(late) + 2.0, 1.0);
    const PathModel truth{delayed, kBackward};
    const std::size_t k = found->report.frequency.size() / 4;
    const Hertz f(found->report.frequency[k]);
    EXPECT_LT(std::abs(found->report.measured[k] - truth.response(f, kRate)), 0.1 * std::abs(truth.response(f, kRate)));
  }
}

TEST(IdentifyPath, FindsARingingPathFromWhiteNoise) {
  const auto y = whiteNoise(20000, 2);
  auto r = plainPath(kForward, kBackward, y);
  const auto noise = whiteNoise(r.size(), 3, 0.02);
  for (std::size_t n = 0; n < r.size(); ++n) r[n] += noise[n];
  const auto found = identifyPath(y, r, kRate, {}, "test");
  ASSERT_TRUE(found.ok()) << found.error().line();
  EXPECT_LT(found->report.residual, 0.1);
  const PathModel truth{kForward, kBackward};
  for (double f : {200.0, 471.0, 700.0, 1024.0, 1800.0}) {
    EXPECT_LT(std::abs(phaseError(found->model, truth.response(Hertz(f), kRate), Hertz(f), kRate)), 0.15) << f;
    EXPECT_NEAR(std::abs(found->model.response(Hertz(f), kRate)) / std::abs(truth.response(Hertz(f), kRate)), 1.0, 0.1)
        << f;
  }
  EXPECT_GT(found->report.phaseMargin, 0.5 * std::numbers::pi - 0.4);
  ASSERT_FALSE(found->report.coherence.empty());
  for (double c : found->report.coherence) {
    EXPECT_GE(c, 0.0);
    EXPECT_LE(c, 1.0 + 1e-12);
  }
}

// A device that works by blocks: 35 taps could not even reach the first that is heard.
TEST(IdentifyPath, FindsTheDelayOfTheLoop) {
  const auto y = whiteNoise(20000, 11);
  for (int late : {0, 64, 700}) {
    std::vector<double> forward(static_cast<std::size_t>(late), 0.0);
    forward.insert(forward.end(), kForward.begin(), kForward.end());
    auto r = plainPath(forward, kBackward, y);
    const auto noise = whiteNoise(r.size(), 12, 0.05);
    for (std::size_t n = 0; n < r.size(); ++n) r[n] += noise[n];
    const auto found = identifyPath(y, r, kRate, {}, "late");
    ASSERT_TRUE(found.ok()) << found.error().line();
    EXPECT_LE(found->model.delay, late + 1);
    EXPECT_GE(found->model.delay, late - 1);
    EXPECT_LT(found->report.residual, 0.12) << late;
    EXPECT_EQ(leadingDelay(found->model), late + 2) << late;
  }
}

// A sweep through the actuator is as good.
TEST(IdentifyPath, FindsTheSamePathFromASweep) {
  std::vector<double> y(30000);
  for (std::size_t n = 0; n < y.size(); ++n) {
    const double share = static_cast<double>(n) / static_cast<double>(y.size());
    y[n] = std::sin(std::numbers::pi * 0.45 * share * static_cast<double>(n));
  }
  const auto found = identifyPath(y, plainPath(kForward, kBackward, y), kRate, {.sweep = true}, "sweep");
  ASSERT_TRUE(found.ok()) << found.error().line();
  const PathModel truth{kForward, kBackward};
  for (double f : {339.0, 471.0, 1024.0, 1800.0}) {
    EXPECT_LT(std::abs(phaseError(found->model, truth.response(Hertz(f), kRate), Hertz(f), kRate)), 0.15) << f;
  }
}

// Metres out, metres per second squared in: eight orders of magnitude between them.
TEST(IdentifyPath, UnitsDoNotMatter) {
  auto y = whiteNoise(20000, 2);
  auto r = plainPath(kForward, kBackward, y);
  const double plain = identifyPath(y, r, kRate, {}, "test")->report.residual;
  for (double& v : y) v *= 1e-7;
  for (double& v : r) v *= 50.0;
  const auto found = identifyPath(y, r, kRate, {}, "test");
  ASSERT_TRUE(found.ok()) << found.error().line();
  EXPECT_NEAR(found->report.residual, plain, 1e-3);
}

TEST(IdentifyPath, TheReportSeesAPhaseThatIsWrong) {
  const auto y = whiteNoise(20000, 4);
  const auto r = plainPath({0.0, 0.0, 0.0, 0.0, 1.0}, {}, y);
  PathRequest request;
  request.filter.forward = 5;
  request.filter.backward = 0;
  const auto found = identifyPath(y, r, kRate, request, "test");
  ASSERT_TRUE(found.ok());
  EXPECT_LT(found->report.worstPhase, 0.2);
  EXPECT_NEAR(found->report.phaseMargin, 0.5 * std::numbers::pi - found->report.worstPhase, 1e-12);
}

TEST(IdentifyPath, RefusesWhatTeachesNothing) {
  const auto y = whiteNoise(5000, 5);
  const std::vector<double> silence(5000, 0.0);
  auto broken = y;
  broken[100] = std::nan("");
  EXPECT_FALSE(identifyPath(y, silence, kRate, {}, "dead sensor").ok());
  EXPECT_FALSE(identifyPath(silence, y, kRate, {}, "no output").ok());
  EXPECT_FALSE(identifyPath(y, broken, kRate, {}, "not finite").ok());
  EXPECT_FALSE(identifyPath(y, whiteNoise(4000, 6), kRate, {}, "lengths").ok());
  EXPECT_FALSE(identifyPath(whiteNoise(100, 7), whiteNoise(100, 8), kRate, {}, "short").ok());
  EXPECT_FALSE(identifyPath(y, whiteNoise(5000, 9), kRate, {}, "unrelated").ok());
}

}  // namespace
}  // namespace stillcut::active
