// History over days on the Sessions page: what the recordings come to by day, tool and job.
#include <QAbstractItemModelTester>
#include <QDateTime>

#include "tests/ui/support/page_picture.h"
#include "tests/ui/support/sessions_fixture.h"
#include "ui/models/history/session_history.h"

namespace stillcut::ui {
namespace {

SessionEntry recorded(const char* job, const char* tool, int day, double hours, int alarms, double alarmed) {
  SessionEntry entry;
  entry.path = QStringLiteral("/rec/%1/%2/%3-%4.h5").arg(QLatin1String(job), QLatin1String(tool)).arg(day).arg(alarms);
  entry.job = QLatin1String(job);
  entry.tool = QLatin1String(tool);
  entry.startedMs = QDateTime(QDate(2026, 11, day), QTime(9, 30)).toMSecsSinceEpoch();
  entry.wallMs = QDateTime(QDate(2026, 12, 24), QTime(18, 0)).toMSecsSinceEpoch();  // marked on Christmas Eve
  entry.inside = SessionEntry::Inside::Known;
  entry.length = Seconds(3600.0 * hours);
  entry.alarms = alarms;
  entry.alarmed = Seconds(alarmed);
  return entry;
}

std::vector<SessionEntry> twoDays() {
  std::vector<SessionEntry> entries{recorded("Housing", "T12", 26, 2.0, 6, 30.0),
                                    recorded("Housing", "T3", 27, 0.5, 1, 2.0),
                                    recorded("Bracket", "T12", 27, 1.5, 0, 0.0)};
  SessionEntry imported;
  imported.path = QStringLiteral("/rec/face.wav");
  imported.job = QStringLiteral("face");
  entries.push_back(imported);
  return entries;
}

TEST(SessionHistory, SumsByDayToolAndJob) {
  const auto days = historyOf(twoDays(), SessionOrder::Time);
  ASSERT_EQ(days.size(), 2U);
  EXPECT_EQ(days[0].name, QStringLiteral("2026-11-27")) << "by when it was cut, the newest first";
  EXPECT_EQ(days[0].recordings, 2);
  EXPECT_DOUBLE_EQ(days[0].alarmsPerHour(), 0.5);
  EXPECT_DOUBLE_EQ(days[1].alarmsPerHour(), 3.0);
  const auto tools = historyOf(twoDays(), SessionOrder::Tool);
  ASSERT_EQ(tools.size(), 2U) << "what was imported has no alarms of its own";
  EXPECT_EQ(tools[0].name, QStringLiteral("T12")) << "the longest in alarm first";
  EXPECT_DOUBLE_EQ(tools[0].alarmed.value, 30.0);
  EXPECT_DOUBLE_EQ(tools[0].recorded.value, 3.5 * 3600.0);
  EXPECT_EQ(historyOf(twoDays(), SessionOrder::Job)[0].name, QStringLiteral("Housing"));
}

TEST(SessionHistory, NothingRecordedIsNoRate) {
  EXPECT_TRUE(std::isnan(HistoryGroup{}.alarmsPerHour()));
  EXPECT_TRUE(historyOf({}, SessionOrder::Time).empty());
}

TEST_F(SessionsPageTest, HistoryIsShownInTheListsPlaceAndLeadsToItsRecordings) {
  controller_.setEntries(twoDays());
  openSessions();
  auto* history = find<QListView>("session-history");
  auto* list = find<QListView>("session-list");
  ASSERT_NE(history, nullptr);
  const QAbstractItemModelTester tester(history->model());
  EXPECT_FALSE(history->isVisible());
  press("sessions-history");
  tick(40);
  ASSERT_TRUE(history->isVisible());
  EXPECT_FALSE(list->isVisible());
  EXPECT_EQ(controller_.lookedInto.size(), 4) << "of all recordings, not only of those on the screen";
  ASSERT_EQ(history->model()->rowCount(), 2);
  const QString newest = history->model()->index(0, 0).data().toString();
  EXPECT_TRUE(newest.startsWith(QStringLiteral("2026-11-27"))) << newest.toStdString();
  EXPECT_TRUE(newest.contains(QStringLiteral("0.5"))) << "alarms an hour: " << newest.toStdString();
  savePage(*window_, "sessions", kPageLooks[0], "history");
  press("sessions-by-tool");
  ASSERT_EQ(history->model()->rowCount(), 2);
  QTest::mouseClick(history->viewport(), Qt::LeftButton, {},
                    history->visualRect(history->model()->index(0, 0)).center());
  tick(40);
  EXPECT_TRUE(list->isVisible());
  EXPECT_FALSE(find<TouchButton>("sessions-history")->isChecked());
  EXPECT_EQ(list->model()->rowCount(), 2) << "the recordings of T12";
}

TEST_F(SessionsPageTest, HistorySaysWhichRecordingsAreNotClosed) {
  std::vector<SessionEntry> entries = twoDays();
  entries[0].session = true;
  entries[0].inside = SessionEntry::Inside::No;
  controller_.setEntries(entries);
  openSessions();
  press("sessions-history");
  tick(40);
  QStringList words;
  for (const QLabel* label : window_->findChildren<QLabel*>()) {
    if (label->isVisible()) words << label->text();
  }
  const QString said = words.join(u'|');
  EXPECT_TRUE(said.contains(QStringLiteral("not closed"))) << said.toStdString();
  EXPECT_TRUE(said.contains(QStringLiteral("without alarms of their own, not counted: 1"))) << "what was imported";
}

TEST_F(SessionsPageTest, HistorySaysWhatIsNotCountedYet) {
  std::vector<SessionEntry> entries = twoDays();
  entries[0].inside = SessionEntry::Inside::NotYet;
  controller_.setEntries(entries);
  openSessions();
  press("sessions-history");
  tick(40);
  const auto said = [&] {
    QStringList words;
    for (const QLabel* label : window_->findChildren<QLabel*>()) {
      if (label->isVisible()) words << label->text();
    }
    return words.join(u'|');
  };
  EXPECT_TRUE(said().contains(QStringLiteral("still to be read: 1"))) << said().toStdString();
  controller_.setEntries(twoDays());
  controller_.changed = true;
  play(0.1);
  EXPECT_FALSE(said().contains(QStringLiteral("still to be read"))) << said().toStdString();
  EXPECT_EQ(find<QListView>("session-history")->model()->rowCount(), 2);
}

}  // namespace
}  // namespace stillcut::ui
