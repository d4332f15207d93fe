// The truth of a simulated cut against the exact lobes: no chatter where no multiplier lies outside, and where one does
// chatter at the frequency that it turns with, unless teeth that leave the cut keep it small beside the forced
// vibration: below half of it is not called chatter for sure (laws.md).
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>

#include "core/milling/simulation/noise.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/simulation/simulated_cut.h"
#include "core/milling/stability/exact_lobes.h"
#include "tests/support/dominant_multiplier.h"

namespace stillcut::milling {
namespace {

constexpr double kSmallChatter = 0.5;  // of the forced vibration, in amplitude

struct Judged {
  ChatterKind kind = ChatterKind::Unknown;
  double hz = 0.0;
  double peak = 0.0;
};

Judged judge(const Scenario& scenario) {
  SimulatedCut cut(scenario);
  SampleBlock block;
  block.allocate(static_cast<int>(scenario.sensors.size()), scenario.blockFrames);
  while (cut.fill(block)) {
  }
  return {cut.truth().kind(), cut.truth().chatterFrequency().value, cut.truth().peakRatio()};
}

double between(NoiseSource& random, double a, double b) {
  return a + (b - a) * random.uniform();
}

// A tool and an engagement, low immersion and half the tooth passing included.
Scenario randomScenario(NoiseSource& random) {
  Scenario s;
  s.name = "random";
  const int modes = 1 + static_cast<int>(2.0 * random.uniform());
  for (int i = 0; i < modes; ++i) {
    const double angle = between(random, 0.0, kTwoPi);
    s.model.modes.push_back({Hertz(between(random, 400.0, 1000.0)),
                             between(random, 0.01, 0.04),
                             1e6 * std::pow(10.0, random.uniform()),
                             {std::cos(angle), std::sin(angle)}});
  }
  s.model.tool.teeth = 1 + static_cast<int>(5.0 * random.uniform());
  const bool low = random.uniform() < 0.5;
  s.model.engagement = {low ? between(random, 0.03, 0.15) : between(random, 0.15, 1.0),
                        random.uniform() < 0.5 ? MillingDirection::Up : MillingDirection::Down};
  s.model.material.tangential = 8e8;
  s.model.material.radial = 2.5e8;
  s.programme.speed = Rpm(between(random, 6000.0, 18000.0));
  s.programme.feedPerTooth = Metres(0.08e-3);
  s.programme.duration = Seconds(2.5);
  s.programme.randomForce = 2e-3;
  s.drive.inertia = 0.02;  // the speed stays
  SensorSettings tip;
  tip.name = "y";
  tip.quantity = SensorQuantity::Displacement;
  tip.axis = "y";
  s.sensors = {tip};
  return s;
}

TEST(TruthAndLobes, AgreeOverRandomTools) {
  NoiseSource random(99);
  int judged = 0, wrong = 0, small = 0, elsewhere = 0;
  for (int n = 0; n < 60 && judged < 40; ++n) {
    Scenario s = randomScenario(random);
    const auto lobes = ExactLobes::make(s.model, "random");
    ASSERT_TRUE(lobes.ok());
    const auto limits = lobes->limits(s.programme.speed, {Metres(12e-3), false, true, {}});
    ASSERT_TRUE(limits.ok());
    if (!limits->hasLimit()) continue;
    const StabilityLimit& first = limits->crossings.front();
    for (double factor : {0.9, 1.1}) {
      const Metres depth = factor * first.depth;
      const auto mu = test::dominantMultiplier(*lobes, s.programme.speed, depth);
      const double perTooth = lobes->system().toothPeriod(s.programme.speed);
      const double folds = mu.ok() ? std::log(std::abs(*mu)) / perTooth * 2.0 : 0.0;
      const bool unstable = limits->outsideAt(depth) > 0;
      if (unstable && folds < 12.0) continue;  // no time to grow
      s.programme.depth = constantSchedule(depth.value);
      const Judged found = judge(s);
      ++judged;
      if (unstable != (found.kind != ChatterKind::Unknown)) {
        ++(unstable && found.peak < kSmallChatter ? small : wrong);
        std::cout << "tool " << n << ", " << s.model.tool.teeth << " teeth, immersion "
                  << s.model.engagement.radialImmersion << ", " << s.programme.speed.value << " rev/min, " << factor
                  << " x " << 1e3 * first.depth.value << " mm (" << crossingName(first.kind) << " at "
                  << first.frequency.value << " Hz, " << folds << " e-folds): found " << found.hz << " Hz, peak ratio "
                  << found.peak << "\n";
      } else if (unstable) {
        // Any line of the family: the loudest at the tip's acceleration need not be that of its displacement.
        const double order = (found.hz - first.frequency.value) * perTooth,
                     twin = (found.hz + first.frequency.value) * perTooth;
        const double off = std::min(std::abs(order - std::round(order)), std::abs(twin - std::round(twin)));
        if (off > 0.05) {
          ++elsewhere;
          std::cout << "tool " << n << ": " << found.hz << " Hz for " << first.frequency.value << "\n";
        }
      }
    }
  }
  std::cout << judged << " cuts judged: " << wrong << " verdicts and " << small << " small ones and " << elsewhere
            << " frequencies differ\n";
  EXPECT_GE(judged, 40);
  EXPECT_EQ(wrong, 0);
  EXPECT_LE(small, judged / 5);
  EXPECT_EQ(elsewhere, 0);
}

TEST(TruthAndLobes, UnstableCutsAtLowImmersionAreChatter) {
  const auto folder = std::filesystem::path(STILLCUT_SHARED_DIR) / "cases_lobes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the shared cases are not here";
  const std::vector<std::pair<const char*, double>> cases{{"truth_none_no_helix_5mm.toml", 658.0},
                                                          {"helix45_18000rpm_2.7mm.toml", 651.0}};
  for (const auto& [file, hz] : cases) {
    const auto scenario = loadScenario((folder / file).string());
    ASSERT_TRUE(scenario.ok()) << scenario.error().line();
    const Judged found = judge(*scenario);
    EXPECT_EQ(found.kind, ChatterKind::Hopf) << file << ", peak ratio " << found.peak;
    EXPECT_NEAR(found.hz, hz, 12.0) << file;
  }
}

}  // namespace
}  // namespace stillcut::milling
