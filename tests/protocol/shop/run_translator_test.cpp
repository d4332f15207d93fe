// What a shop is told of the lines of a run.
#include "app/shop/run_translator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/shop/run_lines.h"

namespace stillcut::shop {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::json;
using testing::RunLines;

std::vector<std::string> topics(const std::vector<ShopMessage>& told) {
  std::vector<std::string> all;
  all.reserve(told.size());
  for (const ShopMessage& m : told) all.push_back(m.topic);
  return all;
}

TEST(RunTranslator, TellsOfARunOnceAndKeepsIt) {
  RunTranslator translator;
  RunLines run;
  const auto told = translator.take(run.start());
  ASSERT_THAT(topics(told), ElementsAre("meta"));
  EXPECT_TRUE(told[0].retained);
  const json& meta = told[0].payload;
  EXPECT_EQ(meta["run"], testing::kBegan);
  EXPECT_EQ(meta["machine"], "Mill 3");
  EXPECT_EQ(meta["tool"], "T12");
  EXPECT_EQ(meta["profile_hash"], "0123456789abcdef");
  EXPECT_EQ(meta["channels"][0]["unit"], "m/s^2");
}

TEST(RunTranslator, TellsAStateWhenItChangesAndFeaturesEverySecond) {
  RunTranslator translator;
  RunLines run;
  translator.take(run.start());
  EXPECT_THAT(topics(translator.take(run.state("status", 1.0, "stable"))), ElementsAre("state", "features"));
  const auto second = translator.take(run.state("status", 2.0, "stable"));
  ASSERT_THAT(topics(second), ElementsAre("features"));
  EXPECT_FALSE(second[0].retained);
  const json& f = second[0].payload;
  EXPECT_EQ(f["utc_ms"], testing::kBegan + 2000);
  EXPECT_EQ(f["run"], testing::kBegan);
  EXPECT_EQ(f["rms"], 3.5);
  EXPECT_EQ(f["operator_feed_percent"], 90.0);
  EXPECT_EQ(f["actual_rpm"], 8498.0);
  EXPECT_EQ(f["judged_s"], 2.0);
  // Changes within the second bring no features where a status comes every second.
  EXPECT_THAT(topics(translator.take(run.state("change", 2.4, "not-judged"))), ElementsAre("state"));
  EXPECT_THAT(topics(translator.take(run.state("status", 3.0, "not-judged"))), ElementsAre("features"));
}

TEST(RunTranslator, AClockThatIsSetBackDoesNotSilenceTheFeatures) {
  RunTranslator translator;
  RunLines run;
  translator.take(run.start());
  EXPECT_THAT(topics(translator.take(run.state("change", 600.0, "stable"))), ElementsAre("state", "features"));
  EXPECT_THAT(topics(translator.take(run.state("change", 1.0, "stable"))), ElementsAre("features"));
  EXPECT_THAT(topics(translator.take(run.state("change", 1.5, "stable"))), IsEmpty());
}

TEST(RunTranslator, NotJudgedSaysWhy) {
  RunTranslator translator;
  RunLines run;
  translator.take(run.start());
  const auto told = translator.take(run.state("change", 0.5, "not-judged"));
  ASSERT_EQ(told[0].topic, "state");
  EXPECT_TRUE(told[0].retained);
  EXPECT_EQ(told[0].payload["state"], "not-judged");
  EXPECT_EQ(told[0].payload["reason"], "input-clipped");
}

TEST(RunTranslator, WithoutStatusLinesFeaturesAreOneASecondAtMost) {
  RunTranslator translator;
  RunLines run;
  translator.take(run.start());
  int features = 0;
  for (int k = 0; k < 100; ++k) {
    for (const std::string& topic :
         topics(translator.take(run.state("change", 0.1 * k, k % 2 == 0 ? "stable" : "not-judged"))))
      features += topic == "features" ? 1 : 0;
  }
  EXPECT_EQ(features, 10);
}

// An alarm has a begin and an end; onset that grows to chatter is one, and a moment not judged ends nothing.
TEST(RunTranslator, AnAlarmIsOneFromItsBeginToItsEnd) {
  RunTranslator translator;
  RunLines run;
  translator.take(run.start());
  translator.take(run.state("change", 1.0, "stable"));
  const auto begin = translator.take(run.state("change", 2.0, "onset", 912.0));
  ASSERT_THAT(topics(begin), ElementsAre("event/alarm", "state", "features"));
  EXPECT_EQ(begin[0].payload["edge"], "begin");
  EXPECT_EQ(begin[0].payload["frequency_hz"], 912.0);
  EXPECT_EQ(begin[0].payload["tool"], "T12");
  EXPECT_THAT(topics(translator.take(run.state("change", 2.1, "chatter", 915.0))), ElementsAre("state"));
  EXPECT_THAT(topics(translator.take(run.state("change", 2.2, "not-judged"))), ElementsAre("state"));
  const auto end = translator.take(run.state("change", 4.5, "stable"));
  ASSERT_EQ(end[0].topic, "event/alarm");
  EXPECT_EQ(end[0].payload["edge"], "end");
  EXPECT_EQ(end[0].payload["how"], "stable");
  EXPECT_NEAR(end[0].payload["duration_s"].get<double>(), 2.5, 1e-9);
  EXPECT_EQ(end[0].payload["frequency_hz"], 912.0);
}

TEST(RunTranslator, ARunThatDiesEndsItsAlarmWithTheNextOne) {
  RunTranslator translator;
  RunLines first, second(testing::kBegan + 60'000);
  translator.take(first.start("T1"));
  translator.take(first.state("change", 2.0, "chatter", 912.0));
  translator.take(first.state("status", 5.0, "chatter", 912.0));
  const auto told = translator.take(second.start("T2"));
  ASSERT_THAT(topics(told), ElementsAre("event/alarm", "meta"));
  EXPECT_EQ(told[0].payload["tool"], "T1");
  EXPECT_EQ(told[0].payload["how"], "run-ended");
  // It was seen for three seconds; the rest of the minute nobody saw.
  EXPECT_EQ(told[0].payload["utc_ms"], testing::kBegan + 5'000);
  EXPECT_NEAR(told[0].payload["duration_s"].get<double>(), 3.0, 1e-9);
  EXPECT_EQ(told[1].payload["tool"], "T2");
}

TEST(RunTranslator, AnInterventionHasABeforeAndAnAfter) {
  RunTranslator translator;
  RunLines run;
  translator.take(run.start());
  json line = run.event(3.0, "info", "chatter-ended");
  line["intervention"] = {{"quiet", true},
                          {"outcome", "helped"},
                          {"time_to_stable_s", 0.8},
                          {"frequency_hz", 912.0},
                          {"speed_before_rpm", 8500.0},
                          {"speed_after_rpm", 9120.0},
                          {"energy_ratio_before", 0.6},
                          {"energy_ratio_after", 0.02},
                          {"rms_before", 20.0},
                          {"rms_after", 3.0},
                          {"marked_mm", 12.0}};
  const auto told = translator.take(line);
  ASSERT_THAT(topics(told), ElementsAre("event/intervention", "event/note"));
  EXPECT_EQ(told[0].payload["before"]["speed_rpm"], 8500.0);
  EXPECT_EQ(told[0].payload["after"]["speed_rpm"], 9120.0);
  EXPECT_EQ(told[0].payload["outcome"], "helped");
}

TEST(RunTranslator, EventsGoByWhatTheyAre) {
  RunTranslator translator;
  RunLines run;
  translator.take(run.start());
  EXPECT_THAT(topics(translator.take(run.event(1.0, "fault", "recorder-stopped"))), ElementsAre("event/fault"));
  EXPECT_THAT(topics(translator.take(run.event(1.1, "warning", "dropped-blocks"))), ElementsAre("event/warning"));
  EXPECT_THAT(topics(translator.take(run.event(1.2, "info", "back-to-programmed"))), ElementsAre("event/note"));
  const auto refused = translator.take(run.event(1.3, "info", "advice-refused"));
  ASSERT_THAT(topics(refused), ElementsAre("event/advice"));
  EXPECT_EQ(refused[0].payload["answer"], "refused");
  EXPECT_EQ(refused[0].payload["advised_rpm"], 8800.0);
  json marker = run.line("marker", 1.4);
  marker["label"] = "false-alarm";
  marker["author"] = "Ada";
  const auto told = translator.take(marker);
  ASSERT_THAT(topics(told), ElementsAre("event/marker"));
  EXPECT_EQ(told[0].payload["author"], "Ada");
}

TEST(RunTranslator, SamplesThatStopAreNotJudgedAndAFault) {
  RunTranslator translator;
  RunLines run;
  translator.take(run.start());
  translator.take(run.state("change", 1.0, "chatter", 900.0));
  json line = run.line("stopped", 5.0);
  line["sentence"] = "samples stopped: unplugged";
  const auto told = translator.take(line);
  ASSERT_THAT(topics(told), ElementsAre("event/alarm", "event/fault", "state"));
  EXPECT_EQ(told[2].payload["state"], "not-judged");
  EXPECT_EQ(told[2].payload["reason"], "samples-stopped");
}

TEST(RunTranslator, MissingLinesAreAFault) {
  RunTranslator translator;
  RunLines run;
  translator.take(run.start());
  run.line("note", 1.0);
  run.line("note", 1.1);
  const auto told = translator.take(run.state("status", 2.0, "stable"));
  ASSERT_EQ(told[0].topic, "event/fault");
  EXPECT_EQ(told[0].payload["reason"], "lines-lost");
  EXPECT_EQ(told[0].payload["lines"], 2);
}

TEST(RunTranslator, ARestartTellsNothingTwice) {
  RunTranslator before, after;
  RunLines run;
  before.take(run.start());
  before.take(run.state("status", 1.0, "chatter", 900.0));
  after.recall(json::parse(before.memory().dump()));
  EXPECT_THAT(topics(after.take(run.state("status", 2.0, "chatter", 900.0))), ElementsAre("features"));
  EXPECT_EQ(after.take(run.state("change", 3.0, "stable"))[0].payload["edge"], "end");
}

TEST(RunTranslator, WhatItDoesNotKnowItPassesOver) {
  RunTranslator translator;
  RunLines run;
  EXPECT_THAT(translator.take(json::object()), IsEmpty());
  EXPECT_THAT(translator.take({{"type", 7}, {"utc_ms", "x"}}), IsEmpty());
  translator.take(run.start());
  EXPECT_THAT(translator.take(run.line("poem", 1.0)), IsEmpty());
  EXPECT_THAT(topics(translator.take({{"type", "status"}, {"machine", 3}, {"advice", "none"}})),
              ElementsAre("state", "features"));
}

}  // namespace
}  // namespace stillcut::shop
