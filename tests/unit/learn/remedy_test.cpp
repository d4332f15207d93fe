// The remedy fits the kind of the chatter, and a speed variation that is offered quiets the cut in simulation.
#include "core/learn/remedy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/milling/stability/exact_lobes.h"

namespace stillcut::learn {
namespace {

using testing::HasSubstr;

// A slender mode in a light finishing cut: period doubling between the lobes.
milling::CutModel finishing() {
  milling::CutModel model;
  model.tool.teeth = 2;
  model.tool.diameter = Metres(0.012);
  model.material.tangential = 6e8;
  model.material.radial = 2e8;
  model.engagement = {0.05, milling::MillingDirection::Up, {}};
  milling::Mode m;
  m.frequency = Hertz(150.0);
  m.damping = 0.01;
  m.stiffness = 2e6;
  m.direction = {0.0, 1.0};
  model.modes = {m};
  return model;
}

// The speed with the shallowest limit of a kind, a tenth to a half beyond it.
struct Point {
  Rpm speed{};
  Metres depth{};
};
Point chattering(const milling::CutModel& model, milling::CrossingKind kind, double beyond) {
  const auto lobes = milling::ExactLobes::make(model, "test").value();
  Point best;
  for (double rpm = 2000.0; rpm < 10000.0; rpm += 100.0) {
    const auto limits = lobes.limits(Rpm(rpm), {Metres(0.02), true, false, {}});
    if (!limits || !limits->hasLimit() || limits->crossings.front().kind != kind) continue;
    const Metres depth = limits->crossings.front().depth;
    if (best.depth.value == 0.0 || depth < best.depth) best = {Rpm(rpm), depth};
  }
  best.depth = best.depth * beyond;
  return best;
}

TEST(SpeedVariation, ItsSimulationAgreesWithTheLobesAtAConstantSpeed) {
  const milling::CutModel model = finishing();
  const Point point = chattering(model, milling::CrossingKind::Flip, 1.0);
  ASSERT_GT(point.depth.value, 0.0);
  EXPECT_GT(tryVariation(model, point.speed, point.depth * 1.1, {}).growth, 0.0);
  EXPECT_LT(tryVariation(model, point.speed, point.depth * 0.9, {}).growth, 0.0);
}

TEST(SpeedVariation, QuietsAPeriodDoublingWithinTheLimitsOfTheSpindle) {
  const milling::CutModel model = finishing();
  const Point point = chattering(model, milling::CrossingKind::Flip, 1.15);
  ASSERT_GT(point.depth.value, 0.0);
  VariationLimits limits;
  const auto helps = helpfulVariation(model, point.speed, point.depth, limits);
  ASSERT_TRUE(helps);
  EXPECT_LE(helps->amplitude.value, 0.2 + 1e-9);
  EXPECT_LE(kTwoPi * helps->amplitude.value * point.speed.value / helps->period.value, limits.acceleration * 1.001);
  EXPECT_GT(tryVariation(model, point.speed, point.depth, {}).growth, 0.0);
  EXPECT_LT(tryVariation(model, point.speed, point.depth, *helps).growth, 0.0);
  limits.lowest = limits.highest = Ratio(1.0);
  EXPECT_FALSE(helpfulVariation(model, point.speed, point.depth, limits));
}

TEST(Remedy, FollowsTheKind) {
  RemedyRequest request;
  request.speed = Rpm(8500.0);
  request.teeth = 2;
  request.frequency = Hertz(850.0);
  request.quietSpeed = Rpm(7900.0);
  request.kind = ChatterKind::Hopf;
  const std::string hopf = text(remedyFor(request).words);
  EXPECT_THAT(hopf, HasSubstr("7900"));
  EXPECT_THAT(hopf, HasSubstr("pitch"));
  request.kind = ChatterKind::Forced;
  EXPECT_THAT(text(remedyFor(request).words), HasSubstr("7650"));  // its third harmonic a tenth below the resonance
  request.wasQuietBefore = true;
  EXPECT_THAT(text(remedyFor(request).words), HasSubstr("worn"));
}

TEST(Remedy, RemembersWhatWasTriedOnThisTool) {
  std::vector<CutEvidence> cuts(3);
  cuts[0].speed = Rpm(8500.0);
  cuts[0].depth = Metres(2e-3);
  cuts[0].outcome = CutOutcome::Chatter;
  cuts[1].speed = Rpm(7900.0);
  cuts[1].depth = Metres(2e-3);
  cuts[2].speed = Rpm(8400.0);  // quiet, and far too shallow to say anything
  cuts[2].depth = Metres(0.2e-3);
  EXPECT_EQ(text(remembered(cuts, Rpm(8500.0), Metres(2e-3))),
            "this tool chattered at 8500 rpm; it was quiet at 7900 rpm");
  EXPECT_TRUE(remembered({}, Rpm(8500.0), Metres(2e-3)).empty());
}

}  // namespace
}  // namespace stillcut::learn
