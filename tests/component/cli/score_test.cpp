// stillcut-cli score: sessions with their own truth and touches, recordings with a TRUTH.csv, the shared ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/session/file/session_markers.h"
#include "core/session/file/session_reader.h"
#include "tests/component/cli/made_files.h"
#include "tests/component/cli/program.h"
#include "tests/support/kept_features.h"
#include "tests/support/temp_folder.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// A cut that chatters from kOnset on, and what is known about it.
void writeMarked(const record::TempFolder& folder) {
  writeSound(folder / "bad.wav", {cutSignal(true)});
  writeSound(folder / "good.wav", {cutSignal(false)});
  char text[400];
  std::snprintf(text, sizeof text,
                "file,t0_s,t1_s,label,programmed_rpm,teeth,note\n"
                "bad.wav,0.4,1.1,stable,%.0f,%d,\n"
                "bad.wav,%.2f,2.5,chatter,%.0f,%d,\"loud, really\"\n"
                "good.wav,0.4,2.5,stable,%.0f,%d,\n",
                kSpeed, kTeeth, kOnset, kSpeed, kTeeth, kSpeed, kTeeth);
  folder.file("TRUTH.csv", text);
}

TEST(Score, AFolderIsHeldAgainstItsTableOfTruth) {
  const record::TempFolder folder;
  writeMarked(folder);
  writeSound(folder / "unknown.wav", {cutSignal(false)});
  const Outcome outcome = runCli(folder / "", {"score", ".", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const json answer = json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(answer.is_object()) << outcome.out;
  EXPECT_EQ(answer["files"].size(), 2U);
  EXPECT_EQ(answer["without_truth"].size(), 1U);
  const json& energy = answer["detectors"]["energy-ratio"];
  EXPECT_EQ(energy["spans"], 1);
  EXPECT_EQ(energy["found"], 1);
  EXPECT_EQ(energy["missed"], 0);
  EXPECT_EQ(energy["false_alarms"], 0);
  EXPECT_NEAR(energy["quiet_s"], 0.7 + 2.1, 1e-9);
  EXPECT_GT(energy["delay_median_s"], 0.0);
  EXPECT_LT(energy["delay_median_s"], 0.5);
  const Outcome table = runCli(folder / "", {"score", ".", "--files", "--detector", "energy-ratio"});
  ASSERT_EQ(table.exitCode, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("2 recording(s) with truth, 1 without"));
  EXPECT_THAT(table.out, HasSubstr("energy-ratio        1      1       0      0"));
  EXPECT_THAT(table.out, HasSubstr("unknown.wav: no truth"));
}

// As spreadsheets save it: with a byte order mark, and parted by semicolons.
TEST(Score, ATableOfTruthIsReadOrRefusedAndNeverPassedOver) {
  const record::TempFolder folder;
  writeSound(folder / "CUT.WAV", {cutSignal(false)});
  folder.file("TRUTH.csv",
              "\xEF\xBB\xBF"
              "file,t0_s,t1_s,label\nCUT.WAV,0.4,2.0,Stable\n");
  const Outcome marked = runCli(folder / "", {"score", ".", "--json"});
  ASSERT_EQ(marked.exitCode, 0) << marked.err;
  EXPECT_EQ(json::parse(marked.out, nullptr, false)["files"].size(), 1U);
  folder.file("TRUTH.csv", "file;t0_s;t1_s;label\nCUT.WAV;0.4;2.0;stable\n");
  const Outcome parted = runCli(folder / "", {"score", ".", "--json"});
  EXPECT_EQ(parted.exitCode, 2);
  EXPECT_THAT(parted.err, HasSubstr("TRUTH.csv:1: has no column 'file'"));
}

TEST(Score, AChangedThresholdIsSaidInWords) {
  const record::TempFolder folder;
  writeMarked(folder);
  const Outcome outcome =
      runCli(folder / "", {"score", "bad.wav", "--detector", "energy-ratio", "--set", "energy-ratio.chatter=0.9"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("with energy-ratio.chatter=0.9:\n"));
  EXPECT_THAT(outcome.out,
              testing::ContainsRegex("energy-ratio would have alarmed .*; before once, none of them marked false"));
}

TEST(Score, ASessionKnowsItsOwnTruthAndTheOperatorsTouches) {
  const record::TempFolder folder;
  writeScenario(folder / "cut.toml");
  ASSERT_EQ(runCli(folder / "", {"simulate", "cut.toml", "--strategy", "monitor", "--out", "cut.h5"}).exitCode, 0);
  const Outcome own = runCli(folder / "", {"score", "cut.h5", "--detector", "energy-ratio", "--json"});
  ASSERT_EQ(own.exitCode, 0) << own.err;
  const json simulated = json::parse(own.out)["detectors"]["energy-ratio"];
  EXPECT_GE(simulated["spans"], 1);
  EXPECT_GE(simulated["found"], 1);
  EXPECT_EQ(simulated["false_alarms"], 0);

  // The machinist says that the alarm just given was none.
  const std::string path = folder / "cut.h5";
  const auto counts = record::countSession(path);
  ASSERT_TRUE(counts.ok());
  const Instant late = counts->begin + std::chrono::milliseconds(1900);
  ASSERT_TRUE(record::addMarker(path, {0, late, late, "false-alarm", "operator", "", 0}).ok());
  const Outcome touched = runCli(folder / "", {"score", "cut.h5", "--detector", "energy-ratio", "--json"});
  ASSERT_EQ(touched.exitCode, 0) << touched.err;
  const json marked = json::parse(touched.out)["detectors"]["energy-ratio"];
  EXPECT_EQ(marked["spans"], 0);
  EXPECT_EQ(marked["false_alarms"], 1);
  // Somebody listened to the whole cut: one false alarm in all of it, not in the half second that it lasted.
  EXPECT_NEAR(marked["quiet_s"].get<double>(), 2.0, 0.1);
  EXPECT_NEAR(marked["false_per_hour"].get<double>(), 1800.0, 90.0);
}

TEST(Score, ANoteLeavesTheSimulationsTruth) {
  const record::TempFolder folder;
  writeScenario(folder / "cut.toml");
  ASSERT_EQ(runCli(folder / "", {"simulate", "cut.toml", "--strategy", "monitor", "--out", "cut.h5"}).exitCode, 0);
  const std::string path = folder / "cut.h5";
  const Outcome before = runCli(folder / "", {"score", "cut.h5", "--detector", "energy-ratio", "--json"});
  const auto counts = record::countSession(path);
  ASSERT_TRUE(counts.ok());
  const Instant at = counts->begin + std::chrono::milliseconds(500);
  ASSERT_TRUE(record::addMarker(path, {0, at, at + std::chrono::seconds(1), "note", "engineer", "coolant", 0}).ok());
  const Outcome after = runCli(folder / "", {"score", "cut.h5", "--detector", "energy-ratio", "--json"});
  EXPECT_EQ(after.out, before.out);
}

// Nothing was there to be found, so nothing was missed.
TEST(Score, AHistoryOfFeaturesIsNotScoredAndSaysWhy) {
  const record::TempFolder folder;
  writeScenario(folder / "cut.toml");
  ASSERT_EQ(runCli(folder / "", {"simulate", "cut.toml", "--strategy", "monitor", "--out", "cut.h5"}).exitCode, 0);
  const std::string history = folder / "history.h5";
  test::keepFeatures(folder / "cut.h5", history, Seconds(0.1));
  const auto counts = record::countSession(history);
  ASSERT_TRUE(counts.ok());
  const Instant at = counts->begin + std::chrono::milliseconds(1500);
  ASSERT_TRUE(record::addMarker(history, {0, at, at, "true-alarm", "operator", "", 0}).ok());
  const Outcome scored = runCli(folder / "", {"score", ".", "--detector", "energy-ratio", "--json"});
  ASSERT_EQ(scored.exitCode, 0) << scored.err;
  const json answer = json::parse(scored.out);
  EXPECT_EQ(answer["files"].size(), 1U);
  EXPECT_EQ(answer["detectors"]["energy-ratio"]["missed"], 0);
  ASSERT_EQ(answer["unreadable"].size(), 1U);
  EXPECT_THAT(answer["unreadable"][0].get<std::string>(), HasSubstr("history.h5: holds no samples (a history of feat"));
  for (const char* command : {"score", "analyze"}) {
    const Outcome alone = runCli(folder / "", {command, "history.h5"});
    EXPECT_EQ(alone.exitCode, 2) << command;
    EXPECT_THAT(alone.err, HasSubstr("history.h5: holds no samples (a history of features"));
  }
}

// Its own export is a plain HDF5 file without truth, and a torn file is said; the rest is scored.
TEST(Score, OneBadFileOfAFolderIsNamedAndTheRestIsScored) {
  const record::TempFolder folder;
  writeScenario(folder / "cut.toml");
  ASSERT_EQ(runCli(folder / "", {"simulate", "cut.toml", "--strategy", "monitor", "--out", "cut.h5"}).exitCode, 0);
  ASSERT_EQ(runCli(folder / "", {"convert", "cut.h5", "plain.h5"}).exitCode, 0);
  std::ofstream(folder / "torn.h5", std::ios::binary) << "\x89HDF\r\n\x1a\n and no more";
  const Outcome scored = runCli(folder / "", {"score", ".", "--detector", "energy-ratio", "--json"});
  ASSERT_EQ(scored.exitCode, 0) << scored.err;
  const json told = json::parse(scored.out);
  EXPECT_EQ(told["files"].size(), 1U);
  ASSERT_EQ(told["without_truth"].size(), 1U);
  EXPECT_THAT(told["without_truth"][0].get<std::string>(), HasSubstr("plain.h5"));
  ASSERT_EQ(told["unreadable"].size(), 1U);
  EXPECT_THAT(told["unreadable"][0].get<std::string>(), HasSubstr("torn.h5"));
}

TEST(Score, WhatCannotBeScoredIsNamed) {
  const record::TempFolder folder;
  writeSound(folder / "cut.wav", {cutSignal(false)});
  for (const auto& [arguments, expected] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"score", "missing"}, "missing: there is no such file"},
           {{"score", "cut.wav"}, "cut.wav: nothing to score"},
           {{"score", "."}, ".: nothing to score"},
           {{"score", "cut.wav", "--set", "nonsense"}, "nonsense"},
           {{"score", "cut.wav", "--detector", "nonsense", "--teeth", "-1"}, "--teeth"}}) {
    const Outcome outcome = runCli(folder / "", arguments);
    EXPECT_EQ(outcome.exitCode, 2) << spelled(arguments);
    EXPECT_THAT(outcome.err, HasSubstr(expected));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  folder.file("TRUTH.csv", "file,t0_s,t1_s,label\ncut.wav,2.0,1.0,stable\n");
  const Outcome outcome = runCli(folder / "", {"score", "cut.wav"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_THAT(outcome.err, HasSubstr("TRUTH.csv:2: t0_s and t1_s must be times"));
}

TEST(Score, TheSharedCasesAreUnderstood) {
  const std::filesystem::path shared = std::filesystem::path(STILLCUT_SHARED_DIR) / "cases";
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << "not here: " << shared;
  const record::TempFolder folder;
  for (const char* name : {"c1_stable", "c2_hopf"}) {
    const Outcome outcome =
        runCli(folder / "", {"score", (shared / (std::string(name) + "_acc.wav")).string(), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json energy = json::parse(outcome.out)["detectors"]["energy-ratio"];
    const int chatters = std::string(name) == "c2_hopf" ? 1 : 0;
    EXPECT_EQ(energy["spans"], chatters) << name;
    EXPECT_EQ(energy["found"], chatters) << name;
  }
}

}  // namespace
}  // namespace stillcut::cli_test
