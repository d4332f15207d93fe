// "What happened?": the log of a run, its list on Analyse and on Sessions, and what stands beside a simulated cut.
#include <QAbstractItemView>
#include <QDateTime>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QScrollBar>
#include <cmath>
#include <memory>

#include "tests/ui/support/fake_session_desk.h"
#include "tests/ui/support/pictures.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/base/format.h"
#include "ui/models/advice_view.h"
#include "ui/models/history/event_list_model.h"
#include "ui/models/history/event_log.h"
#include "ui/models/machine_view.h"
#include "ui/pages/analyse_page.h"
#include "ui/pages/event_panel.h"
#include "ui/plots/machine_plot.h"
#include "ui/widgets/advice_panel.h"

namespace stillcut::ui {
namespace {

// A machine whose numbers a test moves, one snapshot each 100 ms.
class Moving : public testing::Test {
 protected:
  void later(double seconds = 0.1) {
    Snapshot& s = scene_.snapshot;
    ++s.number;
    s.time += toDuration(Seconds(seconds));
    s.machine.time = s.time;
    log_.see(s);
  }
  void command(double speed, double feed) {
    scene_.snapshot.commanding = true;
    scene_.snapshot.command.kind = CommandKind::Set;
    scene_.snapshot.command.speed = Ratio(speed);
    scene_.snapshot.command.feed = Ratio(feed);
  }

