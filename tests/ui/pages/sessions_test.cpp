// The Sessions page, driven as a person would, and its models.
#include <QAbstractItemModelTester>
#include <QFileInfo>
#include <QLineEdit>
#include <QListView>

#include "tests/ui/support/page_picture.h"
#include "tests/ui/support/sessions_fixture.h"
#include "ui/base/format.h"
#include "ui/models/session_models.h"
#include "ui/models/session_text.h"
#include "ui/pages/sessions_page.h"
#include "ui/plots/session_timeline.h"
#include "ui/widgets/transport_bar.h"
#include "ui/widgets/value_slider.h"

namespace stillcut::ui {
namespace {

TEST_F(SessionsPageTest, ListIsOrderedFilteredAndOpensByTouchAndKey) {
  openSessions();
  auto* list = find<QListView>("session-list");
  ASSERT_EQ(list->model()->rowCount(), 3);
  const auto first = [&] { return list->model()->index(0, 0).data(SessionListModel::JobRole).toString(); };
  EXPECT_EQ(first(), QStringLiteral("Bracket")) << "newest first";
  press("sessions-by-tool");
  EXPECT_EQ(first(), QStringLiteral("face"));
  press("sessions-by-job");
  EXPECT_EQ(first(), QStringLiteral("Bracket"));
  auto* filter = find<QLineEdit>("session-filter");
  filter->setFocus();
  QTest::keyClicks(filter, QStringLiteral("hous"));
  ASSERT_EQ(list->model()->rowCount(), 1);
  list->setFocus();
  list->setCurrentIndex(list->model()->index(0, 0));
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_TRUE(controller_.openedPath().contains(QStringLiteral("Housing")));
}

TEST_F(SessionsPageTest, TransportLeadsTheReplay) {
  openSessions();
  EXPECT_FALSE(find<TouchButton>("replay-play")->isEnabled());
  openFirst();
  press("replay-play");
  EXPECT_TRUE(controller_.state.playing);
  play(1.0);
  EXPECT_GT(controller_.state.position.value, 0.5);
  press("replay-play");
  EXPECT_FALSE(controller_.state.playing);
  press("replay-step");
  press("replay-step");
  press("replay-back");
  EXPECT_EQ(controller_.steps, 1);
  press("replay-start");
  EXPECT_EQ(controller_.state.position.value, 0.0);
  auto* pace = find<ValueSlider>("replay-pace");
  pace->setFocus();
  QTest::keyClick(pace, Qt::Key_Home);
  EXPECT_DOUBLE_EQ(controller_.state.pace, 0.1);
  QTest::keyClick(pace, Qt::Key_End);
  EXPECT_DOUBLE_EQ(controller_.state.pace, 0.0) << "as fast as possible";
}

TEST(Transport, EveryPaceOfTheSliderIsInReach) {
  for (int k = 0; k <= 98; ++k) {
    const double pace = TransportBar::paceAt(k / 100.0);
    EXPECT_GE(pace, 0.1);
    EXPECT_LE(pace, 1000.0);
    EXPECT_NEAR(TransportBar::fractionOfPace(pace), k / 100.0, 0.02);
  }
  EXPECT_EQ(TransportBar::paceAt(TransportBar::fractionOfPace(1.0)), 1.0);
  EXPECT_EQ(TransportBar::paceAt(1.0), 0.0);
}

// Controlled and alone: two recordings on one axis.
TEST_F(SessionsPageTest, ARecordingStaysBesideTheNextOne) {
  openSessions();
  press("sheet-compare");
  EXPECT_FALSE(find<TouchButton>("session-beside")->isEnabled());
  openFirst();
  auto* timeline = find<SessionTimeline>();
  press("session-beside");
  EXPECT_FALSE(timeline->besideShown()) << "not beside itself";
  auto other = std::make_shared<SessionSummary>(*controller_.summary());
  other->file = "/rec/Bracket/T3/2026-11-21.h5";
  other->length = Seconds(20.0);
  for (SummaryPoint& point : other->curve) point.vibration *= 0.5;
  controller_.showNext(other);
  controller_.open(QStringLiteral("/rec/Bracket/T3/2026-11-21.h5"));
  tick(40);
  EXPECT_TRUE(timeline->besideShown());
  const QImage both = timeline->grab().toImage();
  savePage(*window_, "sessions", kPageLooks[0], "beside");
  press("session-beside");
  EXPECT_FALSE(timeline->besideShown());
  const QImage alone = timeline->grab().toImage();
  const QColor line = themeColors(ThemeKind::Light).advice;
  const auto count = [&](const QImage& image) {
    int found = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) found += image.pixelColor(x, y) == line ? 1 : 0;
    }
    return found;
  };
  EXPECT_GT(count(both), count(alone) + 200) << "its curve, and its alarms in a row of their own";
}

