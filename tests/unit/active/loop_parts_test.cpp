// The parts of the actuator loop by themselves: the weighting's peaks, the path as filter, impulse and response, and
// its identification.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

#include "core/active/error_weighting.h"
#include "core/active/path_identifier.h"
#include "core/active/path_model.h"
#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

constexpr Hertz kRate{8000.0};

double gainAt(const Emphasis& emphasis, Hertz f) {
  ErrorWeighting weighting;
  weighting.prepare(emphasis, kRate);
  std::complex<double> sum = 0.0;
  for (int n = 0; n < 40000; ++n) {
    sum += weighting.process(n == 0 ? 1.0 : 0.0) * std::polar(1.0, -kTwoPi * f.value / kRate.value * n);
  }
  return std::abs(sum);
}

TEST(ErrorWeighting, HasItsGainAtEveryLineAndNoneFarAway) {
  const Emphasis emphasis{{Hertz(400.0), Hertz(1500.0)}, 20.0, Hertz(20.0)};
  EXPECT_NEAR(gainAt(emphasis, Hertz(400.0)), 20.0, 0.1);
  EXPECT_NEAR(gainAt(emphasis, Hertz(1500.0)), 20.0, 0.1);
  for (double f : {20.0, 900.0, 3000.0, 3900.0}) EXPECT_NEAR(gainAt(emphasis, Hertz(f)), 1.0, 0.05) << f;
}

// The geometric mean of line and background half a width away; near half the rate the bilinear transform narrows it.
TEST(ErrorWeighting, IsAsWideAsItIsAskedToBe) {
  for (double gain : {4.0, 25.0}) {
    const Emphasis emphasis{{Hertz(200.0)}, gain, Hertz(10.0)};
    for (double side : {-5.0, 5.0}) {
      EXPECT_NEAR(gainAt(emphasis, Hertz(200.0 + side)), std::sqrt(gain), 0.04 * std::sqrt(gain)) << gain << side;
    }
  }
}

// Of noise through a resonance of that width the loop foresees 80 % of the amplitude over its delay, and no line
// becomes wider than it was asked to be.
TEST(ErrorWeighting, IsNoWiderThanTheLoopForesees) {
  const Emphasis asked{{Hertz(1000.0)}, 20.0, Hertz(40.0)};
  EXPECT_EQ(foreseen(asked, Seconds(0.0)).width.value, 40.0);
  EXPECT_EQ(foreseen(asked, Seconds(0.4e-3)).width.value, 40.0);
  const Seconds block(32.0 / 5000.0);
  const Emphasis narrow = foreseen(asked, block);
  EXPECT_LT(narrow.width.value, 40.0);
  EXPECT_NEAR(std::exp(-0.5 * kTwoPi * narrow.width.value * block.value), 0.8, 1e-12);
  EXPECT_EQ(narrow.gain, asked.gain);
  EXPECT_EQ(narrow.lines, asked.lines);
}

TEST(ErrorWeighting, WithoutLinesOrWithLinesThatCannotBeItChangesNothing) {
  for (const Emphasis& none : {Emphasis{}, Emphasis{{Hertz(0.0), Hertz(4000.0), Hertz(1e6), Hertz(-3.0)}}}) {
    ErrorWeighting weighting;
    weighting.prepare(none, kRate);
    for (double x : whiteNoise(100, 1)) EXPECT_EQ(weighting.process(x), x);
  }
}

TEST(ErrorWeighting, ResetForgetsWhatRang) {
  ErrorWeighting weighting;
  weighting.prepare({{Hertz(500.0)}, 20.0, Hertz(5.0)}, kRate);
  for (double x : whiteNoise(1000, 2)) weighting.process(x);
  weighting.reset();
  for (int n = 0; n < 100; ++n) EXPECT_EQ(weighting.process(0.0), 0.0);
}

const PathModel kPath{{0.0, 0.5, -0.2, 0.1}, {1.2, -0.6}};

TEST(PathModel, ImpulseIsTheEquationWrittenOut) {
  std::vector<double> unit(60, 0.0);
  unit[0] = 1.0;
  const std::vector<double> plain = plainPath(kPath.forward, kPath.backward, unit);
  const std::vector<double> impulse = kPath.impulse(59);
  for (std::size_t n = 0; n < impulse.size(); ++n) EXPECT_NEAR(impulse[n], plain[n + 1], 1e-14) << n;
}

TEST(PathModel, ResponseIsTheImpulsesTransform) {
  const std::vector<double> impulse = kPath.impulse(2000);
  for (double f : {0.0, 10.0, 333.0, 1234.5, 3999.0}) {
    std::complex<double> sum = 0.0;
    for (std::size_t n = 0; n < impulse.size(); ++n) {
      sum += impulse[n] * std::polar(1.0, -kTwoPi * f / kRate.value * static_cast<double>(n + 1));
    }
    EXPECT_NEAR(std::abs(kPath.response(Hertz(f), kRate) - sum), 0.0, 1e-12) << f;
  }
}

