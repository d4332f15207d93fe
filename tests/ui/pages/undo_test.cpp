// What a touch has deleted, the same touch brings back.
#include <QComboBox>
#include <QListView>

#include "tests/ui/support/sessions_fixture.h"

namespace stillcut::ui {
namespace {

TEST_F(WindowTest, ADeletedPresetComesBackWithTheSameTouch) {
  open();
  window_->showPage(QStringLiteral("analyse"));
  play(0.2);
  auto* names = find<QComboBox>("preset");
  auto* drop = find<TouchButton>("drop-preset");
  names->setEditText(QStringLiteral("Mine"));
  press("save-preset");
  const int row = names->findText(QStringLiteral("Mine"));
  ASSERT_GE(row, 0);
  press("drop-preset");
  EXPECT_LT(names->findText(QStringLiteral("Mine")), 0);
  EXPECT_EQ(drop->text(), QStringLiteral("UNDO"));
  press("drop-preset");
  EXPECT_EQ(names->findText(QStringLiteral("Mine")), row);
  EXPECT_EQ(drop->text(), QStringLiteral("DELETE"));
  press("drop-preset");
  names->setEditText(QStringLiteral("Orders"));
  EXPECT_EQ(drop->text(), QStringLiteral("DELETE"));
  EXPECT_FALSE(drop->isEnabled()) << "whoever goes on has let it go";
}

TEST_F(SessionsPageTest, ARemovedMarkerComesBackWithTheSameTouch) {
  openSessions();
  openFirst();
  ASSERT_TRUE(controller_.mark(Seconds(8.0), Seconds(9.5), QStringLiteral("burr"), QStringLiteral("0.2 mm")).ok());
  tick(40);
  auto* list = find<QListView>("marker-list");
  list->setCurrentIndex(list->model()->index(0, 0));
  press("mark-remove");
  tick(40);
  ASSERT_TRUE(controller_.marks.empty());
  EXPECT_EQ(find<TouchButton>("mark-remove")->text(), QStringLiteral("UNDO"));
  press("mark-remove");
  tick(40);
  ASSERT_EQ(controller_.marks.size(), 1U);
  EXPECT_EQ(controller_.marks[0].label, "burr");
  EXPECT_EQ(controller_.marks[0].note, "0.2 mm");
  EXPECT_NEAR(sinceEpoch(controller_.marks[0].begin).value, 8.0, 1e-6);
  EXPECT_NEAR(sinceEpoch(controller_.marks[0].end).value, 9.5, 1e-6);
  EXPECT_EQ(find<TouchButton>("mark-remove")->text(), QStringLiteral("REMOVE"));
}

}  // namespace
}  // namespace stillcut::ui
