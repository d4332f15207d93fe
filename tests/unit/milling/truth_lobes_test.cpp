// The truth of a simulated cut against the exact lobes: no chatter where no multiplier lies outside, and where one does
// chatter at the frequency that it turns with, small as it may stay where teeth leave the cut.
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "core/milling/simulation/scenario.h"
#include "core/milling/simulation/simulated_cut.h"
#include "tests/support/truth_cuts.h"

namespace stillcut::milling {
namespace {

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

// tests/bench/truth_table has more of them.
TEST(TruthAndLobes, AgreeOverRandomTools) {
  NoiseSource random(99);
  int judged = 0, disagreeing = 0;
  for (int n = 0; n < 90 && judged < 40; ++n) {
    const Scenario s = test::randomCut(random, static_cast<test::CutKind>(n % 3 == 0 ? 0 : n % 5));
    const auto known = test::knownLimit(s);
    ASSERT_TRUE(known.ok()) << known.error().line();
    if (!known.value()) continue;
    for (double factor : {0.9, 1.1}) {
      const test::Comparison found = test::compareWithTruth(s, **known, factor);
      if (found.agreement == test::Agreement::NoTimeToGrow) continue;
      ++judged;
      if (found.agreement == test::Agreement::Agrees) continue;
      ++disagreeing;
      EXPECT_NE(found.agreement, test::Agreement::FalseChatter) << "tool " << n;
      std::cout << "tool " << n << ": " << test::comparisonText(s, **known, factor, found) << "\n";
    }
  }
  std::cout << judged << " cuts judged, " << disagreeing << " differ\n";
  EXPECT_GE(judged, 40);
  EXPECT_LE(disagreeing, 2) << "teeth that leave the cut keep some chatter too small to be sure of";
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
