#include "core/milling/stability/lobe_sweep.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "core/milling/stability/lobe_csv.h"
#include "tests/support/dominant_multiplier.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

SweepOptions sweepTo(double depth, int threads) {
  SweepOptions options;
  options.limits.maxAxialDepth = Metres(depth);
  options.threads = threads;
  return options;
}

TEST(LobeSweep, TheSameBitsWhateverTheNumberOfThreads) {
  const auto speeds = speedSteps(Rpm(5000), Rpm(12000), Rpm(250), "test").value();
  for (bool first : {false, true}) {
    SweepOptions one = sweepTo(2e-3, 1);
    SweepOptions four = sweepTo(2e-3, 4);
    one.limits.firstOnly = four.limits.firstOnly = first;
    const auto a = sweepLobes(textbookHalf(), speeds, one, "a");
    const auto b = sweepLobes(textbookHalf(), speeds, four, "b");
    ASSERT_TRUE(a->finished && b->finished);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      ASSERT_EQ(a->speeds[i].speed, speeds[i]);
      ASSERT_EQ(a->speeds[i].crossings.size(), b->speeds[i].crossings.size());
      for (std::size_t k = 0; k < a->speeds[i].crossings.size(); ++k) {
        EXPECT_EQ(a->speeds[i].crossings[k].depth, b->speeds[i].crossings[k].depth);
      }
    }
  }
}

TEST(LobeSweep, ChartAgreesWithTheMultiplierOfSinglePoints) {
  const auto speeds = speedSteps(Rpm(6000), Rpm(16000), Rpm(2000), "test").value();
  std::vector<Metres> depths;
  for (int i = 0; i < 12; ++i) depths.emplace_back(0.13e-3 * i);
  const auto sweep = sweepLobes(textbookHalf(), speeds, sweepTo(1.6e-3, 2), "chart");
  const auto lobes = ExactLobes::make(textbookHalf(), "points");
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const auto mu = test::dominantMultiplier(*lobes, speeds[i], depths[k]);
      ASSERT_TRUE(mu.ok());
      EXPECT_EQ(sweep->speeds[i].stableAt(depths[k]), std::abs(mu.value()) < 1.0)
          << speeds[i].value << " " << depths[k].value;
    }
  }
}

TEST(LobeSweep, SpeedsTooLowForUnlikeTeethAreUnknownAndTheOthersStay) {
  CutModel model = textbookHalf();
  model.tool.teeth = 4;
  const double degree = 3.14159265358979323846 / 180.0;
  model.tool.pitch = {70.0 * degree, 110.0 * degree, 70.0 * degree, 110.0 * degree};
  const auto lobes = ExactLobes::make(model, "uneven");
  ASSERT_TRUE(lobes.ok()) << lobes.error().line();
  const Rpm lowest = lobes->lowestSpeed();
  ASSERT_GT(lowest.value, 10.0);
  EXPECT_FALSE(lobes->possible(0.99 * lowest));
  EXPECT_TRUE(lobes->possible(lowest));
  const std::vector<Rpm> speeds{0.5 * lowest, 0.9 * lowest, 5.0 * lowest, 6.0 * lowest};
  const auto sweep = sweepLobes(model, speeds, sweepTo(2e-3, 1), "uneven");
  ASSERT_TRUE(sweep.ok()) << sweep.error().line();
  EXPECT_TRUE(sweep->finished);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_FALSE(sweep->speeds[i].hasLimit());
    EXPECT_FALSE(sweep->complete(sweep->speeds[i]));
    EXPECT_FALSE(sweep->speeds[i].stableAt(Metres(1e-6)));
  }
  for (const std::size_t i : {2U, 3U}) {
    EXPECT_TRUE(sweep->speeds[i].hasLimit() || sweep->complete(sweep->speeds[i]));
  }
  ASSERT_EQ(sweep->warnings.size(), 1u);
  EXPECT_NE(text(sweep->warnings[0]).find("below " + std::to_string(std::lround(lowest.value)) + " rpm are unknown"),
            std::string::npos)
      << text(sweep->warnings[0]);
  const std::string csv = lobeCsv(*sweep);
  EXPECT_NE(csv.find(",0,,0,0,unknown,"), std::string::npos) << csv;
  EXPECT_EQ(lobeSummary(*sweep)[1], "2 speeds are unknown: they lie too low to be searched");
  const auto refused = lobes->limits(0.5 * lowest, sweepTo(2e-3, 1).limits);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("from " + std::to_string(std::lround(lowest.value)) + " rpm on it is possible"),
            std::string::npos)
      << refused.error().line();
}

