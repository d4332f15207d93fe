// simulate --strategy active: Ford's cuts with the active work-holder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/component/cli/made_files.h"
#include "tests/component/cli/program.h"
#include "tests/unit/record/temp_folder.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string scenario(const std::string& name) {
  return std::string(STILLCUT_SOURCE_DIR) + "/resources/scenarios/" + name + ".toml";
}

class Active : public testing::Test {
 protected:
  json simulate(const std::string& name, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"simulate", scenario(name), "--strategy", "active", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = runCli(folder_ / "", arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }
  // dB by axis at the line nearest to a frequency.
  static double attenuation(const json& answer, const std::string& axis, double frequency) {
    double best = 1e300;
    double db = 0.0;
    for (const json& line : answer["attenuation_db"]) {
      const double distance = std::abs(line["frequency_hz"].get<double>() - frequency);
      if (line["axis"] != axis || distance >= best) continue;
      best = distance;
      db = line["db"];
    }
    return db;
  }
  record::TempFolder folder_;
};

TEST_F(Active, TheUnstableCutBecomesStable) {
  const json answer = simulate("ford-unstable", {"--out", "held.wav"});
  EXPECT_EQ(answer["strategy"], "active");
  EXPECT_TRUE(answer["chatter_alone"].get<bool>());
  EXPECT_EQ(answer["outcome"], "stable");
  for (const json& axis : answer["axes"]) {
    EXPECT_TRUE(axis["released"].is_null()) << axis["released"];
    EXPECT_LE(axis["stroke_used"].get<double>(), 1.0);
    EXPECT_LT(axis["path_residual"].get<double>(), 0.1);
    EXPECT_GT(axis["path_phase_left_deg"].get<double>(), 60.0);
    const std::string name = axis["axis"];
    EXPECT_GE(attenuation(answer, name, answer["chatter_hz"]), 23.0) << name;
    EXPECT_GE(attenuation(answer, name, 339.0), 23.0) << name;
    EXPECT_GE(attenuation(answer, name, 1024.0), 24.5) << name;
    std::printf("%s: %.1f dB at %.1f Hz, %.1f dB at 339 Hz, %.1f dB at 1024 Hz\n", name.c_str(),
                attenuation(answer, name, answer["chatter_hz"]), answer["chatter_hz"].get<double>(),
                attenuation(answer, name, 339.0), attenuation(answer, name, 1024.0));
  }
  EXPECT_LT(answer["final_ratio"].get<double>(), 0.1);
  const Outcome info = runCli(folder_ / "", {"info", "held.wav"});
  EXPECT_EQ(info.exitCode, 0);
  EXPECT_THAT(info.out, HasSubstr("5000 Hz"));
}

TEST_F(Active, TheStableCutStaysStableAndGetsQuieter) {
  const json answer = simulate("ford-stable");
  EXPECT_FALSE(answer["chatter_alone"].get<bool>());
  EXPECT_EQ(answer["outcome"], "stable");
  EXPECT_LT(answer["final_ratio"].get<double>(), 1.0);
  EXPECT_GE(attenuation(answer, "y", 1000.0), 16.0);
  for (const json& axis : answer["axes"]) EXPECT_TRUE(axis["released"].is_null());
}

// Without a line that is asked for LMS quietens what is loudest: less at 1000 Hz, more over all.
TEST_F(Active, WithoutEmphasisTheLoudestGoesFirst) {
  const json asked = simulate("ford-stable");
  const json plain = simulate("ford-stable", {"--set", "active.emphasis=1"});
  EXPECT_LT(plain["final_ratio"].get<double>(), asked["final_ratio"].get<double>());
  EXPECT_LT(attenuation(plain, "y", 1000.0), attenuation(asked, "y", 1000.0) - 6.0);
}

// A step far beyond what is stable: the gate lets go, and the cut is as if nobody had touched it.
TEST_F(Active, ALoopThatRunsAwayIsLetGo) {
  const json answer = simulate("ford-stable", {"--set", "active.step=1"});
  EXPECT_EQ(answer["outcome"], "stable");
  for (const json& axis : answer["axes"]) EXPECT_FALSE(axis["released"].is_null());
  EXPECT_NEAR(answer["final_ratio"].get<double>(), 1.0, 0.05);
}

TEST_F(Active, NeedsAWorkHolder) {
  writeScenario(folder_ / "cut.toml");
  const Outcome outcome = runCli(folder_ / "", {"simulate", "cut.toml", "--strategy", "active"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_THAT(outcome.err, HasSubstr("[work_holder]"));
  const Outcome session =
      runCli(folder_ / "", {"simulate", scenario("ford-stable"), "--strategy", "active", "--out", "a.h5"});
  EXPECT_EQ(session.exitCode, 2);
  EXPECT_THAT(session.err, HasSubstr(".wav"));
}

}  // namespace
}  // namespace stillcut::cli_test
