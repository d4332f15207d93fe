// What is said about a recording: judged time, channels that are no vibration, and the sentences.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "core/evaluate/answer_text.h"
#include "core/evaluate/audacity_labels.h"
#include "core/evaluate/channel_survey.h"
#include "core/evaluate/judged_time.h"
#include "core/evaluate/scenario_reader.h"
#include "core/evaluate/speed_answer.h"
#include "tests/support/temp_folder.h"

namespace stillcut::evaluate {
namespace {

constexpr Seconds kBlock{0.1};

Verdict verdictOf(CutState state, CutPhase phase, bool valid = true, Reason reason = {}) {
  Verdict v;
  v.state = state;
  v.phase = phase;
  v.valid = valid;
  v.reason = reason;
  return v;
}

TEST(JudgedTime, IsTheSteadyCutAndNothingElse) {
  JudgedTime time;
  for (int i = 0; i < 20; ++i) time.observe(verdictOf(CutState::AirCutting, CutPhase::AirCutting), kBlock);
  for (int i = 0; i < 2; ++i) time.observe(verdictOf(CutState::Stable, CutPhase::Entry), kBlock);
  const Reason learning{ReasonCode::Learning, {0.3}};
  for (int i = 0; i < 3; ++i) time.observe(verdictOf(CutState::Stable, CutPhase::Steady, true, learning), kBlock);
  for (int i = 0; i < 30; ++i) time.observe(verdictOf(CutState::Stable, CutPhase::Steady), kBlock);
  EXPECT_NEAR(time.length().value, 5.5, 1e-9);
  EXPECT_NEAR(time.air().value, 2.0, 1e-9);
  EXPECT_NEAR(time.judged().value, 3.0, 1e-9);
  ASSERT_EQ(time.notJudged().size(), 2U);
  EXPECT_EQ(time.notJudged()[0].reason.code, ReasonCode::Learning);
  EXPECT_EQ(time.finding(), Finding::NoChatter);
}

TEST(JudgedTime, LessThanHalfOfTheCutIsNotJudgedAndAnAlarmCountsAllTheSame) {
  JudgedTime time;
  const Reason first{ReasonCode::InputDead, {0.0}}, second{ReasonCode::InputDead, {1.0}};
  for (int i = 0; i < 4; ++i) time.observe(verdictOf(CutState::Stable, CutPhase::Steady), kBlock);
  for (int i = 0; i < 2; ++i) time.observe(verdictOf(CutState::Stable, CutPhase::Steady, false, first), kBlock);
  for (int i = 0; i < 3; ++i) time.observe(verdictOf(CutState::Stable, CutPhase::Steady, false, second), kBlock);
  EXPECT_EQ(time.finding(), Finding::NotJudged);
  ASSERT_EQ(time.notJudged().size(), 2U) << "two channels are two reasons";
  EXPECT_EQ(channelOf(time.notJudged()[0].reason), 1);
  time.observe(verdictOf(CutState::Onset, CutPhase::Entry), kBlock);
  EXPECT_EQ(time.finding(), Finding::Chatter);
}

TEST(JudgedTime, AirAloneIsNotJudged) {
  JudgedTime time;
  EXPECT_EQ(time.finding(), Finding::NotJudged);
  time.observe(verdictOf(CutState::AirCutting, CutPhase::AirCutting), kBlock);
  EXPECT_EQ(time.finding(), Finding::NotJudged);
}

// Two seconds at 1 kHz, a column each.
class Survey : public testing::Test {
 protected:
  using Column = std::function<double(int)>;
  std::vector<LeftOutChannel> survey(const std::vector<Column>& columns, Hertz told = {}, int rows = 2000) {
    const std::string path = folder_ / "table.csv";
    std::ofstream out(path);
    out << "Time (s)";
    for (std::size_t c = 0; c < columns.size(); ++c) out << ",c" << c << " (m/s^2)";
    for (int i = 0; i < rows; ++i) {
      out << "\n" << 1e-3 * i;
      for (const Column& column : columns) out << "," << column(i);
    }
    out << "\n";
    out.close();
    auto reader = openCut(path);
    EXPECT_TRUE(reader.ok()) << reader.error().line();
    auto left = surveyChannels(**reader, told);
    EXPECT_TRUE(left.ok());
    return left.value();
  }
  static double vibration(int i) { return std::sin(0.7 * i) + 0.3 * std::sin(2.1 * i); }
  static double tacho(int i) { return i % 20 < 3 ? 5.0 : 0.0; }
  record::TempFolder folder_;
};

TEST_F(Survey, WhatIsNoVibrationIsNamed) {
  const auto left = survey({vibration, [](int) { return 9.81; }, [](int i) { return 1000.0 + i; }, tacho,
                            [](int i) { return 18.0 * (i % 20); }});
  ASSERT_EQ(left.size(), 4U);
  for (int c = 0; c < 4; ++c) EXPECT_EQ(left[static_cast<std::size_t>(c)].index, c + 1);
  EXPECT_EQ(left[1].name, "c2");
  EXPECT_THAT(text(left[0].why), testing::HasSubstr("constant"));
  EXPECT_THAT(text(left[1].why), testing::HasSubstr("row number"));
  EXPECT_THAT(text(left[2].why), testing::HasSubstr("tacho"));
  EXPECT_THAT(text(left[3].why), testing::HasSubstr("angle"));
}

// A clipped sine, one that drifts, one that dies, and one that begins late are vibrations: others judge those.
TEST_F(Survey, AVibrationThatIsNotInOrderStays) {
  EXPECT_TRUE(survey({vibration, [](int i) { return std::clamp(6.0 * vibration(i), -1.0, 1.0); },
                      [](int i) { return 0.01 * i + vibration(i); }, [](int i) { return i < 500 ? vibration(i) : 0.0; },
                      [](int i) { return i < 1500 ? 0.0 : vibration(i); }})
                  .empty());
}

TEST_F(Survey, WhereNothingIsAVibrationAllStay) {
  EXPECT_TRUE(survey({[](int) { return 1.0; }, tacho}).empty());
}

// Five seconds beside a sound channel. A spindle of 3000 rev/min shakes a part at 50 Hz as well.
TEST_F(Survey, MainsHumBesideAVibrationIsNamedUnlessTheSpindleMayForceIt) {
  const Column hum = [](int i) { return std::sin(kTwoPi * 50.0 * 1e-3 * i) + 0.1 * vibration(i); };
  const auto left = survey({vibration, hum}, {}, 5000);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].index, 1);
  EXPECT_THAT(text(left[0].why), testing::HasSubstr("mains hum of 50 Hz"));
  EXPECT_EQ(survey({vibration, hum}, Hertz(100.0), 5000).size(), 1U);
  EXPECT_TRUE(survey({vibration, hum}, Hertz(50.5), 5000).empty());
  EXPECT_TRUE(survey({vibration, hum}, Hertz(24.8), 5000).empty());
  EXPECT_TRUE(survey({hum, hum}, {}, 5000).empty());
}

