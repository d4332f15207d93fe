// The simulated turning cut against the lobes of the same cut, and the chip of an edge that stands.
#include <gtest/gtest.h>

#include <cmath>

#include "core/milling/simulation/scenario.h"
#include "core/milling/simulation/simulated_cut.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::milling {
namespace {

constexpr double kDegree = kTwoPi / 360.0;

Scenario bar(double rpm, double depth) {
  Scenario s;
  s.name = "bar";
  Mode tool;
  tool.frequency = Hertz(250.0);
  tool.damping = 0.02;
  tool.stiffness = 5e6;
  tool.direction = {0.3, 1.0};
  tool.directionZ = 0.3;
  Mode part;
  part.frequency = Hertz(180.0);
  part.damping = 0.03;
  part.stiffness = 9e6;
  part.direction = {0.0, 1.0};
  part.ofPart = true;
  s.model.modes = {tool, part};
  s.model.tool.teeth = 1;
  s.model.tool.diameter = Metres(0.060);
  s.model.material.tangential = 2.0e9;
  s.model.material.radial = 1.6e9;
  s.model.turning = Turning{75.0 * kDegree};
  s.programme.speed = Rpm(rpm);
  s.programme.feedPerTooth = Metres(2e-4);
  s.programme.duration = Seconds(8.0);  // it grows by one or two e-folds a second
  s.programme.depth = constantSchedule(depth);
  s.programme.randomForce = 0.02;
  s.drive.torqueLimit = 500.0;  // a lathe's
  s.drive.inertia = 0.5;
  s.rate = Hertz(5000.0);
  SensorSettings force;
  force.name = "force";
  force.quantity = SensorQuantity::Force;
  force.axis = "x";
  SensorSettings across = force;
  across.name = "across";
  across.axis = "y";
  s.sensors = {force, across};
  return s;
}

TEST(TurningCut, ChattersWhereTheLobesSay) {
  for (double rpm : {700.0, 1100.0, 1900.0}) {
    const auto lobes = ExactLobes::make(bar(rpm, 1e-3).model, "bar");
    ASSERT_TRUE(lobes.ok()) << lobes.error().line();
    LimitOptions options;
    options.maxAxialDepth = Metres(0.02);
    const auto limits = lobes->limits(Rpm(rpm), options);
    ASSERT_TRUE(limits.ok() && limits->hasLimit()) << rpm;
    const StabilityLimit& limit = limits->crossings.front();
    for (double factor : {0.8, 1.3}) {
      const Scenario s = bar(rpm, factor * limit.depth.value);
      ASSERT_TRUE(check(s, "bar").ok());
      SimulatedCut cut(s);
      SampleBlock block;
      block.allocate(2, s.blockFrames);
      while (cut.fill(block)) {
      }
      const bool chatters = cut.truth().kind() == ChatterKind::Hopf;
      EXPECT_EQ(chatters, factor > 1.0) << rpm << " rpm, " << factor << ", peak " << cut.truth().peakRatio();
      if (!chatters) continue;
      EXPECT_NEAR(cut.truth().chatterFrequency().value, limit.frequency.value, 6.0) << rpm;
    }
  }
}

// Area f a_p, force K_r A along the chip's thickness: sin and cos of the edge's angle along feed and depth.
TEST(TurningCut, TheSteadyForceIsThatOfTheChip) {
  Scenario s = bar(1100.0, 0.1e-3);
  s.programme.randomForce = 0.0;
  s.programme.duration = Seconds(1.5);
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(2, s.blockFrames);
  double along = 0.0, across = 0.0;
  while (cut.fill(block)) {
    along = block.channel(0)[0];
    across = block.channel(1)[0];
  }
  const double force = 1.6e9 * 2e-4 * 0.1e-3;
  EXPECT_NEAR(along, -force * std::sin(75.0 * kDegree), 0.01 * force);
  EXPECT_NEAR(across, -force * std::cos(75.0 * kDegree), 0.01 * force);
}

}  // namespace
}  // namespace stillcut::milling