TEST_F(SessionsPageTest, WhatIsReadMeanwhileLeavesTheSelectedSpan) {
  openSessions();
  openFirst();
  auto* timeline = find<SessionTimeline>();
  timeline->select(Seconds(8.0), Seconds(9.5));
  timeline->setSummary(std::make_shared<SessionSummary>(*controller_.summary()));
  EXPECT_TRUE(timeline->hasSelection());
  EXPECT_EQ(timeline->selectedTo().value, 9.5);
  auto other = std::make_shared<SessionSummary>(*controller_.summary());
  other->file = "/rec/Bracket/T3/2026-11-21.h5";
  timeline->setSummary(other);
  EXPECT_FALSE(timeline->hasSelection()) << "of another recording";
}

TEST_F(SessionsPageTest, ClickGoesThereAndDragSelectsForLoopMarkAndExport) {
  openSessions();
  openFirst();
  measureAxis();
  auto* timeline = find<SessionTimeline>();
  QTest::mouseClick(timeline, Qt::LeftButton, {}, at(12.0));
  EXPECT_NEAR(controller_.state.position.value, 12.0, 0.2);
  press("replay-loop");
  EXPECT_FALSE(controller_.state.looping) << "there is nothing to repeat yet";

  QTest::mousePress(timeline, Qt::LeftButton, {}, at(8.0));
  QTest::mouseMove(timeline, at(9.0));
  QTest::mouseRelease(timeline, Qt::LeftButton, {}, at(9.5));
  tick(40);
  press("replay-loop");
  EXPECT_TRUE(controller_.state.looping);
  EXPECT_NEAR(controller_.state.loopFrom.value, 8.0, 0.2);
  EXPECT_NEAR(controller_.state.loopTo.value, 9.5, 0.2);

  auto* note = find<QLineEdit>("mark-text");
  note->setFocus();
  QTest::keyClicks(note, QStringLiteral("corner"));
  press("mark-true");
  ASSERT_EQ(controller_.marks.size(), 1U);
  EXPECT_EQ(controller_.marks[0].label, kLabelTrueAlarm);
  EXPECT_EQ(controller_.marks[0].note, "corner");
  EXPECT_NEAR(secondsBetween(controller_.marks[0].begin, controller_.marks[0].end).value, 1.5, 0.3);
  EXPECT_TRUE(note->text().isEmpty());

  press("sheet-compare");
  press("session-export");
  EXPECT_TRUE(controller_.exported.endsWith(QStringLiteral(".wav")));
  EXPECT_NEAR(controller_.exportFrom.value, 8.0, 0.2);
  EXPECT_NEAR(controller_.exportTo.value, 9.5, 0.2);
}

TEST_F(SessionsPageTest, WhatWasRecordedMeanwhileIsListedWhenSomebodyLooks) {
  openSessions();
  const int before = controller_.listed;
  EXPECT_GT(before, 0);
  window_->showPage(QStringLiteral("operate"));
  play(0.2);
  EXPECT_EQ(controller_.listed, before);
  window_->showPage(QStringLiteral("sessions"));
  EXPECT_EQ(controller_.listed, before + 1);
}

