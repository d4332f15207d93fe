// Marking on the Sessions page: by one touch, with words, mended and removed, and gone to.
#include <QLineEdit>
#include <QListView>

#include "tests/ui/support/sessions_fixture.h"
#include "ui/plots/session_timeline.h"

namespace stillcut::ui {
namespace {

TEST_F(SessionsPageTest, IHearItNowIsOneKeyAndMarkersCanBeRemoved) {
  openSessions();
  openFirst();
  controller_.goTo(Seconds(5.0));
  tick(40);
  QTest::keyClick(window_.get(), Qt::Key_3, Qt::AltModifier);
  tick(40);
  ASSERT_EQ(controller_.marks.size(), 1U);
  EXPECT_EQ(controller_.marks[0].label, kLabelOperatorChatter);
  EXPECT_EQ(controller_.marks[0].begin, controller_.marks[0].end);
  auto* list = find<QListView>("marker-list");
  ASSERT_EQ(list->model()->rowCount(), 1);
  list->setCurrentIndex(list->model()->index(0, 0));
  press("mark-remove");
  EXPECT_TRUE(controller_.marks.empty());
}

TEST_F(SessionsPageTest, AnEngineerNamesASpanAndAddsItsNoteAfterwards) {
  openSessions();
  openFirst();
  auto* timeline = find<SessionTimeline>();
  timeline->select(Seconds(8.0), Seconds(9.5));
  auto* label = find<QLineEdit>("mark-label");
  auto* note = find<QLineEdit>("mark-text");
  press("mark-span");
  EXPECT_TRUE(controller_.marks.empty()) << "a span without a label is none";
  label->setFocus();
  QTest::keyClicks(label, QStringLiteral("burr on the edge"));
  press("mark-span");
  tick(40);
  ASSERT_EQ(controller_.marks.size(), 1U);
  EXPECT_EQ(controller_.marks[0].label, "burr on the edge");
  EXPECT_NEAR(sinceEpoch(controller_.marks[0].begin).value, 8.0, 1e-6);
  EXPECT_NEAR(sinceEpoch(controller_.marks[0].end).value, 9.5, 1e-6);
  EXPECT_TRUE(label->text().isEmpty());

  auto* list = find<QListView>("marker-list");
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
  EXPECT_EQ(label->text(), QStringLiteral("burr on the edge")) << "what is there can be mended";
  note->setFocus();
  QTest::keyClicks(note, QStringLiteral("0.2 mm, tool 3"));
  press("mark-change");
  tick(40);
  ASSERT_EQ(controller_.marks.size(), 1U);
  EXPECT_EQ(controller_.marks[0].label, "burr on the edge");
  EXPECT_EQ(controller_.marks[0].note, "0.2 mm, tool 3");
  EXPECT_TRUE(list->currentIndex().isValid()) << "it stays chosen";

  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
  press("mark-true");
  ASSERT_EQ(controller_.marks.size(), 2U);
  EXPECT_TRUE(controller_.marks[1].note.empty()) << "another marker's note is not this one's";
}

// CHANGE writes what is in the fields to the marker they were filled from, and to no other.
TEST_F(SessionsPageTest, ChangeNeverOverwritesAnotherMarker) {
  openSessions();
  openFirst();
  ASSERT_TRUE(controller_.mark(Seconds(3.0), Seconds(4.0), QStringLiteral("burr"), QStringLiteral("left")).ok());
  ASSERT_TRUE(controller_.mark(Seconds(8.0), Seconds(9.0), QStringLiteral("scratch"), QStringLiteral("right")).ok());
  tick(40);
  auto* list = find<QListView>("marker-list");
  auto* label = find<QLineEdit>("mark-label");
  auto* note = find<QLineEdit>("mark-text");
  const auto* change = find<TouchButton>("mark-change");
  const auto* remove = find<TouchButton>("mark-remove");
  EXPECT_FALSE(change->isEnabled()) << "nothing is chosen";
  EXPECT_FALSE(remove->isEnabled());
  const auto touch = [list](int row) {
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(row, 0)).center());
  };
  touch(0);
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Down);
  EXPECT_EQ(label->text(), QStringLiteral("scratch")) << "the keys choose as a touch does";
  EXPECT_EQ(note->text(), QStringLiteral("right"));
  press("mark-change");
  tick(40);
  EXPECT_EQ(controller_.marks[1].label, "scratch");
  EXPECT_EQ(controller_.marks[0].label, "burr");

  // Words typed for the one are not the other's.
  note->setFocus();
  QTest::keyClicks(note, QStringLiteral(", 0.2 mm"));
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Up);
  EXPECT_EQ(note->text(), QStringLiteral("right, 0.2 mm")) << "nor thrown away";
  EXPECT_FALSE(change->isEnabled());
  EXPECT_TRUE(remove->isEnabled()) << "what is chosen is seen";

  // A new marker takes the fields, and leaves them empty for the next.
  touch(1);
  press("mark-true");
  tick(40);
  ASSERT_EQ(controller_.marks.size(), 3U);
  EXPECT_FALSE(change->isEnabled());
  EXPECT_EQ(controller_.marks[1].note, "right");

  // A marker of the same number in another recording is another marker.
  touch(0);
  EXPECT_TRUE(change->isEnabled());
  controller_.open(QStringLiteral("/rec/Housing/T12/2026-11-19.h5"));
  tick(40);
  EXPECT_TRUE(label->text().isEmpty());
  EXPECT_TRUE(note->text().isEmpty());
  EXPECT_FALSE(change->isEnabled());
  EXPECT_FALSE(remove->isEnabled());
  touch(1);
  press("mark-remove");
  tick(40);
  EXPECT_TRUE(label->text().isEmpty()) << "what is gone is not shown any more";
  EXPECT_EQ(controller_.marks.size(), 2U);
}

TEST_F(SessionsPageTest, AMarkedSpanIsRepeatedWithTwoTouches) {
  openSessions();
  openFirst();
  ASSERT_TRUE(controller_.mark(Seconds(8.0), Seconds(9.5), QStringLiteral("true-alarm"), {}).ok());
  ASSERT_TRUE(controller_.mark(Seconds(14.0), Seconds(14.0), QStringLiteral("heard"), {}).ok());
  ASSERT_TRUE(controller_.mark(Seconds(20.0), Seconds(23.0), QStringLiteral("note"), {}).ok());
  tick(40);
  auto* list = find<QListView>("marker-list");
  const auto touch = [list](int row) {
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(row, 0)).center());
  };
  touch(0);
  EXPECT_EQ(controller_.state.position.value, 8.0);
  press("replay-loop");
  EXPECT_TRUE(controller_.state.looping);
  EXPECT_EQ(controller_.state.loopFrom.value, 8.0);
  EXPECT_EQ(controller_.state.loopTo.value, 9.5);
  touch(1);
  EXPECT_EQ(controller_.state.loopTo.value, 9.5) << "a moment is no span to repeat";
  list->setCurrentIndex(list->model()->index(2, 0));
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_EQ(controller_.state.loopFrom.value, 20.0) << "from span to span while it repeats";
  EXPECT_EQ(controller_.state.loopTo.value, 23.0);
}

}  // namespace
}  // namespace stillcut::ui
