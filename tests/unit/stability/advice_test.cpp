#include "core/milling/stability/advice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/dominant_multiplier.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

AdviceRequest requestAt(double depth, double from, double to) {
  AdviceRequest request;
  request.depth = Metres(depth);
  request.lowest = Rpm(from);
  request.highest = Rpm(to);
  request.feedPerTooth = Metres(0.1e-3);
  return request;
}

bool stable(const ExactLobes& lobes, Rpm speed, Metres depth) {
  return std::abs(test::dominantMultiplier(lobes, speed, depth).value()) < 1.0;
}

TEST(SpeedAdvice, PocketsAreStableInsideAndEndAtChatter) {
  const CutModel model = textbookHalf();
  const auto lobes = ExactLobes::make(model, "half");
  const auto advice = adviseSpeeds(model, requestAt(0.4e-3, 5000, 20000), "half");
  ASSERT_TRUE(advice.ok());
  ASSERT_TRUE(advice->finished);
  ASSERT_GE(advice->pockets.size(), 2u);
  EXPECT_FALSE(advice->deepest.has_value());
  for (const SpeedPocket& p : advice->pockets) {
    EXPECT_TRUE(stable(*lobes, p.best, Metres(0.4e-3))) << p.best.value;
    EXPECT_LE(p.from.speed, p.best);
    EXPECT_GE(p.to.speed, p.best);
    EXPECT_NEAR(p.margin, p.limit.value / 0.4e-3 - 1.0, 1e-12);
    EXPECT_GT(p.margin, 0.0);
    if (p.to.speed.value < 19999.0) {
      EXPECT_TRUE(stable(*lobes, 0.9999 * p.to.speed, Metres(0.4e-3))) << p.to.speed.value;
      EXPECT_FALSE(stable(*lobes, 1.0001 * p.to.speed, Metres(0.4e-3))) << p.to.speed.value;
      EXPECT_GT(p.to.frequency.value, 0.0);
    }
    // depth x width x feed: 0.4 mm x 5 mm x 0.1 mm x 2 teeth x rev/s
    EXPECT_NEAR(p.removal, 0.4e-3 * 5e-3 * 0.2e-3 * p.best.value / 60.0, 1e-15);
  }
}

// The same draws as the band of the limit: a pocket ends where the band's low end meets the depth.
TEST(SpeedAdvice, WithDoubtKeepsClearOfTheBand) {
  AdviceRequest request = requestAt(0.4e-3, 12000, 20000);
  request.spread = {0.01, 0.1, 0.1, 0.1};
  const auto sure = adviseSpeeds(textbookHalf(), requestAt(0.4e-3, 12000, 20000), "half");
  const auto doubtful = adviseSpeeds(textbookHalf(), request, "half");
  ASSERT_TRUE(sure.ok() && doubtful.ok());
  ASSERT_TRUE(doubtful->finished);
  ASSERT_FALSE(doubtful->pockets.empty());
  const auto width = [](const SpeedAdvice& advice) {
    Rpm sum{};
    for (const SpeedPocket& p : advice.pockets) sum = sum + (p.to.speed - p.from.speed);
    return sum.value;
  };
  EXPECT_LT(width(*doubtful), 0.95 * width(*sure));
  const auto lowAt = [&](Rpm speed) {
    const auto bands = limitBands(textbookHalf(), std::vector<Rpm>{speed}, Metres(1.6e-3), request.spread, 1, "half");
    return bands->speeds.front().low.value;
  };
  int edges = 0;
  for (const SpeedPocket& p : doubtful->pockets) {
    EXPECT_NEAR(lowAt(p.best), p.limit.value, 1e-5 * p.limit.value) << p.best.value;
    EXPECT_GT(p.expected, p.open ? 0.999 * p.limit : 1.02 * p.limit) << p.best.value;
    for (const auto& [edge, away] : {std::pair{p.from, 0.999}, std::pair{p.to, 1.001}}) {
      if (!(edge.frequency.value > 0.0)) continue;
      ++edges;
      EXPECT_GT(lowAt(edge.speed), 0.4e-3) << edge.speed.value;
      EXPECT_LT(lowAt(away * edge.speed), 0.4e-3) << edge.speed.value;
    }
  }
  EXPECT_GT(edges, 0);
  request.spread.force = 0.9;
  EXPECT_FALSE(adviseSpeeds(textbookHalf(), request, "half").ok());
}

