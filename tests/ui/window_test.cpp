// The frame every page lives in: the ways to a page, the bar that is always there, what outlives a restart.
#include <QSignalSpy>
#include <QTemporaryDir>

#include "tests/ui/ui_fixture.h"
#include "ui/shell/header_bar.h"
#include "ui/shell/page_table.h"
#include "ui/widgets/command_bar.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/status_strip.h"

namespace stillcut::ui {
namespace {

TEST_F(WindowTest, EveryPageIsReachedByTouchAndByKey) {
  open();
  for (const PageEntry& entry : pageTable()) {
    window_->showPage(QStringLiteral("operate"));
    press(QStringLiteral("page-") + QLatin1String(entry.id));
    EXPECT_EQ(window_->currentPage(), QLatin1String(entry.id));
    window_->showPage(QStringLiteral("operate"));
    QTest::keyClick(window_.get(), static_cast<Qt::Key>(Qt::Key_0 + entry.number), Qt::ControlModifier);
    EXPECT_EQ(window_->currentPage(), QLatin1String(entry.id));
  }
}

TEST_F(WindowTest, AuthorityHoldAndBackAreOnEveryPage) {
  open();
  for (const PageEntry& entry : pageTable()) {
    window_->showPage(QLatin1String(entry.id));
    play(0.2);
    EXPECT_TRUE(find<CommandBar>()->isVisible()) << entry.id;
    EXPECT_TRUE(find<StatusStrip>()->isVisible()) << entry.id;
    press("advise");
    ASSERT_FALSE(session_.sent().empty());
    EXPECT_EQ(session_.sent().back().action, OperatorAction::SetAuthority) << entry.id;
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    EXPECT_EQ(session_.sent().back().action, OperatorAction::BackToProgrammed) << entry.id;
  }
}

TEST_F(WindowTest, PageTabsAreTouchTargetsWithNames) {
  open();
  const int least = pixelsFor(kTouchMm, window_.get());
  for (const PageEntry& entry : pageTable()) {
    const auto* tab = find<TouchButton>(QStringLiteral("page-") + QLatin1String(entry.id));
    ASSERT_NE(tab, nullptr);
    EXPECT_GE(tab->height(), least);
    EXPECT_GE(tab->width(), least);
    EXPECT_EQ(tab->accessibleName(), pageTitle(entry));
  }
}

TEST_F(WindowTest, ThemePageAndSizeOutliveARestart) {
  const QTemporaryDir folder;
  session_.keepStateIn(folder.path());
  open(1300, 810, ThemeKind::Light);
  QTest::keyClick(window_.get(), Qt::Key_F12);
  const ThemeKind changed = window_->theme();
  EXPECT_EQ(changed, ThemeKind::Dark);
  const QString last = QLatin1String(pageTable().back().id);
  window_->showPage(last);
  window_->close();

  MainWindow next(session_);
  next.restorePlace();
  EXPECT_EQ(next.theme(), changed);
  EXPECT_EQ(next.currentPage(), last);
  EXPECT_EQ(next.size(), QSize(1300, 810));
}

TEST_F(WindowTest, AnotherSessionShowsItsOwnMachine) {
  open();
  EXPECT_TRUE(find<HeaderBar>()->accessibleName().contains(QStringLiteral("Mill 3")));
  session_.openOther("Lathe 9");
  tick(40);
  EXPECT_TRUE(find<HeaderBar>()->accessibleName().contains(QStringLiteral("Lathe 9")));
}

TEST_F(WindowTest, ClosingTellsTheSessionOnce) {
  open();
  const QSignalSpy closed(window_.get(), &MainWindow::closed);
  window_->close();
  EXPECT_EQ(closed.count(), 1);
}

}  // namespace
}  // namespace stillcut::ui
