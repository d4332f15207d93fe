// Forced vibration and surface location error by lines against the time domain, step by step.
#include "core/milling/stability/forced_vibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/milling/regenerative_cut.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

constexpr double kFeed = 0.1e-3;

CutModel withEdges() {
  CutModel model = textbookHalf();
  model.material.tangentialEdge = 2e4;
  model.material.radialEdge = 1e4;
  model.tool.diameter = Metres(0.012);
  return model;
}

struct Simulated {
  double acceleration = 0.0;
  double atWall = 0.0;  // y of the tip when the straight edge of tooth 0 passes the wall at `wall` [m]
};

// A stable cut after 400 revolutions, over one more.
Simulated simulate(const CutModel& model, double rpm, double depth, double wall) {
  CutNumerics n;
  n.stepsPerRevolution = 8192;
  n.slices = 48;
  n.deepest = Metres(depth);
  RegenerativeCut cut(model, n);
  cut.setSpeed(rpm * kTwoPi / 60.0);
  cut.setFeed(kFeed * model.tool.teeth * rpm / 60.0);
  const AngularWindow window{model.engagement.startAngle(), model.engagement.exitAngle()};
  cut.setWindows({&window, 1});
  cut.setAxialDepth(depth);
  cut.advance(400 * n.stepsPerRevolution);
  Simulated s;
  for (int i = 0; i < n.stepsPerRevolution; ++i) {
    cut.advance(1);
    const auto a = cut.tipAcceleration();
    s.acceleration += (a[0] * a[0] + a[1] * a[1]) / n.stepsPerRevolution;
    if (cut.cell() == static_cast<int>(std::lround(wall / kTwoPi * n.stepsPerRevolution))) s.atWall = cut.tip()[1];
  }
  s.acceleration = std::sqrt(s.acceleration);
  return s;
}

TEST(ForcedVibration, EqualsTheSimulatedStableCut) {
  for (double helix : {0.0, 0.5}) {
    CutModel model = withEdges();
    model.tool.helix = helix;
    const double rpm = 14500.0, depth = 0.1e-3;
    const auto found = forcedVibration(model, Rpm(rpm), Metres(depth), Metres(kFeed));
    ASSERT_TRUE(found.has_value());
    const Simulated truth = simulate(model, rpm, depth, 0.0);
    EXPECT_NEAR(found->acceleration, truth.acceleration, 0.02 * truth.acceleration) << helix;
    ASSERT_TRUE(found->upWall.has_value());
    EXPECT_FALSE(found->downWall.has_value());
    // The lowest edge cuts its wall at 0: what is there lies between the extremes over the depth, and is one of them.
    EXPECT_GE(-truth.atWall, found->upWall->least.value - 0.03 * std::abs(truth.atWall)) << helix;
    EXPECT_LE(-truth.atWall, found->upWall->greatest.value + 0.03 * std::abs(truth.atWall)) << helix;
    if (helix == 0.0) {
      EXPECT_NEAR(found->upWall->least.value, -truth.atWall, 0.03 * std::abs(truth.atWall));
      EXPECT_EQ(found->upWall->least, found->upWall->greatest);
    }
  }
}

TEST(ForcedVibration, IsLoudestWhereAToothHarmonicMeetsTheMode) {
  const CutModel model = textbookHalf();
  const auto at = [&](double rpm) {
    return forcedVibration(model, Rpm(rpm), Metres(0.1e-3), Metres(kFeed))->displacement;
  };
  const double resonance = 60.0 * 922.0 / 2.0;
  EXPECT_GT(at(resonance), 5.0 * at(0.9 * resonance));
  EXPECT_GT(at(resonance / 2.0), 2.0 * at(0.9 * resonance / 2.0));
}

TEST(ForcedVibration, OfUnlikeTeethIsNotSaid) {
  CutModel uneven = textbookHalf(), thrown = textbookHalf();
  uneven.tool.pitch = {3.0, kTwoPi - 3.0};
  thrown.tool.runout = {Metres(5e-6), Metres(0.0)};
  for (const CutModel& model : {uneven, thrown}) {
    EXPECT_FALSE(forcedVibration(model, Rpm(9000), Metres(1e-4), Metres(kFeed)).has_value());
  }
}

}  // namespace
}  // namespace stillcut::milling
