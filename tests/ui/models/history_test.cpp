// What the screens remember: columns, verdicts, samples with their gaps; and the models that read it out.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QDateTime>
#include <QSettings>
#include <QTemporaryDir>
#include <cmath>

#include "tests/ui/support/fake_lobes.h"
#include "tests/ui/support/fake_session.h"
#include "tests/ui/support/pictures.h"
#include "ui/base/format.h"
#include "ui/models/history/analyse_view.h"
#include "ui/models/history/run_history.h"
#include "ui/models/history/signal_history.h"
#include "ui/models/history/spectrum_view.h"
#include "ui/models/lobe_view.h"
#include "ui/models/time_text.h"
#include "ui/models/tune/preset_list.h"
#include "ui/plots/spectrogram/heat_image.h"

namespace stillcut::ui {
namespace {

Instant at(double s) {
  return Instant() + toDuration(Seconds(s));
}

CutSetup oneChannel(double scale = 1.0) {
  CutSetup setup;
  setup.rate = Hertz(1000);
  setup.channels = {{"x", SensorQuantity::Acceleration, scale, "x"}};
  return setup;
}

SampleBlock blockOf(Instant first, const std::vector<float>& samples) {
  SampleBlock block;
  block.allocate(1, static_cast<int>(samples.size()));
  block.samples = samples;
  block.frames = block.capacityFrames;
  block.rate = Hertz(1000);
  block.firstSample = first;
  return block;
}

TEST(SignalHistory, GivesLowestAndHighestInSiUnits) {
  SignalHistory history;
  history.prepare(oneChannel(10.0));
  history.add(blockOf(at(1.0), {1.0F, -2.0F, 3.0F, 0.5F}));
  const auto whole = history.extents(0, at(1.0), at(1.004), 1);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_FLOAT_EQ(whole[0].low, -20.0F);
  EXPECT_FLOAT_EQ(whole[0].high, 30.0F);
  const auto each = history.extents(0, at(1.0), at(1.004), 4);
  EXPECT_FLOAT_EQ(each[2].high, 30.0F);
  EXPECT_FLOAT_EQ(each[3].low, 5.0F);
  EXPECT_FALSE(history.extents(1, at(1.0), at(1.004), 1)[0].present) << "there is no such channel";
}

TEST(SignalHistory, WhatIsMissingIsAGapAndIsNotDrawn) {
  SignalHistory history;
  history.prepare(oneChannel());
  history.add(blockOf(at(0.0), std::vector<float>(100, 1.0F)));
  history.add(blockOf(at(0.1), std::vector<float>(100, 1.0F)));
  SampleBlock late = blockOf(at(0.4), std::vector<float>(100, 1.0F));
  late.flags |= kBlockGap;
  history.add(late);
  ASSERT_EQ(history.gaps().size(), 1U) << "blocks that follow each other are one piece";
  EXPECT_NEAR(secondsBetween(at(0.2), history.gaps()[0].from).value, 0.0, 1e-6);
  EXPECT_NEAR(secondsBetween(at(0.4), history.gaps()[0].to).value, 0.0, 1e-6);
  const auto extents = history.extents(0, at(0.0), at(0.5), 5);
  EXPECT_TRUE(extents[1].present);
  EXPECT_FALSE(extents[2].present);
  EXPECT_FALSE(extents[3].present);
  EXPECT_TRUE(extents[4].present);
}

TEST(SignalHistory, WhatTheScreenMissedIsEmptyAndNoGapOfSamples) {
  SignalHistory history;
  history.prepare(oneChannel());
  history.add(blockOf(at(0.0), std::vector<float>(100, 1.0F)));
  history.add(blockOf(at(0.4), std::vector<float>(100, 1.0F)));
  EXPECT_TRUE(history.gaps().empty());
  EXPECT_FALSE(history.extents(0, at(0.0), at(0.5), 5)[2].present);
}

TEST(EventLog, AnAlarmIsAnOnsetUntilItHasBecomeChatter) {
  Snapshot s;
  s.detectorCount = 1;
  s.number = 1;
  s.eventCount = 1;
  s.events[0] = {at(1.0), 0, EventLevel::Warning, {ReasonCode::ChatterBegan, {1713.0, 0.3}}};
  s.verdicts[0].valid = true;
  s.verdicts[0].state = CutState::Onset;
  EventLog log;
  log.see(s);
  ASSERT_EQ(log.events().size(), 1U);
  EXPECT_TRUE(eventSentence(log.events()[0], UnitSystem::Metric).startsWith(QStringLiteral("Onset")));
  s.verdicts[0].state = CutState::Chatter;
  log.see(s);
  EXPECT_TRUE(eventSentence(log.events()[0], UnitSystem::Metric).startsWith(QStringLiteral("Chatter")));
}

// The stamps of a device whose clock is being followed: each block a little off from where the one before ended, and a
// crystal that is off by half a percent.
TEST(SignalHistory, AClockThatIsBeingFollowedMakesNoGaps) {
  SignalHistory history;
  history.prepare(oneChannel());
  for (int k = 0; k < 200; ++k) {
    const double wobble = 0.004 * std::sin(0.7 * k);  // four samples
    history.add(blockOf(at(1.0 + 0.0201 * 1.005 * k + wobble), std::vector<float>(20, 1.0F)));
  }
  EXPECT_TRUE(history.gaps().empty());
  EXPECT_NEAR(secondsBetween(at(1.0 + 0.0201 * 1.005 * 199), history.end()).value, 0.02, 0.015)
      << "the stamps are kept to";
  SampleBlock lost = blockOf(history.end(), std::vector<float>(20, 1.0F));
  lost.flags = kBlockGap;
  history.add(lost);
  EXPECT_EQ(history.gaps().size(), 1U) << "the device says so";
}

TEST(SignalHistory, KeepsTheNewestSecondsOnly) {
  SignalHistory history;
  history.prepare(oneChannel());
  for (int k = 0; k < 400; ++k) history.add(blockOf(at(0.1 * k), std::vector<float>(100, static_cast<float>(k))));
  EXPECT_NEAR(secondsBetween(history.begin(), history.end()).value, SignalHistory::kKept.value, 1e-6);
  EXPECT_NEAR(sinceEpoch(history.end()).value, 40.0, 1e-6);
  EXPECT_FLOAT_EQ(history.extents(0, at(39.95), at(40.0), 1)[0].high, 399.0F);
}

TEST(RunHistory, RemembersMoreThanASnapshotHolds) {
  FakeSession session;
  RunHistory history;
  for (int k = 0; k < 100; ++k) {
    session.advance(Seconds(0.04));
    history.see(*session.pull());
  }
  EXPECT_EQ(history.columns().size(), 100U);
  ASSERT_EQ(history.tracks().size(), 2U);
  EXPECT_EQ(history.tracks()[0].size(), 100U);
  EXPECT_EQ(history.end(), session.snapshot().time);
  const SpectrumColumn* column = history.columnAt(at(2.0));
  ASSERT_NE(column, nullptr);
  EXPECT_NEAR(sinceEpoch(column->time).value, 2.0, 0.021);
  history.see(*session.pull());
  EXPECT_EQ(history.columns().size(), 100U) << "the same picture again brings nothing";
}

TEST(RunHistory, KnowsWhereSamplesAreMissing) {
  FakeSession session;
  RunHistory history;
  for (int k = 0; k < 10; ++k) {
    session.advance(Seconds(0.04));
    if (k == 6) session.snapshot().health.gaps += 2;
    history.see(*session.pull());
  }
  for (std::size_t k = 0; k < 10; ++k) EXPECT_EQ(history.tracks()[0][k].afterGap, k == 6) << k;
}

// "Was stable" is said of a cut that was judged at its speed; chatter is chatter wherever it was.
TEST(RunHistory, StablePointsAreOfSteadyCutsAtSpeedOnly) {
  Scene s = stableScene();
  s.snapshot.machine.programmedSpeed = s.snapshot.machine.actualSpeed = Rpm(8800.0);
  RunHistory history;
  const auto next = [&] {
    s.snapshot.time += std::chrono::seconds(1);
    ++s.snapshot.number;
    history.see(s.snapshot);
    return history.points().size();
  };
  s.verdict().phase = CutPhase::Entry;
  EXPECT_EQ(next(), 0U);
  s.verdict().phase = CutPhase::Steady;
  s.snapshot.machine.actualSpeed = Rpm(8500.0);
  EXPECT_EQ(next(), 0U) << "on its way to another speed";
  s.snapshot.machine.actualSpeed = Rpm(8790.0);
  EXPECT_EQ(next(), 1U);
  s.verdict().phase = CutPhase::Entry;
  s.verdict().state = CutState::Chatter;
  EXPECT_EQ(next(), 2U);
}

TEST(RunHistory, AnotherChannelBeginsANewPicture) {
  FakeSession session;
  RunHistory history;
  session.advance(Seconds(0.4));
  history.see(*session.pull());
  session.showChannel(1);
  session.advance(Seconds(0.04));
  history.see(*session.pull());
  ASSERT_EQ(history.columns().size(), 1U);
  EXPECT_EQ(history.columns().front().channel, 1);
}

// A picture that was moved along is the picture painted at once.
TEST(HeatImage, MovedAlongIsTheSameAsPaintedAnew) {
  FakeSession session;
  RunHistory history;
  HeatImage moving;
  HeatWindow window;
  window.size = QSize(300, 80);
  window.span = Seconds(4.0);
  window.high = Hertz(5000);
  window.gap = qRgb(1, 2, 3);
  const auto look = [&] {
    window.from = history.end() - toDuration(window.span);
    return moving.draw(history, window).copy();
  };
  QImage last;
  for (int k = 0; k < 200; ++k) {
    if (k == 120) session.lose(Seconds(0.4));
    session.advance(Seconds(0.04));
    history.see(*session.pull());
    last = look();
    if (k != 150) continue;
    EXPECT_LT(moving.painted(), 20) << "only what is new";
  }
  HeatImage anew;
  const QImage whole = anew.draw(history, window);
  EXPECT_GT(anew.painted(), 200);
  int different = 0;
  for (int y = 0; y < whole.height(); ++y) {
    for (int x = 0; x < whole.width(); ++x) different += whole.pixel(x, y) != last.pixel(x, y) ? 1 : 0;
  }
  EXPECT_EQ(different, 0);
  int gaps = 0;
  for (int x = 0; x < whole.width(); ++x) gaps += whole.pixel(x, 40) == window.gap ? 1 : 0;
  EXPECT_NEAR(gaps, 0.4 / 4.0 * 300, 6) << "what was lost leaves a hole as long as it lasted";
}

TEST(AnalyseView, ZoomKeepsTheMomentUnderThePointer) {
  AnalyseView view;
  view.setReach(at(0), at(60), Hertz(12800));
  view.goTo(at(30));
  const double before = secondsBetween(view.from(), at(28)) / view.options().span;
  view.zoomTime(0.5, at(28));
  EXPECT_NEAR(view.options().span.value, 5.0, 1e-9);
  EXPECT_NEAR(secondsBetween(view.from(), at(28)) / view.options().span, before, 1e-9);
}

TEST(AnalyseView, APictureThatStandsStaysWhileTimeGoesOn) {
  AnalyseView view;
  view.setReach(at(0), at(20), Hertz(12800));
  EXPECT_EQ(view.to(), at(20));
  view.setCursor(AnalyseView::A, at(15));
  view.pan(Seconds(-2));
  view.setReach(at(0), at(50), Hertz(12800));
  EXPECT_FALSE(view.following());
  EXPECT_NEAR(secondsBetween(at(18), view.to()).value, 0.0, 1e-9);
  view.follow();
  EXPECT_EQ(view.to(), at(50));
  EXPECT_EQ(view.cursor(AnalyseView::A), at(15)) << "cursors stay";
}

TEST(AnalyseView, NothingMovesOutOfSightOrOutOfBounds) {
  AnalyseView view;
  view.setReach(at(10), at(20), Hertz(12800));
  view.pan(Seconds(-1e6));
  EXPECT_GT(view.to(), at(10));
  view.pan(Seconds(1e6));
  EXPECT_LT(view.from(), at(20));
  view.zoomTime(1e-9, at(15));
  EXPECT_EQ(view.options().span, AnalyseView::kShortest);
  view.zoomFrequency(1e-9, Hertz(1000));
  EXPECT_NEAR((view.options().high - view.options().low).value, AnalyseView::kNarrowest.value, 1e-6);
  view.zoomFrequency(1e9, Hertz(1000));
  EXPECT_LE(view.options().high, Hertz(12800));
  EXPECT_GE(view.options().low.value, 0.0);
}

TEST(SpectrumView, FindsTheChatterLineAndReadsItsOrder) {
  FakeSession session;
  RunHistory history;
  for (int k = 0; k < 150; ++k) {
    session.advance(Seconds(0.04));
    history.see(*session.pull());
  }
  AnalyseView view;
  view.setReach(history.begin(), history.end(), history.spectrumTop());
  SpectrumView spectrum = makeSpectrumView(history, view, session.info());
  ASSERT_TRUE(spectrum.known);
  const auto line = strongestLine(spectrum.level_dB, spectrum.top, Hertz(1500), Hertz(1900));
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->value, 1713.0, 15.0) << "half a bin of 25 Hz, and noise";
  view.setHarmonic(*line);
  spectrum = makeSpectrumView(history, view, session.info());
  EXPECT_NEAR(spectrum.harmonics.at(1).value, 2.0 * line->value, 1e-9);
  EXPECT_TRUE(spectrum.reading.contains(QStringLiteral("order 11."))) << spectrum.reading.toStdString();
  EXPECT_NEAR(spectrum.toothPassing.front().value, 8800.0 / 60.0 * 4, 1.0);
}

TEST(SpectrumView, MaxHoldIsTheHighestOfTheStretchOnShow) {
  FakeSession session;
  RunHistory history;
  for (int k = 0; k < 250; ++k) {
    session.advance(Seconds(0.04));
    if (k == 150) session.send({OperatorAction::GrantBySimulation, Authority::Auto}, session.generation());
    history.see(*session.pull());
  }
  AnalyseView view;
  view.setReach(history.begin(), history.end(), history.spectrumTop());
  AnalyseOptions options;
  options.maxHold = true;
  view.setOptions(options);
  const SpectrumView spectrum = makeSpectrumView(history, view, session.info());
  ASSERT_TRUE(spectrum.hold);
  const auto chatter = static_cast<std::size_t>(1713.0 / 25.0);
  EXPECT_GT((*spectrum.hold)[chatter], spectrum.level_dB[chatter] + 20.0F) << "the chatter that is over is still held";
}

TEST(TimeText, ReadsClockAndSecondsAgo) {
  SessionInfo info;
  info.wallMsAtStreamZero = 1'780'000'000'000;
  const Instant newest = at(100);
  EXPECT_EQ(momentFrom("-12.5", info, newest), at(87.5));
  EXPECT_EQ(momentFrom("-12,5 s", info, newest), at(87.5));
  const QString clock = clockTime(info.wallMs(at(90)));
  EXPECT_EQ(momentFrom(clock, info, newest), at(90));
  EXPECT_EQ(momentFrom(clock.left(5), info, newest), momentFrom(clock.left(5) + ":00", info, newest))
      << "whoever asks what happened at 13:58 need not know the second";
  info.wallMsAtStreamZero = QDateTime(QDate(2026, 11, 27), QTime(0, 5)).toMSecsSinceEpoch() - 100'000;
  const auto beforeMidnight = momentFrom("23:58", info, newest);
  ASSERT_TRUE(beforeMidnight);
  EXPECT_NEAR(secondsBetween(*beforeMidnight, newest).value, 7 * 60.0, 1e-6);
  for (const char* wrong : {"", "12", "25:00:00", "noon", "1:2:3"})
    EXPECT_FALSE(momentFrom(wrong, info, newest)) << wrong;
}

TEST(PresetList, KeepsTheUsersOwnAndPassesTheModelTester) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("a.ini");
  AnalyseOptions mine;
  mine.axis = FrequencyAxis::Order;
  mine.span = Seconds(3);
  {
    PresetList presets;
    const QAbstractItemModelTester tester(&presets, QAbstractItemModelTester::FailureReportingMode::Fatal);
    const int shipped = presets.rowCount();
    EXPECT_FALSE(presets.save("  ", mine));
    EXPECT_FALSE(presets.save(presets.data(presets.index(0)).toString(), mine)) << "the program's own stay";
    EXPECT_TRUE(presets.save("my cut", {}));
    EXPECT_TRUE(presets.save("my cut", mine));
    EXPECT_EQ(presets.rowCount(), shipped + 1);
    EXPECT_FALSE(presets.remove(0));
    QSettings settings(file, QSettings::IniFormat);
    presets.keep(settings);
  }
  PresetList again;
  const QAbstractItemModelTester tester(&again, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const QSettings settings(file, QSettings::IniFormat);
  again.restore(settings);
  ASSERT_GE(again.rowOf("my cut"), 0);
  EXPECT_EQ(again.options(again.rowOf("my cut")), mine);
  EXPECT_TRUE(again.remove(again.rowOf("my cut")));
}

TEST(Lobes, PocketsAreWhereTheLimitIsDeeperThanTheCut) {
  FakeLobes lobes;
  lobes.ask({LobeMethodChoice::Exact, lobes.frame().lowest, lobes.frame().highest, 200, lobes.frame().maxAxialDepth});
  lobes.finish();
  const auto pockets = pocketsAt(*lobes.diagram(), lobes.frame(), Metres(2e-3));
  ASSERT_EQ(pockets.size(), 4U);  // 4 500, 7 000, 9 500, 12 000 rpm
  EXPECT_NEAR(pockets[1].best.value, 7000.0, 51.0);
  EXPECT_NEAR(pockets[1].limit.value, 3e-3, 1e-5);
  for (const double edge : {pockets[1].from.value, pockets[1].to.value}) {
    EXPECT_NEAR(limitAt(*lobes.diagram(), Rpm(edge))->value, 2e-3, 2e-5);
  }
  // depth x width x feed per tooth x teeth x revolutions per second
  EXPECT_NEAR(pockets[1].removal, 2e-3 * 8e-3 * 40e-6 * 4 * pockets[1].best.value / 60.0, 1e-15);
  EXPECT_TRUE(pockets[1].reachable);
  EXPECT_FALSE(pockets[3].reachable) << "12 000 rpm is beyond 120 % of 8 800";
  EXPECT_TRUE(pocketsAt(*lobes.diagram(), lobes.frame(), Metres(3.5e-3)).empty());
}

TEST(Lobes, WhatIfSaysStableOrChatterWithItsMargin) {
  FakeLobes lobes;
  EXPECT_FALSE(whatIf(nullptr, lobes.frame(), {Rpm(7000), Metres(1e-3)}, UnitSystem::Metric).known);
  lobes.ask({LobeMethodChoice::Exact, lobes.frame().lowest, lobes.frame().highest, 200, lobes.frame().maxAxialDepth});
  lobes.finish();
  const auto ask = [&](double rpm, double mm) {
    return whatIf(lobes.diagram().get(), lobes.frame(), {Rpm(rpm), Metres(mm * 1e-3)}, UnitSystem::Metric);
  };
  EXPECT_TRUE(ask(7000, 2.0).stable);
  EXPECT_TRUE(ask(7000, 2.0).verdict.contains("50"));
  EXPECT_FALSE(ask(8250, 2.0).stable);
  EXPECT_TRUE(ask(8250, 2.0).verdict.contains("100")) << ask(8250, 2.0).verdict.toStdString();
  EXPECT_FALSE(ask(20000, 2.0).known);
}

// Shallow up to 11 000 rpm, then nothing limits the cut as deep as was looked, up to 16 000.
LobeDiagram openPocket() {
  LobeDiagram diagram;
  for (int n = 9000; n <= 18000; n += 100) {
    const bool open = n >= 11000 && n <= 16000;
    diagram.limits.push_back({Rpm(n), Metres(open ? 4.5e-3 : 1e-3), !open, ChatterKind::Unknown, Hertz()});
  }
  return diagram;
}

TEST(Lobes, APocketsBestSpeedIsTheMiddleOfItsPlateauNotItsEdge) {
  const LobeDiagram diagram = openPocket();
  LobeFrame frame;
  frame.reachLow = Rpm(8000);
  frame.reachHigh = Rpm(20000);
  auto pockets = pocketsAt(diagram, frame, Metres(2e-3));
  ASSERT_EQ(pockets.size(), 1U);
  EXPECT_NEAR(pockets[0].best.value, 13500.0, 1.0);
  EXPECT_FALSE(pockets[0].limited);
  frame.reachHigh = Rpm(12000);
  pockets = pocketsAt(diagram, frame, Metres(2e-3));
  EXPECT_NEAR(pockets[0].best.value, 12000.0, 1.0) << "as near to the middle as the override reaches";
  EXPECT_TRUE(pockets[0].reachable);
  frame.reachHigh = Rpm(10500);
  pockets = pocketsAt(diagram, frame, Metres(2e-3));
  EXPECT_FALSE(pockets[0].reachable);
  EXPECT_NEAR(pockets[0].best.value, 13500.0, 1.0);
}

TEST(Lobes, WhereTheSearchEndedIsNotToldAsALimit) {
  const LobeDiagram diagram = openPocket();
  LobeFrame frame;
  frame.reachHigh = Rpm(20000);
  PocketTable table;
  table.setPockets(pocketsAt(diagram, frame, Metres(4.5e-3)), UnitSystem::Metric);
  ASSERT_EQ(table.rowCount(), 1) << "quiet down to the end of the search, that depth included";
  const QModelIndex limit = table.index(0, PocketTable::Limit);
  EXPECT_EQ(table.data(limit).toString(), QStringLiteral("> 4.50\u00a0mm"));
  EXPECT_TRUE(table.data(limit, Qt::ToolTipRole).toString().contains("No limit found"));
  const auto ask = [&](double rpm, double mm) {
    return whatIf(&diagram, frame, {Rpm(rpm), Metres(mm * 1e-3)}, UnitSystem::Metric);
  };
  EXPECT_TRUE(ask(13500, 4.5).stable);
  EXPECT_TRUE(ask(13500, 3.0).verdict.contains("no limit found down to"));
  EXPECT_TRUE(ask(13500, 3.0).detail.contains("deeper than"));
  EXPECT_FALSE(ask(13500, 5.0).known) << "nobody looked there";
  EXPECT_FALSE(ask(10000, 2.0).stable);
  EXPECT_TRUE(ask(10000, 0.5).detail.startsWith("limit 1.00"));
}

TEST(Lobes, PocketTablePassesTheModelTester) {
  FakeLobes lobes;
  lobes.ask({LobeMethodChoice::Exact, lobes.frame().lowest, lobes.frame().highest, 200, lobes.frame().maxAxialDepth});
  lobes.finish();
  PocketTable table;
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  table.setPockets(pocketsAt(*lobes.diagram(), lobes.frame(), Metres(2e-3)), UnitSystem::Metric);
  EXPECT_EQ(table.rowCount(), 4);
  EXPECT_TRUE(table.data(table.index(1, PocketTable::Limit)).toString().contains("mm"));
  table.setPockets({}, UnitSystem::Inch);
  EXPECT_EQ(table.rowCount(), 0);
}

}  // namespace
}  // namespace stillcut::ui
