// The shared reference cuts, made by an independent simulator: same verdict, onset and frequency from their JSON alone.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/milling/simulation/case_json.h"
#include "core/milling/simulation/simulated_cut.h"

namespace stillcut::milling {
namespace {

std::string casePath(const std::string& name) {
  return std::string(STILLCUT_SHARED_DIR) + "/cases/" + name + ".json";
}

// Runs the whole cut; nullopt where the shared cases are not at hand.
std::optional<SimulatedCut> runCase(const std::string& name) {
  if (!std::filesystem::exists(casePath(name))) return std::nullopt;
  const Result<Scenario> scenario = loadCaseJson(casePath(name));
  if (!scenario) {
    ADD_FAILURE() << scenario.error().line();
    return std::nullopt;
  }
  std::optional<SimulatedCut> cut(std::in_place, *scenario);
  SampleBlock block;
  block.allocate(2, scenario->blockFrames);
  while (cut->fill(block)) {
  }
  return cut;
}

#define RUN_CASE(variable, name)       \
  const auto variable = runCase(name); \
  if (!(variable)) GTEST_SKIP() << "no shared cases at " << casePath(name)

TEST(SharedCases, C1StaysStable) {
  RUN_CASE(cut, "c1_stable");
  EXPECT_TRUE(std::isnan(cut->truth().onset().at20));
  EXPECT_EQ(cut->truth().peakRatio(), 0.0);  // a stable cut has no chatter, whatever its transients
  EXPECT_LT(cut->truth().ratio(), 0.01);
  // Forced vibration as in the truth table (446..465 m/s^2 from one window to the next).
  EXPECT_NEAR(cut->truth().vibration(), 455.0, 15.0);
}

struct Expected {
  const char* name;
  double onset20, tolerance, frequency;
};

class SharedChatter : public ::testing::TestWithParam<Expected> {};

TEST_P(SharedChatter, OnsetAndFrequency) {
  const Expected& e = GetParam();
  RUN_CASE(cut, e.name);
  EXPECT_NEAR(cut->truth().onset().at20, e.onset20, e.tolerance);
  EXPECT_NEAR(cut->truth().chatterFrequency().value, e.frequency, 0.005 * e.frequency);
  EXPECT_EQ(cut->truth().kind(), ChatterKind::Hopf);
  EXPECT_LT(cut->truth().onset().at1, cut->truth().onset().at20);
  EXPECT_GT(cut->truth().onset().at50, cut->truth().onset().at20);
}

INSTANTIATE_TEST_SUITE_P(All, SharedChatter,
                         ::testing::Values(Expected{"c2_hopf", 0.927, 0.030, 935.5},
                                           Expected{"c6_air_entry_chatter_exit", 2.080, 0.030, 805.83},
                                           Expected{"c7b_xu_800rpm", 3.843, 0.080, 198.49}));

// The runout's comb in the stable part of c7b, against the reference's own recording of the displacement: the spindle
// harmonics near the mode are amplified by the regeneration, so they prove delay, surface and runout at once.
TEST(SharedCases, C7bForcedSpectrumEqualsTheRecording) {
  const std::string wav = std::string(STILLCUT_SHARED_DIR) + "/cases/c7b_xu_800rpm_disp.wav";
  Result<Scenario> scenario = loadCaseJson(casePath("c7b_xu_800rpm"));
  std::ifstream in(wav, std::ios::binary);
  if (!scenario || !in) GTEST_SKIP() << "no shared cases at " << wav;
  std::stringstream text;
  text << in.rdbuf();
  const std::string bytes = text.str();
  const std::size_t data = bytes.find("data") + 8;

  for (SensorSettings& s : scenario->sensors) {
    s.quantity = SensorQuantity::Displacement;
    s.gain = 1e6;  // [um]
    s.noise = 0.0;
  }
  SimulatedCut cut(*scenario);
  SampleBlock block;
  block.allocate(2, 256);
  std::vector<double> ours, theirs;
  const std::size_t first = 4096, count = 3072;  // 1.0 to 1.75 s: ten whole revolutions
  while (ours.size() < first + count && cut.fill(block)) {
    for (float v : block.channel(0)) ours.push_back(static_cast<double>(v));
  }
  for (std::size_t i = 0; i < first + count; ++i) {
    float v = 0.0F;
    std::memcpy(&v, bytes.data() + data + 8 * i, sizeof(float));
    theirs.push_back(static_cast<double>(v));
  }
  const auto amplitude = [&](const std::vector<double>& x, int harmonic) {
    double c = 0.0, s = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = kTwoPi * harmonic * 10.0 * static_cast<double>(i) / static_cast<double>(count);
      c += x[first + i] * std::cos(angle);
      s += x[first + i] * std::sin(angle);
    }
    return 2.0 * std::hypot(c, s) / static_cast<double>(count);
  };
  for (int h : {1, 3, 4, 5, 7, 8, 11, 12, 13, 15, 16}) {
    const double reference = amplitude(theirs, h);
    EXPECT_NEAR(amplitude(ours, h), reference, 0.02 * reference + 0.003) << "spindle harmonic " << h;
  }
}

}  // namespace
}  // namespace stillcut::milling
