#include "core/active/path_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/active/path_filter.h"
#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

const PathModel kPath{{0.0, 0.5, 0.3, -0.1}, {1.2, -0.72}};  // poles at 0.6 +- 0.6i

TEST(PathFilter, AgreesWithTheEquationWrittenOut) {
  const auto y = whiteNoise(400, 1);
  const auto plain = plainPath(kPath.forward, kPath.backward, y);
  PathFilter filter;
  filter.prepare(kPath);
  for (std::size_t n = 0; n < y.size(); ++n) {
    EXPECT_NEAR(filter.arrive(), plain[n], 1e-12);
    filter.push(y[n]);
  }
}

TEST(PathModel, ResponseIsTheTransformOfTheImpulse) {
  const auto impulse = kPath.impulse(400);
  for (double f : {50.0, 471.0, 1800.0}) {
    std::complex<double> sum = 0.0;
    for (std::size_t n = 0; n < impulse.size(); ++n) {
      sum += impulse[n] * std::polar(1.0, -2.0 * std::numbers::pi * f / 5000.0 * static_cast<double>(n + 1));
    }
    EXPECT_LT(std::abs(kPath.response(Hertz(f), Hertz(5000.0)) - sum), 1e-9);
  }
}

TEST(PathModel, PolesAreFound) {
  EXPECT_NEAR(kPath.largestPole(), std::hypot(0.6, 0.6), 1e-12);
  EXPECT_EQ(PathModel({{1.0}, {}}).largestPole(), 0.0);
}

TEST(PathModel, UselessModelsAreRefused) {
  EXPECT_TRUE(checkPath(kPath, "x").ok());
  EXPECT_FALSE(checkPath({}, "x").ok());
  EXPECT_FALSE(checkPath({{0.0, 0.0}, {}}, "x").ok());
  EXPECT_FALSE(checkPath({{1.0, std::nan("")}, {}}, "x").ok());
  EXPECT_FALSE(checkPath({{1.0}, {1.01}}, "x").ok());
  EXPECT_FALSE(checkPath({{1.0}, {HUGE_VAL}}, "x").ok());
  EXPECT_FALSE(checkPath({std::vector<double>(600, 0.1), {}}, "x").ok());
}

}  // namespace
}  // namespace stillcut::active
