#include "core/pipeline/intervention_log.h"

#include <gtest/gtest.h>

namespace stillcut::pipeline {
namespace {

constexpr double kBlock = 0.01;

// Plays blocks of 10 ms with a given verdict into a log.
class Story {
 public:
  StepOutput block(CutState state, double severity, double speed, double vibration, bool command = false,
                   CutPhase phase = CutPhase::Steady) {
    StepInput in;
    in.block.rate = Hertz(10000.0);
    in.block.frames = 100;
    in.block.firstSample = Instant(toDuration(Seconds(kBlock * static_cast<double>(n_++))));
    in.machine.actualSpeed = Rpm(speed);
    in.machine.actualFeed = feed;
    StepOutput out;
    out.verdictCount = 1;
    Verdict& v = out.verdicts[0];
    v.valid = valid;
    v.phase = phase;
    v.state = state;
    v.time = in.block.end();
    v.frequency = Hertz(state == CutState::Stable ? 0.0 : 850.0);
    v.severity = Ratio(severity);
    if (command) {
      out.hasCommand = true;
      out.command.kind = CommandKind::Set;
      out.command.speed = Ratio(0.97);
      out.command.time = in.block.end();
    }
    log.follow(in, out, {vibration, feed, judged}, Seconds(kBlock));
    judged = {};
    return out;
  }
  InterventionLog log;
  safety::GateOutput::Judged judged;           // of the block that follows
  bool valid = true;                           // of the verdicts that follow
  MetresPerSecond feed = fromMmPerMin(600.0);  // 10 mm/s