TEST_F(SessionsPageTest, ASimulatedCutIsOpenedBesideTheRecordings) {
  openSessions();
  auto* list = find<QListView>("session-list");
  EXPECT_EQ(list->model()->rowCount(), 3);
  press("sessions-simulated");
  ASSERT_EQ(list->model()->rowCount(), 1);
  openFirst();
  EXPECT_EQ(controller_.openedPath(), QStringLiteral("/scenarios/demo.toml"));
  press("sessions-recorded");
  EXPECT_EQ(list->model()->rowCount(), 3);
}

TEST_F(SessionsPageTest, WhatIsExportedGoesIntoTheChosenFormat) {
  openSessions();
  openFirst();
  press("sheet-compare");
  QStringList suffixes;
  for (int k = 0; k < 7; ++k) {
    press("session-export");
    suffixes << QFileInfo(controller_.exported).suffix();
    press("session-format");
  }
  EXPECT_EQ(suffixes.join(u' '), QStringLiteral("wav flac csv mat uff unv hdf5"));
  EXPECT_EQ(find<TouchButton>("session-format")->text(), QStringLiteral("AS PNG"));
  controller_.exported.clear();
  press("session-export");
  EXPECT_TRUE(controller_.exported.isEmpty()) << "a picture is not made of samples";
  bool told = false;  // there is no such folder here
  for (const TextLabel* label : window_->findChildren<TextLabel*>())
    told = told || label->text().contains(QStringLiteral(".png: cannot be written"));
  EXPECT_TRUE(told);
}

TEST_F(UiTest, AReportIsWrittenInTheUnitsOfTheScreen) {
  FakeSessionDesk controller;
  controller.open(controller.entries().front().path);
  std::vector<UnitSystem> written;
  SessionsPage page(&controller, [&](const SessionSummary&, const QString&, UnitSystem units) {
    written.push_back(units);
    return Status(Done{});
  });
  Picture picture;
  for (const UnitSystem units : {UnitSystem::Inch, UnitSystem::Metric}) {
    picture.units = units;
    page.see(picture);
    page.display(picture);
    QTest::mouseClick(page.findChild<TouchButton*>(QStringLiteral("session-report")), Qt::LeftButton);
  }
  EXPECT_EQ(written, (std::vector{UnitSystem::Inch, UnitSystem::Inch, UnitSystem::Metric, UnitSystem::Metric}));
}

TEST_F(SessionsPageTest, FilesThatCouldNotBeScoredAreListedWithTheReason) {
  controller_.unreadable = {QStringLiteral("/rec/broken.h5: is cut short: its end is missing")};
  openSessions();
  openFirst();
  press("sheet-compare");
  press("session-score-all");
  tick(40);
  QString told;
  for (const TextLabel* label : window_->findChildren<TextLabel*>()) told += label->text() + u'\n';
  EXPECT_TRUE(told.contains(QStringLiteral("found 3 of 4")));
  EXPECT_TRUE(told.contains(QStringLiteral("Not scored: /rec/broken.h5: is cut short")));
}

TEST_F(SessionsPageTest, DetectorsRunSideBySideWithWhatWasTuned) {
  controller_.tuned = {QStringLiteral("energy-ratio.chatter=0.3")};
  openSessions();
  openFirst();
  press("sheet-compare");
  press("session-tuned");
  press("session-run");
  EXPECT_EQ(controller_.asked, controller_.tuned);
  tick(40);
  bool told = false;
  for (const TextLabel* label : window_->findChildren<TextLabel*>()) {
    told = told || label->text().contains(QStringLiteral(
                       "would have alarmed once, none marked false; as recorded: 2 times, 1 of them marked false"));
  }
  EXPECT_TRUE(told);
  press("session-score-all");
  EXPECT_TRUE(controller_.scoredFolder);
}

