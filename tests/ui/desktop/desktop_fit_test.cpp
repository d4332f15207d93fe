// The window on a real session, whose parts have more and longer names than those of a test: every page in
// every language, on the smallest screen. Kept as pictures for people to look at.
#include <QTemporaryDir>

#include "app/compose/scenario_rig.h"
#include "app/session/session.h"
#include "tests/support/demo_cut.h"
#include "tests/ui/support/page_picture.h"
#include "ui/shell/page_table.h"

namespace stillcut::app {
namespace {

constexpr QSize kSmallest(1280, 800);

class DesktopFit : public testing::TestWithParam<ui::Language> {
 protected:
  void SetUp() override {
    auto opened = openScenarioSession(STILLCUT_RESOURCE_DIR "/scenarios/demo.toml", false);
    ASSERT_TRUE(opened) << opened.error().line();
    session_ = std::move(opened).value();
    window_ = std::make_unique<ui::MainWindow>(*session_, ui::ThemeKind::Light, GetParam());
    window_->resize(kSmallest);
    window_->show();
    while (t_ < 9.0 && session_->advance()) tick();
  }
  void tick() {
    const Snapshot* snapshot = session_->pull();
    if (snapshot == nullptr) return;
    t_ = sinceEpoch(snapshot->time).value;
    if (t_ * 1e3 < shown_ + ui::kDisplayTickMs) return;
    shown_ = t_ * 1e3;
    window_->tick(static_cast<qint64>(shown_));
  }
  // Rows that were made a moment ago have their places after a few rounds.
  void settle() {
    constexpr int kRounds = 4;
    for (int k = 0; k < kRounds; ++k) {
      window_->tick(static_cast<qint64>(shown_));
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      QCoreApplication::sendPostedEvents();
      QCoreApplication::processEvents();
    }
  }
  void keep(const QString& name) {
    settle();
    EXPECT_EQ(window_->size(), kSmallest) << name.toStdString() << " makes the window grow";
    ui::expectNothingCut(*window_, name, kSmallest);
    ui::expectNames(*window_, name);
    ui::expectWholePage(*window_);
    picture(QStringLiteral("real-%1").arg(name));
  }
  void picture(const QString& name) {
    const QDir folder(QStringLiteral(STILLCUT_SCREENSHOT_DIR));
    ASSERT_TRUE(folder.mkpath(QStringLiteral(".")));
    EXPECT_TRUE(
        window_->grab().save(folder.filePath(QStringLiteral("%1-%2.png").arg(name, ui::languageCode(GetParam())))));
  }
  std::unique_ptr<Session> session_;
  std::unique_ptr<ui::MainWindow> window_;
  double t_ = 0.0, shown_ = -1e3;
};

TEST_P(DesktopFit, EveryPage) {
  for (const ui::PageEntry& entry : ui::pageTable()) {
    window_->showPage(QLatin1String(entry.id));
    settle();
    EXPECT_TRUE(QTest::qWaitFor(
        [this] { return session_->lobes()->progress().state != ui::LobeProgress::State::Running; }, 60'000));
    keep(QLatin1String(entry.id));
  }
}

// Also on 12.1 and 10.1 inches, where buttons of 12 mm take more of it: pages may scroll there, but not what commands,
// and not the operator's page.
TEST_P(DesktopFit, WhatCommandsStaysOnTheScreen) {
  for (const ui::PageEntry& entry : ui::pageTable()) {
    window_->showPage(QLatin1String(entry.id));
    settle();
    EXPECT_EQ(window_->size(), kSmallest) << entry.id << " makes the window grow";
    for (const char* const name : {"off", "advise", "auto", "hold", "back"}) {
      const auto* button = window_->findChild<ui::TouchButton*>(QLatin1String(name));
      const QRect place(button->mapTo(window_.get(), QPoint()), button->size());
      EXPECT_TRUE(window_->rect().contains(place)) << entry.id << ": " << name << " is off the screen";
      EXPECT_GE(button->height(), ui::pixelsFor(ui::kTouchMm, window_.get())) << name;
    }
    const bool operate = QLatin1String(entry.id) == QStringLiteral("operate");
    for (const QScrollArea* area : window_->findChildren<QScrollArea*>(QStringLiteral("scroll"))) {
      EXPECT_FALSE(operate && area->isVisible() && area->verticalScrollBar()->isVisible()) << "seen at a glance";
      EXPECT_FALSE(area->isVisible() && area->horizontalScrollBar()->isVisible())
          << entry.id << " is too wide: " << area->widget()->minimumSizeHint().width() << " in " << area->width();
    }
    picture(QStringLiteral("dense%1-%2").arg(window_->logicalDpiY()).arg(QLatin1String(entry.id)));
  }
}

// An old panel, or a window beside another: pages may be longer there, but nobody moves them sideways.
TEST_P(DesktopFit, NoPageScrollsSidewaysOnAnOldPanel) {
  constexpr QSize kOldPanel(1024, 768);
  window_->resize(kOldPanel);
  const auto expectNarrow = [&](const QString& name) {
    settle();
    EXPECT_EQ(window_->size(), kOldPanel) << name.toStdString() << " makes the window grow";
    for (const QScrollArea* area : window_->findChildren<QScrollArea*>(QStringLiteral("scroll"))) {
      EXPECT_FALSE(area->isVisible() && area->horizontalScrollBar()->isVisible())
          << name.toStdString() << " is too wide: " << area->widget()->minimumSizeHint().width() << " in "
          << area->width();
    }
    picture(QStringLiteral("old-panel-%1").arg(name));
  };
  for (const ui::PageEntry& entry : ui::pageTable()) {
    window_->showPage(QLatin1String(entry.id));
    expectNarrow(QLatin1String(entry.id));
  }
  window_->showPage(QStringLiteral("setup"));
  for (const char* const tab : {"machine", "limits", "sensors", "tools", "recording", "profile", "guide"}) {
    QTest::mouseClick(window_->findChild<ui::TouchButton*>(QStringLiteral("setup-") + QLatin1String(tab)),
                      Qt::LeftButton);
    expectNarrow(QStringLiteral("setup-") + QLatin1String(tab));
  }
}

// With a recording open there is more to say of it, and file names are long.
TEST_P(DesktopFit, WhatCommandsStaysOnTheScreenBesideAnOpenRecording) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("Housing-7-second-operation-2026-11-22_08-30-00.h5"));
  auto built = buildScenarioRig(test::demoCut(), {});
  ASSERT_TRUE(built.ok());
  ASSERT_TRUE(built->rig->recordTo(file.toStdString(), "").ok());
  built->rig->runToEnd({});
  ASSERT_TRUE(built->rig->recorder()->finish().ok());
  ui::SessionController& controller = *session_->sessions();
  controller.open(file);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        window_->tick(static_cast<qint64>(shown_));
        return controller.replay().open && controller.summaryWhole() && controller.replayed() != nullptr;
      },
      60'000));
  window_->showPage(QStringLiteral("sessions"));
  for (const char* const sheet : {"sheet-mark", "sheet-compare", "sheet-events"}) {
    QTest::mouseClick(window_->findChild<ui::TouchButton*>(QLatin1String(sheet)), Qt::LeftButton);
    settle();
    EXPECT_EQ(window_->size(), kSmallest) << sheet << " makes the window grow";
    for (const QScrollArea* area : window_->findChildren<QScrollArea*>(QStringLiteral("scroll"))) {
      EXPECT_FALSE(area->isVisible() && area->horizontalScrollBar()->isVisible())
          << sheet << " is too wide: " << area->widget()->minimumSizeHint().width() << " in " << area->width();
    }
    picture(QStringLiteral("dense%1-%2").arg(window_->logicalDpiY()).arg(QLatin1String(sheet)));
  }
}

// What a device or a link asks for comes from core, and is as long as it is there.
TEST_P(DesktopFit, EveryDeviceAndEveryLinkOnSetUp) {
  window_->showPage(QStringLiteral("setup"));
  const auto press = [this](const QString& name) {
    auto* button = window_->findChild<ui::TouchButton*>(name);
    ASSERT_NE(button, nullptr) << name.toStdString();
    QTest::mouseClick(button, Qt::LeftButton);
  };
  ASSERT_NE(session_->setup(), nullptr);
  press(QStringLiteral("setup-machine"));
  for (const ui::ComponentOption& link : session_->setup()->links()) {
    press(QStringLiteral("link-") + link.id);
    keep(QStringLiteral("setup-link-") + link.id);
  }
  press(QStringLiteral("setup-sensors"));
  for (const ui::ComponentOption& source : session_->setup()->sources()) {
    const auto* kind = window_->findChild<ui::TouchButton*>(QStringLiteral("source-") + source.id);
    if (kind != nullptr && !kind->isVisible()) press(QStringLiteral("device-other"));
    press(QStringLiteral("source-") + source.id);
    keep(QStringLiteral("setup-source-") + source.id);
  }
  for (const char* const tab : {"limits", "tools", "recording", "profile", "guide"}) {
    press(QStringLiteral("setup-") + QLatin1String(tab));
    keep(QStringLiteral("setup-") + QLatin1String(tab));
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, DesktopFit, testing::ValuesIn(ui::kLanguages),
                         [](const auto& language) { return ui::languageCode(language.param).toStdString(); });

}  // namespace
}  // namespace stillcut::app
