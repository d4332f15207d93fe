// Tools with a shape. The numbers of the independent program are a first-order semi-discretization written for this
// test alone (numpy; force summed over some hundred discs, 60 to 120 cells a tooth period): it shares no formula with
// the harmonics used here but the force law of a disc.
#include "core/milling/stability/any_tool/shaped_teeth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/milling/stability/any_tool/edge_pieces.h"
#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/semi_discretization.h"
#include "core/milling/stability/zeroth_order.h"

namespace stillcut::milling {
namespace {

constexpr double kPi = std::numbers::pi;

CutModel roundTool(double cornerMm, double startDegrees, double exitDegrees, double helixDegrees) {
  CutModel model;
  model.modes = {{Hertz(900.0), 0.03, 1.5e6, {1.0, 0.0}}, {Hertz(980.0), 0.025, 2e6, {0.0, 1.0}}};
  model.tool.teeth = 2;
  model.tool.diameter = Metres(0.010);
  model.tool.helix = helixDegrees * kPi / 180.0;
  model.tool.cornerRadius = Metres(1e-3 * cornerMm);
  model.material.tangential = 8e8;
  model.material.radial = 3e8;
  model.engagement = engagementBetween(startDegrees * kPi / 180.0, exitDegrees * kPi / 180.0);
  return model;
}

double limitMm(const CutModel& model, double rpm, double deepestMm = 6.0) {
  const auto lobes = ExactLobes::make(model, "tool");
  if (!lobes) return -1.0;
  LimitOptions options;
  options.maxAxialDepth = Metres(1e-3 * deepestMm);
  options.frequencies = false;
  const auto limits = lobes->limits(Rpm(rpm), options);
  if (!limits || !limits->hasLimit()) return -1.0;
  return 1e3 * limits->crossings.front().depth.value;
}

TEST(ShapedTeeth, RoundEndsAgreeWithAnIndependentProgram) {
  const CutModel ball = roundTool(5.0, 90.0, 180.0, 0.0), slot = roundTool(5.0, 0.0, 180.0, 30.0);
  const CutModel bull = roundTool(2.0, 0.0, 60.0, 0.0);
  CutModel threeAxes = ball;
  Mode slanted{Hertz(700.0), 0.03, 1.5e7, {0.3, 0.5}};
  slanted.directionZ = 0.8;
  threeAxes.modes.insert(threeAxes.modes.begin() + 1, slanted);
  const struct {
    const char* name;
    const CutModel& model;
    double rpm, mm;
  } known[] = {
      {"ball at the side", ball, 9000, 1.3681},
      {"ball at the side", ball, 13000, 1.4154},
      {"ball at the side", ball, 17500, 1.2385},
      {"ball in a slot, helix", slot, 9000, 0.32039},
      {"ball in a slot, helix", slot, 13000, 0.32654},
      {"ball in a slot, helix", slot, 17500, 0.21952},
      {"bull", bull, 9000, 1.2951},
      {"bull", bull, 13000, 1.3312},
      {"bull", bull, 17500, 0.68397},
      {"three axes", threeAxes, 9000, 1.1112},
      {"three axes", threeAxes, 13000, 1.4608},
      {"three axes", threeAxes, 17500, 1.1821},
  };
  for (const auto& k : known) EXPECT_NEAR(limitMm(k.model, k.rpm), k.mm, 0.006 * k.mm) << k.name << " at " << k.rpm;
}

TEST(ShapedTeeth, ACornerWithoutRadiusIsASquareEnd) {
  for (double helix : {0.0, 35.0}) {
    const CutModel square = roundTool(0.0, 60.0, 180.0, helix), sharp = roundTool(1e-5, 60.0, 180.0, helix);
    for (double rpm : {7000.0, 9500.0, 14000.0}) {
      const double mm = limitMm(square, rpm);
      ASSERT_GT(mm, 0.0);
      EXPECT_NEAR(limitMm(sharp, rpm), mm, 2e-4 * mm) << rpm << " rpm, helix " << helix;
    }
  }
}

// The share of the pieces is the depth's, their angles those of the work's edges at their radius.
TEST(ShapedTeeth, PiecesCoverTheDepthThatIsReached) {
  const CutModel slot = roundTool(5.0, 0.0, 180.0, 0.0);
  double share = 0.0;
  for (const EdgePiece& p : edgePieces(slot, toothPattern(slot.tool), 7e-3, 10)) {
    share += p.share;
    EXPECT_NEAR(p.to - p.from, kPi, 1e-6);
  }
  EXPECT_NEAR(share, 1.0, 1e-9);
  // A quarter of the diameter wide at the side: the ball's radius must reach 2.5 mm, at 5 - sqrt(25 - 6.25) mm.
  CutModel side = roundTool(5.0, 0.0, 60.0, 0.0);
  share = 0.0;
  for (const EdgePiece& p : edgePieces(side, toothPattern(side.tool), 2e-3, 10)) share += p.share;
  EXPECT_NEAR(share, 1.0 - (5.0 - std::sqrt(25.0 - 6.25)) / 2.0, 1e-9);
}

CutModel serrated(double amplitudeMm, double feedMm) {
  CutModel model = roundTool(0.0, 90.0, 180.0, 0.0);
  Serration waves;
  waves.amplitude = Metres(1e-3 * amplitudeMm);
  waves.length = Metres(1e-3);
  waves.feedPerTooth = Metres(1e-3 * feedMm);
  model.tool.serration = waves;
  return model;
}

TEST(ShapedTeeth, SerratedTeethAgreeWithAnIndependentProgram) {
  CutModel two = serrated(0.05, 0.06), three = serrated(0.04, 0.04);
  three.tool.teeth = 3;
  three.tool.helix = kPi / 6.0;
  // Its cells go over a whole revolution, for no two teeth are alike.
  EXPECT_NEAR(limitMm(two, 9000.0, 3.0), 2.142, 0.02 * 2.1);
  EXPECT_NEAR(limitMm(two, 13000.0, 3.0), 2.233, 0.01 * 2.2);
  EXPECT_NEAR(limitMm(two, 17500.0, 3.0), 2.501, 0.01 * 2.5);
  EXPECT_NEAR(limitMm(three, 9000.0, 3.0), 1.872, 0.01 * 1.9);
  EXPECT_NEAR(limitMm(three, 13000.0, 3.0), 1.688, 0.01 * 1.7);
}

// Steps of depth are no proof that nothing lies between them.
TEST(ShapedTeeth, WhatIsSearchedInStepsIsNotCalledVerified) {
  LimitOptions options;
  options.maxAxialDepth = Metres(3e-3);
  const auto lobes = ExactLobes::make(serrated(0.05, 0.06), "serrated");
  ASSERT_TRUE(lobes.ok());
  const auto limits = lobes->limits(Rpm(13000.0), options);
  ASSERT_TRUE(limits.ok());
  EXPECT_TRUE(limits->hasLimit());
  EXPECT_FALSE(limits->verified);
}

TEST(ShapedTeeth, WavesFarLowerThanTheChipDoNothing) {
  CutModel plain = serrated(1e-6, 0.1);
  plain.tool.serration.reset();
  for (double rpm : {7000.0, 11000.0}) {
    const double mm = limitMm(plain, rpm);
    ASSERT_GT(mm, 0.0);
    EXPECT_NEAR(limitMm(serrated(1e-6, 0.1), rpm), mm, 5e-3 * mm) << rpm;
  }
}

// Two teeth whose waves are far higher than the chip: at every height one of them cuts, once a revolution.
TEST(ShapedTeeth, WavesFarHigherThanTheChipLeaveOneToothAtEveryHeight) {
  const CutModel model = serrated(0.5, 0.01);
  double share = 0.0, once = 0.0;
  for (const EdgePiece& p : edgePieces(model, toothPattern(model.tool), 3e-3, 10)) {
    const double part = p.share * (p.to - p.from) / (0.5 * kPi);
    share += part;
    if (std::abs(p.delay - 2.0 * kPi) < 1e-9) once += part;
  }
  EXPECT_NEAR(share, 1.0, 0.03);
  EXPECT_GT(once, 0.97 * share);
}

TEST(ShapedTeeth, WhatCannotBeAnsweredIsSaid) {
  const auto line = [](const auto& result) { return result.ok() ? std::string() : result.error().line(); };
  const CutModel ball = roundTool(5.0, 90.0, 180.0, 0.0);
  EXPECT_NE(line(ZerothOrder::make(ball, "x")).find("corner radius"), std::string::npos);
  EXPECT_NE(line(SemiDiscretization::make(ball, {}, "x")).find("corner radius"), std::string::npos);
  EXPECT_NE(line(ExactLobes::make(serrated(0.2, 0.0), "x")).find("feed"), std::string::npos);
  EXPECT_FALSE(ExactLobes::make(roundTool(5.1, 90.0, 180.0, 0.0), "x").ok());
  const auto lobes = ExactLobes::make(ball, "x");
  ASSERT_TRUE(lobes.ok());
  EXPECT_GT(lobes->lowestSpeed().value, 0.0);
  EXPECT_FALSE(lobes->limits(0.9 * lobes->lowestSpeed(), {}).ok());
}

}  // namespace
}  // namespace stillcut::milling
