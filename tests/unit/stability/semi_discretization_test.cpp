#include "core/milling/stability/semi_discretization.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

TEST(SemiDiscretization, BothOrdersConvergeToTheExactLimit) {
  const Rpm speed(5000);
  const Metres deepest(2e-3);
  const auto exact = ExactLobes::make(textbookSlot(), "slot")->limits(speed, {.maxAxialDepth = deepest});
  ASSERT_TRUE(exact->hasLimit());
  const Metres depth = exact->crossings.front().depth;
  for (int order : {0, 1}) {
    const auto error = [&](int k) {
      const auto sdm = SemiDiscretization::make(textbookSlot(), {k, order}, "slot")->limit(speed, deepest);
      EXPECT_TRUE(sdm->hasLimit());
      return sdm->hasLimit() ? std::abs(sdm->crossings.front().depth / depth - 1.0) : 1.0;
    };
    const double e80 = error(80);
    const double e160 = error(160);
    const double e320 = error(320);
    EXPECT_LT(e160, 0.3 * e80) << order;  // second order in the cell
    EXPECT_LT(e320, 0.3 * e160) << order;
    EXPECT_LT(e320, 3e-3) << order;
  }
}

TEST(SemiDiscretization, TheLimitIsWhereAMultiplierLeaves) {
  const auto sdm = SemiDiscretization::make(textbookHalf(), {40, 1}, "half");
  for (double rpm : {6000.0, 12000.0}) {
    const auto limit = sdm->limit(Rpm(rpm), Metres(4e-3));
    ASSERT_TRUE(limit->hasLimit());
    const Metres depth = limit->crossings.front().depth;
    EXPECT_EQ(sdm->outside(Rpm(rpm), (1.0 - 1e-7) * depth).value_or(-1), 0) << rpm;
    EXPECT_EQ(sdm->outside(Rpm(rpm), (1.0 + 1e-7) * depth).value_or(-1), limit->crossings.front().after) << rpm;
    EXPECT_GT(limit->crossings.front().frequency.value, 600.0);
    EXPECT_LT(limit->crossings.front().frequency.value, 1300.0);
  }
}

TEST(SemiDiscretization, AnyNumberOfCellsWorks) {
  for (int k : {1, 2, 3, 7, 41}) {
    const auto sdm = SemiDiscretization::make(textbookSlot(), {k, 1}, "slot");
    ASSERT_TRUE(sdm.ok());
    EXPECT_EQ(sdm->outside(Rpm(20000), Metres(1e-6)).value_or(-1), 0) << k;
  }
}

}  // namespace
}  // namespace stillcut::milling
