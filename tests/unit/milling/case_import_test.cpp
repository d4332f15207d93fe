// Reference cuts of every family as JSON made up here: what the file says over time is what the simulated cut does.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/milling/simulation/case_json.h"
#include "core/milling/simulation/simulated_cut.h"

namespace stillcut::milling {
namespace {

namespace fs = std::filesystem;

// One mode along x, two teeth: the single-degree example whose limits core/milling/stability knows.
std::string caseText(const std::string& process, const std::string& extra = "") {
  return R"({"name": "made_up", "fs": 25600, "teeth": 2, "spindle_rpm": 7400.0, "feed_per_tooth_m": 0.0001,
    "runout_m": 4e-06, "helix_deg": 0, "Kt": 6e8, "Kn": 2e8, "aD": 0.1, "up": false, "duration_s": 1.5,
    "modes": [{"f": 922.0, "zeta": 0.011, "m": 0.03993, "d": [1.0, 0.0]}], "sensor_gain": 0.02,
    "sensor_noise_rms_m_s2": 0.01, "sim_rate_hz": 409600.0, "chatter_hz": 863.3, "notes": "remark")" +
         extra + R"(, "process": )" + process + "}";
}

std::string depthOf(double mm) {
  const std::string value = std::to_string(mm);
  return R"({"from_s": 0, "to_s": 1.5, "from_mm": )" + value + R"(, "to_mm": )" + value + R"(, "shape": "linear"})";
}

Result<Scenario> imported(const std::string& text) {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path path = fs::temp_directory_path() / (std::string("stillcut_import_") + info->name() + ".json");
  std::ofstream(path) << text;
  Result<Scenario> s = loadCaseJson(path.string());
  fs::remove(path);
  return s;
}

// As TOML and back, which is how `convert` and `simulate` hand it on.
Scenario throughToml(const Scenario& s) {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path path = fs::temp_directory_path() / (std::string("stillcut_import_") + info->name() + ".toml");
  EXPECT_TRUE(saveScenario(s, path.string()).ok());
  Result<Scenario> again = loadScenario(path.string());
  fs::remove(path);
  EXPECT_TRUE(again.ok()) << again.error().line();
  return std::move(again).value();
}

Scenario made(const std::string& process) {
  const Result<Scenario> s = imported(caseText(process));
  EXPECT_TRUE(s.ok()) << s.error().line();
  return throughToml(*s);
}

template <class Look>
SimulatedCut run(const Scenario& s, Look look) {
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(2, 64);
  while (cut.fill(block)) look(cut);
  return cut;
}

std::string errorOf(const std::string& process) {
  const Result<Scenario> s = imported(caseText(process));
  return s.ok() ? "" : s.error().line();
}

TEST(CaseImport, DepthRampPeriodDoublingAndRecovery) {
  // At 7400 rev/min the only multiplier outside is -1, from 2.114 to 3.197 mm: a flip, and an even number of teeth with
  // runout, whose own vibration repeats as the flip does.
  const Scenario s = made(R"({"depth_segments": [
    {"from_s": 0.0, "to_s": 0.2, "from_mm": 1.2, "to_mm": 1.2, "shape": "linear"},
    {"from_s": 0.2, "to_s": 0.4, "from_mm": 1.2, "to_mm": 2.7, "shape": "smoothstep"},
    {"from_s": 0.4, "to_s": 0.9, "from_mm": 2.7, "to_mm": 2.7, "shape": "linear"},
    {"from_s": 0.9, "to_s": 1.0, "from_mm": 2.7, "to_mm": 1.2, "shape": "smoothstep"},
    {"from_s": 1.0, "to_s": 1.5, "from_mm": 1.2, "to_mm": 1.2, "shape": "linear"}]})");
  bool wild = false;
  const SimulatedCut cut = run(s, [&](const SimulatedCut& c) {
    if (c.time().value > 0.6 && c.time().value < 0.9) wild = wild || c.truth().chattering();
    EXPECT_FALSE(c.time().value > 1.3 && c.truth().chattering()) << "not recovered at " << c.time().value;
  });
  EXPECT_TRUE(wild);
  EXPECT_EQ(cut.truth().kind(), ChatterKind::Flip);
  EXPECT_GT(cut.truth().onset().at20, 0.25);
  EXPECT_LT(cut.truth().onset().at20, 0.6);
  const double order = cut.truth().chatterFrequency().value * 60.0 / (2 * 7400.0);  // of the tooth-passing frequency
  EXPECT_NEAR(order - std::floor(order), 0.5, 0.02);
}

