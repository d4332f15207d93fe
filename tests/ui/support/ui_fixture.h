// What every test of a screen needs: an application without a display, and a font with glyphs.
#pragma once

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFontInfo>
#include <QPixmap>
#include <QTest>
#include <QWidget>
#include <cmath>
#include <memory>

#include "tests/ui/support/fake_session.h"
#include "ui/shell/main_window.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {

class UiTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_FALSE(QFontInfo(makeTheme(ThemeKind::Light, 1.0).font(20)).family().isEmpty()); }
};

// The main window on the scripted session, on a clock of its own.
class WindowTest : public UiTest {
 protected:
  void open(int width = 1280, int height = 800, ThemeKind theme = ThemeKind::Light,
            Language language = Language::English) {
    window_ = std::make_unique<MainWindow>(session_, theme, language);
    window_->resize(width, height);
    window_->show();
    window_->activateWindow();
    QCoreApplication::processEvents();
    tick(0);
  }
  // Lets the story and the screen's clock go on together.
  void play(double seconds) {
    for (long k = 0; k < std::lround(seconds / 0.04); ++k) {
      session_.advance(Seconds(0.04));
      tick(40);
    }
  }
  void tick(qint64 passedMs) {
    nowMs_ += passedMs;
    window_->tick(nowMs_);
    QCoreApplication::sendPostedEvents();
  }
  template <class Widget>
  Widget* find(const QString& name = {}) const {
    return window_->findChild<Widget*>(name);
  }
  void press(const QString& name) const {
    auto* button = find<TouchButton>(name);
    ASSERT_NE(button, nullptr) << name.toStdString();
    QTest::mouseClick(button, Qt::LeftButton);
  }
  QImage picture() const { return window_->grab().toImage(); }

  FakeSession session_;
  std::unique_ptr<MainWindow> window_;
  qint64 nowMs_ = 0;
};

}  // namespace stillcut::ui
