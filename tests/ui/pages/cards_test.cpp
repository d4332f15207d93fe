// The cards of the last interventions, as values: what was before, what came of it, what it has marked and costs.
#include <gtest/gtest.h>

#include "tests/ui/support/pictures.h"
#include "ui/models/strip_view.h"
#include "ui/models/verdict_view.h"

namespace stillcut::ui {
namespace {

TEST(Cards, NewestFirstAndNoMoreThanKept) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 6;
  for (std::uint64_t n = 2; n < 6; ++n) s.snapshot.interventions[n % kInterventionsShown].number = n;
  const std::vector<CardView> cards = makeCards(s.picture());
  ASSERT_EQ(cards.size(), 4U);
  EXPECT_EQ(cards.front().number, 5U);
  EXPECT_EQ(cards.back().number, 2U);
}

TEST(Cards, AnOnsetThatWasCaughtHasMarkedNothing) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 1;
  Intervention& i = s.snapshot.interventions[0];
  i.finished = i.quiet = true;
  i.feedBefore = fromMmPerMin(1400.0);
  i.commanded = s.snapshot.time;
  EXPECT_TRUE(makeCards(s.picture())[0].headline.contains(QStringLiteral("nothing marked")));
  EXPECT_TRUE(makeVerdictView(s.picture(), Trend::Unknown).marked.contains(QStringLiteral("no chatter")));
  i.marked = Metres(0.002);
  EXPECT_FALSE(makeCards(s.picture())[0].headline.contains(QStringLiteral("nothing")));
  s.snapshot.chatterTime = Seconds(0.2);
  s.snapshot.chatterLength = i.marked;
  EXPECT_FALSE(makeVerdictView(s.picture(), Trend::Unknown).marked.contains(QStringLiteral("no chatter")));
}

TEST(Cards, AnOnsetThatNobodyTouchedHasNoneAndCanBeJudgedAllTheSame) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 1;
  Intervention& i = s.snapshot.interventions[0];
  i.finished = i.quiet = true;
  i.feedBefore = fromMmPerMin(1400.0);
  EXPECT_TRUE(makeCards(s.picture()).empty());
  EXPECT_EQ(makeNewestAlarm(s.picture()).count, 1U);
  EXPECT_FALSE(makeNewestAlarm(s.picture()).time.isEmpty());
  i.marked = Metres(0.001);
  EXPECT_EQ(makeCards(s.picture()).size(), 1U) << "it has chattered";
}

TEST(Cards, WhereTheToolLeftTheAirIsNoResult) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 1;
  Intervention& i = s.snapshot.interventions[0];
  i.finished = true;
  i.marked = Metres(0.002);
  i.severityBefore = Ratio(0.9);
  i.severityAfter = Ratio(0.01);
  i.vibrationBefore = 22.0;
  i.vibrationAfter = 0.1;
  const CardView card = makeCards(s.picture())[0];
  EXPECT_TRUE(card.vibration.contains(QStringLiteral("22"))) << card.vibration.toStdString();
  EXPECT_FALSE(card.vibration.contains(QChar(0x2192))) << "no after";
  EXPECT_FALSE(card.ratio.contains(QChar(0x2192))) << card.ratio.toStdString();
}

TEST(Cards, SayThatStillcutActsOnlyWhereItMay) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 1;
  s.snapshot.interventions[0].finished = false;
  s.snapshot.authority = Authority::Auto;
  EXPECT_TRUE(makeCards(s.picture())[0].headline.contains(QStringLiteral("acting")));
  s.snapshot.authority = Authority::Off;
  EXPECT_TRUE(makeCards(s.picture())[0].headline.contains(QStringLiteral("going on")));
}