TEST_F(SessionsPageTest, TheReplayTakesThePlaceOfTheCutOnlyWhereItMay) {
  openSessions();
  openFirst();
  controller_.refuse = true;
  press("replay-everywhere");
  tick(40);
  EXPECT_FALSE(find<TouchButton>("replay-everywhere")->isChecked());
  controller_.refuse = false;
  press("replay-everywhere");
  tick(40);
  EXPECT_TRUE(controller_.everywhere);
}

TEST(SessionModels, PassTheModelTester) {
  FakeSessionDesk controller;
  SessionListModel list;
  SessionOrder order;
  MarkerModel markers;
  order.setSourceModel(&list);
  const auto fatal = QAbstractItemModelTester::FailureReportingMode::Fatal;
  const QAbstractItemModelTester a(&list, fatal), b(&order, fatal), c(&markers, fatal);
  std::vector<SessionEntry> entries = controller.entries();
  entries[0].inside = SessionEntry::Inside::NotYet;
  list.show(entries);
  EXPECT_FALSE(list.index(0).data().toString().contains(QStringLiteral("markers")));
  const QPersistentModelIndex chosen = list.index(0);
  list.show(controller.entries());
  ASSERT_TRUE(chosen.isValid()) << "what is found inside a file costs nobody his place in the list";
  EXPECT_TRUE(chosen.data().toString().endsWith(duration(Seconds(754.0)) + QStringLiteral(", markers: 2")));
  order.orderBy(SessionOrder::Job);
  order.setFilterFixedString(QStringLiteral("T3"));
  EXPECT_EQ(order.rowCount(), 1);
  ASSERT_TRUE(controller.mark(Seconds(61.5), Seconds(63.0), QStringLiteral("heard"), QStringLiteral("loud")).ok());
  markers.show(controller);
  EXPECT_EQ(markers.index(0, 0).data().toString(),
            QStringLiteral("1:01.50  heard, %1: loud").arg(duration(Seconds(1.5))));
  list.show({});
}

TEST_F(SessionsPageTest, OnlyWhatIsOnTheScreenIsLookedInto) {
  std::vector<SessionEntry> many(500, controller_.entries().front());
  for (int k = 0; k < 500; ++k) {
    SessionEntry& entry = many[static_cast<std::size_t>(k)];
    entry.path = QStringLiteral("/rec/%1.h5").arg(k);
    entry.inside = SessionEntry::Inside::NotYet;
    entry.wallMs -= k;
  }
  controller_.setEntries(many);
  openSessions();
  ASSERT_FALSE(controller_.lookedInto.isEmpty());
  EXPECT_LT(controller_.lookedInto.size(), 40);
  EXPECT_EQ(controller_.lookedInto.front(), many.front().path);
  find<QListView>("session-list")->scrollToBottom();
  EXPECT_LT(controller_.lookedInto.size(), 40);
  EXPECT_EQ(controller_.lookedInto.back(), many.back().path);
}

class SessionsPictures : public SessionsPageTest, public testing::WithParamInterface<PageLook> {};

TEST_P(SessionsPictures, EveryStateFits) {
  openSessions(GetParam().width, GetParam().height, GetParam().theme);
  savePage(*window_, "sessions", GetParam(), "closed");
  openFirst();
  controller_.goTo(Seconds(13.0));
  (void)controller_.mark(Seconds(8.0), Seconds(9.5), QStringLiteral("true-alarm"), QStringLiteral("corner"));
  (void)controller_.mark(Seconds(14.0), Seconds(14.0), QStringLiteral("false-alarm"), {});
  tick(40);
  find<QLineEdit>("session-settings")->setText(QStringLiteral("energy-ratio.chatter=0.3"));
  savePage(*window_, "sessions", GetParam(), "marked");
  press("sheet-compare");
  press("session-run");
  press("session-score");
  find<SessionTimeline>()->select(Seconds(20.0), Seconds(23.0));
  tick(40);
  savePage(*window_, "sessions", GetParam(), "open");
}

INSTANTIATE_TEST_SUITE_P(Looks, SessionsPictures, testing::ValuesIn(kPageLooks), lookName);

}  // namespace
}  // namespace stillcut::ui