// In the air every sensor may measure hum alone.
TEST_F(Survey, HumThatTheCutDrownsIsNoFault) {
  const Column cut = [](int i) {
    return 0.1 * std::sin(kTwoPi * 50.0 * 1e-3 * i) + (i > 2500 ? vibration(i) : 0.001 * vibration(i));
  };
  EXPECT_TRUE(survey({vibration, cut}, {}, 6000).empty());
}

RecordingAnswer chatterAnswer() {
  RecordingAnswer a;
  a.finding = Finding::Chatter;
  a.length = Seconds(8.0);
  a.judged = Seconds(6.0);
  a.air = Seconds(2.0);
  a.alarms = 1;
  a.firstAlarm = Seconds(3.3);
  a.chatter = Hertz(1502.0);
  a.advice = answerSpeed({{Hertz(1502.0), 2, Rpm(9500.0), {}, nullptr}, {}});
  return a;
}

TEST(Answer, NamesChatterSpeedsAndDepth) {
  const AnswerWriting english = englishWriting();
  RecordingAnswer a = chatterAnswer();
  EXPECT_EQ(text(findingSentence(a, english)), "chatter at 1502 Hz from 3.3 s on");
  EXPECT_EQ(text(adviceSentence(a.advice, english)),
            "try 9,010 or 10,010 rpm (5 or 4½ waves of 1502 Hz between two teeth instead of 4.74), or less depth");
  a.advice.depthLimit = Metres(1.25e-3);
  EXPECT_THAT(text(adviceSentence(a.advice, english)), testing::EndsWith("or less than 1.25 mm of depth"));
  EXPECT_EQ(text(judgedSentence(a, english)), "judged 6.0 of 8.0 s; the rest: 2.0 s of air cutting");
}

