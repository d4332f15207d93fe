// analyze: what it finds, and the files scripts read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tests/component/cli/made_files.h"
#include "tests/component/cli/program.h"
#include "tests/support/temp_folder.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

constexpr double kFrequencyTolerance = 5.0;  // [Hz], a line looked at for a tenth of a second or more

std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Analyze : public testing::Test {
 protected:
  // Runs to its end without complaint and parses what it printed.
  json analyze(const std::string& recording, Arguments more = {}) {
    Arguments arguments{"analyze", recording, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = runCli(folder_ / "", arguments);
    EXPECT_EQ(run.err, "") << spelled(arguments);
    json answer = json::parse(run.out, nullptr, false);
    EXPECT_EQ(run.exitCode, answer["answer"]["finding"] == "chatter" ? 1 : 0) << spelled(arguments);
    return answer;
  }
  static Arguments told(Arguments more = {}) {
    Arguments all{"--teeth", "4", "--speed", "8500", "--quantity", "acceleration"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  void expectChatter(const json& answer) {
    const json& detector = answer["detectors"][0];
    EXPECT_GE(detector["alarms"], 1);
    EXPECT_NEAR(detector["frequency_hz"], kChatter, kFrequencyTolerance);
    EXPECT_GE(detector["first_alarm_s"], kOnset);
    EXPECT_LE(detector["first_alarm_s"], kOnset + 0.25);  // grown to full size by then
  }
  json events(const std::string& recording, Arguments more) {
    more.insert(more.end(), {"--events", "events.json"});
    analyze(recording, more);
    return json::parse(contentOf(folder_ / "events.json"), nullptr, false);
  }

  record::TempFolder folder_;
};

TEST_F(Analyze, NamesTheChatterAndStaysQuietWithoutIt) {
  writeSound(folder_ / "chatter.wav", {cutSignal(true)});
  writeSound(folder_ / "stable.wav", {cutSignal(false)});
  expectChatter(analyze("chatter.wav", told()));
  const json quiet = analyze("stable.wav", told());
  EXPECT_EQ(quiet["detectors"][0]["alarms"], 0);
  EXPECT_TRUE(quiet["detectors"][0]["first_alarm_s"].is_null());
  EXPECT_THAT(quiet["remarks"], testing::IsEmpty());
}

// What the program set itself is told with its reason; --set shows in both.
TEST_F(Analyze, TellsWhatItSetItselfAndWhy) {
  writeSound(folder_ / "stable.wav", {cutSignal(false)});
  const auto own = [this](const Arguments& more, const std::string& key) {
    const json answer = analyze("stable.wav", told(more));
    for (const json& value : answer["own_values"]) {
      if (value["key"] == key) return value;
    }
    return json();
  };
  const json harmonics = own({}, "energy-ratio.harmonics");
  EXPECT_EQ(harmonics["value"], 40);
  EXPECT_EQ(harmonics["why"], "as many as the sampling rate hears at this speed");
  EXPECT_NEAR(own({}, "conditioner.speed")["value"], 8500.0, 0.03 * 8500.0);
  EXPECT_EQ(own({}, "conditioner.speed")["unit"], "rpm");
  EXPECT_GT(own({}, "energy-ratio.floor")["value"], 0.0);
  EXPECT_EQ(own({"--set", "energy-ratio.harmonics=20"}, "energy-ratio.harmonics")["why"], "as set");
  const Outcome plain = runCli(folder_ / "", {"analyze", "stable.wav", "--teeth", "4", "--speed", "8500"});
  EXPECT_THAT(plain.out, testing::Not(testing::HasSubstr("set by itself")));
  const Outcome asked = runCli(folder_ / "", {"analyze", "stable.wav", "--teeth", "4", "--speed", "8500", "--values"});
  EXPECT_THAT(asked.out, testing::HasSubstr("energy-ratio.harmonics"));
  EXPECT_THAT(asked.out, testing::HasSubstr("as many as the sampling rate hears"));
}

TEST_F(Analyze, ScoresEveryDetectorWhereTheTruthIsKnown) {
  std::vector<float> second = cutSignal(true);  // another sensor: later, with noise of its own
  std::rotate(second.begin(), second.end() - 3, second.end());
  std::mt19937 random(9);
  std::normal_distribution<float> noise(0.0F, 2e-3F);
  for (float& x : second) x += noise(random);
  writeSound(folder_ / "cut.wav", {cutSignal(true), second});
  EXPECT_TRUE(analyze("cut.wav", told())["truth"].is_null());
  std::ofstream(folder_ / "TRUTH.csv") << "file,t0_s,t1_s,label\ncut.wav,0.2,1.1,stable\ncut.wav,1.3,2.5,chatter\n";
  EXPECT_TRUE(analyze("cut.wav", told())["truth"].is_null()) << "nobody has asked for it";
  const json answer = analyze("cut.wav", told({"--detector", "all", "--truth"}));
  EXPECT_THAT(answer["truth"].get<std::string>(), testing::EndsWith("TRUTH.csv"));
  ASSERT_EQ(answer["detectors"].size(), 4U);
  for (const json& detector : answer["detectors"]) {
    const json& score = detector["score"];
    EXPECT_EQ(score["spans"], 1) << detector;
    EXPECT_EQ(score["found"], 1) << detector;
    EXPECT_EQ(score["false_alarms"], 0) << detector;
    EXPECT_LT(score["delay_median_s"], 0.3) << detector;
    EXPECT_NEAR(detector["frequency_hz"], kChatter, 0.02 * kChatter) << detector;
  }
  const Outcome table = runCli(folder_ / "", {"analyze", "cut.wav", "--teeth", "4", "--speed", "8500", "--quantity",
                                              "acceleration", "--detector", "all", "--truth"});
  EXPECT_THAT(table.out, testing::HasSubstr("found      delay   f error  false"));
  // Every row ends where the heading does: a table, whatever stands in it.
  std::istringstream lines(table.out);
  std::string line;
  std::vector<std::size_t> widths;
  while (std::getline(lines, line)) {
    if (line.starts_with("detector") || !widths.empty()) widths.push_back(line.size());
  }
  EXPECT_EQ(widths, std::vector<std::size_t>(5, widths.front()));
}

// A file that is called the same by chance, and not what a case's is.
TEST_F(Analyze, WhatStandsBesideARecordingIsNotReadUnasked) {
  writeSound(folder_ / "case_acc.wav", {cutSignal(true)});
  std::ofstream(folder_ / "case.json") << R"({"teeth": "four", "spindle_rpm": []})";
  std::ofstream(folder_ / "case_truth.csv") << "t_s,ratio_chatter_to_forced\n0,0\n1,0\n2,1\n";
  EXPECT_TRUE(analyze("case_acc.wav", told())["truth"].is_null());
  EXPECT_FALSE(analyze("case_acc.wav", told({"--truth"}))["truth"].is_null()) << "numbers that are none are not told";
}

// A simulated case beside its truth: delay, frequency error and false alarms of every detector side by side.
TEST_F(Analyze, ScoresTheFrequencyOfACaseAsWell) {
  std::vector<float> second = cutSignal(true);
  std::rotate(second.begin(), second.end() - 3, second.end());
  writeSound(folder_ / "case_acc.wav", {cutSignal(true), second});
  std::ofstream truth(folder_ / "case_truth.csv");
  truth << "t_s,ratio_chatter_to_forced\n";
  for (int i = 0; i < 250; ++i) truth << 0.01 * i << "," << (0.01 * i < kOnset ? 0.0 : 1.0) << "\n";
  truth.close();
  const json about{{"teeth", 4},
                   {"spindle_rpm", 8500.0},
                   {"onset_1pct_s", kOnset},
                   {"onset_20pct_s", kOnset},
                   {"chatter_hz_at_onset", kChatter}};
  std::ofstream(folder_ / "case.json") << about;
  const json answer = analyze("case_acc.wav", told({"--detector", "all", "--truth"}));
  ASSERT_EQ(answer["detectors"].size(), 4U);
  for (const json& detector : answer["detectors"]) {
    const double error = detector["frequency_hz"].get<double>() / kChatter - 1.0;
    EXPECT_NEAR(detector["score"]["frequency_error"], error, 1e-9) << detector;
    EXPECT_LT(std::abs(error), 0.02) << detector;
  }
}

TEST_F(Analyze, EverySoundFormatKeepsItsRateAndItsChatter) {
  const std::pair<const char*, int> formats[] = {
      {"u8.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_U8},   {"s16.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16},
      {"s24.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_24},  {"s32.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_32},
      {"f32.wav", SF_FORMAT_WAV | SF_FORMAT_FLOAT},   {"f64.wav", SF_FORMAT_WAV | SF_FORMAT_DOUBLE},
      {"ext.wav", SF_FORMAT_WAVEX | SF_FORMAT_PCM_24}};
  for (const auto& [name, format] : formats) {
    SCOPED_TRACE(name);
    writeSound(folder_ / name, {cutSignal(true)}, format);
    const json answer = analyze(name, told());
    EXPECT_EQ(answer["rate_hz"], kRate);
    EXPECT_NEAR(answer["length_s"], kLength, 1e-9);
    expectChatter(answer);
  }
}

TEST_F(Analyze, EventsHaveTheirFieldsInOrderOfTime) {
  writeSound(folder_ / "cut.wav", {cutSignal(true)});
  const json list = events("cut.wav", told());
  ASSERT_TRUE(list.is_array());
  ASSERT_GE(list.size(), 3U);
  double last = 0.0;
  std::vector<std::string> states;
  for (const json& event : list) {
    std::vector<std::string> keys;
    for (const auto& item : event.items()) keys.push_back(item.key());
    EXPECT_THAT(keys,
                testing::UnorderedElementsAre("t", "detector", "state", "phase", "valid", "reason", "frequency_hz",
                                              "frequency_sd_hz", "severity", "kind", "early_warning"));
    EXPECT_EQ(event["detector"], "energy-ratio");
    EXPECT_GE(event["t"], last);
    EXPECT_THAT(event["state"].get<std::string>(), testing::AnyOf("air", "stable", "onset", "chatter"));
    EXPECT_THAT(event["phase"].get<std::string>(), testing::AnyOf("air", "runup", "entry", "steady", "exit"));
    EXPECT_THAT(event["kind"].get<std::string>(), testing::AnyOf("hopf", "flip", "forced", "unknown"));
    EXPECT_TRUE(event["valid"].is_boolean());
    EXPECT_TRUE(event["early_warning"].is_boolean());
    EXPECT_TRUE(event["reason"].is_string());
    last = event["t"];
    states.push_back(event["state"]);
  }
  EXPECT_LE(last, kLength + 1e-6);
  EXPECT_EQ(states.front(), "air");
  EXPECT_EQ(states.back(), "chatter");
}

TEST_F(Analyze, SeriesHasOneRowPerBlockAndTheNamedColumns) {
  writeSound(folder_ / "cut.wav", {cutSignal(true)});
  analyze("cut.wav", told({"--series", "series.csv"}));
  std::istringstream table(contentOf(folder_ / "series.csv"));
  std::string line;
  ASSERT_TRUE(std::getline(table, line));
  EXPECT_TRUE(line.starts_with("t,energy-ratio.er,energy-ratio.frequency_hz")) << line;
  const auto columns = std::count(line.begin(), line.end(), ',');
  EXPECT_THAT(line, testing::EndsWith("energy-ratio.state,energy-ratio.valid,energy-ratio.speed_rpm"));
  int rows = 0;
  double t = 0.0;
  while (std::getline(table, line)) {
    ++rows;
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    EXPECT_GT(std::stod(line), t);
    t = std::stod(line);
  }
  EXPECT_NEAR(t, kLength, 1e-9);
  EXPECT_EQ(rows, 500);  // blocks of 64 samples, 5 ms
}

TEST_F(Analyze, TextWithTimesAndTextWithARateSayTheSame) {
  writeTable(folder_ / "times.csv", cutSignal(true), "Time (s),a (m/s^2)");
  writeTable(folder_ / "plain", cutSignal(true), "");
  const json withTimes = analyze("times.csv", {"--teeth", "4", "--speed", "8500"});
  const json withRate = analyze("plain", told({"--rate", "12800"}));
  EXPECT_EQ(withTimes["rate_hz"], kRate);
  expectChatter(withTimes);
  EXPECT_EQ(withTimes["detectors"], withRate["detectors"]);
}

TEST_F(Analyze, ChannelsAreChosenFromZeroInTheOrderGiven) {
  writeSound(folder_ / "two.wav", {cutSignal(false), cutSignal(true)});
  EXPECT_EQ(analyze("two.wav", told())["channels"], 2);
  const json first = analyze("two.wav", told({"--channel", "0"}));
  EXPECT_EQ(first["channels"], 1);
  EXPECT_EQ(first["detectors"][0]["alarms"], 0);
  expectChatter(analyze("two.wav", told({"--channel", "1"})));
  expectChatter(analyze("two.wav", told({"--channel", "1,0"})));
}

TEST_F(Analyze, ASpeedLogStandsForTheSpeed) {
  writeSound(folder_ / "cut.wav", {cutSignal(true)});
  folder_.file("speed.csv", "t,rpm\n0,8500\n1.0,8500\n2.5,8500\n");
  const json logged = analyze("cut.wav", {"--teeth", "4", "--quantity", "acceleration", "--speed-log", "speed.csv"});
  expectChatter(logged);
  EXPECT_THAT(logged["remarks"], testing::IsEmpty());
  EXPECT_NEAR(logged["detectors"][0]["spindle_hz"], kSpeed / 60.0, 0.2);
}

TEST_F(Analyze, SaysWhatNobodyToldIt) {
  writeSound(folder_ / "cut.wav", {cutSignal(true)});
  const json answer = analyze("cut.wav");
  ASSERT_EQ(answer["remarks"].size(), 2U);
  EXPECT_THAT(answer["remarks"][0].get<std::string>(), testing::HasSubstr("--teeth"));
  EXPECT_THAT(answer["remarks"][1].get<std::string>(), testing::HasSubstr("--speed"));
  const Outcome text = runCli(folder_ / "", {"analyze", "cut.wav"});
  EXPECT_LE(text.exitCode, 1);
  EXPECT_THAT(text.out, testing::HasSubstr("speed not given"));
}

TEST_F(Analyze, SettingsComeFromTheCommandLineAFileOrAProfile) {
  writeSound(folder_ / "cut.wav", {cutSignal(true)});
  folder_.file("shy.toml", "[energy-ratio]\nchatter = 0.9\n");
  folder_.file("profile.toml",
               "version = 1\nmachine = \"M\"\n[control]\ndetector = \"energy-ratio\"\n"
               "[parameters.energy-ratio]\nchatter = 0.9\n");
  const auto chatterTime = [&](const Arguments& more) {
    return analyze("cut.wav", told(more))["detectors"][0]["chatter_time_s"].get<double>();
  };
  EXPECT_GT(chatterTime({}), 0.5);
  EXPECT_EQ(chatterTime({"--set", "energy-ratio.chatter=0.9"}), 0.0);  // chatter holds 80 % of the energy at most
  EXPECT_EQ(chatterTime({"--config", "shy.toml"}), 0.0);
  EXPECT_EQ(chatterTime({"--config", "profile.toml"}), 0.0);
  EXPECT_GT(chatterTime({"--config", "shy.toml", "--set", "energy-ratio.chatter=0.2"}), 0.5);  // the nearer word counts
}

TEST_F(Analyze, EveryDetectorRunsSideBySide) {
  writeSound(folder_ / "cut.wav", {cutSignal(true)});
  const json answer = analyze("cut.wav", told({"--detector", "all"}));
  ASSERT_GE(answer["detectors"].size(), 1U);
  EXPECT_EQ(answer["detectors"][0]["detector"], "energy-ratio");  // in charge comes first
}

}  // namespace
}  // namespace stillcut::cli_test