TEST(LobeSweep, ProgressRisesToOne) {
  const auto speeds = speedSteps(Rpm(5000), Rpm(9000), Rpm(200), "test").value();
  SweepOptions options = sweepTo(1e-3, 2);
  std::vector<double> seen;
  options.progress = [&](double share) { seen.push_back(share); };
  ASSERT_TRUE(sweepLobes(textbookSlot(), speeds, options, "p").ok());
  ASSERT_EQ(seen.size(), speeds.size());
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_DOUBLE_EQ(seen.back(), 1.0);
}

TEST(LobeSweep, AStopEndsItAndIsSaid) {
  const auto speeds = speedSteps(Rpm(5000), Rpm(25000), Rpm(10), "test").value();
  SweepOptions options = sweepTo(1e-3, 2);
  std::stop_source stop;
  std::atomic<int> done{0};
  options.progress = [&](double) {
    if (++done == 5) stop.request_stop();
  };
  const auto sweep = sweepLobes(textbookSlot(), speeds, options, "stop", stop.get_token());
  ASSERT_TRUE(sweep.ok());
  EXPECT_FALSE(sweep->finished);
  EXPECT_LT(done, 12);  // what was under way on two threads may still report
  EXPECT_EQ(sweep->speeds.back().searchedTo.value, 0.0);
}

TEST(LobeSweep, EveryMethodAnswersAndZerothOrderWarns) {
  const auto speeds = speedSteps(Rpm(6000), Rpm(6400), Rpm(200), "test").value();
  SweepOptions options = sweepTo(4e-3, 1);
  double depth[3] = {};
  for (LobeMethod method : {LobeMethod::Exact, LobeMethod::SemiDiscretization, LobeMethod::ZerothOrder}) {
    options.method = method;
    options.sdm.cells = 120;
    const auto sweep = sweepLobes(textbookHalf(), speeds, options, "m");
    ASSERT_TRUE(sweep.ok());
    ASSERT_TRUE(sweep->speeds[0].hasLimit());
    depth[static_cast<int>(method)] = sweep->speeds[0].crossings[0].depth.value;
    EXPECT_EQ(sweep->warnings.empty(), method != LobeMethod::ZerothOrder);
  }
  EXPECT_NEAR(depth[1] / depth[0], 1.0, 5e-3);
  EXPECT_NEAR(depth[2] / depth[0], 1.0, 0.3);
}

TEST(LobeSweep, StepsIncludeTheEnd) {
  EXPECT_EQ(speedSteps(Rpm(5000), Rpm(25000), Rpm(100), "s")->size(), 201u);
  EXPECT_EQ(speedSteps(Rpm(5000), Rpm(5000), Rpm(100), "s")->size(), 1u);
  EXPECT_EQ(speedSteps(Rpm(1000), Rpm(1001), Rpm(0.1), "s")->back().value, 1001.0);
  EXPECT_EQ(speedSteps(Rpm(1000), Rpm(1050), Rpm(100), "s")->size(), 1u);
}

TEST(LobeSweep, TheZerothOrderNamesWhatItLeavesOut) {
  CutModel model = textbookSlot();
  model.material.processDamping = 1e4;
  const std::vector<Rpm> speeds{Rpm(6000)};
  SweepOptions options = sweepTo(1e-3, 1);
  EXPECT_TRUE(sweepLobes(model, speeds, options, "exact")->warnings.empty());
  options.method = LobeMethod::ZerothOrder;
  const auto sweep = sweepLobes(model, speeds, options, "zeroth");
  ASSERT_EQ(sweep->warnings.size(), 2u);
  EXPECT_NE(text(sweep->warnings[1]).find("process damping"), std::string::npos);
}

}  // namespace
}  // namespace stillcut::milling
