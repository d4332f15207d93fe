// The program's log: a run can be told from it afterwards, and a place that cannot be written stops nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "app/compose/scenario_rig.h"
#include "app/log/run_log.h"
#include "core/milling/simulation/scenario.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

using record::TempFolder;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// The demonstration, to its first move, with what `lowest` lets through.
std::string logOfDemonstration(LogLevel lowest) {
  const TempFolder folder;
  const std::string file = folder / "state/stillcut.log";
  const std::string path = STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml";
  const auto log = ProgramLog::open(file, lowest);
  EXPECT_TRUE(log.ok()) << log.error().line();
  const auto scenario = milling::loadScenario(path);
  EXPECT_TRUE(scenario.ok()) << scenario.error().line();
  ScenarioOptions options;
  options.watched = true;
  auto built = buildScenarioRig(*scenario, options);
  EXPECT_TRUE(built.ok()) << built.error().line();
  Rig& rig = *built->rig;
  RunLog run(*log);
  run.begin(rig, path);
  double seconds = 0.0;
  while (seconds < 8.0 && rig.advance()) {
    const Snapshot* snapshot = rig.read();
    run.look(rig, snapshot);
    if (snapshot != nullptr) seconds += snapshot->health.blockLength.value;
  }
  run.end(rig, rig.stop());
  return contentOf(file);
}

TEST(RunLog, TellsWhatRanWhatHappenedAndThatItEnded) {
  const std::string lines = logOfDemonstration(LogLevel::Info);
  EXPECT_THAT(lines,
              ContainsRegex("20[0-9][0-9]-[0-9][0-9]-[0-9][0-9] [0-9:.]+[+-][0-9:]+ \\[[0-9]+\\] info: run begins: "
                            "[^\n]*demo.toml, [0-9]+ channels at [0-9.e+]+ Hz\n"));
  EXPECT_THAT(lines, HasSubstr("info: machine: "));
  EXPECT_THAT(lines, ContainsRegex("[Cc]hatter"));
  EXPECT_THAT(lines, HasSubstr("info: run ends\n"));
}

TEST(RunLog, KeepsNothingBelowItsLevel) {
  const std::string lines = logOfDemonstration(LogLevel::Warning);
  EXPECT_THAT(lines, HasSubstr(" warning: chatter"));
  EXPECT_THAT(lines, Not(HasSubstr(" info: ")));
}

TEST(ProgramLog, SaysWhereItCannotBeWritten) {
  const TempFolder folder;
  folder.file("state", "a file, not a folder");
  const auto log = ProgramLog::open(folder / "state/stillcut.log", LogLevel::Info);
  ASSERT_FALSE(log.ok());
  EXPECT_THAT(log.error().line(), HasSubstr("state/stillcut.log"));
}

TEST(ProgramLog, BeginsANewFileWhenOneIsFullAndKeepsFourOlder) {
  const TempFolder folder;
  const auto log = ProgramLog::open(folder / "stillcut.log", LogLevel::Info);
  ASSERT_TRUE(log.ok());
  const std::string line(10'000, 'x');
  for (int k = 0; k < 1'300; ++k) log->write(LogLevel::Info, line);
  std::uintmax_t bytes = 0;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
    bytes += entry.file_size();
    ++files;
  }
  EXPECT_EQ(files, 5);
  EXPECT_LE(bytes, 10'000'000U);
}

TEST(ProgramLog, KnowsItsLevelsByName) {
  EXPECT_EQ(logLevelFrom("warning"), LogLevel::Warning);
  EXPECT_EQ(logLevelFrom("loud"), std::nullopt);
}

}  // namespace
}  // namespace stillcut::app
