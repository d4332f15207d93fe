// The contract of `analyze` for people and scripts: the answer, exit codes, several recordings, pipes, labels.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/component/cli/in_folder.h"
#include "tests/component/cli/made_files.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

class Answer : public InFolder {
 protected:
  void SetUp() override {
    writeSound(folder_ / "chatter.wav", {cutSignal(true)});
    writeSound(folder_ / "stable.wav", {cutSignal(false)});
  }
  static Arguments told(Arguments words) {
    for (const char* word : {"--teeth", "4", "--speed", "8500", "--quantity", "acceleration"}) words.emplace_back(word);
    return words;
  }
  Outcome outcome(const Arguments& words) { return runCli(folder_ / "", told(words)); }
  static std::vector<json> lines(const std::string& text) {
    std::vector<json> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) all.push_back(json::parse(line, nullptr, false));
    return all;
  }
};

TEST_F(Answer, ExitCodesSayWhatWasFound) {
  EXPECT_EQ(outcome({"analyze", "stable.wav"}).exitCode, 0);
  EXPECT_EQ(outcome({"analyze", "chatter.wav"}).exitCode, 1);
  EXPECT_EQ(outcome({"analyze", "none.wav"}).exitCode, 2);
  writeSound(folder_ / "air.wav", {std::vector<float>(20000, 0.0F)});
  const Outcome silence = outcome({"analyze", "air.wav", "--json"});
  EXPECT_EQ(silence.exitCode, 0);
  const json answer = lines(silence.out).at(0)["answer"];
  EXPECT_EQ(answer["finding"], "not-judged");
  EXPECT_TRUE(answer["alarms"].is_null()) << "not judged is never 0";
  EXPECT_EQ(outcome({"analyze", "air.wav", "--strict"}).exitCode, 1);
  EXPECT_THAT(outcome({"analyze", "air.wav"}).out, testing::StartsWith("air.wav: not judged: "));
}

TEST_F(Answer, SpeedsFollowFromTeethSpeedAndFrequency) {
  const json answer = lines(outcome({"analyze", "chatter.wav", "--json"}).out).at(0)["answer"];
  const json& advice = answer["advice"];
  const double chatter = answer["frequency_hz"];
  ASSERT_GE(advice["speeds"].size(), 2U);
  for (const json& speed : advice["speeds"]) {
    EXPECT_NEAR(speed["speed_rpm"].get<double>(), 60.0 * chatter / (kTeeth * speed["waves"].get<double>()), 1e-3);
  }
  EXPECT_NEAR(advice["present_rpm"], kSpeed, 0.01 * kSpeed);
  const std::string text = outcome({"analyze", "chatter.wav"}).out;
  EXPECT_THAT(text, HasSubstr("  try "));
  EXPECT_THAT(text, HasSubstr("or less depth"));
  EXPECT_GT(answer["judged_s"], 1.0);
  EXPECT_LT(answer["judged_s"].get<double>() + answer["air_s"].get<double>(), kLength);
  EXPECT_GT(answer["hears_to_hz"], kChatter);
}

TEST_F(Answer, AColumnThatIsNoVibrationIsLeftOutByName) {
  const std::vector<float> signal = cutSignal(true);
  std::vector<float> rows(signal.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = 1e-5F * static_cast<float>(i);
  writeSound(folder_ / "three.wav", {rows, signal, std::vector<float>(signal.size(), 0.25F)});
  const json answer = lines(outcome({"analyze", "three.wav", "--json"}).out).at(0)["answer"];
  EXPECT_EQ(answer["finding"], "chatter");
  ASSERT_EQ(answer["left_out"].size(), 2U);
  EXPECT_EQ(answer["left_out"][0]["channel"], 0);
  EXPECT_EQ(answer["left_out"][1]["channel"], 2);
  EXPECT_EQ(answer["channels"][0]["channel"], 1) << "counted as in the file";
}

TEST_F(Answer, AColumnThatWasNotReadAtAllIsNamedWithTheReason) {
  const std::vector<float> signal = cutSignal(true);
  std::string table = "Sampling rate: 8000 Hz\na (g),Score\n";
  for (const float value : signal) table += std::to_string(value) + ",0.5\n";
  folder_.file("score.csv", table);
  const json leftOut = lines(outcome({"analyze", "score.csv", "--json"}).out).at(0)["answer"]["left_out"];
  ASSERT_EQ(leftOut.size(), 1U);
  EXPECT_TRUE(leftOut[0]["channel"].is_null());
  EXPECT_EQ(leftOut[0]["name"], "Score");
  EXPECT_THAT(leftOut[0]["reason"].get<std::string>(), HasSubstr("has no unit"));
  EXPECT_THAT(outcome({"analyze", "score.csv"}).out, HasSubstr("'Score' is left out: it has no unit"));
}

TEST_F(Answer, SeveralRecordingsAreALineEachAndOneBadOneLosesNoOther) {
  const Outcome all = outcome({"analyze", "stable.wav", "none.wav", "chatter.wav", "--json"});
  EXPECT_EQ(all.exitCode, 2);
  const std::vector<json> answers = lines(all.out);
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0]["answer"]["finding"], "no-chatter");
  EXPECT_EQ(answers[1]["type"], "error");
  EXPECT_THAT(answers[1]["error"].get<std::string>(), HasSubstr("none.wav"));
  EXPECT_EQ(answers[2]["answer"]["finding"], "chatter");
  for (const json& answer : answers) EXPECT_EQ(answer["schema"], "stillcut-cli/1");
  const Outcome one = outcome({"analyze", "stable.wav", "chatter.wav", "--events", "e.json"});
  EXPECT_EQ(one.exitCode, 2);
  EXPECT_THAT(one.err, HasSubstr("needs a folder"));
  std::filesystem::create_directory(folder_ / "out");
  EXPECT_EQ(outcome({"analyze", "stable.wav", "chatter.wav", "--events", "out", "--labels", "out"}).exitCode, 1);
  EXPECT_THAT(content("out/chatter.wav.labels.txt"), HasSubstr("chatter 9"));
  EXPECT_EQ(content("out/stable.wav.labels.txt"), "");
  EXPECT_TRUE(json::parse(content("out/stable.wav.events.json")).is_array());
}

