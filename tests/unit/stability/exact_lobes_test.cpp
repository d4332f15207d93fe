#include "core/milling/stability/exact_lobes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/support/dominant_multiplier.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

SpeedLimits allLimits(const ExactLobes& lobes, double rpm, double maxAxialDepth) {
  LimitOptions options;
  options.maxAxialDepth = Metres(maxAxialDepth);
  return lobes.limits(Rpm(rpm), options).value();
}

// Golden numbers given with the reference cases.
TEST(ExactLobes, DominantMultiplierOfTheTextbookSlot) {
  const auto lobes = ExactLobes::make(textbookSlot(), "slot");
  const std::pair<double, double> golden[] = {
      {0.2e-3, 0.81974278}, {0.5e-3, 1.07397559}, {0.7e-3, 1.22155614}, {1.0e-3, 1.40647353}};
  for (const auto& [depth, size] : golden) {
    const auto mu = test::dominantMultiplier(*lobes, Rpm(5000), Metres(depth));
    ASSERT_TRUE(mu.ok());
    EXPECT_NEAR(std::abs(mu.value()), size, 1e-7) << depth;
  }
}

TEST(ExactLobes, WithoutDepthTheStructureDecays) {
  const auto lobes = ExactLobes::make(textbookSlot(), "slot");
  const auto mu = test::dominantMultiplier(*lobes, Rpm(5000), Metres(0.0));
  EXPECT_NEAR(std::abs(mu.value()), std::exp(-0.011 * kTwoPi * 922.0 * 0.006), 1e-12);
}

// A scan of 81 depths up to 4 mm steps over this island, which is 0.03 mm thin.
TEST(ExactLobes, ThinIslandAt5500IsNotSteppedOver) {
  const auto lobes = ExactLobes::make(textbookSlot(), "slot");
  const SpeedLimits limits = allLimits(*lobes, 5500, 4e-3);
  ASSERT_GE(limits.crossings.size(), 2u);
  EXPECT_NEAR(limits.crossings[0].depth.value, 2.764553945e-3, 1e-10);
  EXPECT_EQ(limits.crossings[0].kind, CrossingKind::Hopf);
  EXPECT_NEAR(limits.crossings[1].depth.value, 2.794894546e-3, 1e-10);
  EXPECT_EQ(limits.crossings[1].kind, CrossingKind::Flip);
  EXPECT_EQ(limits.crossings[1].before, 2);
  EXPECT_EQ(limits.crossings[1].after, 3);
}

TEST(ExactLobes, TheModulusIsOneAtEveryCrossingAndTheCountChangesThere) {
  const auto lobes = ExactLobes::make(textbookHalf(), "half");
  for (double rpm : {5500.0, 9000.0, 16000.0, 21000.0}) {
    const SpeedLimits limits = allLimits(*lobes, rpm, 2e-3);
    ASSERT_TRUE(limits.hasLimit()) << rpm;
    const Metres first = limits.crossings.front().depth;
    EXPECT_NEAR(std::abs(test::dominantMultiplier(*lobes, Rpm(rpm), first).value()), 1.0, 1e-7) << rpm;
    EXPECT_LT(std::abs(test::dominantMultiplier(*lobes, Rpm(rpm), 0.99 * first).value()), 1.0) << rpm;
    EXPECT_GT(std::abs(test::dominantMultiplier(*lobes, Rpm(rpm), 1.01 * first).value()), 1.0) << rpm;
  }
}

