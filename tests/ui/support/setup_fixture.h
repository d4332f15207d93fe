// The Set up page on a desk in memory, driven as a person would.
#pragma once

#include <QLineEdit>

#include "tests/ui/support/fake_setup_desk.h"
#include "tests/ui/support/page_picture.h"

namespace stillcut::ui {

// As a search finds them: one is no machine.
inline MachineSearch twoServersOfOneMill() {
  return {
      false,
      true,
      {{QStringLiteral("/dev/ttyUSB0"),
        QStringLiteral("serial port, for 'grbl' or 'modbus'"),
        {"grbl", {{"device", "/dev/ttyUSB0"}}}},
       {QStringLiteral("mill:5007"), QStringLiteral("linuxcncrsh, for 'linuxcnc'"), {"linuxcnc", {{"host", "mill"}}}},
       {QStringLiteral("mill:5008"),
        QStringLiteral("stillcut-hal, watchdog for 'linuxcnc'"),
        {"linuxcnc", {{"host", "mill"}, {"hal_component_port", "5008"}}}},
       {QStringLiteral("nowhere"), QStringLiteral("nowhere:5007: the host cannot be found"), {}}},
      {}};
}

class SetupPageTest : public WindowTest {
 protected:
  // The page lets a device go that it listens to: its controller has to be there.
  ~SetupPageTest() override { window_.reset(); }
  void openSetup(int width = 1280, int height = 800, ThemeKind theme = ThemeKind::Light) {
    session_.setSetup(&controller_);
    open(width, height, theme);
    window_->showPage(QStringLiteral("setup"));
    play(0.4);
  }
  // The page begins with the device of what runs.
  void runsSimulated() { controller_.running.source.id = "simulated"; }
  void type(const QString& name, const QString& text) const {
    auto* edit = find<QLineEdit>(name);
    ASSERT_NE(edit, nullptr) << name.toStdString();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  // A kind of device: shown where one was chosen before, or somebody has asked for the others.
  void pressKind(const char* name) {
    if (!find<TouchButton>(name)->isVisible()) press("device-other");
    press(name);
  }
  bool told(const QString& part) const {
    for (const TextLabel* label : window_->findChildren<TextLabel*>()) {
      if (label->isVisible() && label->text().contains(part)) return true;
    }
    return false;
  }

  FakeSetupDesk controller_;
};

}  // namespace stillcut::ui