TEST_F(Answer, ChangesComeAsLinesBeforeTheAnswer) {
  const std::vector<json> all = lines(outcome({"analyze", "chatter.wav", "--json", "--lines"}).out);
  ASSERT_GE(all.size(), 4U);
  EXPECT_EQ(all.back()["type"], "answer");
  EXPECT_EQ(all.front()["type"], "change");
  EXPECT_EQ(all[all.size() - 2]["state"], "chatter");
  EXPECT_EQ(outcome({"analyze", "chatter.wav", "--lines"}).exitCode, 2);
}

TEST_F(Answer, ARecordingMayComeThroughAPipe) {
  const std::string command = "cd '" + std::string(folder_ / "") +
                              "' && cat chatter.wav | " STILLCUT_CLI
                              " analyze - --teeth 4 --speed 8500 --json > piped.json; "
                              "test $? = 1 && ! " STILLCUT_CLI " analyze - < /dev/null 2> empty.txt";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(json::parse(content("piped.json"), nullptr, false)["answer"]["finding"], "chatter");
  EXPECT_THAT(content("empty.txt"), HasSubstr("standard input: is empty"));
}

// What happens to be called like the recording is somebody else's.
TEST_F(Answer, AFileOfTheSameNameIsNotReadUnasked) {
  std::filesystem::rename(folder_ / "chatter.wav", folder_ / "cut_acc.wav");
  for (const char* name : {"cut.json", "cut_acc.json", "cut_truth.csv"}) folder_.file(name, "{\"teeth\": \"no\" [");
  const Outcome unasked = outcome({"analyze", "cut_acc.wav", "--json"});
  EXPECT_EQ(unasked.exitCode, 1) << unasked.err;
  EXPECT_EQ(unasked.err, "");
  EXPECT_TRUE(lines(unasked.out).at(0)["truth"].is_null());
  folder_.file("cut_truth.csv", "t_s,ratio_chatter_to_forced\n0,0\n1,0\n2,1\n");
  folder_.file("cut.json", "{\"teeth\": \"four\", \"spindle_rpm\": [1]}");
  const Outcome asked = outcome({"analyze", "cut_acc.wav", "--truth"});
  EXPECT_EQ(asked.exitCode, 1) << asked.err;
  EXPECT_THAT(asked.out, HasSubstr("truth from"));
}

TEST_F(Answer, AProfileBringsToolSpeedAndLobes) {
  folder_.file("mill.toml", "version = 1\nmachine = \"M\"\n[tool]\nteeth = 4\n[cut]\nspeed_rpm = 8500.0\n");
  const Outcome run = runCli(folder_ / "", {"analyze", "chatter.wav", "--profile", "mill.toml", "--json"});
  ASSERT_EQ(run.exitCode, 1) << run.err;
  const json answer = lines(run.out).at(0);
  EXPECT_EQ(answer["answer"]["advice"]["teeth"], 4);
  for (const json& speed : answer["answer"]["advice"]["speeds"]) {
    EXPECT_LE(speed["speed_rpm"].get<double>(), 1.2 * kSpeed * 1.001) << "beyond the profile's override";
  }
}

}  // namespace
}  // namespace stillcut::cli_test
