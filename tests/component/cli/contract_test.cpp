// What scripts rely on: one schema in every object, several strategies at once, series with machine and cut; and
// figures of the papers from one command.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tests/component/cli/in_folder.h"
#include "tests/component/cli/made_files.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Contract : public InFolder {
 protected:
  void SetUp() override { writeScenario(folder_ / "cut.toml"); }
  std::vector<json> lines(const std::vector<std::string>& arguments) {
    std::vector<json> objects;
    std::istringstream in(run(arguments));
    for (std::string line; std::getline(in, line);) {
      objects.push_back(json::parse(line, nullptr, false));
      EXPECT_EQ(objects.back()["schema"], "stillcut-cli/1") << line;
      EXPECT_EQ(objects.back()["command"], arguments.front()) << line;
    }
    return objects;
  }
};

TEST_F(Contract, SeveralStrategiesAreALineEachWithASeriesEach) {
  std::filesystem::create_directory(folder_ / "series");
  const std::vector<json> answers = lines({"simulate", "--strategy", "monitor,lobe-center", "cut.toml", "--detector",
                                           "spectral", "--series", "series", "--json"});
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0]["strategy"], "monitor");
  EXPECT_EQ(answers[1]["strategy"], "lobe-center");
  EXPECT_EQ(answers[1]["type"], "answer");
  for (const char* strategy : {"monitor", "lobe-center"}) {
    const std::string series = content("series/" + std::string(strategy) + ".csv");
    const std::string head = series.substr(0, series.find('\n'));
    EXPECT_THAT(head, testing::StartsWith("t,spectral.peak,"));
    EXPECT_THAT(head, HasSubstr(",spectral.state,spectral.valid,spectral.speed_rpm,machine.speed_rpm,"));
    EXPECT_THAT(head, testing::EndsWith(",cut.depth_mm,cut.vibration_m_s2,cut.chatter_ratio"));
    const std::string last = series.substr(series.rfind('\n', series.size() - 2) + 1);
    EXPECT_EQ(std::count(last.begin(), last.end(), ','), std::count(head.begin(), head.end(), ','));
  }
  EXPECT_EQ(runCli(folder_ / "", {"simulate", "cut.toml", "--strategy", "a,monitor", "--series", "series"}).exitCode,
            2);
  EXPECT_THAT(runCli(folder_ / "", {"simulate", "cut.toml", "--strategy", "monitor,lobe-center", "--out", "a.wav"}).err,
              HasSubstr("name one strategy"));
}

TEST_F(Contract, AdviceAndLobesSayTheirSchema) {
  const std::vector<json> advice = lines({"advise", "cut.toml", "--depth", "1.5", "--json"});
  ASSERT_EQ(advice.size(), 1U);
  EXPECT_EQ(advice[0]["depth_mm"], 1.5);
  ASSERT_FALSE(advice[0]["pockets"].empty());
  EXPECT_TRUE(advice[0]["pockets"][0].contains("quietest"));
  const json lobes = json::parse(run({"lobes", "cut.toml", "--speeds", "8000:8200:100", "--json"}), nullptr, false);
  EXPECT_EQ(lobes["schema"], "stillcut-cli/1");
  EXPECT_EQ(lobes["type"], "answer");
}

TEST_F(Contract, EveryOtherAnswerSaysItsSchemaToo) {
  writeSound(folder_ / "cut.wav", {cutSignal(true), cutSignal(false)});
  std::vector<float> written, heard;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> noise(-0.5F, 0.5F);
  for (int i = 0; i < 20'000; ++i) {
    written.push_back(noise(random));
    heard.push_back(i < 10 ? 0.0F : -0.4F * written[static_cast<std::size_t>(i) - 10]);
  }
  writeSound(folder_ / "path.wav", {written, heard});
  folder_.file("TRUTH.csv", "file,t0_s,t1_s,label,programmed_rpm,teeth,note\ncut.wav,1.2,2.5,chatter,8500,4,\n");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"info", "cut.wav", "--json"},
                                                    {"score", "cut.wav", "--json"},
                                                    {"path", "path.wav", "--json"},
                                                    {"materials", "--json"},
                                                    {"materials", "1045", "--json"}}) {
    const json answer = json::parse(run(arguments), nullptr, false);
    EXPECT_EQ(answer["schema"], "stillcut-cli/1") << spelled(arguments);
    EXPECT_EQ(answer["command"], arguments.front());
    EXPECT_EQ(answer["type"], "answer");
  }
  const json info = json::parse(run({"info", "cut.wav", "--json"}), nullptr, false);
  EXPECT_TRUE(info["started_utc_ms"].is_null()) << "what is not known is null";
  EXPECT_TRUE(info["channels"][0]["sensitivity_mv"].is_null());
}

TEST_F(Contract, FiguresAreMadeWithTheirNumbers) {
  const std::vector<json> made = lines({"reproduce", "liao-4", "caliskan-6", "xu-3.7", "--out", "made", "--json"});
  ASSERT_EQ(made.size(), 3U);
  double heard = 0.0, quarter = 0.0, late = 0.0;
  for (const json& n : made[0]["numbers"]) {
    if (n["name"] == "chatter frequency") heard = n["ours"];
    if (n["name"] == "growth after 2 s, nu 0.25") quarter = n["ours"];
    if (n["name"] == "growth after 2 s, nu 0.75") late = n["ours"];
  }
  // By derivation: 33.3 to 33.4 Hz, a decay of about 15.4 1/s at a quarter, growth at three quarters.
  EXPECT_NEAR(heard, 33.35, 0.3);
  EXPECT_NEAR(quarter, -15.4, 1.5);
  EXPECT_GT(late, 0.0);
  EXPECT_NEAR(made[1]["numbers"][0]["ours"], -3.0, 0.02);
  for (const json& one : made) {
    ASSERT_FALSE(one["files"].empty());
    for (const std::string file : one["files"]) EXPECT_GT(content(file).size(), 50U) << file;
  }
  EXPECT_THAT(content("made/liao-4.svg"), HasSubstr("</svg>"));
  EXPECT_THAT(content("made/liao-4.csv"), testing::StartsWith("panel,curve,x,y\n"));
  EXPECT_THAT(content("made/xu-3.7-speed-rules.csv"), testing::StartsWith("error,NX,"));
  const Outcome unknown = runCli(folder_ / "", {"reproduce", "liao-5", "--out", "made"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'liao-4'?"));
}

// The page names every figure.
TEST_F(Contract, ThePageListsTheFigures) {
  std::ifstream page(STILLCUT_SOURCE_DIR "/resources/manual/papers.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  std::istringstream list(run({"reproduce", "--list"}));
  int figures = 0;
  for (std::string line; std::getline(list, line); ++figures) {
    EXPECT_THAT(text, HasSubstr("| `" + line.substr(0, line.find(' ')) + "` |"));
  }
  EXPECT_GE(figures, 35);
}

}  // namespace
}  // namespace stillcut::cli_test
