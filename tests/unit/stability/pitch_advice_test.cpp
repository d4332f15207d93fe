// Pitch advice: what is advised is deeper than even teeth at the speed, as the exact lobes say.
#include "core/milling/stability/advice/pitch_advice.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/milling/stability/exact_lobes.h"

namespace stillcut::milling {
namespace {

CutModel cut(int teeth) {
  CutModel m;
  m.modes = {{Hertz(560.0), 0.035, 1.2e7, {1.0, 0.0}}, {Hertz(600.0), 0.035, 1.1e7, {0.0, 1.0}}};
  m.tool.teeth = teeth;
  m.tool.diameter = Metres(19e-3);
  m.engagement = {0.5, MillingDirection::Up};
  return m;
}

TEST(PitchAdvice, IsDeeperThanEvenTeethWhereThoseAreAtTheirWorst) {
  for (int teeth : {3, 4}) {
    const CutModel model = cut(teeth);
    const Rpm speed(60.0 * 640.0 / (1.5 * teeth));  // a wave and a half between two teeth
    const auto advice = advisePitch(model, speed, Metres(2e-3), "test");
    ASSERT_TRUE(advice.ok()) << advice.error().line();
    EXPECT_GT(advice->best.limit.value, 1.3 * advice->even.limit.value) << teeth;
    ASSERT_EQ(advice->best.pitch.size(), static_cast<std::size_t>(teeth));
    EXPECT_NEAR(std::accumulate(advice->best.pitch.begin(), advice->best.pitch.end(), 0.0), kTwoPi, 1e-9);
    CutModel ground = model;
    ground.tool.pitch = advice->best.pitch;
    const auto lobes = ExactLobes::make(ground, "test");
    ASSERT_TRUE(lobes.ok());
    const auto limits = lobes->limits(speed, {Metres(6e-3), true, false, {}});
    const double there = limits->hasLimit() ? limits->crossings.front().depth.value : 6e-3;
    EXPECT_GE(there, advice->best.limit.value * (1.0 - 1e-6));
  }
}

TEST(PitchAdvice, OneToothHasNone) {
  EXPECT_FALSE(advisePitch(cut(1), Rpm(6000), Metres(1e-3), "test").ok());
}

}  // namespace
}  // namespace stillcut::milling
