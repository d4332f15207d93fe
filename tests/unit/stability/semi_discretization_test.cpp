#include "core/milling/stability/semi_discretization.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

// |mu| = 1.40647353 is the exact multiplier of this cut.
TEST(SemiDiscretization, BothOrdersConvergeToTheExactMultiplier) {
  const Rpm speed(5000);
  const Metres depth(1e-3);
  for (int order : {0, 1}) {
    const auto error = [&](int k) {
      return std::abs(SemiDiscretization::make(textbookSlot(), {k, order}, "slot")->largestMultiplier(speed, depth) -
                      1.40647353);
    };
    const double e80 = error(80);
    const double e160 = error(160);
    const double e320 = error(320);
    EXPECT_LT(e160, 0.3 * e80) << order;  // second order in the cell
    EXPECT_LT(e320, 0.3 * e160) << order;
    EXPECT_LT(e320, 3e-3) << order;
  }
}

TEST(SemiDiscretization, TheLimitIsWhereTheLargestMultiplierIsOne) {
  const auto sdm = SemiDiscretization::make(textbookHalf(), {40, 1}, "half");
  for (double rpm : {6000.0, 12000.0}) {
    const auto limit = sdm->limit(Rpm(rpm), Metres(4e-3));
    ASSERT_TRUE(limit->hasLimit());
    EXPECT_NEAR(sdm->largestMultiplier(Rpm(rpm), limit->crossings.front().depth), 1.0, 1e-7) << rpm;
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