 private:
  int n_ = 0;
};

TEST(InterventionLog, TellsBeforeAndAfterOfOneAlarm) {
  Story s;
  for (int i = 0; i < 10; ++i) s.block(CutState::Stable, 0.01, 8000.0, 1.0);
  const StepOutput first = s.block(CutState::Onset, 0.1, 8000.0, 2.0);
  ASSERT_EQ(first.eventCount, 1);
  EXPECT_EQ(first.events[0].reason.code, ReasonCode::ChatterBegan);
  s.block(CutState::Chatter, 0.6, 8000.0, 9.0);
  s.block(CutState::Chatter, 0.5, 8000.0, 8.0, true);
  for (int i = 0; i < 7; ++i) s.block(CutState::Chatter, 0.95, 7900.0, 12.0);  // the spindle runs down: not "before"
  StepOutput last;
  for (int i = 0; i < 30 && last.eventCount == 0; ++i) last = s.block(CutState::Stable, 0.02, 7760.0, 1.1);

  ASSERT_EQ(s.log.count(), 1U);
  const Intervention& card = s.log.card(0);
  EXPECT_TRUE(card.finished);
  EXPECT_TRUE(card.quiet);
  EXPECT_DOUBLE_EQ(card.frequency.value, 850.0);
  EXPECT_DOUBLE_EQ(card.speedBefore.value, 8000.0);
  EXPECT_DOUBLE_EQ(card.speedAfter.value, 7760.0);
  EXPECT_DOUBLE_EQ(card.severityBefore.value, 0.6);
  EXPECT_DOUBLE_EQ(card.severityAfter.value, 0.02);
  EXPECT_DOUBLE_EQ(card.vibrationBefore, 9.0);
  EXPECT_DOUBLE_EQ(card.vibrationAfter, 1.1);
  EXPECT_NEAR(card.timeToStable.value, 9 * kBlock, 1e-9);  // from the first to the last alarming block
  EXPECT_NEAR(card.marked.value * 1e3, 9 * kBlock * 10.0, 1e-9) << "the onset marks nothing";
  EXPECT_NEAR(secondsBetween(card.began, card.commanded).value, 2 * kBlock, 1e-9);
  ASSERT_EQ(last.eventCount, 1);
  EXPECT_EQ(last.events[0].reason.code, ReasonCode::ChatterEnded);
  EXPECT_NEAR(s.log.chatterTime().value, 9 * kBlock, 1e-9);
}

TEST(InterventionLog, AShortPauseIsTheSameChatter) {
  Story s;
  for (int i = 0; i < 5; ++i) s.block(CutState::Chatter, 0.5, 8000.0, 5.0);
  for (int i = 0; i < 10; ++i) s.block(CutState::Stable, 0.1, 8000.0, 2.0);
  for (int i = 0; i < 5; ++i) s.block(CutState::Chatter, 0.5, 8000.0, 5.0);
  EXPECT_EQ(s.log.count(), 1U);
  for (int i = 0; i < 40; ++i) s.block(CutState::Stable, 0.1, 8000.0, 2.0);
  s.block(CutState::Onset, 0.1, 8000.0, 2.0);
  EXPECT_EQ(s.log.count(), 2U);
}

TEST(InterventionLog, WithoutAVerdictItIsNeitherQuietNorOver) {
  Story s;
  for (int i = 0; i < 5; ++i) s.block(CutState::Chatter, 0.5, 8000.0, 5.0);
  s.valid = false;
  for (int i = 0; i < 100; ++i) s.block(CutState::Stable, 0.0, 8000.0, 5.0);
  EXPECT_FALSE(s.log.card(0).finished);
  s.valid = true;
  for (int i = 0; i < 20; ++i) s.block(CutState::Stable, 0.02, 8000.0, 1.0);
  EXPECT_FALSE(s.log.card(0).finished) << "0.2 s have been judged";
  for (int i = 0; i < 10; ++i) s.block(CutState::Stable, 0.02, 8000.0, 1.0);
  EXPECT_TRUE(s.log.card(0).finished);
  EXPECT_TRUE(s.log.card(0).quiet);
}

TEST(InterventionLog, LeavingTheCutEndsItButProvesNothing) {
  Story s;
  for (int i = 0; i < 5; ++i) s.block(CutState::Chatter, 0.5, 8000.0, 5.0);
  for (int i = 0; i < 40; ++i) s.block(CutState::Stable, 0.1, 8000.0, 2.0, false, CutPhase::Exit);
  EXPECT_FALSE(s.log.card(0).finished) << "an exit, or chatter that dies down";
  const StepOutput last = s.block(CutState::AirCutting, 0.0, 8000.0, 0.1, false, CutPhase::AirCutting);
  EXPECT_TRUE(s.log.card(0).finished);
  EXPECT_FALSE(s.log.card(0).quiet);
  ASSERT_EQ(last.eventCount, 1);
  EXPECT_EQ(last.events[0].reason.code, ReasonCode::ChatterLeftCut);
}

TEST(InterventionLog, KeepsTheNewestCardsOnly) {
  Story s;
  for (int n = 0; n < kInterventionsShown + 3; ++n) {
    s.block(CutState::Chatter, 0.5, 8000.0 + n, 5.0);
    for (int i = 0; i < 40; ++i) s.block(CutState::Stable, 0.1, 8000.0, 2.0);
  }
  const std::uint64_t newest = s.log.count() - 1;
  EXPECT_EQ(s.log.card(newest).number, newest);
  EXPECT_DOUBLE_EQ(s.log.card(newest).speedBefore.value, 8000.0 + static_cast<double>(newest));
}

TEST(InterventionLog, KeepsWhatTheGateSaysOfTheMove) {
  Story s;
  s.block(CutState::Chatter, 0.6, 8000.0, 9.0);
  s.judged = {MoveOutcome::NotHelped, 1.1, 1, false};
  s.block(CutState::Chatter, 0.6, 8000.0, 9.0);
  EXPECT_EQ(s.log.card(0).outcome, MoveOutcome::None) << "nothing was moved for this alarm";
  s.block(CutState::Chatter, 0.6, 8000.0, 9.0, true);
  s.judged = {MoveOutcome::Louder, 2.5, 2, true};
  s.block(CutState::Chatter, 0.6, 7760.0, 22.0);
  const Intervention& card = s.log.card(0);
  EXPECT_EQ(card.outcome, MoveOutcome::Louder);
  EXPECT_DOUBLE_EQ(card.timesAsLoud, 2.5);
  EXPECT_EQ(card.withoutHelp, 2);
  EXPECT_TRUE(card.endedAuto);
}

TEST(InterventionLog, AMoveProvesItselfAfterItsCardIsClosed) {
  Story s;
  for (int i = 0; i < 3; ++i) s.block(CutState::Chatter, 0.6, 8000.0, 9.0, true);
  for (int i = 0; i < 40; ++i) s.block(CutState::Stable, 0.02, 7760.0, 1.1);
  ASSERT_TRUE(s.log.card(0).finished);
  s.judged = {MoveOutcome::Helped, 0.2, 0, false};
  s.block(CutState::Stable, 0.02, 7760.0, 1.1);
  EXPECT_EQ(s.log.card(0).outcome, MoveOutcome::Helped);
}

}  // namespace
}  // namespace stillcut::pipeline
