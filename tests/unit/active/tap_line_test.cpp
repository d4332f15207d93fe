#include "core/active/tap_line.h"

#include <gtest/gtest.h>

#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

TEST(TapLine, HoldsTheNewestValuesFirstHoweverLongItRuns) {
  for (std::size_t taps : {1U, 7U, 8U, 35U}) {
    TapLine line;
    line.prepare(taps);
    const auto x = whiteNoise(1000, 1);
    for (std::size_t n = 0; n < x.size(); ++n) {
      line.push(x[n]);
      for (std::size_t k = 0; k < line.size(); ++k) ASSERT_EQ(line.data()[k], past(x, n, k)) << taps << " " << n;
    }
    line.reset();
    for (std::size_t k = 0; k < line.size(); ++k) EXPECT_EQ(line.data()[k], 0.0);
  }
}

TEST(TapLine, SumsAreSums) {
  const auto a = whiteNoise(40, 2);
  const auto b = whiteNoise(40, 3);
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  EXPECT_NEAR(dot(a.data(), b.data(), a.size()), sum, 1e-13);
  std::vector<double> c = a;
  steer(c.data(), 0.9, 0.1, b.data(), c.size());
  for (std::size_t k = 0; k < c.size(); ++k) EXPECT_DOUBLE_EQ(c[k], 0.9 * a[k] + 0.1 * b[k]);
}

}  // namespace
}  // namespace stillcut::active