// Unstable between a floor and a roof, and stable again above: what the crossings say against the multiplier itself, on
// both sides of both, and the kind against where the multiplier sits.
void expectIsland(const ExactLobes& lobes, double rpm, const StabilityLimit& floor, const StabilityLimit& roof,
                  CrossingKind kind) {
  SCOPED_TRACE(rpm);
  ASSERT_EQ(floor.before, 0);
  ASSERT_EQ(roof.after, 0);
  EXPECT_EQ(floor.kind, kind);
  EXPECT_EQ(roof.kind, kind);
  const auto multiplier = [&](Metres depth) { return test::dominantMultiplier(lobes, Rpm(rpm), depth).value(); };
  EXPECT_LT(std::abs(multiplier(0.995 * floor.depth)), 1.0);
  EXPECT_LT(std::abs(multiplier(1.005 * roof.depth)), 1.0);
  const std::complex<double> inside = multiplier(0.5 * (floor.depth + roof.depth));
  EXPECT_GT(std::abs(inside), 1.0);
  if (kind == CrossingKind::Flip) {
    EXPECT_LT(inside.real(), -1.0);
    EXPECT_LT(std::abs(inside.imag()), 1e-6);
  } else {
    EXPECT_GT(std::abs(inside.imag()), 0.1);
  }
}

TEST(ExactLobes, FlipIslandsAtLowImmersionHaveAStableFloorAndRoof) {
  CutModel model = textbookSlot();
  model.engagement = {0.1, MillingDirection::Down};
  const auto lobes = ExactLobes::make(model, "down");
  int islands = 0;
  for (double rpm : {7500.0, 10600.0, 10700.0, 18000.0, 18200.0}) {
    const SpeedLimits limits = allLimits(*lobes, rpm, 4e-3);
    ASSERT_TRUE(limits.verified);
    ASSERT_GE(limits.crossings.size(), 2u) << rpm;
    expectIsland(*lobes, rpm, limits.crossings[0], limits.crossings[1], CrossingKind::Flip);
    ++islands;
    EXPECT_EQ(limits.crossings[0].after, 1);  // one multiplier leaves at -1
  }
  EXPECT_EQ(islands, 5);
}

TEST(ExactLobes, AHopfLensInTheSlotHasAStableFloorAndRoof) {
  const auto lobes = ExactLobes::make(textbookSlot(), "slot");
  for (double rpm : {18500.0, 18600.0, 18700.0}) {
    const SpeedLimits limits = allLimits(*lobes, rpm, 4e-3);
    ASSERT_TRUE(limits.verified);
    ASSERT_GE(limits.crossings.size(), 4u) << rpm;
    expectIsland(*lobes, rpm, limits.crossings[0], limits.crossings[1], CrossingKind::Hopf);
    EXPECT_EQ(limits.crossings[0].after, 2);  // a pair leaves
    EXPECT_TRUE(limits.stableAt(0.5 * (limits.crossings[1].depth + limits.crossings[2].depth)));
    EXPECT_FALSE(limits.stableAt(0.5 * (limits.crossings[0].depth + limits.crossings[1].depth)));
  }
}

// Every island of the shared case, and no other: their number comes from its two independent programs.
TEST(ExactLobes, EveryIslandOfTheLowImmersionCaseIsFound) {
  STILLCUT_NEEDS_REFERENCE();
  const ReferenceCase reference = loadReference("ins1dof_aD0.1_down");
  const auto lobes = ExactLobes::make(reference.model, "down");
  int islands = 0;
  for (const auto& [rpm, rows] : reference.rows) {
    const SpeedLimits limits = allLimits(*lobes, rpm, reference.maxAxialDepth);
    const auto closes = [](const auto& one) { return one.after == 0; };
    const auto known = std::count_if(rows.begin(), rows.end(), closes);
    EXPECT_EQ(std::count_if(limits.crossings.begin(), limits.crossings.end(), closes), known) << rpm;
    islands += static_cast<int>(known);
  }
  EXPECT_GE(islands, 7);
}

TEST(ExactLobes, FlipChatterSitsHalfwayBetweenToothHarmonics) {
  const auto lobes = ExactLobes::make(textbookSlot(), "slot");
  for (double rpm : {5300.0, 9300.0, 9500.0}) {
    for (const StabilityLimit& l : allLimits(*lobes, rpm, 4e-3).crossings) {
      if (l.kind != CrossingKind::Flip) continue;
      const double tooth = toothPassing(Rpm(rpm), 2).value;
      const double order = l.frequency.value / tooth;
      EXPECT_NEAR(order - std::floor(order), 0.5, 1e-9) << rpm;
      // So deep the cut stiffens the mode over one half of the pass and overcomes its stiffness over the other, where
      // the tool is driven off in one burst a tooth: half the tooth frequency itself may be the largest line.
      EXPECT_LT(l.frequency.value, 2.0 * 922.0) << rpm;
    }
  }
}

