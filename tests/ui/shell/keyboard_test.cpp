// Everything without a mouse: Tab comes by every control of every page and every sheet, in a ring.
#include <QApplication>
#include <set>
#include <tuple>
#include <vector>

#include "tests/ui/support/fake_session_desk.h"
#include "tests/ui/support/fake_setup_desk.h"
#include "tests/ui/support/fake_tap_desk.h"
#include "tests/ui/support/fake_tuning.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/shell/display_panel.h"
#include "ui/shell/manual_panel.h"
#include "ui/shell/page_table.h"

namespace stillcut::ui {
namespace {

class Keyboard : public WindowTest {
 protected:
  void SetUp() override {
    setup_.kept[QStringLiteral("mill3")] = {};
    session_.setTuning(&tuning_);
    session_.setSetup(&setup_);
    session_.setSessions(&sessions_);
    session_.setTap(&tap_);
    sessions_.open(sessions_.entries().front().path);
    open();
    play(1.0);
  }
  std::set<const QWidget*> controls() const {
    std::set<const QWidget*> all;
    for (const QWidget* widget : window_->findChildren<QWidget*>()) {
      const bool own = widget->focusProxy() == nullptr && !widget->objectName().startsWith("qt_");
      const bool takes = (widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isEnabled();
      if (own && takes && widget->isVisible()) all.insert(widget);
    }
    return all;
  }
  void expectAllReached(const std::string& where) const {
    const std::set<const QWidget*> wanted = controls();
    std::set<const QWidget*> met;
    // Links of a text are steps of their own.
    constexpr std::size_t kLinks = 200;
    const std::size_t most = 2 * wanted.size() + 4 + (find<ManualPanel>()->isVisible() ? kLinks : 0);
    for (std::size_t k = 0; k < most; ++k) {
      QWidget* focus = QApplication::focusWidget();
      QTest::keyClick(focus != nullptr ? focus : window_.get(), Qt::Key_Tab);
      if (QApplication::focusWidget() != nullptr) met.insert(QApplication::focusWidget());
    }
    EXPECT_GT(wanted.size(), 10U) << where;
    for (const QWidget* widget : wanted) {
      EXPECT_TRUE(met.count(widget) > 0) << where << ": " << widget->metaObject()->className() << ' '
                                         << widget->objectName().toStdString() << ' '
                                         << widget->accessibleName().toStdString();
    }
  }

  FakeTuning tuning_{"fuzzy-learning"};
  FakeSetupDesk setup_;
  FakeSessionDesk sessions_;
  FakeTapDesk tap_;
};

TEST_F(Keyboard, TabComesByEveryControlOfEveryPage) {
  for (const PageEntry& entry : pageTable()) {
    window_->showPage(QLatin1String(entry.id));
    play(0.2);
    expectAllReached(entry.id);
  }
}

TEST_F(Keyboard, TabComesByEveryControlOfEverySheetOfSetUp) {
  window_->showPage(QStringLiteral("setup"));
  for (const char* sheet :
       {"setup-guide", "setup-machine", "setup-sensors", "setup-tools", "setup-recording", "setup-profile"}) {
    auto* button = find<TouchButton>(QLatin1String(sheet));
    ASSERT_NE(button, nullptr) << sheet;
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
    EXPECT_TRUE(button->isChecked()) << "the space bar touches it";
    play(0.2);
    expectAllReached(sheet);
  }
}

TEST_F(Keyboard, TheSheetsOfSessionsOpenWithTheSpaceBarAndTabComesByAllTheyHold) {
  window_->showPage(QStringLiteral("sessions"));
  play(0.2);
  for (const char* const sheet : {"sheet-compare", "sheet-mark"}) {
    auto* button = find<TouchButton>(QLatin1String(sheet));
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
    EXPECT_TRUE(button->isChecked()) << sheet;
    play(0.2);
    expectAllReached(sheet);
  }
}

// They lie over a page; what is under them stays in the ring.
TEST_F(Keyboard, ThePanelsOverAPageOpenAndCloseByKeyAndTabComesByThem) {
  const std::vector<std::tuple<Qt::Key, QWidget*, std::string>> panels{{Qt::Key_F11, find<DisplayPanel>(), "display"},
                                                                       {Qt::Key_F1, find<ManualPanel>(), "manual"}};
  for (const auto& [key, panel, name] : panels) {
    window_->showPage(QStringLiteral("operate"));
    ASSERT_NE(panel, nullptr) << name;
    QTest::keyClick(window_.get(), key);
    ASSERT_TRUE(panel->isVisible()) << name;
    play(0.1);
    expectAllReached(name);
    QTest::keyClick(window_.get(), key);
    EXPECT_FALSE(panel->isVisible()) << name;
  }
}

TEST_F(Keyboard, AThemeIsChosenInThePanelWithoutAMouse) {
  QTest::keyClick(window_.get(), Qt::Key_F11);
  const ThemeKind before = window_->look().theme;
  auto* dark = find<TouchButton>("theme-1");
  ASSERT_NE(dark, nullptr);
  dark->setFocus();
  QTest::keyClick(dark, Qt::Key_Space);
  QCoreApplication::processEvents();
  EXPECT_NE(window_->look().theme, before);
}

}  // namespace
}  // namespace stillcut::ui