TEST(Cards, SayWhenAMoveDidNotHelpAndThatAutoHasEnded) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 1;
  Intervention& i = s.snapshot.interventions[0];
  i.frequency = Hertz(1713.0);
  i.outcome = MoveOutcome::NotHelped;
  i.withoutHelp = 1;
  EXPECT_TRUE(makeCards(s.picture())[0].headline.contains(QStringLiteral("did not help")));
  i.outcome = MoveOutcome::Louder;
  i.timesAsLoud = 2.5;
  EXPECT_TRUE(makeCards(s.picture())[0].headline.contains(QStringLiteral("louder: 2.5")));
  i.withoutHelp = 2;
  i.endedAuto = true;
  const QString ended = makeCards(s.picture())[0].headline;
  EXPECT_TRUE(ended.contains(QStringLiteral("ended in Advise")) && ended.contains(u'2')) << ended.toStdString();
  i.outcome = MoveOutcome::Helped;
  EXPECT_FALSE(makeCards(s.picture())[0].headline.contains(QStringLiteral("help")));
}

TEST(Cards, AnAlarmThatGoesOnHasANowAndNoBeforeAndAfter) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 1;
  Intervention& i = s.snapshot.interventions[0];
  i.severityBefore = Ratio(0.99);
  i.severityAfter = Ratio(0.95);
  EXPECT_FALSE(makeCards(s.picture())[0].ratio.contains(QChar(0x2192)));
  EXPECT_FALSE(makeCards(s.picture())[0].vibration.contains(QChar(0x2192)));
  i.commanded = s.snapshot.time;
  EXPECT_TRUE(makeCards(s.picture())[0].ratio.contains(QChar(0x2192)));
}

TEST(Cards, WhereNothingWasMovedThereIsOneSpeed) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 1;
  Intervention& i = s.snapshot.interventions[0];
  i.speedBefore = i.speedAfter = Rpm(8800.0);
  EXPECT_FALSE(makeCards(s.picture())[0].speed.contains(QChar(0x2192)));
  i.speedBefore = i.speedAfter = Rpm();
  EXPECT_TRUE(makeCards(s.picture())[0].speed.isEmpty()) << "a speed that is not known is not 0";
}

TEST(Cards, TellWhatTheQuietSpeedCostsInTime) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 1;
  Intervention& i = s.snapshot.interventions[0];
  i.finished = i.quiet = true;
  i.speedBefore = Rpm(8500.0);
  i.speedAfter = Rpm(7012.0);
  i.cycleTime = Ratio(8500.0 / 7012.0);
  EXPECT_EQ(makeCards(s.picture()).front().cost, QStringLiteral("time +21") + QChar(0xa0) + u'%');
  i.cycleTime = Ratio(1.0);
  EXPECT_TRUE(makeCards(s.picture()).front().cost.isEmpty());
}

// The quiet speed may lie where the teeth excite a mode: what was cured is said, and what shakes now is not hidden.
TEST(Cards, TellThatTheChatterIsGoneThoughTheVibrationHasRisen) {
  Scene s = stableScene();
  s.snapshot.interventionCount = 2;
  for (std::uint64_t n = 0; n < 2; ++n) {
    Intervention& i = s.snapshot.interventions[n];
    i.number = n;
    i.finished = i.quiet = true;
    i.severityBefore = Ratio(0.04);
    i.severityAfter = Ratio(0.004);
    i.vibrationBefore = 1.4;
    i.vibrationAfter = 9.2;
  }
  Intervention& newest = s.snapshot.interventions[1];
  const std::vector<CardView> cards = makeCards(s.picture());
  EXPECT_TRUE(cards[0].vibration.contains(QStringLiteral("no chatter"))) << cards[0].vibration.toStdString();
  EXPECT_TRUE(cards[0].vibration.contains(QStringLiteral("99") + QChar(0xa0) + u'%')) << "never rounded up to all";
  EXPECT_TRUE(cards[0].vibration.contains(QStringLiteral("9.2")));
  EXPECT_TRUE(cards[1].vibration.isEmpty()) << "it is about now";
  newest.vibrationAfter = 0.4;
  EXPECT_TRUE(makeCards(s.picture())[0].vibration.contains(QStringLiteral("gone")));
  newest.quiet = false;
  EXPECT_FALSE(makeCards(s.picture())[0].vibration.contains(u':')) << "nothing is proven";
}

}  // namespace
}  // namespace stillcut::ui
