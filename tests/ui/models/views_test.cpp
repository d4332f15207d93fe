#include <gtest/gtest.h>

#include <cmath>

#include "tests/ui/support/pictures.h"
#include "ui/base/format.h"
#include "ui/models/advice_view.h"
#include "ui/models/freshness.h"
#include "ui/models/history/spectrum_column_reader.h"
#include "ui/models/machine_view.h"
#include "ui/models/severity_trend.h"
#include "ui/models/strip_view.h"
#include "ui/models/verdict_view.h"

namespace stillcut::ui {
namespace {

const QString kThin(kThousandsSpace);

SpeedAdvice speedAdvice() {
  return {SpeedAdvice::Kind::Speed,
          Rpm(8565),
          fromMmPerMin(1408.0 * 8565 / 8800),
          Rpm(8800),
          fromMmPerMin(1408.0),
          Hertz(1713),
          {},
          {ReasonCode::CentreOfNextPocket, {8565, 3, 1713, 8800}}};
}

TEST(AdviceView, OpenAdviceGivesTargetDeltaReasonAndCost) {
  Scene s = chatterScene();
  s.snapshot.authority = Authority::Advise;
  s.snapshot.adviceOpen = true;
  s.snapshot.advice = speedAdvice();
  const AdviceView view = makeAdviceView(s.picture());
  EXPECT_TRUE(view.canAnswer());
  EXPECT_EQ(view.target, "8" + kThin + "565" + QChar(0xa0) + "rpm");
  EXPECT_TRUE(view.delta.contains(QChar(0x2212) + QStringLiteral("235, "))) << view.delta.toStdString();
  EXPECT_TRUE(view.delta.contains("97"));
  EXPECT_TRUE(view.feed.contains("1" + kThin + "370"));
  // 8800 / 8565 - 1 = 2.7 % more time; pi * 12 mm * 8565 / min = 323 m/min.
  EXPECT_TRUE(view.cost.contains("2.7")) << view.cost.toStdString();
  EXPECT_TRUE(view.cost.contains("323")) << view.cost.toStdString();
}

TEST(AdviceView, UnderOffTheSpeedIsOfferedInGrey) {
  Scene s = chatterScene();
  s.snapshot.advice = speedAdvice();
  const AdviceView view = makeAdviceView(s.picture());
  EXPECT_EQ(view.mode, AdviceView::Mode::Offered);
  EXPECT_FALSE(view.canAnswer());
  EXPECT_EQ(view.target, "8" + kThin + "565" + QChar(0xa0) + "rpm");
  EXPECT_TRUE(view.feed.contains("ADVISE")) << view.feed.toStdString();
  EXPECT_TRUE(view.reason.contains("chatter waves"));
}

TEST(AdviceView, WithoutAMachineTheSpeedIsForTheHandAndAutoIsNotOffered) {
  Scene s = chatterScene();
  s.info.linkLabel.clear();
  s.snapshot.machine = {};
  s.snapshot.autoAllowed = false;
  s.snapshot.advice = speedAdvice();
  const AdviceView view = makeAdviceView(s.picture());
  EXPECT_EQ(view.mode, AdviceView::Mode::ForHand);
  EXPECT_EQ(view.target, "8" + kThin + "565" + QChar(0xa0) + "rpm");
  EXPECT_FALSE(view.canAnswer());
  const CommandView bar = makeCommandView(s.picture());
  EXPECT_FALSE(bar.machine);
  EXPECT_FALSE(bar.autoAllowed);
  EXPECT_EQ(makeStrip(s.picture())[0].value, "none");
  EXPECT_FALSE(makeMachineView(s.picture()).warning) << "no machine is no fault of one";
}

TEST(AdviceView, WhereNoSpeedWillDoItNamesTheDepth) {
  Scene s = chatterScene();
  s.snapshot.advice = {SpeedAdvice::Kind::LessDepth,
                       Rpm(8900),
                       {},
                       Rpm(8800),
                       {},
                       Hertz(1713),
                       Metres(1.8e-3),
                       {ReasonCode::NoStableSpeed, {3.0, 1.8, 8900, 1713}}};
  const AdviceView view = makeAdviceView(s.picture());
  EXPECT_TRUE(view.target.contains("1.8")) << view.target.toStdString();
  EXPECT_TRUE(view.delta.contains("900")) << view.delta.toStdString();
}

// Verdict, advice and card: an estimate that wavers is no second frequency.
TEST(AdviceView, OneFrequencyOnTheWholeScreen) {
  Scene s = chatterScene();
  s.snapshot.authority = Authority::Advise;
  s.snapshot.adviceOpen = true;
  s.snapshot.advice = speedAdvice();
  s.snapshot.interventionCount = 1;
  s.snapshot.interventions[0].frequency = Hertz(1709);
  s.snapshot.verdicts[0].frequency = Hertz(1719);
  const QString shown = "1" + kThin + "713";
  EXPECT_TRUE(makeVerdictView(s.picture(), Trend::Unknown).frequency.contains(shown));
  EXPECT_TRUE(makeAdviceView(s.picture()).reason.contains(shown));
  EXPECT_TRUE(makeCards(s.picture())[0].headline.contains(shown));
  s.snapshot.verdicts[0].frequency = Hertz(1850);
  EXPECT_TRUE(makeVerdictView(s.picture(), Trend::Unknown).frequency.contains("1" + kThin + "850"))
      << "another line is another line";
}

TEST(EventLine, AMachineThatWasNotReadAtFirstIsNoWarningOnceItAnswers) {
  Scene s = stableScene();
  s.snapshot.eventCount = 1;
  s.snapshot.events[0] = {s.snapshot.time, 0, EventLevel::Warning, {ReasonCode::MachineNeverRead, {}}};
  EXPECT_TRUE(makeEventLine(s.picture()).text.isEmpty());
  s.snapshot.machine.linkUp = false;
  EXPECT_FALSE(makeEventLine(s.picture()).text.isEmpty());
}

TEST(CommandView, WhatWasReleasedAndNotReadBackIsSaid) {
  Scene s = stableScene();
  s.snapshot.machine.speedOverride = s.snapshot.machine.feedOverride = Ratio(0.83);
  Picture p = s.picture();
  EXPECT_FALSE(makeCommandView(p).notYetBack);
  p.link.notYetBack = true;
  const CommandView view = makeCommandView(p);
  EXPECT_TRUE(view.inCommand.contains("NOT YET BACK")) << view.inCommand.toStdString();
  EXPECT_TRUE(view.inCommand.contains("83"));
  EXPECT_EQ(makeStrip(p)[0].value, "not yet back");
  p.link.ended = "The device has gone";
  EXPECT_TRUE(makeCommandView(p).inCommand.contains("NOT YET BACK")) << "also after the last sample";
}

// Its machine has ended with the cut: nobody waits for an answer of it, and nothing is red that nobody can mend.
TEST(CommandView, ASimulatedCutThatIsOverSaysSoQuietly) {
  Scene s = stableScene();
  s.info.simulatedMachine = true;
  s.snapshot.machine.speedOverride = s.snapshot.machine.feedOverride = Ratio(0.83);
  Picture p = s.picture();
  p.link.notYetBack = true;
  EXPECT_TRUE(makeCommandView(p).notYetBack) << "while it runs the machine is asked";
  p.link.ended = "The run has ended";
  p.mayRunAgain = true;
  p.stale = true;
  p.age = Seconds(49.0);
  EXPECT_FALSE(makeCommandView(p).notYetBack);
  EXPECT_EQ(makeCommandView(p).since, "The run has ended");
  for (const StripItem& item : makeStrip(p)) {
    EXPECT_NE(item.tone, Tone::Chatter) << item.label.toStdString() << ' ' << item.value.toStdString();
    EXPECT_FALSE(item.value.contains("49")) << item.label.toStdString();
  }
  EXPECT_FALSE(makeMachineView(p).warning);
  s.info.simulatedMachine = false;
  EXPECT_TRUE(makeCommandView(p).notYetBack) << "a real machine still has them";
}

TEST(AdviceView, ACommandThatMovesNothingIsNotInForce) {
  Scene s = stableScene();
  s.snapshot.commanding = true;
  s.snapshot.command.kind = CommandKind::Set;
  EXPECT_EQ(makeAdviceView(s.picture()).mode, AdviceView::Mode::Nothing);
  s.snapshot.command.speed = Ratio(0.973);
  const AdviceView view = makeAdviceView(s.picture());
  EXPECT_EQ(view.mode, AdviceView::Mode::InForce);
  EXPECT_EQ(view.title, "ACTIVE");
  EXPECT_FALSE(view.canAnswer());
  s.snapshot.machine.linkUp = false;
  EXPECT_TRUE(makeAdviceView(s.picture()).title.contains("NOT CONFIRMED"));
}

TEST(AdviceView, TheReasonOfAMoveStaysUnlessTheGateHoldsSomethingBack) {
  Scene s = stableScene();
  MoveReason why;
  s.snapshot.commanding = true;
  s.snapshot.command.kind = CommandKind::Set;
  s.snapshot.command.speed = Ratio(0.973);
  s.snapshot.command.reason = {ReasonCode::GateInForce, {97.3, 97.3, 97.3, 97.3}};
  s.snapshot.request.kind = RequestKind::Set;
  s.snapshot.request.reason = {ReasonCode::CentreOfNextPocket, {8565, 3, 1713, 8800}};
  why.see(s.snapshot);
  s.snapshot.request = OverrideRequest{};
  why.see(s.snapshot);
  EXPECT_TRUE(makeAdviceView(s.picture(), why.reason()).reason.contains("chatter waves"));
  s.snapshot.command.reason = {ReasonCode::GateSettling, {8700, 8565}};
  EXPECT_TRUE(makeAdviceView(s.picture(), why.reason()).reason.contains("Waiting for the spindle"));
  s.snapshot.commanding = false;
  why.see(s.snapshot);
  EXPECT_EQ(why.reason().code, ReasonCode::None);
}

TEST(AdviceView, StaleAdviceCannotBeAccepted) {
  Scene s = chatterScene();
  s.snapshot.adviceOpen = true;
  s.snapshot.request.kind = RequestKind::Set;
  Picture p = s.picture();
  p.stale = true;
  EXPECT_FALSE(makeAdviceView(p).canAnswer());
}

TEST(Bars, ABarThatTheVerdictDoesNotGoByDoesNotCount) {
  Scene s = stableScene();
  VibrationScale scale;
  s.info.detectors.push_back({"coherence", "Coherence", {"gamma_max"}});
  s.snapshot.detectorCount = 2;
  EXPECT_TRUE(makeBars(s.picture(), scale)[0].counts);
  EXPECT_FALSE(makeBars(s.picture(), scale)[2].counts);
  s.snapshot.inCharge = 1;
  EXPECT_FALSE(makeBars(s.picture(), scale)[0].counts);
  EXPECT_TRUE(makeBars(s.picture(), scale)[2].counts);
}

TEST(Bars, ASensorThatNobodyHasCalibratedSaysSo) {
  Scene s = stableScene();
  VibrationScale scale;
  EXPECT_TRUE(makeBars(s.picture(), scale)[1].label.contains("uncalibrated"));
  s.info.setup.channels[0].sensitivity = 100.0;
  EXPECT_FALSE(makeBars(s.picture(), scale)[1].label.contains("uncalibrated"));
}

TEST(MachineView, OldValuesAreShownAsOld) {
  Scene s = stableScene();
  EXPECT_FALSE(makeMachineView(s.picture()).speed.old);
  s.snapshot.machine.time = s.snapshot.time - std::chrono::seconds(3);
  const MachineView old = makeMachineView(s.picture());
  EXPECT_TRUE(old.speed.old);
  EXPECT_TRUE(old.warning);
  EXPECT_TRUE(old.note.contains("3.0"));
  s.snapshot.machine.valid = false;
  EXPECT_EQ(makeMachineView(s.picture()).speed.actual, QString(QChar(0x2013)));
}

// A speed that nothing measures is no speed of 0.
TEST(MachineView, AnActualSpeedThatNothingMeasuresIsSaid) {
  Scene s = stableScene();
  s.snapshot.machine.actualSpeed = Rpm(0.0);
  s.snapshot.machine.link.speed = {};
  EXPECT_EQ(makeMachineView(s.picture()).speed.actual, QString("not measured"));
  s.snapshot.machine.link.speed = s.snapshot.time;  // it stands still
  EXPECT_NE(makeMachineView(s.picture()).speed.actual, QString("not measured"));
}

TEST(MachineView, AControllerThatStartsIsNotSilence) {
  Scene s = stableScene();
  s.snapshot.machine.valid = false;
  s.snapshot.machine.block = OverrideInhibit::Starting;
  EXPECT_TRUE(makeMachineView(s.picture()).note.startsWith("The controller starts"));
}

TEST(MachineView, TheOperatorsKnobIsNotOurMove) {
  Scene s = stableScene();
  s.snapshot.machine.operatorSpeed = s.snapshot.machine.speedOverride = Ratio(0.8);
  EXPECT_EQ(makeMachineView(s.picture()).speed.tone, Tone::Normal);
  s.snapshot.machine.speedOverride = Ratio(0.78);
  EXPECT_EQ(makeMachineView(s.picture()).speed.tone, Tone::Advice);
}

// A raised speed on a machine whose feed ends at 100 %: the chip gets thinner, and that is said.
TEST(MachineView, AFeedPerToothThatIsNotHeldIsShown) {
  Scene s = stableScene();
  MachineState& m = s.snapshot.machine;
  m.speedOverride = m.feedOverride = Ratio(0.83);  // the feed follows
  EXPECT_EQ(makeMachineView(s.picture()).note, QString("Knobs %1, %2").arg(overrideText(1.0), overrideText(1.0)));
  m.speedOverride = Ratio(1.2);
  m.feedOverride = Ratio(1.0);
  EXPECT_EQ(
      makeMachineView(s.picture()).note,
      QString("Knobs %1, %2; feed per tooth %3").arg(overrideText(1.0), overrideText(1.0), overrideText(1.0 / 1.2)));
  m.operatorFeed = m.feedOverride = Ratio(0.8);  // his own knob is his own say
  m.speedOverride = Ratio(1.0);
  EXPECT_EQ(makeMachineView(s.picture()).note, QString("Knobs %1, %2").arg(overrideText(1.0), overrideText(0.8)));
}

// What keeps our overrides from acting has a sentence of its own each.
TEST(MachineView, WhatHindersIsToldApart) {
  QStringList said;
  for (bool MachineState::*whole : {&MachineState::linkUp, &MachineState::controlOurs, &MachineState::overridesEnabled,
                                    &MachineState::programRunning}) {
    Scene s = stableScene();
    s.snapshot.machine.*whole = false;
    const QString note = makeMachineView(s.picture()).note;
    EXPECT_FALSE(note.isEmpty());
    EXPECT_FALSE(said.contains(note)) << note.toStdString();
    said << note;
  }
}

// Where the link knows the cause it is said; each in other words.
TEST(MachineView, EveryCauseHasWordsOfItsOwn) {
  QStringList said;
  for (int k = 1; k < kOverrideInhibits; ++k) {
    Scene s = stableScene();
    s.snapshot.machine.block = static_cast<OverrideInhibit>(k);
    const MachineView view = makeMachineView(s.picture());
    EXPECT_TRUE(view.warning);
    EXPECT_FALSE(view.note.isEmpty()) << k;
    EXPECT_FALSE(said.contains(view.note)) << view.note.toStdString();
    said << view.note;
  }
}

// Not taken back while it is off: what it will begin with is said while somebody can still read it.
TEST(MachineView, AMachineThatIsOffSaysWhatItKeepsOfOurs) {
  Scene s = stableScene();
  MachineState& m = s.snapshot.machine;
  m.block = OverrideInhibit::MachineOff;
  m.programRunning = false;
  EXPECT_EQ(makeMachineView(s.picture()).note, QString("The machine is off"));
  m.speedOverride = Ratio(0.9);
  EXPECT_TRUE(makeMachineView(s.picture()).note.contains(overrideText(0.9)));
  EXPECT_TRUE(makeMachineView(s.picture()).note.contains("Stillcut brings them back"));  // if it is still there
}

TEST(Bars, LimitsBecomeMarksAndAbsentDetectorsNoBar) {
  Scene s = chatterScene();
  s.info.limits.energyRatio = 0.3;
  VibrationScale scale;
  std::vector<BarView> bars = makeBars(s.picture(), scale);
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_EQ(bars[0].marks, (std::vector<double>{0.3}));
  EXPECT_DOUBLE_EQ(bars[0].fraction, 0.62);
  EXPECT_EQ(bars[0].tone, Tone::Chatter);
  EXPECT_EQ(bars[1].tone, Tone::Normal) << "vibration has a limit only where somebody has set one";
  s.snapshot.vibrationRms = 4.0;
  s.info.limits.vibration = 3.0;
  bars = makeBars(s.picture(), scale);
  EXPECT_EQ(bars[1].marks.size(), 1U);
  EXPECT_EQ(bars[1].tone, Tone::Chatter);
  s.verdict().state = CutState::Stable;
  EXPECT_EQ(makeBars(s.picture(), scale)[0].tone, Tone::Normal) << "colour means act: the verdict alarms, not a number";
  s.info.detectors.push_back({"coherence", "Coherence", {"energy", "gamma_max"}});
  s.snapshot.verdicts[1].valid = true;
  s.snapshot.verdicts[1].indicators[1] = 0.41;
  bars = makeBars(s.picture(), scale);
  ASSERT_EQ(bars.size(), 3U);
  EXPECT_DOUBLE_EQ(bars[2].fraction, 0.41);
}

TEST(Bars, AnInvalidVerdictGivesNoNumber) {
  Scene s = chatterScene();
  s.verdict().valid = false;
  VibrationScale scale;
  EXPECT_FALSE(makeBars(s.picture(), scale)[0].known);
}

TEST(VibrationScale, GrowsInRoundStepsAndNeverShrinks) {
  VibrationScale scale;
  EXPECT_DOUBLE_EQ(scale.fullFor(1.2, std::nan("")), 2.0);
  EXPECT_DOUBLE_EQ(scale.fullFor(16.0, std::nan("")), 20.0);
  EXPECT_DOUBLE_EQ(scale.fullFor(0.1, std::nan("")), 20.0);
  EXPECT_DOUBLE_EQ(scale.fullFor(std::nan(""), std::nan("")), 20.0);
}

TEST(Strip, CountersAndLossesStandOut) {
  Scene s = stableScene();
  s.snapshot.health.droppedBlocks = 3;
  s.snapshot.machine.linkUp = false;
  Picture p = s.picture();
  p.recorder = {RecorderView::State::Failed, Seconds(), "disk full"};
  const std::vector<StripItem> items = makeStrip(p);
  ASSERT_EQ(items.size(), 7U);
  EXPECT_EQ(items[0].tone, Tone::Chatter);
  EXPECT_EQ(items[3].value, "3");
  EXPECT_EQ(items[3].tone, Tone::Onset);
  EXPECT_EQ(items[4].tone, Tone::Normal);
  EXPECT_EQ(items[6].value, "disk full");
  EXPECT_EQ(items[6].tone, Tone::Chatter);
}

// Whose fault it is: a machine that is silent, or a thread of ours that asks nothing.
TEST(Strip, AThreadThatStandsStillIsNoSilentMachine) {
  Scene s = stableScene();
  s.snapshot.machine.time = s.snapshot.time - std::chrono::seconds(5);
  s.snapshot.machine.linkUp = false;
  EXPECT_TRUE(makeStrip(s.picture())[0].value.startsWith("no answer for 5"));
  s.snapshot.health.linkThreadAge = Seconds(5.0);
  EXPECT_TRUE(makeStrip(s.picture())[0].value.startsWith("Stillcut itself stands still for 5"));
  const auto shown = [&](const char* label) {
    const auto items = makeStrip(s.picture());
    return std::any_of(items.begin(), items.end(), [&](const StripItem& i) { return i.label == QLatin1String(label); });
  };
  EXPECT_FALSE(shown("Leases run out"));
  s.snapshot.health.leasesExpired = 2;
  s.snapshot.health.linkStalls = 1;
  EXPECT_TRUE(shown("Leases run out"));
  EXPECT_TRUE(shown("Standstills"));
}

TEST(Strip, ALostLinkIsRedForAsLongAsItHasNotAnswered) {
  Scene s = stableScene();
  s.snapshot.machine.time = s.snapshot.time - std::chrono::seconds(3);
  s.snapshot.machine.linkUp = s.snapshot.machine.valid = false;
  StripItem link = makeStrip(s.picture())[0];
  EXPECT_EQ(link.tone, Tone::Chatter);
  EXPECT_TRUE(link.value.startsWith("no answer for 3")) << link.value.toStdString();
  s.snapshot.machine = MachineState{};  // never read
  link = makeStrip(s.picture())[0];
  EXPECT_EQ(link.tone, Tone::Faint);
  EXPECT_EQ(link.value, "not read yet");
}

TEST(Strip, TheEndOfTheSamplesIsSaid) {
  Scene s = stableScene();
  Picture p = s.picture();
  p.link.ended = "ALSA hw:1: unplugged";
  EXPECT_EQ(makeStrip(p)[1].value, p.link.ended);
  EXPECT_EQ(makeStrip(p)[1].tone, Tone::Chatter);
}

TEST(SeverityTrend, FollowsTheSlope) {
  for (const auto& [slope, wanted] : {std::pair{1.0, Trend::Growing}, {0.0, Trend::Steady}, {-1.0, Trend::Fading}}) {
    SeverityTrend trend;
    Verdict v = chatterScene().verdict();
    for (int k = 0; k < 20; ++k) {
      v.time = instantFromNs(k * 20'000'000LL);
      v.severity = Ratio(0.5 + slope * 0.02 * k);
      trend.add(v);
    }
    EXPECT_EQ(trend.trend(), wanted) << slope;
    v.state = CutState::Stable;
    trend.add(v);
    EXPECT_EQ(trend.trend(), Trend::Unknown);
  }
}

TEST(Freshness, CountsFromTheLastChange) {
  Freshness freshness;
  Snapshot s;
  s.number = 1;
  freshness.see(&s, 1000);
  freshness.see(&s, 1500);
  EXPECT_FALSE(freshness.stale());
  freshness.see(&s, 1501);
  EXPECT_TRUE(freshness.stale());
  EXPECT_NEAR(freshness.age().value, 0.501, 1e-9);
  ++s.number;
  freshness.see(&s, 1600);
  EXPECT_FALSE(freshness.stale());
}

TEST(Freshness, AWorkerThatLagsMakesNoLivePictureHoweverOftenItPublishes) {
  Scene s = chatterScene();
  s.snapshot.autoAllowed = true;
  s.snapshot.authority = Authority::Advise;
  s.snapshot.health.blockAge = Seconds(24.0);
  Freshness freshness;
  for (qint64 now = 1000; now < 3000; now += 40) {
    ++s.snapshot.number;
    freshness.see(&s.snapshot, now);
  }
  EXPECT_TRUE(freshness.stale());
  EXPECT_NEAR(freshness.age().value, 24.0, 0.1);
  Picture picture = s.picture();
  picture.age = freshness.age();
  picture.stale = true;
  const VerdictView verdict = makeVerdictView(picture, Trend::Unknown);
  EXPECT_EQ(verdict.word, QStringLiteral("NO VERDICT"));
  EXPECT_TRUE(verdict.detail.contains(QStringLiteral("24")) && verdict.detail.contains(QStringLiteral("behind")))
      << verdict.detail.toStdString();
  const CommandView command = makeCommandView(picture);
  EXPECT_FALSE(command.autoAllowed);
  EXPECT_TRUE(command.since.contains(QStringLiteral("behind"))) << command.since.toStdString();
  EXPECT_FALSE(makeStrip(picture)[1].value.contains(QStringLiteral("nothing"))) << "samples do come";
  freshness.see(&s.snapshot, 3000, false);
  s.snapshot.health.blockAge = Seconds(0.02);
  ++s.snapshot.number;
  freshness.see(&s.snapshot, 3040);
  EXPECT_FALSE(freshness.stale()) << "it has caught up";
}

TEST(VerdictView, AReplaySaysSoAboveTheWord) {
  Scene s = chatterScene();
  Picture picture = s.picture();
  EXPECT_TRUE(makeVerdictView(picture, Trend::Unknown).caption.isEmpty());
  picture.replay = true;
  EXPECT_EQ(makeVerdictView(picture, Trend::Unknown).caption, QStringLiteral("REPLAY"));
}

TEST(AdviceView, TouchingAdviseKeepsTheSpeedThatWasOffered) {
  Scene s = chatterScene();
  s.snapshot.advice = speedAdvice();
  const QString offered = makeAdviceView(s.picture()).target;
  s.snapshot.authority = Authority::Advise;
  EXPECT_EQ(makeAdviceView(s.picture()).target, offered);
  EXPECT_FALSE(makeAdviceView(s.picture()).canAnswer()) << "nobody has asked yet";
  s.snapshot.request.reason = {ReasonCode::AdviceRefused, {8565.0, 1370.0}};
  EXPECT_NE(makeAdviceView(s.picture()).target, offered) << "refused is refused";
}

TEST(AdviceView, ARampNamesItsEndLargeAndOneFrequency) {
  Scene s = chatterScene();
  s.snapshot.authority = Authority::Auto;
  s.snapshot.commanding = true;
  s.snapshot.command.kind = CommandKind::Set;
  s.snapshot.command.speed = s.snapshot.command.feed = Ratio(8700.0 / 8800.0);
  s.snapshot.command.reason = {ReasonCode::GateMoving, {98.9, 97.3, 98.9, 97.3}};
  s.snapshot.machine.linkUp = true;
  s.snapshot.request.kind = RequestKind::Set;
  s.snapshot.request.claimsSpeed = true;
  s.snapshot.request.speed = Rpm(8565.0);
  s.snapshot.request.reason = {ReasonCode::CentreOfNextPocket, {8565.0, 3.0, 1701.0, 8800.0}};
  MoveReason reason;
  reason.see(s.snapshot);
  const AdviceView view = makeAdviceView(s.picture(), reason.reason(), reason.target());
  EXPECT_TRUE(view.target.startsWith("8" + kThin + "565")) << view.target.toStdString();
  EXPECT_TRUE(view.delta.contains("now 8" + kThin + "700")) << view.delta.toStdString();
  EXPECT_TRUE(view.reason.contains("1" + kThin + "713")) << "as the verdict: " << view.reason.toStdString();
}

TEST(CommandView, AfterTheEndNobodyAdvises) {
  Scene s = stableScene();
  Picture picture = s.picture();
  EXPECT_FALSE(makeCommandView(picture).over);
  picture.link.ended = QStringLiteral("The run has ended");
  EXPECT_TRUE(makeCommandView(picture).over);
}

TEST(SpectrumColumnReader, HandsOnEachColumnOnceAndWhatTheRingStillHas) {
  Snapshot s;
  SpectrumColumnReader reader;
  std::vector<std::uint64_t> seen;
  const auto make = [&](std::uint64_t upTo) {
    for (; s.columnCount < upTo; ++s.columnCount) s.columns[s.columnCount % kSpectrumColumns].number = s.columnCount;
    reader.read(s, [&](const SpectrumColumn& c) { seen.push_back(c.number); });
  };
  make(3);
  make(3);
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{0, 1, 2}));
  seen.clear();
  make(3 + kSpectrumColumns + 5);
  ASSERT_EQ(seen.size(), static_cast<std::size_t>(kSpectrumColumns));
  EXPECT_EQ(seen.front(), 8U);
}

}  // namespace
}  // namespace stillcut::ui
