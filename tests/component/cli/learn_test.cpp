// The commands around what is learned from cuts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/component/cli/in_folder.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Learn : public InFolder {
 protected:
  std::vector<std::string> cut(double speed, double depth, const std::string& outcome) {
    std::vector<std::string> words{"learn",       "add",
                                   "--store",     "s",
                                   "--machine",   "Mill 3",
                                   "--tool",      "T12",
                                   "--teeth",     "3",
                                   "--diameter",  "12",
                                   "--immersion", "0.5",
                                   "--speed",     std::to_string(speed),
                                   "--depth",     std::to_string(depth),
                                   "--outcome",   outcome};
    if (outcome == "chatter") words.insert(words.end(), {"--frequency", "912"});
    return words;
  }
  std::vector<std::string> ask(const std::string& command) {
    return {"learn",  command, "--store",  "s",          "--machine", "Mill 3",
            "--tool", "T12",   "--speeds", "5000:12000", "--json"};
  }
};

TEST_F(Learn, KeepsCutsAndNamesTheNext) {
  run(cut(8500, 1.5, "chatter"));
  run(cut(7900, 1.5, "stable"));
  const json known = json::parse(run(ask("show")), nullptr, false);
  EXPECT_EQ(known["schema"], "stillcut-cli/1");
  EXPECT_EQ(known["cuts"], 2);
  EXPECT_EQ(known["chattered"], 1);
  EXPECT_EQ(known["limits"].size(), 60U);
  EXPECT_LE(known["limits"][7]["low_mm"], known["limits"][7]["median_mm"]);
  EXPECT_NEAR(known["modes"][0]["frequency_hz"]["median"].get<double>(), 912.0, 250.0);
  const json next = json::parse(run(ask("next")), nullptr, false);
  EXPECT_GE(next["speed_rpm"], 5000.0);
  EXPECT_LE(next["speed_rpm"], 12000.0);
  EXPECT_GT(next["bits"], 0.0);
}

TEST_F(Learn, ACutThatChattersHasNoMargin) {
  run({"simulate", STILLCUT_SOURCE_DIR "/resources/scenarios/caliskan-1.toml", "--strategy", "monitor", "--out",
       "c.h5"});
  const json info = json::parse(run({"info", "c.h5", "--json"}), nullptr, false);
  const json answer = json::parse(run({"analyze", "c.h5", "--json"}), nullptr, false);
  ASSERT_GE(answer["detectors"][0]["alarms"], 1) << info.dump();
  run(cut(8500, 1.5, "stable"));
  std::vector<std::string> words = ask("margin");
  words.insert(words.end(), {"c.h5", "--speed", "8500", "--depth", "1.5"});
  const json margin = json::parse(run(words), nullptr, false);
  EXPECT_EQ(margin["rise_mm"], json()) << margin.dump();
  EXPECT_EQ(margin["reason"], "the cut chatters");
}

TEST_F(Learn, MergesStoresWithoutDuplicates) {
  run(cut(8500, 1.5, "chatter"));
  run({"learn", "export", "a.jsonl", "--store", "s"});
  EXPECT_THAT(run({"learn", "import", "a.jsonl", "--store", "t"}), HasSubstr("1 cuts added, 0 were known"));
  EXPECT_THAT(run({"learn", "merge", "s", "--store", "t"}), HasSubstr("0 cuts added, 1 were known"));
  EXPECT_THAT(run({"learn", "list", "--store", "t"}), HasSubstr("0 stable, 1 with chatter"));
}

TEST_F(Learn, RefusesWithOneLine) {
  folder_.file("notes.txt", "a shop's notes, which are no store of cuts and no lines of evidence either");
  folder_.file("answer.json", "{\"schema\": \"stillcut-cli/1\", \"answer\": {\"finding\": \"not-judged\"}}");
  auto answered = cut(8500, 1.5, "stable");
  answered.resize(answered.size() - 2);
  auto neither = answered;
  answered.insert(answered.end(), {"--answer", "answer.json"});
  for (const std::vector<std::string>& words : {std::vector<std::string>{"learn", "list", "--store", "notes.txt"},
                                                {"learn", "import", "notes.txt", "--store", "s"},
                                                {"learn", "merge", "missing", "--store", "s"},
                                                answered,
                                                neither,
                                                {"learn", "show", "--store", "s", "--machine", "M", "--tool", "T"},
                                                {"learn", "sho"},
                                                {"learn", "list", "--stroe", "s"}}) {
    const Outcome outcome = runCli(folder_ / "", words);
    EXPECT_EQ(outcome.exitCode, 2) << spelled(words);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
}

}  // namespace
}  // namespace stillcut::cli_test
