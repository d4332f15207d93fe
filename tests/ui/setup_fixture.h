// The Set up page on a desk in memory, driven as a person would.
#pragma once

#include <QLineEdit>

#include "tests/ui/fake_setup_desk.h"
#include "tests/ui/page_picture.h"

namespace stillcut::ui {

class SetupPageTest : public WindowTest {
 protected:
  void openSetup(int width = 1280, int height = 800, ThemeKind theme = ThemeKind::Light) {
    session_.setSetup(&desk_);
    open(width, height, theme);
    window_->showPage(QStringLiteral("setup"));
    play(0.4);
  }
  void type(const QString& name, const QString& text) const {
    auto* edit = find<QLineEdit>(name);
    ASSERT_NE(edit, nullptr) << name.toStdString();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  bool told(const QString& part) const {
    for (const TextLabel* label : window_->findChildren<TextLabel*>()) {
      if (label->isVisible() && label->text().contains(part)) return true;
    }
    return false;
  }

  FakeSetupDesk desk_;
};

}  // namespace stillcut::ui
