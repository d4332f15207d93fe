// What a move was good for, by the judge alone, in virtual time.
#include "core/safety/intervention_judge.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stillcut::safety {
namespace {

class Judged : public testing::Test {
 protected:
  static constexpr double kDt = 0.01;

  Judged() {
    judge.prepare(rules);
    step.heard = true;
    step.dt = kDt;
    step.vibration = 1.0;
  }
  // Until an outcome or for so long.
  Outcome run(double seconds) {
    for (int i = 0; i < std::lround(seconds / kDt); ++i) {
      judge.listen(step);
      if (const Outcome outcome = judge.judge(step); outcome != Outcome::None) return outcome;
    }
    return Outcome::None;
  }
  // An alarm and a move for it that has arrived.
  void move() {
    step.alarming = true;
    step.arrived = false;
    run(0.2);
    judge.begin({}, {0.9, 0.9});
    run(0.3);
    step.arrived = true;
  }

  InterventionRules rules;
  InterventionJudge judge;
  InterventionStep step;
};

TEST_F(Judged, AMoveAfterWhichTheAlarmEndsAndStaysAwayHelped) {
  move();
  run(0.5);  // it rings down
  step.alarming = false;
  EXPECT_EQ(run(0.9 * rules.staysAway.value), Outcome::None) << "not yet";
  EXPECT_EQ(run(0.2 * rules.staysAway.value), Outcome::Helped);
  EXPECT_FALSE(judge.open());
  EXPECT_EQ(judge.withoutHelp(), 0);
}

TEST_F(Judged, AnAlarmThatGoesOnAfterItsTimeIsNoHelp) {
  move();
  EXPECT_EQ(run(0.95 * rules.helpsWithin.value), Outcome::None);
  EXPECT_EQ(run(0.1 * rules.helpsWithin.value), Outcome::NotHelped);
  EXPECT_EQ(judge.withoutHelp(), 1);
}

TEST_F(Judged, AnAlarmThatComesBackIsNoHelpEither) {
  move();
  run(0.9 * rules.helpsWithin.value);
  step.alarming = false;
  EXPECT_EQ(run(0.9 * rules.staysAway.value), Outcome::None);
  step.alarming = true;
  EXPECT_EQ(run(kDt), Outcome::NotHelped);
}

TEST_F(Judged, TheNextMoveOfAStandingAlarmSaysThatTheOneBeforeDidNotHelp) {
  move();
  run(0.5);
  EXPECT_EQ(judge.begin({0.9, 0.9}, {0.8, 0.8}), Outcome::NotHelped);
  EXPECT_EQ(judge.before().speed, 0.9);
  step.arrived = false;
  run(0.1);
  EXPECT_EQ(judge.begin({0.85, 0.85}, {0.95, 0.95}), Outcome::None) << "it has not arrived: it is the same move";
  step.arrived = true;
  run(0.8 * rules.listens.value);
  EXPECT_EQ(judge.begin({0.95, 0.95}, {0.85, 0.85}), Outcome::None) << "nobody has listened: it is the same move";
  EXPECT_EQ(judge.before().speed, 0.9);
}

TEST_F(Judged, AMachineThatNeverArrivesIsNoHelp) {
  move();
  step.arrived = false;
  judge.begin({}, {0.9, 0.9});
  EXPECT_EQ(run(rules.arrivesWithin.value - 1.0), Outcome::None);
  EXPECT_EQ(run(2.0), Outcome::NotHelped);
}

TEST_F(Judged, ACutThatChattersOnAndLouderIsOne) {
  move();
  step.vibration = 1.5 * rules.louder;
  EXPECT_EQ(run(0.95 * rules.helpsWithin.value), Outcome::None) << "it may ring down";
  EXPECT_EQ(run(0.1 * rules.helpsWithin.value), Outcome::Louder);
  EXPECT_NEAR(judge.timesAsLoud(), 1.5 * rules.louder, 0.1);
  EXPECT_EQ(judge.withoutHelp(), 1);
}

TEST_F(Judged, WhatIsThrownOffItsPlaceIsNotJudgedThere) {
  move();
  run(0.2);
  step.arrived = false;  // a script has put the override back
  step.vibration = 10.0 * rules.louder;
  EXPECT_EQ(run(5.0), Outcome::None);
}

TEST_F(Judged, ALoudCutWithoutChatterIsHelpAndShowsThatItIsLoud) {
  move();
  step.alarming = false;
  step.vibration = 1.5 * rules.louder;
  EXPECT_EQ(run(2.0), Outcome::Helped);
  EXPECT_TRUE(judge.louder());
}

TEST_F(Judged, ALawThatFeelsItsWayGoesOneWay) {
  move();
  run(0.5);
  double at = 0.9;
  for (int i = 0; i < 5; ++i) {
    const double next = at - 0.9 * rules.creeps;
    EXPECT_EQ(judge.begin({at, at}, {next, next}), Outcome::None);
    at = next;
    run(1.4 * rules.listens.value);
  }
  EXPECT_EQ(judge.begin({at, at}, {0.9, 0.9}), Outcome::NotHelped) << "it turns back";
}

TEST_F(Judged, WhatIsNotKnownIsNotLouder) {
  step.vibration = std::nan("");
  move();
  EXPECT_EQ(run(3.0), Outcome::NotHelped);
}

TEST_F(Judged, FailuresInARowAreCountedAndForgivenByAProvenQuiet) {
  move();
  EXPECT_EQ(judge.fault(), Outcome::NotHelped);
  EXPECT_FALSE(judge.usedUp());
  move();
  step.alarming = false;
  EXPECT_EQ(run(2.0), Outcome::Helped);
  EXPECT_EQ(judge.withoutHelp(), 1) << "quiet is not proven yet";
  run(rules.proven.value);
  EXPECT_EQ(judge.withoutHelp(), 0);
  move();
  judge.fault();
  move();
  judge.fault();
  EXPECT_TRUE(judge.usedUp());
}

TEST_F(Judged, WithoutAVerdictNoTimePasses) {
  move();
  step.heard = false;
  EXPECT_EQ(run(20.0), Outcome::None);
}

}  // namespace
}  // namespace stillcut::safety
