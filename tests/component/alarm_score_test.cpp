// The score: what counts as found, missed, false and late, by cases small enough to be counted by hand.
#include "core/evaluate/alarm_score.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/compose/recording_score.h"
#include "core/evaluate/recorded_truth.h"

namespace stillcut::evaluate {
namespace {

TruthSpan span(double begin, double end, const std::string& label) {
  return {Seconds(begin), Seconds(end), kindOf(label), label};
}
Alarm alarm(double begin, double end) {
  return {Seconds(begin), Seconds(end)};
}

TEST(AlarmScore, CountsFoundMissedAndFalse) {
  const std::vector<TruthSpan> truth{span(0, 10, "stable"), span(10, 20, "chatter"), span(20, 30, "idle"),
                                     span(30, 40, "chatter"), span(40, 50, "transition_1")};
  const AlarmScore s = scoreAlarms(truth, {alarm(3, 4), alarm(12, 15), alarm(16, 20.5), alarm(45, 46)});
  EXPECT_EQ(s.spans, 2);
  EXPECT_EQ(s.found, 1);
  EXPECT_EQ(s.missed(), 1);
  EXPECT_EQ(s.alarms, 4);
  EXPECT_EQ(s.falseAlarms, 1) << "one in the stable cut; the one that lingers half a second is none";
  EXPECT_DOUBLE_EQ(s.quiet.value, 20.0);
  EXPECT_DOUBLE_EQ(s.falsePerHour(), 180.0);
  EXPECT_DOUBLE_EQ(s.delayQuantile(0.5), 2.0);
}

TEST(AlarmScore, AnAlarmThatComesFarTooEarlyOrStaysTooLongIsFalseAsWell) {
  const std::vector<TruthSpan> truth{span(0, 10, "stable"), span(10, 20, "chatter"), span(20, 30, "stable")};
  const AlarmScore early = scoreAlarms(truth, {alarm(5, 15)});
  EXPECT_EQ(early.found, 1);
  EXPECT_EQ(early.falseAlarms, 1);
  EXPECT_DOUBLE_EQ(early.delayQuantile(0.5), 0.0);
  EXPECT_EQ(scoreAlarms(truth, {alarm(9.6, 15)}).falseAlarms, 0);
  EXPECT_EQ(scoreAlarms(truth, {alarm(12, 25)}).falseAlarms, 1);
}

TEST(AlarmScore, SaysNothingWhereNothingIsKnown) {
  const AlarmScore s = scoreAlarms({}, {alarm(1, 2)});
  EXPECT_EQ(s.falseAlarms, 0);
  EXPECT_TRUE(std::isnan(s.falsePerHour()));
  EXPECT_TRUE(std::isnan(s.delayQuantile(0.95)));
}

TEST(AlarmScore, QuantilesAreOfAllFilesTogether) {
  AlarmScore all;
  for (int i = 1; i <= 20; ++i) {
    all.add(scoreAlarms({span(10, 20, "chatter")}, {alarm(10 + i * 0.1, 19)}));
  }
  EXPECT_EQ(all.found, 20);
  EXPECT_NEAR(all.delayQuantile(0.5), 1.0, 1e-9);
  EXPECT_NEAR(all.delayQuantile(0.95), 1.9, 1e-9);
}

TEST(AlarmScore, LabelsOfTablesAndOfTouchesHaveTheirKind) {
  for (const char* label : {"chatter", "chatter_onset", "true-alarm", "heard"}) {
    EXPECT_EQ(kindOf(label), SpanKind::Chatter) << label;
  }
  for (const char* label : {"stable", "idle", "entry_stable", "exit_stable", "spindle_runup", "false-alarm"}) {
    EXPECT_EQ(kindOf(label), SpanKind::Quiet) << label;
  }
  for (const char* label : {"entry", "exit", "transition", "transition_speed", "note", "?"}) {
    EXPECT_EQ(kindOf(label), SpanKind::Ignored) << label;
  }
}

TEST(AlarmList, APauseOfTheSameChatterIsNoNewAlarm) {
  AlarmList list;
  Verdict v;
  v.valid = true;
  for (int i = 0; i < 300; ++i) {
    const double t = i * 0.01;
    const bool on = (t >= 0.5 && t < 0.8) || (t >= 0.9 && t < 1.0) || t >= 2.0;
    v.state = on ? CutState::Chatter : CutState::Stable;
    list.observe(Seconds(t), v);
  }
  ASSERT_EQ(list.alarms().size(), 2U);
  EXPECT_NEAR(list.alarms()[0].begin.value, 0.5, 1e-9);
  EXPECT_NEAR(list.alarms()[0].end.value, 0.99, 1e-9);
  EXPECT_NEAR(list.alarms()[1].begin.value, 2.0, 1e-9);
}

TEST(Truth, TouchesSpeakOfTheAlarmThatHadJustBegun) {
  const Instant begin = instantFromNs(5'000'000'000);
  const auto at = [begin](double s) { return begin + toDuration(Seconds(s)); };
  const std::vector<Marker> markers{
      {0, at(1.0), at(1.0), "true-alarm", "", "", 0},  // nothing had alarmed yet
      {1, at(6.0), at(6.0), "false-alarm", "", "", 0}, {2, at(12.0), at(12.0), "true-alarm", "", "", 0},
      {3, at(20.0), at(20.0), "heard", "", "", 0},     {4, at(30.0), at(40.0), "stable", "", "", 0},
      {5, at(41.0), at(41.0), "note", "", "", 0}};
  const std::vector<TruthSpan> spans = spansOfMarkers(markers, begin, {alarm(4, 5), alarm(11, 13)});
  ASSERT_EQ(spans.size(), 4U);
  EXPECT_EQ(spans[0].kind, SpanKind::Quiet);
  EXPECT_NEAR(spans[0].begin.value, 4.0, 1e-9);
  EXPECT_NEAR(spans[0].end.value, 5.0, 1e-9);
  EXPECT_EQ(spans[1].kind, SpanKind::Chatter);
  EXPECT_NEAR(spans[1].begin.value, 11.0, 1e-9);
  EXPECT_NEAR(spans[2].end.value, 20.0, 1e-9);
  EXPECT_EQ(spans[3].kind, SpanKind::Quiet);
}

TEST(Truth, TheRatioOfASimulatedCutGivesItsSpans) {
  std::vector<Seconds> times;
  std::vector<double> ratios;
  for (int i = 0; i < 1000; ++i) {
    const double t = i * 0.01;
    times.emplace_back(t);
    ratios.push_back(t < 1.0 ? 0.7 : t < 4.0 ? 0.001 : t < 4.5 ? 0.2 : t < 8.0 ? 2.0 : t < 9.0 ? 0.05 : 0.001);
  }
  ratios[600] = 0.05;  // a beat
  const std::vector<TruthSpan> spans = spansOfRatio(times, ratios, {Seconds(4.0), Seconds(4.2)});
  ASSERT_EQ(spans.size(), 3U);
  EXPECT_EQ(spans[0].kind, SpanKind::Quiet) << "the transient of the entry is no chatter";
  EXPECT_NEAR(spans[0].begin.value, 0.0, 1e-9);
  EXPECT_NEAR(spans[0].end.value, 3.99, 1e-9);
  EXPECT_EQ(spans[1].kind, SpanKind::Chatter);
  EXPECT_NEAR(spans[1].begin.value, 4.2, 1e-9);
  EXPECT_NEAR(spans[1].end.value, 7.99, 1e-9);
  EXPECT_EQ(spans[2].kind, SpanKind::Quiet);
  EXPECT_NEAR(spans[2].begin.value, 9.0, 1e-9);
  const double never = std::nan("");
  const double always = std::numeric_limits<double>::infinity();
  const std::vector<TruthSpan> stable = spansOfRatio(times, ratios, {Seconds(always), Seconds(never)});
  ASSERT_EQ(stable.size(), 1U);
  EXPECT_EQ(stable[0].kind, SpanKind::Quiet);
}

TEST(Truth, WhatWasStoppedWhileItGrewIsNeitherChatterNorQuiet) {
  std::vector<Seconds> times;
  std::vector<double> ratios;
  for (int i = 0; i < 1000; ++i) {
    times.emplace_back(i * 0.01);
    ratios.push_back(i < 400 || i >= 420 ? 0.0 : 0.15);
  }
  const double never = std::nan("");
  const std::vector<TruthSpan> spans = spansOfRatio(times, ratios, {Seconds(never), Seconds(never)});
  ASSERT_EQ(spans.size(), 3U);
  EXPECT_EQ(spans[1].kind, SpanKind::Grew);
  EXPECT_NEAR(spans[1].begin.value, 4.0, 1e-9);
  EXPECT_NEAR(spans[1].end.value, 4.19, 1e-9);
  const AlarmScore right = scoreAlarms(spans, {alarm(4.05, 4.6)});
  EXPECT_EQ(right.falseAlarms, 0);
  EXPECT_EQ(right.missed(), 0);
  EXPECT_EQ(scoreAlarms(spans, {alarm(7.0, 7.1)}).falseAlarms, 1);
}

TEST(Truth, WhatIsToldOfATimeAfterTheEndCountsNothing) {
  const std::vector<TruthSpan> told{{Seconds(0.0), Seconds(5000.0), SpanKind::Quiet, "stable"},
                                    {Seconds(6000.0), Seconds(6001.0), SpanKind::Chatter, "chatter"}};
  const AlarmScore score = scoreAlarms(told, {}, Seconds(7.8));
  EXPECT_DOUBLE_EQ(score.quiet.value, 7.8);
  EXPECT_EQ(score.spans, 0) << "nobody could have found it";
}

TEST(Truth, LabelsAreReadInLettersOfAnySize) {
  EXPECT_EQ(kindOf("Chatter"), SpanKind::Chatter);
  EXPECT_EQ(kindOf("STABLE"), SpanKind::Quiet);
}

TEST(WhatIf, IsSaidInWords) {
  AlarmScore before, after;
  before.alarms = 5;
  before.falseAlarms = 4;
  after.alarms = 3;
  after.falseAlarms = 2;
  EXPECT_EQ(app::whatIfSentence("energy-ratio", before, after),
            "energy-ratio would have alarmed 3 times, 2 of them marked false; before 5 times, 4 of them marked false");
  EXPECT_EQ(app::whatIfSentence("spectral", after, {}),
            "spectral would have alarmed not at all; before 3 times, 2 of them marked false");
}

}  // namespace
}  // namespace stillcut::evaluate
