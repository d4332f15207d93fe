// One cut out of a band of limits.
#include "core/milling/stability/advice/recommended_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stillcut::milling {
namespace {

constexpr Metres kDeepest{10e-3};

// A pocket around `middle` in a floor of 1 mm, every 100 rev/min.
std::vector<LimitBand> pocket(double middle, double half, double low) {
  std::vector<LimitBand> all;
  for (double speed = 4000.0; speed <= 16000.0; speed += 100.0) {
    const double depth = std::abs(speed - middle) <= half ? low : 1e-3;
    all.push_back({Rpm(speed), Metres(depth), Metres(1.5 * depth)});
  }
  return all;
}

TEST(RecommendedCut, LiesInsideAPocketAndNotAtItsEdge) {
  const auto cut = recommendCut(pocket(12000.0, 600.0, 3e-3), kDeepest);
  ASSERT_TRUE(cut);
  EXPECT_GT(cut->speed.value, 11400.0);
  EXPECT_LE(cut->speed.value * 1.015, 12600.0) << "the speed may be off by 1.5 %";
  EXPECT_NEAR(cut->depth.value, 0.9 * 3e-3, 1e-9) << "a tenth is taken off";
  EXPECT_NEAR(cut->anySpeed.value, 0.9 * 1e-3, 1e-9);
  EXPECT_FALSE(cut->open);
}

TEST(RecommendedCut, APocketTooNarrowForTheSpindleIsNone) {
  const auto cut = recommendCut(pocket(12000.0, 100.0, 3e-3), kDeepest);
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->depth.value, 0.9 * 1e-3, 1e-9);
  EXPECT_DOUBLE_EQ(cut->speed.value, 16000.0) << "at the same depth the faster one removes more";
}

TEST(RecommendedCut, ADeepPocketAtAThirdOfTheSpeedRemovesLess) {
  std::vector<LimitBand> both = pocket(5000.0, 500.0, 4e-3);
  const std::vector<LimitBand> fast = pocket(14000.0, 800.0, 2e-3);
  for (std::size_t i = 0; i < both.size(); ++i) both[i].low = std::max(both[i].low, fast[i].low);
  const auto cut = recommendCut(both, kDeepest);
  ASSERT_TRUE(cut);
  EXPECT_GT(cut->speed.value, 13000.0);
}

TEST(RecommendedCut, WhereNothingLimitsTheToolDoesAndNoMarginIsTaken) {
  const std::vector<LimitBand> all{{Rpm(5000.0), kDeepest, kDeepest}, {Rpm(9000.0), kDeepest, kDeepest}};
  const auto cut = recommendCut(all, kDeepest);
  ASSERT_TRUE(cut);
  EXPECT_TRUE(cut->open);
  EXPECT_EQ(cut->depth, kDeepest);
  EXPECT_EQ(cut->speed, Rpm(9000.0));
  EXPECT_FALSE(recommendCut({}, kDeepest));
}

}  // namespace
}  // namespace stillcut::milling