  Scene scene_ = stableScene();
  EventLog log_;
};

TEST_F(Moving, ARampIsOneMoveWithItsReason) {
  later();
  scene_.snapshot.request.reason = {ReasonCode::CentreOfNextPocket, {8448, 3, 1713, 8800}};
  for (int k = 1; k <= 10; ++k) {
    command(1.0 - 0.004 * k, 1.0 - 0.004 * k);
    later();
  }
  ASSERT_EQ(log_.events().size(), 1U);
  const RunEvent& moved = log_.events().front();
  EXPECT_EQ(moved.what, RunEvent::What::OurMove);
  EXPECT_NEAR(moved.before, 8800.0, 1.0);
  EXPECT_NEAR(moved.after, 8448.0, 40.0);
  const QString said = eventSentence(moved, UnitSystem::Metric);
  EXPECT_TRUE(said.contains(number(8800))) << said.toStdString();
  EXPECT_TRUE(said.contains(u':')) << "and why: " << said.toStdString();
  scene_.snapshot.commanding = false;
  later(3.0);
  EXPECT_EQ(log_.events().back().what, RunEvent::What::Released);
}

TEST(EventSentence, WhereNoLengthWasMarkedNoneIsSaid) {
  const auto ended = [](double seconds, double mm) {
    RunEvent event;
    event.reason = {ReasonCode::ChatterEnded, {seconds, mm}};
    return eventSentence(event, UnitSystem::Metric);
  };
  EXPECT_TRUE(ended(1.67, 65.4).contains(QStringLiteral("65.4 mm"))) << ended(1.67, 65.4).toStdString();
  EXPECT_FALSE(ended(0.02, 0.0).contains(QStringLiteral("mm"))) << ended(0.02, 0.0).toStdString();
  EXPECT_TRUE(ended(0.02, 0.0).contains(QStringLiteral("0.02")));
}

TEST_F(Moving, WhoMovedWhatIsToldApart) {
  later();
  scene_.snapshot.machine.operatorSpeed = Ratio(0.9);
  later(3.0);
  EXPECT_EQ(log_.events().back().what, RunEvent::What::SpeedKnob);
  scene_.snapshot.machine.operatorFeed = Ratio(1.1);
  later(3.0);
  EXPECT_EQ(log_.events().back().what, RunEvent::What::FeedKnob);
  scene_.snapshot.machine.programmedSpeed = Rpm(6000);
  later(3.0);
  EXPECT_EQ(log_.events().back().what, RunEvent::What::ProgrammedSpeed);
  EXPECT_EQ(log_.events().size(), 3U);
}

TEST_F(Moving, EveryEventIsKeptOnceAndTheMachinesNumbersWhereTheyChange) {
  Snapshot& s = scene_.snapshot;
  later();
  s.eventCount = 2;
  s.events[0] = {.time = s.time, .level = EventLevel::Info, .reason = {ReasonCode::ChatterBegan, {1713, 0.4}}};
  s.events[1] = {.time = s.time, .level = EventLevel::Info, .reason = {ReasonCode::ChatterEnded, {0.4, 2.0}}};
  later();
  later();
  EXPECT_EQ(log_.events().size(), 2U);
  const std::size_t before = log_.machine().size();
  for (int k = 0; k < 5; ++k) later();
  EXPECT_LE(log_.machine().size(), before + 1) << "nothing changes";
  s.machine.actualSpeed = Rpm(8500);
  later();
  EXPECT_EQ(log_.machine().back().actual, Rpm(8500));
}

RunEvent heardAt(double seconds) {
  return {.time = Instant{} + toDuration(Seconds(seconds)),
          .what = RunEvent::What::Event,
          .reason = {ReasonCode::ChatterBegan, {1700.0 + seconds, 0.4}}};
}

qint64 wallAt(Instant t) {
  return toNs(t) / 1'000'000;
}

TEST(EventRows, OnlyWhatDiffersIsChanged) {
  EventListModel model;
  int resets = 0, told = 0;
  QObject::connect(&model, &QAbstractItemModel::modelReset, [&] { ++resets; });
  QObject::connect(&model, &QAbstractItemModel::dataChanged,
                   [&](const QModelIndex& from, const QModelIndex& to) { told += to.row() - from.row() + 1; });
  std::vector<RunEvent> events{heardAt(1), heardAt(2), heardAt(3)};
  const auto show = [&] { model.show(events, wallAt, UnitSystem::Metric); };
  show();
  const QPersistentModelIndex chosen = model.index(1);  // of the second
  const QString words = chosen.data().toString();
  events.push_back({heardAt(4).time, RunEvent::What::OurMove, EventLevel::Info, {}, 8800.0, 8700.0});
  show();
  EXPECT_EQ(chosen.data().toString(), words);
  EXPECT_EQ(told, 0);
  events.back().after = 8600.0;  // the move goes on
  events.push_back(heardAt(5));
  show();
  EXPECT_EQ(told, 1);
  EXPECT_EQ(chosen.data().toString(), words);
  events.insert(events.begin() + 3, heardAt(3.5));  // a machine's stamp, older than the newest
  show();
  EXPECT_EQ(chosen.data().toString(), words);
  events.erase(events.begin());  // the log is full
  events.push_back(heardAt(6));
  show();
  EXPECT_EQ(chosen.data().toString(), words);
  EXPECT_EQ(model.rowCount(), static_cast<int>(events.size()));
  for (int row = 0; row < model.rowCount(); ++row) {
    EXPECT_EQ(model.eventAt(row).time, events[events.size() - 1 - static_cast<std::size_t>(row)].time);
  }
  EXPECT_EQ(resets, 0);
}

TEST_F(UiTest, WhoeverReadsOlderEventsStaysThereWhileNewOnesCome) {
  EventPanel panel(QStringLiteral("rows"));
  panel.resize(400, 400);
  panel.show();
  std::vector<RunEvent> events;
  for (int k = 1; k <= 60; ++k) events.push_back(heardAt(k));
  panel.display(events, wallAt, UnitSystem::Metric);
  QCoreApplication::processEvents();
  auto* list = panel.findChild<QListView*>(QStringLiteral("rows"));
  const QModelIndex read = list->model()->index(30, 0);
  list->scrollTo(read, QAbstractItemView::PositionAtTop);
  list->setCurrentIndex(read);
  const QPersistentModelIndex kept = read;
  const int place = list->visualRect(kept).top();
  events.push_back(heardAt(61));
  panel.display(events, wallAt, UnitSystem::Metric);
  QCoreApplication::processEvents();
  EXPECT_EQ(kept.row(), 31);
  EXPECT_EQ(list->currentIndex(), kept);
  EXPECT_EQ(list->visualRect(kept).top(), place);
  list->scrollToTop();
  events.push_back(heardAt(62));
  panel.display(events, wallAt, UnitSystem::Metric);
  QCoreApplication::processEvents();
  EXPECT_EQ(list->verticalScrollBar()->value(), 0) << "whoever is at the newest sees the newest";
}

TEST_F(UiTest, WhereNothingHappenedAtThatTimeTheNearestIsChosen) {
  EventPanel panel(QStringLiteral("rows"));
  panel.resize(400, 400);
  panel.show();
  const qint64 noon = QDateTime(QDate(2026, 11, 27), QTime(12, 0)).toMSecsSinceEpoch();
  const auto wall = [noon](Instant t) { return noon + toNs(t) / 1'000'000; };
  panel.display({heardAt(60.0), heardAt(600.0), heardAt(7200.0)}, wall, UnitSystem::Metric);
  auto* list = panel.findChild<QListView*>(QStringLiteral("rows"));
  auto* search = panel.findChild<QLineEdit*>(QStringLiteral("rows-find"));
  search->setText(QStringLiteral("12:10"));
  EXPECT_EQ(list->model()->rowCount(), 1) << "that one alone";
  search->setText(QStringLiteral("13:58"));
  EXPECT_EQ(list->model()->rowCount(), 3);
  EXPECT_TRUE(list->currentIndex().data().toString().startsWith(QStringLiteral("14:00"))) << "two minutes later";
  search->setText(QStringLiteral("no such thing"));
  EXPECT_EQ(list->model()->rowCount(), 0);
}

class EventsPage : public WindowTest {
 protected:
  QListView& list(const char* name) const { return *find<QListView>(QLatin1String(name)); }
  const OperatorInput& lastSent() const { return session_.sent().back(); }
};

TEST_F(EventsPage, AnalyseListsWhatHappenedAndATouchGoesThere) {
  open();
  play(1.0);
  press("advise");
  while (!session_.snapshot().adviceOpen) play(0.04);
  press("accept");
  play(1.0);
  press("page-analyse");
  press("events");
  play(0.1);
  QListView& events = list("analyse-events");
  ASSERT_TRUE(events.isVisible());
  EXPECT_TRUE(find<MachinePlot>()->isVisible());
  ASSERT_GT(events.model()->rowCount(), 0);
  const QString newest = events.model()->index(0, 0).data().toString();
  EXPECT_TRUE(newest.contains(u':')) << "with its time of day: " << newest.toStdString();
  QTest::mouseClick(events.viewport(), Qt::LeftButton, {}, events.visualRect(events.model()->index(0, 0)).center());
  EXPECT_TRUE(find<AnalysePage>()->view().cursor(AnalyseView::A));
  EXPECT_FALSE(find<AnalysePage>()->view().following());
  auto* search = find<QLineEdit>("analyse-events-find");
  search->setText(newest.left(5));
  EXPECT_GT(events.model()->rowCount(), 0) << "by its time of day";
  search->setText(QStringLiteral("no such thing"));
  EXPECT_EQ(events.model()->rowCount(), 0);
}

TEST_F(EventsPage, ARecordingTellsWhatHappenedInItAndGoesThere) {
  FakeSessionDesk desk;
  session_.setSessions(&desk);
  open();
  window_->showPage(QStringLiteral("sessions"));
  const QString path = desk.entries().front().path;
  desk.open(path);
  auto summary = std::make_shared<SessionSummary>(*desk.summary());
  summary->events = {{instantFromNs(8'000'000'000), 1, EventLevel::Warning, {ReasonCode::ChatterBegan, {912.0, 0.4}}},
                     {instantFromNs(21'000'000'000), 2, EventLevel::Warning, {ReasonCode::ChatterBegan, {912.0, 0.5}}}};
  desk.showNext(summary);
  desk.open(path);
  tick(40);
  press("sheet-events");
  tick(40);
  QListView& events = list("session-events");
  ASSERT_TRUE(events.isVisible());
  ASSERT_EQ(events.model()->rowCount(), 2);
  const QModelIndex second = events.model()->index(1, 0);
  EXPECT_TRUE(second.data().toString().contains("912")) << second.data().toString().toStdString();
  QTest::mouseClick(events.viewport(), Qt::LeftButton, {}, events.visualRect(second).center());
  const double gone = desk.replay().position.value;
  EXPECT_TRUE(std::abs(gone - 8.0) < 0.01 || std::abs(gone - 21.0) < 0.01) << gone;
}

// Also one long ago; on Operate the newest stands as it was marked here.
TEST_F(EventsPage, AnyAlarmOfTheListIsMarkedAndTheMarkTakenBack) {
  Snapshot& s = session_.snapshot();
  s.eventCount = 0;
  open();
  play(2.0);
  const Instant first = s.time - toDuration(Seconds(1.5)), second = s.time - toDuration(Seconds(0.5));
  for (const Instant began : {first, second})
    s.events[s.eventCount++ % kEventsShown] = {
        .time = began, .level = EventLevel::Warning, .reason = {ReasonCode::ChatterBegan, {912.0, 0.4}}};
  play(0.1);
  window_->showPage(QStringLiteral("analyse"));
  press("events");
  play(0.1);
  EXPECT_FALSE(find<TouchButton>("analyse-events-was-false")->isEnabled()) << "no alarm is chosen";
  QListView& events = list("analyse-events");
  const auto rowOf = [&](Instant began) {
    for (int row = 0; row < events.model()->rowCount(); ++row) {
      const QModelIndex index = events.model()->index(row, 0);
      if (index.data().toString().startsWith(clockTime(session_.info().wallMs(began)))) return index;
    }
    return QModelIndex();
  };
  QTest::mouseClick(events.viewport(), Qt::LeftButton, {}, events.visualRect(rowOf(first)).center());
  press("analyse-events-was-false");
  EXPECT_EQ(lastSent().action, OperatorAction::FalseAlarm);
  EXPECT_EQ(lastSent().value, sinceEpoch(first).value);
  play(0.1);
  EXPECT_TRUE(rowOf(first).data().toString().contains("false alarm"));
  EXPECT_FALSE(rowOf(second).data().toString().contains("false alarm"));
  EXPECT_TRUE(find<TouchButton>("analyse-events-was-false")->isChecked());
  press("analyse-events-was-true");
  EXPECT_EQ(lastSent().action, OperatorAction::TrueAlarm);
  EXPECT_EQ(lastSent().value, sinceEpoch(first).value);
  press("analyse-events-was-true");
  EXPECT_EQ(lastSent().action, OperatorAction::UndoMark);
  EXPECT_EQ(lastSent().value, sinceEpoch(first).value);
  play(0.1);
  EXPECT_FALSE(rowOf(first).data().toString().contains("marked"));
  session_.mutableLink().ended = QStringLiteral("The run has ended");
  play(0.1);
  EXPECT_FALSE(find<TouchButton>("analyse-events-was-true")->isEnabled()) << "its recording is closed";
  window_->showPage(QStringLiteral("operate"));
  play(0.1);
  EXPECT_FALSE(find<TouchButton>("was-true")->isEnabled());
}

TEST_F(EventsPage, ARunThatIsOverAndCanBeRunAgainSaysSo) {
  open();
  play(0.4);
  session_.mutableLink().ended = QStringLiteral("The run has ended");
  session_.setMayRunAgain(true);
  play(0.1);
  EXPECT_EQ(find<AdvicePanel>()->view().mode, AdviceView::Mode::Again);
  EXPECT_EQ(find<TouchButton>("accept")->text(), QStringLiteral("AGAIN"));
  press("accept");
  EXPECT_EQ(session_.runsAgain(), 1);
}

TEST_F(EventsPage, WhyARunDoesNotBeginAgainIsSaidOnThePage) {
  open();
  play(0.4);
  session_.mutableLink().ended = QStringLiteral("The run has ended");
  session_.setMayRunAgain(true);
  session_.answerRunAgain(Error{message("mill.toml"), message("cannot be opened"), message("no such file")});
  play(0.1);
  press("accept");
  play(0.1);
  const AdviceView& view = find<AdvicePanel>()->view();
  EXPECT_EQ(view.mode, AdviceView::Mode::Again) << "it may be tried once more";
  EXPECT_TRUE(view.reason.contains(QStringLiteral("no such file"))) << view.reason.toStdString();
  session_.answerRunAgain(Done{});
  press("accept");
  play(0.1);
  EXPECT_FALSE(find<AdvicePanel>()->view().reason.contains(QStringLiteral("no such file")));
}

TEST(Without, WhatASimulatedCutWouldBeIsShownBesideWhatItIs) {
  Scene s = stableScene();
  s.snapshot.vibrationRms = 1.0;
  Picture p = s.picture();
  VibrationScale scale;
  EXPECT_LT(makeBars(p, scale)[1].without, 0.0) << "of a real cut nobody knows";
  p.vibrationWithout = 9.0;
  const BarView bar = makeBars(p, scale)[1];
  EXPECT_NEAR(bar.without / bar.fraction, 9.0, 1e-9) << "on one scale";
  EXPECT_TRUE(bar.withoutText.contains(u'9'));
}

}  // namespace
}  // namespace stillcut::ui