TEST(Answer, SaysWhyNoSpeedFollows) {
  const AnswerWriting english = englishWriting();
  const auto said = [&](const SpeedRequest& request) { return text(adviceSentence(answerSpeed(request), english)); };
  EXPECT_THAT(said({{Hertz(1502.0), 0, Rpm(9500.0), {}, nullptr}, {}}), testing::HasSubstr("number of teeth"));
  EXPECT_THAT(said({{Hertz(1502.0), 2, Rpm(), {}, nullptr}, {}}), testing::HasSubstr("spindle speed is not known"));
  StableSpeeds none;
  none.depth = Metres(2e-3);
  none.largestStableDepth = Metres(0.5e-3);
  none.largestDepthSpeed = Rpm(9100.0);
  EXPECT_THAT(said({{Hertz(1502.0), 2, Rpm(9500.0), {}, &none}, {}}),
              testing::AllOf(testing::HasSubstr("2.00 mm"), testing::HasSubstr("0.50 mm at 9100 rpm")));
  // 30 waves between two teeth: pockets nearer than a spindle can be set.
  EXPECT_THAT(said({{Hertz(3020.0), 2, Rpm(3000.0), {}, nullptr}, {}}), testing::HasSubstr("rpm apart"));
}

TEST(Answer, NotJudgedNamesTheReason) {
  RecordingAnswer a;
  a.length = Seconds(8.0);
  a.notJudged = {{{ReasonCode::InputDead, {2.0}}, Seconds(8.0)}};
  EXPECT_EQ(text(findingSentence(a, englishWriting())), "not judged: channel 2 delivers a constant");
  a.notJudged.clear();
  a.air = a.length;
  EXPECT_EQ(text(findingSentence(a, englishWriting())), "not judged: no cut was measured");
}

TEST(AudacityLabels, HaveTheAlarmItsBandAndWhatWasNotJudged) {
  AudacityLabels labels;
  double t = 0.0;
  const auto go = [&](int blocks, const Verdict& v) {
    for (int i = 0; i < blocks; ++i) labels.observe(Seconds(t += kBlock.value), kBlock, v);
  };
  go(10, verdictOf(CutState::Stable, CutPhase::Steady, false, {ReasonCode::InputDead, {1.0}}));
  go(10, verdictOf(CutState::Stable, CutPhase::Steady));
  Verdict chatter = verdictOf(CutState::Chatter, CutPhase::Steady);
  chatter.frequency = Hertz(1000.0);
  chatter.severity = Ratio(0.5);
  go(5, chatter);
  go(1, verdictOf(CutState::Stable, CutPhase::Steady));  // a pause of the same alarm
  go(5, chatter);
  EXPECT_EQ(labels.text(),
            "0.000000\t1.000000\tnot judged: channel 1 delivers a constant\n"
            "2.000000\t3.100000\tchatter 1000 Hz\n\\\t980.000\t1020.000\n");
}

}  // namespace
}  // namespace stillcut::evaluate
