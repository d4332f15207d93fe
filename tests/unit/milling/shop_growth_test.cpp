// Tools and engagements as shops have them: the limits of the exact method against the time domain, which knows
// nothing of multipliers. A small disturbance of the linear cut dies at 0.9 times the limit and grows at 1.1 times.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/milling/regenerative_cut.h"
#include "core/milling/simulation/noise.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::milling {
namespace {

double between(NoiseSource& random, double a, double b) {
  return a + (b - a) * random.uniform();
}

// Every third with an uneven pitch, every third with a helix for each tooth, every second with process damping.
CutModel randomTool(NoiseSource& random, int number) {
  CutModel m;
  const int modes = 1 + static_cast<int>(3.0 * random.uniform());
  for (int i = 0; i < modes; ++i) {
    const double angle = between(random, 0.0, kTwoPi);
    m.modes.push_back({Hertz(between(random, 400.0, 1000.0)),
                       between(random, 0.015, 0.05),
                       1e6 * std::pow(10.0, random.uniform()),
                       {std::cos(angle), std::sin(angle)}});
  }
  m.tool.teeth = 2 + static_cast<int>(4.0 * random.uniform());
  m.tool.diameter = Metres(between(random, 10e-3, 20e-3));
  m.tool.helix = between(random, 0.0, 0.8);
  const double even = kTwoPi / m.tool.teeth;
  for (int j = 0; number % 3 == 0 && j < m.tool.teeth; ++j) {
    const double shift = j % 2 == 0 ? 0.2 : -0.2;
    m.tool.pitch.push_back(even * (j + 1 == m.tool.teeth && m.tool.teeth % 2 == 1 ? 1.0 : 1.0 + shift));
  }
  for (int j = 0; number % 3 == 1 && j < m.tool.teeth; ++j) {
    m.tool.toothHelix.push_back(m.tool.helix + (j % 2 == 0 ? 0.03 : -0.03));
  }
  if (number % 2 == 1) m.material.processDamping = between(random, 1e4, 1e5);
  const double immersion = between(random, 0.05, 0.9);
  m.engagement = {immersion, MillingDirection::Up, between(random, immersion - 1.0, 1.0 - immersion)};
  return m;
}

// Growth of the linear cut in e-folds a revolution, over the second half of `revolutions`.
double growth(const CutModel& model, Rpm speed, double depth, int revolutions) {
  CutNumerics n;
  n.stepsPerRevolution = 240 * 8;
  n.slices = 20;
  n.deepest = Metres(depth);
  n.mayLeaveCut = false;
  RegenerativeCut cut(model, n);
  cut.setSpeed(speed.value * kTwoPi / 60.0);
  const AngularWindow window{model.engagement.startAngle(), model.engagement.exitAngle()};
  cut.setWindows({&window, 1});
  cut.setAxialDepth(depth);
  for (int i = 0; i < cut.modes(); ++i) cut.disturb(i, 1e-6 * (i + 1), 0.0);
  double grown = 0.0;
  for (int r = 0; r < revolutions; ++r) {
    double power = 0.0;
    for (int i = 0; i < 240; ++i) {
      cut.advance(8);
      for (int k = 0; k < cut.modes(); ++k) {
        power += model.modes[static_cast<std::size_t>(k)].stiffness * cut.displacement(k) * cut.displacement(k);
      }
    }
    const double size = std::sqrt(power / 240.0);
    if (r == revolutions / 2) grown = 0.0;
    grown += std::log(size);
    cut.scaleMotion(1.0 / size);
  }
  return grown / (revolutions - revolutions / 2);
}

TEST(ShopGrowth, RandomToolsChatterExactlyWhereTheLobesSay) {
  NoiseSource random(4711);
  int compared = 0, disagreeing = 0;
  for (int number = 0; compared < 18 && number < 60; ++number) {
    const CutModel model = randomTool(random, number);
    const Rpm speed(between(random, 4000.0, 12000.0));
    const auto lobes = ExactLobes::make(model, "random");
    ASSERT_TRUE(lobes.ok());
    const auto limits = lobes->limits(speed, {Metres(8e-3), false, false, {}});
    ASSERT_TRUE(limits.ok()) << limits.error().line();
    if (!limits->hasLimit()) continue;
    const StabilityLimit& first = limits->crossings.front();
    // An island thinner than the step above the limit says nothing at 1.1 times it.
    if (limits->outsideAt(1.1 * first.depth) == 0) continue;
    ++compared;
    for (double factor : {0.9, 1.1}) {
      const double rate = growth(model, speed, factor * first.depth.value, 300);
      if ((rate > 0.0) == (factor > 1.0)) continue;
      ++disagreeing;
      ADD_FAILURE() << "tool " << number << ": " << model.tool.teeth << " teeth at " << speed.value << " rpm, "
                    << factor << " times " << 1e3 * first.depth.value << " mm grows by " << rate << " a revolution";
    }
  }
  EXPECT_EQ(compared, 18);
  EXPECT_EQ(disagreeing, 0);
}

}  // namespace
}  // namespace stillcut::milling
