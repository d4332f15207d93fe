// What the truth calls chatter: against the truth tables of the shared cuts, and where noise is all there is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/milling/simulation/case_json.h"
#include "core/milling/simulation/simulated_cut.h"
#include "tests/unit/milling/small_cut.h"

namespace stillcut::milling {
namespace {

struct Row {
  double time, total, chatter;
};

std::string shared(const std::string& name) {
  return std::string(STILLCUT_SHARED_DIR) + "/cases/" + name;
}

std::vector<Row> truthTable(const std::string& name) {
  std::ifstream in(shared(name + "_truth.csv"));
  std::vector<Row> rows;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    Row r{};
    char comma = 0;
    std::istringstream(line) >> r.time >> comma >> r.total >> comma >> r.chatter;
    rows.push_back(r);
  }
  return rows;
}

SimulatedCut run(const Scenario& s) {
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(static_cast<int>(s.sensors.size()), 256);
  while (cut.fill(block)) {
  }
  return cut;
}

const ChatterTruth::LogEntry& at(const ChatterTruth& truth, double time) {
  const auto& log = truth.log();
  const auto it = std::lower_bound(log.begin(), log.end(), time, [](const ChatterTruth::LogEntry& e, double t) {
    return static_cast<double>(e.time) < t;
  });
  return it == log.end() ? log.back() : *it;
}

struct Stretch {
  const char* name;
  double from, to;
  double gain;       // |1 - exp(-2 pi i f T)|^2 by which the table's chatter part is divided
  double tolerance;  // of the chatter part: what grows from noise (c6) has a size of its own in every run
};

class TruthTable : public ::testing::TestWithParam<Stretch> {};

// Vibration in the mean within 1 % (a window of 8 ms is no whole revolution: 5 % from one row to the next), and the
// chatter part as it grows through 20 %.
TEST_P(TruthTable, IsWhatOursSays) {
  const Stretch& p = GetParam();
  if (!std::filesystem::exists(shared(std::string(p.name) + ".json"))) GTEST_SKIP() << "no shared cases";
  const Result<Scenario> s = loadCaseJson(shared(std::string(p.name) + ".json"));
  ASSERT_TRUE(s.ok()) << s.error().line();
  const SimulatedCut cut = run(*s);
  double worst = 0.0, totalSum = 0.0, logSum = 0.0;
  int rows = 0;
  for (const Row& r : truthTable(p.name)) {
    if (r.time < p.from || r.time > p.to) continue;
    const ChatterTruth::LogEntry& e = at(cut.truth(), r.time);
    worst = std::max(worst, std::abs(static_cast<double>(e.forcedAndChatterRms) / r.total - 1.0));
    totalSum += static_cast<double>(e.forcedAndChatterRms) / r.total;
    if (p.gain > 0.0) logSum += std::log(static_cast<double>(e.chatterRms) / p.gain / r.chatter);
    ++rows;
  }
  ASSERT_GT(rows, 50);
  EXPECT_LT(worst, 0.05);
  EXPECT_NEAR(totalSum / rows, 1.0, 0.01);
  EXPECT_NEAR(logSum / rows, 0.0, p.tolerance) << "chatter part";
}

INSTANTIATE_TEST_SUITE_P(Shared, TruthTable,
                         ::testing::Values(Stretch{"c1_stable", 0.3, 1.9, 0.0, 1.0},
                                           Stretch{"c2_hopf", 0.86, 0.94, 0.40235, 0.1},
                                           Stretch{"c6_air_entry_chatter_exit", 1.95, 2.06, 2.9124, 1.0},
                                           Stretch{"c7b_xu_800rpm", 3.3, 3.9, 0.48301, 0.1}));

Scenario noisyCut(double depth) {
  Scenario s = smallCut("noisy", Rpm(7500.0), Seconds(3.0), depth);
  SensorSettings c;
  c.name = c.axis = "x";
  s.sensors = {c};
  return s;
}

// A slow spindle whose speed ripples with its teeth, chatter that grows by e in 0.2 s, and a growth that is measured
// below zero for a moment: neither the ripple nor the moment moves what the truth says.
TEST(Truth, RippleOfTheSpeedAndAFlickerOfTheGrowthMoveNothing) {
  constexpr int kSamples = 512;
  constexpr double kSpindle = 13.3, kChatter = 190.0, kConstant = 0.2, kBegins = 1.0, kFirst = 0.002;
  ChatterTruth truth({kSamples, 1, kSpindle, 1.1 * kSpindle, 4.0, 0.1, 400.0});
  double time = 0.0;
  for (int i = 0; time < 3.0; ++i) {
    const double angle = kTwoPi * i / kSamples;
    TruthSample s;
    s.spindleHz = kSpindle * (1.0 + 0.03 * std::cos(4.0 * angle));
    time += 1.0 / (kSamples * s.spindleHz);
    s.time = time;
    const double grown = std::min(1.0, kFirst * std::exp((time - kBegins) / kConstant));
    s.forced = {std::cos(4.0 * angle), 0.0};
    s.acceleration = {s.forced[0] + (time > kBegins ? grown * std::cos(kTwoPi * kChatter * time) : 0.0), 0.0};
    s.growth = time > 0.5 && !(time > 1.6 && time < 1.61) ? 5.0 : -1.0;
    s.cutting = true;
    truth.add(s);
  }
  const ChatterOnset onset = truth.onset();
  constexpr double kTurn = 1.1 / kSpindle;  // the second difference over a revolution is centred that much earlier
  EXPECT_NEAR(onset.at1, kBegins + kConstant * std::log(0.01 / kFirst), kTurn);
  EXPECT_NEAR(onset.at20, kBegins + kConstant * std::log(0.2 / kFirst), kTurn);
  EXPECT_NEAR(truth.chatterFrequency().value, kChatter, 0.003 * kChatter);
}

// A line stays where it is while the spindle's speed drifts by 5 % a second: samples at equal angles are not at equal
// times.
TEST(Truth, ADriftOfTheSpeedMovesNoLine) {
  constexpr int kSamples = 128;
  constexpr double kSpindle = 105.0, kChatter = 790.0, kBegins = 0.5, kConstant = 0.03;
  ChatterTruth truth({kSamples, 1, kSpindle, 1.1 * kSpindle, 2.0, 0.1, 1000.0});
  double time = 0.0;
  for (int i = 0; time < 1.5; ++i) {
    TruthSample s;
    s.spindleHz = kSpindle * (1.0 - 0.05 * time);
    time += 1.0 / (kSamples * s.spindleHz);
    s.time = time;
    s.forced = {std::cos(3.0 * kTwoPi * i / kSamples), 0.0};
    const double grown = time > kBegins ? std::min(1.0, 0.002 * std::exp((time - kBegins) / kConstant)) : 0.0;
    s.acceleration = {s.forced[0] + grown * std::cos(kTwoPi * kChatter * time), 0.0};
    s.growth = time > 0.4 ? 30.0 : -1.0;
    s.cutting = true;
    truth.add(s);
  }
  EXPECT_NEAR(truth.chatterFrequency().value, kChatter, 1e-3 * kChatter);
}

TEST(Truth, ShakingAStableCutIsNotChatter) {
  Scenario s = noisyCut(1e-3);
  s.programme.randomForce = 1.0;
  s.programme.unevenness = 1e-3;
  const SimulatedCut cut = run(s);
  EXPECT_GT(cut.truth().ratio(), 0.5) << "the noise is no smaller than the forced vibration";
  EXPECT_TRUE(std::isnan(cut.truth().onset().at20));
  EXPECT_EQ(cut.truth().peakRatio(), 0.0);
  EXPECT_EQ(cut.truth().marked().value, 0.0);
  EXPECT_EQ(cut.truth().kind(), ChatterKind::Unknown);
}

TEST(Truth, SensorNoiseChangesNothing) {
  Scenario s = noisyCut(6e-3);
  s.programme.randomForce = 1e-3;
  const SimulatedCut quiet = run(s);
  s.sensors[0].noise = 1e3;
  const SimulatedCut loud = run(s);
  ASSERT_FALSE(std::isnan(quiet.truth().onset().at20));
  EXPECT_EQ(quiet.truth().onset().at20, loud.truth().onset().at20);
  EXPECT_EQ(quiet.truth().chatterFrequency(), loud.truth().chatterFrequency());
}

// Chatter grown in a deep cut is chatter until it has died in a shallow one, however noisy that is.
TEST(Truth, ChatterEndsAfterTheCutHasBecomeStable) {
  Scenario s = noisyCut(1e-3);
  s.programme.randomForce = 1.0;
  s.programme.depth.segments = {{0.0, 1.5, 6e-3, 6e-3, RampShape::Linear}, {1.5, 3.0, 1e-3, 1e-3, RampShape::Linear}};
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(1, 64);
  double ended = 0.0;
  while (cut.fill(block)) {
    if (cut.truth().chattering()) ended = cut.time().value;
  }
  EXPECT_GT(ended, 1.5);
  EXPECT_LT(ended, 1.8);
}

}  // namespace
}  // namespace stillcut::milling
