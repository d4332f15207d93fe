// Random structures and engagements: two methods that share nothing but the force model must agree.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/semi_discretization.h"

namespace stillcut::milling {
namespace {

CutModel randomCut(std::mt19937& random, int modes) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  CutModel model;
  for (int i = 0; i < modes; ++i) {
    const double angle = between(0.0, kTwoPi);
    model.modes.push_back(
        {Hertz(between(300.0, 1500.0)), between(0.01, 0.05), between(5e6, 4e7), {std::cos(angle), std::sin(angle)}});
  }
  model.tool.teeth = static_cast<int>(between(1.0, 5.99));
  model.material.tangential = between(5e8, 2e9);
  model.material.radial = between(0.1, 0.7) * model.material.tangential;
  model.engagement = {between(0.05, 1.0), between(0.0, 1.0) < 0.5 ? MillingDirection::Up : MillingDirection::Down};
  return model;
}

class RandomCuts : public testing::TestWithParam<int> {};

TEST_P(RandomCuts, FineSemiDiscretizationCountsTheSameMultipliersBetweenTheExactLimits) {
  std::mt19937 random(977u + static_cast<unsigned>(GetParam()));
  int compared = 0;
  for (int n = 0; n < (GetParam() > 2 ? 6 : 16); ++n) {
    const CutModel model = randomCut(random, GetParam());
    const double rpm = std::uniform_real_distribution<double>(4000.0, 20000.0)(random);
    const auto lobes = ExactLobes::make(model, "random");
    LimitOptions options;
    options.maxAxialDepth = Metres(25e-3);
    options.frequencies = false;
    const auto limits = lobes->limits(Rpm(rpm), options);
    ASSERT_TRUE(limits.ok());
    EXPECT_EQ(limits->verified, limits->searchedTo == options.maxAxialDepth);
    const auto sdm = SemiDiscretization::make(model, {300, 1}, "random");
    double below = 0.0;
    for (const StabilityLimit& l : limits->crossings) {
      // In the middle between two limits that lie clearly apart.
      if (l.depth.value - below > 0.02 * l.depth.value) {
        EXPECT_EQ(sdm->outside(Rpm(rpm), Metres(0.5 * (below + l.depth.value))).value_or(-1), l.before)
            << "cut " << n << " depth " << l.depth.value;
        ++compared;
      }
      below = l.depth.value;
    }
  }
  EXPECT_GT(compared, 5);
}

// The first-order scheme converges with 1/k^2 to the exact limit.
TEST_P(RandomCuts, SemiDiscretizationConvergesToTheExactLimit) {
  std::mt19937 random(31u + static_cast<unsigned>(GetParam()));
  int compared = 0;
  for (int n = 0; n < (GetParam() > 2 ? 2 : 10); ++n) {
    const CutModel model = randomCut(random, GetParam());
    const Rpm speed(std::uniform_real_distribution<double>(5000.0, 15000.0)(random));
    const auto exact = ExactLobes::make(model, "random")->limits(speed, {Metres(30e-3), true, false, {}});
    if (!exact->hasLimit()) continue;
    const double w = exact->crossings.front().depth.value;
    const auto errorWith = [&](int cells) {
      const auto sdm = SemiDiscretization::make(model, {cells, 1}, "random");
      const auto limit = sdm->limit(speed, Metres(1.2 * w), 12);
      return limit->hasLimit() ? std::abs(limit->crossings.front().depth.value / w - 1.0) : 1.0;
    };
    const double coarse = errorWith(150);
    const double fine = errorWith(450);
    EXPECT_LT(fine, 5e-3) << n;
    EXPECT_LT(fine, 0.25 * coarse + 1e-6) << n;
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

INSTANTIATE_TEST_SUITE_P(Modes, RandomCuts, testing::Values(1, 2, 3, 5));

}  // namespace
}  // namespace stillcut::milling
