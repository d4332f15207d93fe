// What the operator reads of a verdict.
#include <gtest/gtest.h>

#include "tests/ui/support/pictures.h"
#include "ui/base/format.h"
#include "ui/models/verdict_view.h"

namespace stillcut::ui {
namespace {

const QString kThin(kThousandsSpace);

TEST(VerdictView, EachStateHasItsOwnWordShapeAndTone) {
  const VerdictView stable = makeVerdictView(stableScene().picture(), Trend::Unknown);
  EXPECT_EQ(stable.word, "STABLE");
  EXPECT_EQ(stable.shape, Shape::Circle);
  EXPECT_EQ(stable.tone, Tone::Normal);
  const VerdictView onset = makeVerdictView(chatterScene(CutState::Onset).picture(), Trend::Unknown);
  EXPECT_EQ(onset.word, "ONSET");
  EXPECT_EQ(onset.shape, Shape::Triangle);
  EXPECT_EQ(onset.tone, Tone::Onset);
  const VerdictView chatter = makeVerdictView(chatterScene().picture(), Trend::Growing);
  EXPECT_EQ(chatter.word, "CHATTER");
  EXPECT_EQ(chatter.shape, Shape::Octagon);
  EXPECT_EQ(chatter.tone, Tone::Chatter);
  EXPECT_TRUE(chatter.frequency.startsWith("1" + kThin + "713"));
  EXPECT_EQ(chatter.kind, "regenerative") << "no word of theory for a machinist";
  EXPECT_EQ(chatter.detail, "growing");
  EXPECT_TRUE(chatter.marked.contains("1.2")) << chatter.marked.toStdString();
}

TEST(VerdictView, AnInvalidVerdictIsNeverStable) {
  Scene s = stableScene();
  s.verdict().valid = false;
  s.verdict().reason = {ReasonCode::InputClipped, {}};
  const VerdictView view = makeVerdictView(s.picture(), Trend::Unknown);
  EXPECT_EQ(view.word, "NO VERDICT");
  EXPECT_EQ(view.tone, Tone::Faint);
  EXPECT_EQ(view.detail, "The sensor is at its limit");
}

TEST(VerdictView, WhatWasNotJudgedIsNeverStable) {
  Scene s = stableScene();
  s.verdict().reason = {ReasonCode::Learning, {0.4}};
  const VerdictView learning = makeVerdictView(s.picture(), Trend::Unknown);
  EXPECT_EQ(learning.word, "NO VERDICT");
  EXPECT_TRUE(learning.detail.contains("0.4")) << learning.detail.toStdString();
  s.verdict().reason = {};
  s.verdict().phase = CutPhase::Entry;
  EXPECT_EQ(makeVerdictView(s.picture(), Trend::Unknown).word, "ENTRY");
  s.verdict().phase = CutPhase::Exit;
  EXPECT_EQ(makeVerdictView(s.picture(), Trend::Unknown).word, "EXIT");
  s.verdict().phase = CutPhase::RunUp;
  EXPECT_EQ(makeVerdictView(s.picture(), Trend::Unknown).word, "NO VERDICT");
  // Chatter is chatter wherever it is.
  s.verdict().phase = CutPhase::Entry;
  s.verdict().state = CutState::Chatter;
  EXPECT_EQ(makeVerdictView(s.picture(), Trend::Unknown).word, "CHATTER");
}

TEST(VerdictView, AStalePictureSaysSoAndHowOldItIs) {
  const Scene s = chatterScene();
  Picture p = s.picture();
  p.stale = true;
  p.age = Seconds(2.3);
  const VerdictView view = makeVerdictView(p, Trend::Growing);
  EXPECT_EQ(view.word, "NO VERDICT");
  EXPECT_TRUE(view.detail.contains("stale"));
  EXPECT_TRUE(view.detail.contains("2.3"));
  EXPECT_TRUE(view.marked.contains("CHATTER"));
}

TEST(VerdictView, BeforeTheFirstSamplesThereIsNoVerdict) {
  const Scene s = stableScene();
  Picture p = s.picture();
  p.snapshot = nullptr;
  EXPECT_EQ(makeVerdictView(p, Trend::Unknown).word, "NO VERDICT");
}

}  // namespace
}  // namespace stillcut::ui
