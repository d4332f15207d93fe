// The first step of the Tap test page: what can be listened to, and files.
#include <QComboBox>
#include <QFileDialog>
#include <QPushButton>

#include "tests/ui/support/fake_tap_desk.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/shell/manual_panel.h"
#include "ui/widgets/painting.h"

namespace stillcut::ui {
namespace {

class TapMeasureTest : public WindowTest {
 protected:
  void openTap() {
    session_.setTap(&tap_);
    open();
    window_->showPage(QStringLiteral("tap"));
    play(0.1);
  }

  FakeTapDesk tap_;
};

TEST_F(TapMeasureTest, AProfileSavedMeanwhileCanBeListenedTo) {
  openTap();
  auto* devices = find<QComboBox>("tap-device");
  const int before = devices->count();
  devices->setCurrentIndex(devices->findData(QStringLiteral("simulated-hammer")));
  window_->showPage(QStringLiteral("setup"));
  tap_.offered.push_back({QStringLiteral("profile:hammer"), QStringLiteral("hammer and accelerometer")});
  window_->showPage(QStringLiteral("tap"));
  EXPECT_EQ(devices->count(), before + 1);
  EXPECT_GE(devices->findText(QStringLiteral("hammer and accelerometer")), 0);
  EXPECT_EQ(devices->currentData().toString(), QStringLiteral("simulated-hammer")) << "which it listens to";
}

TEST_F(TapMeasureTest, TheMachineIsInReachWhileAFileIsLookedFor) {
  openTap();
  press("tap-files");
  auto* dialog = find<QFileDialog>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->isModal());
  for (const QPushButton* button : dialog->findChildren<QPushButton*>()) {
    if (!button->isVisible()) continue;
    EXPECT_GE(button->height(), pixelsFor(kTouchMm, window_.get())) << "with gloves";
  }
  press("back");
  ASSERT_FALSE(session_.sent().empty());
  EXPECT_EQ(session_.sent().back().action, OperatorAction::BackToProgrammed);
  const QStringList chosen{QStringLiteral("/taps/x1.csv"), QStringLiteral("/taps/x2.csv")};
  emit dialog->filesSelected(chosen);
  EXPECT_EQ(tap_.files(), chosen);
  EXPECT_EQ(tap_.axisOfFiles, 0);
}

TEST_F(TapMeasureTest, EscClosesTheDialogThatIsOnTopFirst) {
  openTap();
  QTest::keyClick(window_.get(), Qt::Key_F1);
  press("tap-files");
  auto* dialog = find<QFileDialog>();
  ASSERT_NE(dialog, nullptr);
  window_->activateWindow();
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(dialog->isVisible());
  EXPECT_TRUE(find<ManualPanel>()->isVisible()) << "one touch closes one";
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(find<ManualPanel>()->isVisible());
}

}  // namespace
}  // namespace stillcut::ui