// z^2 = 2 r cos(a) z - r^2 has its roots at r e^(+-ja).
TEST(PathModel, TheLargestPoleIsWhereItWasPut) {
  for (double r : {0.1, 0.7, 0.99, 1.01, 1.5}) {
    for (double a : {0.3, 1.0, 2.5}) {
      const PathModel model{{1.0}, {2.0 * r * std::cos(a), -r * r}};
      EXPECT_NEAR(model.largestPole(), r, 1e-9);
      EXPECT_EQ(checkPath(model, "path").ok(), r < 1.0) << r;
    }
  }
  EXPECT_EQ(PathModel({{1.0}, {}}).largestPole(), 0.0);
}

TEST(PathModel, WhatNoControllerCanUseIsRefusedInOneLine) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<PathModel, const char*> bad[] = {{{{}, {}}, "no model"},
                                                   {{std::vector<double>(1000, 0.1), {}}, "more than"},
                                                   {{{0.1}, std::vector<double>(1000, 0.0)}, "more than"},
                                                   {{{nan}, {}}, "not finite"},
                                                   {{{0.1}, {nan}}, "not finite"},
                                                   {{{0.0, 0.0}, {0.5}}, "does nothing"},
                                                   {{{0.1}, {1.0}}, "unstable"}};
  for (const auto& [model, what] : bad) {
    const Status status = checkPath(model, "x.toml: path");
    ASSERT_FALSE(status.ok()) << what;
    EXPECT_EQ(status.error().line().rfind("x.toml: path: ", 0), 0u);
    EXPECT_NE(status.error().line().find(what), std::string::npos) << status.error().line();
  }
}

TEST(PathModel, PhaseErrorIsTheAngleBetweenModelAndMeasurement) {
  for (double angle : {-2.0, -0.5, 0.0, 1.0, 3.0}) {
    const Hertz f(500.0);
    const std::complex<double> measured = 3.0 * kPath.response(f, kRate) * std::polar(1.0, -angle);
    EXPECT_NEAR(phaseError(kPath, measured, f, kRate), angle, 1e-12);
  }
}

// Noise goes out, the path answers: the model learns the response, finite or recursive.
TEST(PathIdentifier, FindsAFinitePath) {
  const std::vector<double> path{0.0, 0.6, -0.3, 0.15};
  PathIdentifier identifier;
  identifier.prepare({.forward = 8, .backward = 0, .step = 0.3, .normalised = true});
  const std::vector<double> y = whiteNoise(20000, 3);
  const std::vector<double> r = plainPath(path, {}, y);
  double last = 1.0;
  for (std::size_t n = 0; n < y.size(); ++n) {
    last = identifier.reading(r[n]);
    identifier.output(y[n]);
  }
  EXPECT_NEAR(last, 0.0, 1e-9);
  const PathModel model = identifier.model();
  ASSERT_EQ(model.forward.size(), 8U);
  EXPECT_TRUE(model.backward.empty());
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(model.forward[k], k < path.size() ? path[k] : 0.0, 1e-9) << k;
}

TEST(PathIdentifier, ARecursivePathIsFoundByItsResponse) {
  PathIdentifier identifier;
  identifier.prepare({.forward = 4, .backward = 2, .step = 0.05, .normalised = true});
  const std::vector<double> y = whiteNoise(400000, 4);
  const std::vector<double> r = plainPath(kPath.forward, kPath.backward, y);
  for (std::size_t n = 0; n < y.size(); ++n) {
    identifier.reading(r[n]);
    identifier.output(y[n]);
  }
  const PathModel model = identifier.model();
  for (double f : {100.0, 800.0, 1500.0, 3000.0}) {
    const std::complex<double> truth = kPath.response(Hertz(f), kRate);
    EXPECT_LT(std::abs(model.response(Hertz(f), kRate) - truth), 0.05 * std::abs(truth)) << f;
  }
}

TEST(PathIdentifier, PreparedAnewItForgetsEverything) {
  PathIdentifier identifier;
  const IdentifierOptions options{.forward = 4, .backward = 2, .step = 0.05, .normalised = true};
  identifier.prepare(options);
  for (double v : whiteNoise(500, 5)) {
    identifier.reading(v);
    identifier.output(v);
  }
  identifier.prepare(options);
  for (double c : identifier.model().forward) EXPECT_EQ(c, 0.0);
  EXPECT_EQ(identifier.reading(0.7), 0.7);
}

}  // namespace
}  // namespace stillcut::active
