// simulate, and what it records: the same cut again from its files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/control/registry.h"
#include "tests/component/cli/made_files.h"
#include "tests/component/cli/program.h"
#include "tests/support/temp_folder.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

class Simulate : public testing::Test {
 protected:
  void SetUp() override { writeScenario(folder_ / "cut.toml"); }
  std::string run(const Arguments& arguments) {
    const Outcome outcome = runCli(folder_ / "", arguments);
    const int worst = arguments.front() == "analyze" ? 1 : 0;  // 1: chatter was found
    EXPECT_TRUE(outcome.exitCode >= 0 && outcome.exitCode <= worst) << spelled(arguments) << "\n" << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  json simulate(Arguments more = {}) {
    Arguments arguments{"simulate", "cut.toml", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json::parse(run(arguments), nullptr, false);
  }
  record::TempFolder folder_;
};

TEST_F(Simulate, GivesOneObjectWithTheNamedFields) {
  const json answer = simulate();
  std::vector<std::string> keys;
  for (const auto& item : answer.items()) keys.push_back(item.key());
  EXPECT_THAT(keys, testing::IsSupersetOf({"scenario", "strategy", "outcome", "alarm_delay_s", "command_delay_s",
                                           "quiet_delay_s", "marked_mm", "peak_ratio", "final_ratio", "final_speed_rpm",
                                           "final_feed_mm_min", "mrr_ratio", "speed_changes"}));
  EXPECT_EQ(answer["scenario"], "demo");
  EXPECT_EQ(answer["strategy"], kStrategy) << "the scenario's own";
  ASSERT_NE(control::kDefaultStrategy, kStrategy);
  EXPECT_THAT(answer["outcome"].get<std::string>(), testing::AnyOf("stable", "no-stable-speed", "hold", "chatter"));
}

TEST_F(Simulate, ALoneCutIsItsOwnMeasure) {
  const json alone = simulate({"--strategy", "monitor"});
  EXPECT_EQ(alone["strategy"], "monitor");
  EXPECT_EQ(alone["outcome"], "chatter");
  EXPECT_EQ(alone["speed_changes"], 0);
  EXPECT_DOUBLE_EQ(alone["peak_ratio"], 1.0);
  EXPECT_DOUBLE_EQ(alone["mrr_ratio"], 1.0);
}

TEST_F(Simulate, TheSameSeedGivesTheSameCut) {
  const json first = simulate({"--seed", "5"});
  EXPECT_EQ(first, simulate({"--seed", "5"}));
  EXPECT_NE(first, simulate({"--seed", "6"}));
}

TEST_F(Simulate, EveryStrategyOfTheTableRuns) {
  for (const control::StrategyEntry& entry : control::strategyTable()) {
    const std::string id(entry.id);
    SCOPED_TRACE(id);
    EXPECT_EQ(simulate({"--strategy", id})["strategy"], id);
  }
}

// The default strategy with the program's own detectors on the scenarios that come with the program.
struct Ending {
  const char* scenario;
  const char* outcome;
  int mostChanges;
  double mostMarked;  // [mm] of path in true chatter; negative: any
};

class ScenarioEnds : public Simulate, public testing::WithParamInterface<Ending> {};

TEST_P(ScenarioEnds, AsItExpects) {
  const Ending& expected = GetParam();
  const std::string path = STILLCUT_SOURCE_DIR "/resources/scenarios/" + std::string(expected.scenario) + ".toml";
  const std::string strategy(control::kDefaultStrategy);
  const json answer = json::parse(run({"simulate", path, "--strategy", strategy, "--json"}), nullptr, false);
  EXPECT_EQ(answer["outcome"], expected.outcome);
  EXPECT_LE(answer["speed_changes"], expected.mostChanges);
  if (expected.mostMarked >= 0.0) {
    EXPECT_LE(answer["marked_mm"], expected.mostMarked);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ScenarioEnds,
    testing::Values(
        // The depth goes on rising after the move, and the tool leaves the cut: neither is a reason to move again.
        Ending{"demo", "stable", 1, 1.0}, Ending{"van-dijk-ramp", "stable", 3, 60.0},
        Ending{"caliskan-1", "stable", 3, 5.0}, Ending{"caliskan-2", "stable", 3, 20.0},
        Ending{"liao-1", "stable", 3, -1.0}, Ending{"liao-2", "stable", 3, -1.0}, Ending{"xu-steel", "stable", 3, -1.0},
        Ending{"xu-aluminium", "stable", 3, -1.0}, Ending{"xu-thin-wall-single", "stable", 3, -1.0},
        // Nothing is cut, or nothing chatters: nothing is moved.
        Ending{"air-cut", "stable", 0, 0.0}, Ending{"ford-stable", "stable", 0, 0.0},
        // No pocket is in reach at 477 rev/min: said, and nothing is moved.
        Ending{"ford-unstable", "no-stable-speed", 0, -1.0},
        // Three speeds are tried and the programmed one comes back.
        Ending{"caliskan-3", "no-stable-speed", 4, -1.0},
        // A sensor that rattles in its mount is no chatter, and nothing is moved on its word.
        Ending{"loose-sensor", "hold", 0, 0.0}),
    [](const auto& which) {
      std::string name(which.param.scenario);
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

// Each published method on its own paper's cut, without control: seconds from 20 % of the vibration being chatter to
// its alarm. Van Dijk's comes before that, as in his figure 9. Liao's window lasts 1.5 s, half as long again as the
// stable part of his second cut; it was not found at all where a force sensor's spindle orders did not count as a cut.
TEST_F(Simulate, EachMethodFindsTheChatterOfItsOwnPaper) {
  struct Own {
    const char *scenario, *detector;
    double latest;  // s
  };
  for (const Own& own : {Own{"van-dijk-ramp", "parametric", 0.02}, Own{"caliskan-1", "energy-ratio", 0.1},
                         Own{"caliskan-2", "energy-ratio", 0.1}, Own{"liao-2", "spectral", 1.7}}) {
    const std::string path = STILLCUT_SOURCE_DIR "/resources/scenarios/" + std::string(own.scenario) + ".toml";
    const json answer = json::parse(
        run({"simulate", path, "--detector", own.detector, "--strategy", "monitor", "--json"}), nullptr, false);
    ASSERT_TRUE(answer["alarm_delay_s"].is_number()) << own.scenario;
    EXPECT_LT(answer["alarm_delay_s"], own.latest) << own.scenario;
  }
}

TEST_F(Simulate, WritesASessionThatCanBeReadAnalysedAndConverted) {
  simulate({"--out", "cut.h5"});
  const json info = json::parse(run({"info", "cut.h5", "--json"}), nullptr, false);
  EXPECT_EQ(info["rate_hz"], 25600.0);
  EXPECT_EQ(info["frames"], 51200);
  EXPECT_TRUE(info["session"]["simulated"]);
  EXPECT_TRUE(info["session"]["truth"].contains("onset_20pct_s"));
  EXPECT_THAT(run({"info", "cut.h5", "--repair"}), testing::HasSubstr("nothing to repair"));

  const json again = json::parse(run({"analyze", "cut.h5", "--json"}), nullptr, false);
  EXPECT_GE(again["detectors"][0]["alarms"], 1);
  EXPECT_THAT(again["remarks"], testing::IsEmpty());  // the session knows teeth and speed

  run({"convert", "cut.h5", "converted.wav"});
  run({"convert", "cut.h5", "converted.csv"});
  EXPECT_EQ(json::parse(run({"info", "converted.wav", "--json"}))["frames"], 51200);
  EXPECT_EQ(json::parse(run({"info", "converted.csv", "--json"}))["frames"], 51200);
}

TEST_F(Simulate, WritesASoundFileInSi) {
  simulate({"--out", "cut.wav"});
  const json info = json::parse(run({"info", "cut.wav", "--json"}), nullptr, false);
  EXPECT_EQ(info["rate_hz"], 25600.0);
  EXPECT_EQ(info["frames"], 51200);
  EXPECT_EQ(info["channels"].size(), 2U);
  EXPECT_EQ(folder_.files(), 2U);  // nothing else beside the scenario
}

constexpr const char* kMachine =
    "version = 1\nmachine = \"M\"\noperator = \"Ada\"\n[tool]\nlabel = \"T12\"\nteeth = 4\ndiameter_mm = 12.0\n[cut]\n"
    "speed_rpm = 8500.0\nfeed_mm_min = 2720.0\n[source]\nid = \"simulated\"\n[source.settings]\n"
    "scenario = \"cut.toml\"\n[link]\nid = \"simulated\"\n[control]\ndetector = \"energy-ratio\"\n"
    "strategy = \"lobe-center\"\n";

TEST_F(Simulate, AProfileThatSaysSoIsRecordedUnderJobAndTool) {
  folder_.file("machine.toml", std::string(kMachine) + "[recording]\nfolder = \"kept\"\njob = \"Housing 7\"\n");
  run({"run", "--profile", "machine.toml", "--seconds", "0.5", "--flights", "flights"});
  run({"run", "--profile", "machine.toml", "--seconds", "0.5", "--flights", "flights", "--job", "Bracket"});
  for (const char* job : {"Housing 7", "Bracket"}) {
    const std::filesystem::path place = std::filesystem::path(folder_ / "kept") / job / "T12";
    ASSERT_TRUE(std::filesystem::is_directory(place)) << place;
    const std::string file = std::filesystem::directory_iterator(place)->path().string();
    const json info = json::parse(run({"info", file, "--json"}), nullptr, false);
    EXPECT_EQ(info["session"]["job"], job);
    EXPECT_EQ(info["session"]["operator"], "Ada");
    EXPECT_FALSE(info["session"]["started_utc"].get<std::string>().empty());
  }
}

TEST_F(Simulate, AProfileRunsOnTheSimulatedMachineAndRecords) {
  folder_.file("machine.toml", kMachine);
  const std::string said =
      run({"run", "--profile", "machine.toml", "--seconds", "1", "--record", "run.h5", "--flights", "flights"});
  EXPECT_THAT(said, testing::HasSubstr("authority is off"));
  EXPECT_THAT(said,
              testing::ContainsRegex("[0-9]+ blocks decided, half within .* ms of their last sample.* [0-9]+ dropped"));
  const json info = json::parse(run({"info", "run.h5", "--json"}), nullptr, false);
  EXPECT_TRUE(info["session"]["closed_cleanly"]);
  EXPECT_GE(info["length_s"], 0.9);
  EXPECT_EQ(info["session"]["commands"], 0);  // off: nothing is commanded
}

TEST_F(Simulate, WhatCannotBeRecordedIsSaidInOneLineAndTheCutIsWatched) {
  folder_.file("machine.toml", kMachine);
  for (const std::string path : {"/proc/run.h5", "lost/run.h5"}) {  // a share that is not there
    const Outcome ran = runCli(folder_ / "", {"run", "--profile", "machine.toml", "--seconds", "0.5", "--record", path,
                                              "--flights", "flights"});
    EXPECT_EQ(ran.exitCode, 3);
    EXPECT_THAT(ran.out, testing::HasSubstr("blocks decided"));
    EXPECT_THAT(ran.err, testing::HasSubstr(path));
    EXPECT_THAT(ran.err, testing::HasSubstr("monitoring goes on"));
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  }
}

TEST_F(Simulate, TheProfileThatComesWithTheProgramRuns) {
  const std::string profile = STILLCUT_SOURCE_DIR "/resources/profiles/simulated.toml";
  EXPECT_THAT(run({"run", "--profile", profile, "--seconds", "1", "--flights", "flights"}),
              testing::HasSubstr("authority is off"));
}

}  // namespace
}  // namespace stillcut::cli_test