TEST(ExactLobes, HopfChatterIsHeardAboveTheModeAndMatchesTheMultipliersAngle) {
  const auto lobes = ExactLobes::make(textbookSlot(), "slot");
  for (double rpm : {5000.0, 5100.0, 5200.0}) {
    const SpeedLimits limits = allLimits(*lobes, rpm, 2e-3);
    ASSERT_TRUE(limits.hasLimit());
    const StabilityLimit& l = limits.crossings.front();
    ASSERT_EQ(l.kind, CrossingKind::Hopf);
    const double tooth = toothPassing(Rpm(rpm), 2).value;
    const double turns = l.frequency.value / tooth;
    const double angle = std::abs(std::remainder(turns * kTwoPi, kTwoPi));
    EXPECT_NEAR(angle, l.angle.value, 1e-6);
    EXPECT_NEAR(l.frequency.value, 922.0, 0.15 * 922.0) << rpm;
  }
}

// Depth and mode stiffness enter only as w K / k; a second mode that does not move leaves the first as it is.
TEST(ExactLobes, ScalesWithStiffnessAndIgnoresARigidSecondMode) {
  const auto soft = ExactLobes::make(textbookSlot(), "soft");
  CutModel stiff = textbookSlot();
  stiff.modes[0].stiffness *= 3.0;
  CutModel rigid = textbookSlot();
  rigid.modes.push_back({Hertz(700.0), 0.03, 1e14, {0.0, 1.0}});
  const auto scaled = ExactLobes::make(stiff, "stiff");
  const auto held = ExactLobes::make(rigid, "rigid");
  for (double rpm : {5000.0, 5100.0, 5200.0}) {
    const double depth = allLimits(*soft, rpm, 3e-3).crossings.at(0).depth.value;
    EXPECT_NEAR(allLimits(*scaled, rpm, 9e-3).crossings.at(0).depth.value / (3.0 * depth), 1.0, 1e-8);
    EXPECT_NEAR(allLimits(*held, rpm, 3e-3).crossings.at(0).depth.value / depth, 1.0, 1e-5);
  }
}

// Turning the structure, the coordinate frame only: a single mode in any direction uses the projected force.
TEST(ExactLobes, AModeSplitInTwoEqualHalvesIsTheSameMode) {
  CutModel whole = textbookSlot();
  whole.modes[0].direction = {0.8, 0.6};
  CutModel halves = whole;
  halves.modes[0].stiffness *= 2.0;
  halves.modes.push_back(halves.modes[0]);
  const auto one = ExactLobes::make(whole, "whole");
  const auto two = ExactLobes::make(halves, "halves");
  for (double rpm : {6000.0, 11000.0}) {
    const SpeedLimits a = allLimits(*one, rpm, 6e-3);
    const SpeedLimits b = allLimits(*two, rpm, 6e-3);
    ASSERT_TRUE(b.hasLimit());
    ASSERT_TRUE(a.hasLimit());
    EXPECT_NEAR(b.crossings[0].depth.value / a.crossings[0].depth.value, 1.0, 1e-7);
  }
}

TEST(ExactLobes, LowSpeedSearchesAsDeepAsDigitsAllowAndSaysSo) {
  const auto lobes = ExactLobes::make(textbookHalf(), "half");
  for (double rpm : {1000.0, 300.0}) {
    const SpeedLimits limits = allLimits(*lobes, rpm, 4e-3);
    ASSERT_TRUE(limits.hasLimit()) << rpm;
    EXPECT_GT(limits.searchedTo, limits.crossings.front().depth);
    EXPECT_EQ(limits.verified, limits.searchedTo.value == 4e-3);
    EXPECT_FALSE(limits.stableAt(Metres(4e-3)));
    EXPECT_GE(limits.crossings.back().after, 6);
  }
}

}  // namespace
}  // namespace stillcut::milling