TEST(SpeedAdvice, TheBestSpeedKeepsAwayFromTheEdgesOfItsPocket) {
  for (const double depth : {0.2e-3, 0.4e-3, 0.7e-3, 1.0e-3, 1.3e-3}) {
    const auto advice = adviseSpeeds(textbookHalf(), requestAt(depth, 5000, 20000), "half");
    ASSERT_TRUE(advice.ok());
    for (const SpeedPocket& p : advice->pockets) {
      const Rpm quarter = 0.25 * (p.to.speed - p.from.speed);
      if (p.from.frequency.value > 0.0) {
        EXPECT_GE(p.best - p.from.speed, 0.999 * std::min(0.01 * p.from.speed, quarter))
            << depth << " " << p.best.value;
      }
      if (p.to.frequency.value > 0.0) {
        EXPECT_GE(p.to.speed - p.best, 0.999 * std::min(0.01 * p.to.speed, quarter)) << depth << " " << p.best.value;
      }
      EXPECT_EQ(p.open, p.limit.value >= 3.9999 * depth);
    }
  }
}

TEST(SpeedAdvice, WhereNothingIsStableTheDeepestCutIsTold) {
  const CutModel model = textbookHalf();
  const auto advice = adviseSpeeds(model, requestAt(1e-3, 5000, 5600), "half");
  ASSERT_TRUE(advice.ok());
  EXPECT_TRUE(advice->pockets.empty());
  ASSERT_TRUE(advice->deepest.has_value());
  EXPECT_LT(advice->deepest->depth.value, 1e-3);
  const auto lobes = ExactLobes::make(model, "half");
  EXPECT_TRUE(stable(*lobes, advice->deepest->speed, 0.999 * advice->deepest->depth));
  EXPECT_FALSE(stable(*lobes, advice->deepest->speed, 1.001 * advice->deepest->depth));
}

TEST(SpeedAdvice, TheToolsCuttingSpeedCapsTheRange) {
  AdviceRequest request = requestAt(0.2e-3, 5000, 20000);
  request.cuttingSpeed = 300.0;  // m/min on 10 mm
  const auto advice = adviseSpeeds(textbookHalf(), request, "half");
  ASSERT_TRUE(advice.ok());
  EXPECT_TRUE(advice->cappedByTool);
  EXPECT_NEAR(advice->highest.value, 300.0 / (3.14159265358979 * 0.01), 1e-6);
  for (const SpeedPocket& p : advice->pockets) EXPECT_LE(p.to.speed, advice->highest);
  request.cuttingSpeed = 10.0;
  EXPECT_FALSE(adviseSpeeds(textbookHalf(), request, "half").ok());
}

TEST(SpeedAdvice, BadRequestsAreRefused) {
  EXPECT_FALSE(adviseSpeeds(textbookHalf(), requestAt(0.0, 5000, 20000), "x").ok());
  EXPECT_FALSE(adviseSpeeds(textbookHalf(), requestAt(1e-3, 9000, 8000), "x").ok());
  EXPECT_FALSE(adviseSpeeds(textbookHalf(), requestAt(1e-3, 0, 8000), "x").ok());
  CutModel broken = textbookHalf();
  broken.modes.clear();
  EXPECT_FALSE(adviseSpeeds(broken, requestAt(1e-3, 5000, 8000), "x").ok());
}

}  // namespace
}  // namespace stillcut::milling