TEST(CaseImport, ImmersionRampMovesTheEngagement) {
  const Scenario s = made(R"({"depth_segments": [)" + depthOf(2.0) + R"(], "immersion_segments": [
    {"from_s": 0.0, "to_s": 0.3, "from_aD": 0.05, "to_aD": 0.05, "shape": "linear"},
    {"from_s": 0.3, "to_s": 0.8, "from_aD": 0.05, "to_aD": 0.75, "shape": "linear"}]})");
  EXPECT_DOUBLE_EQ(s.programme.immersion.at(0.1, 0.0, 0.0), 0.05);
  EXPECT_DOUBLE_EQ(s.programme.immersion.at(0.55, 0.0, 0.0), 0.4);
  EXPECT_DOUBLE_EQ(s.programme.immersion.at(1.4, 0.0, 0.0), 0.75);
  const SimulatedCut cut = run(s, [](const SimulatedCut&) {});
  EXPECT_GT(cut.truth().onset().at20, 0.4);
}

TEST(CaseImport, SpindleAndFeedAreWhereTheProgrammeSays) {
  const Scenario s = made(R"({"depth_segments": [)" + depthOf(0.3) + R"(], "speed_segments": [
    {"from_s": 0.0, "to_s": 0.5, "from_rpm": 7400.0, "to_rpm": 7400.0, "shape": "linear"},
    {"from_s": 0.5, "to_s": 0.9, "from_rpm": 7400.0, "to_rpm": 9000.0, "shape": "smoothstep"}]})");
  int looks = 0;
  run(s, [&](const SimulatedCut& c) {
    const double programmed = s.programme.speedOverTime.at(c.time().value, 0.0, 0.0);
    // A look at the drives is at most a thirtieth of a millisecond old.
    EXPECT_NEAR(c.machineState().actualSpeed.value, programmed, 0.5);
    EXPECT_NEAR(c.machineState().actualFeed.value, 1e-4 * 2 * programmed / 60.0, 1e-6);
    ++looks;
  });
  EXPECT_GT(looks, 500);
}

TEST(CaseImport, FeedAndSpeedStepsAreTakenAtOnce) {
  const Scenario s = made(R"({"depth_segments": [)" + depthOf(0.3) + R"(], "feed_per_tooth_segments": [
    {"from_s": 0.0, "to_s": 0.5, "from_mm": 0.1, "to_mm": 0.1, "shape": "linear"},
    {"from_s": 0.5, "to_s": 1.5, "from_mm": 0.05, "to_mm": 0.05, "shape": "linear"}], "spindle_segments": [
    {"from_s": 0.0, "to_s": 1.0, "from_rpm": 7400.0, "to_rpm": 7400.0, "shape": "linear"},
    {"from_s": 1.0, "to_s": 1.5, "from_rpm": 6000.0, "to_rpm": 6000.0, "shape": "linear"}]})");
  run(s, [&](const SimulatedCut& c) {
    const double t = c.time().value;
    if (std::abs(t - 0.5) < 0.003 || std::abs(t - 1.0) < 0.003) return;
    const double rpm = t < 1.0 ? 7400.0 : 6000.0;
    EXPECT_NEAR(c.machineState().actualSpeed.value, rpm, 1e-3);
    EXPECT_NEAR(c.machineState().actualFeed.value, (t < 0.5 ? 1e-4 : 0.5e-4) * 2 * rpm / 60.0, 1e-8);
  });
}

TEST(CaseImport, WhatIsSaidBeyondTheCutIsKept) {
  const Scenario s = made(R"({"depth_segments": [)" + depthOf(0.5) + R"(], "entry": "as the tool comes"})");
  EXPECT_EQ(s.reference.at("chatter_hz"), "863.3");
  EXPECT_EQ(s.reference.at("notes"), "remark");
  EXPECT_EQ(s.reference.at("process-entry"), "as the tool comes");
  EXPECT_FALSE(s.reference.contains("Kt"));
}

TEST(CaseImport, AnglesInTheCutBecomeAnEngagement) {
  const Scenario s = made(R"({"depth_segments": [)" + depthOf(0.5) +
                          R"(], "phi_st_in_cut": 2.0943951023931953, "phi_ex_in_cut": 3.141592653589793})");
  EXPECT_EQ(s.model.engagement.side, MillingDirection::Down);
  EXPECT_NEAR(s.model.engagement.radialImmersion, 0.25, 1e-12);
}

TEST(CaseImport, RefusesWhatItDoesNotUnderstandByName) {
  const std::string depth = R"({"depth_segments": [)" + depthOf(0.5) + "]";
  EXPECT_NE(errorOf("{}").find("process.depth_segments"), std::string::npos);
  EXPECT_NE(errorOf(depth + R"(, "wobble_segments": [{"from_s": 0}]})").find("wobble_segments"), std::string::npos);
  EXPECT_NE(errorOf(depth + R"(, "speed_segments": [{"from_s": 0, "to_s": 1, "from_knots": 3, "to_knots": 4}]})")
                .find("'knots'"),
            std::string::npos);
  EXPECT_NE(errorOf(depth + R"(, "speed_segments": [{"from_s": 0, "to_s": 1, "from_rpm": 3}]})").find("to_rpm"),
            std::string::npos);
  EXPECT_NE(errorOf(depth + R"(, "phi_st_in_cut": 0.3, "phi_ex_in_cut": 1.0})").find("phi_st_in_cut"),
            std::string::npos);
}

}  // namespace
}  // namespace stillcut::milling
