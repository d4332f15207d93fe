// The frame every page lives in: the ways to a page, the bar that is always there, what outlives a restart.
#include <QComboBox>
#include <QDir>
#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QListView>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTextBrowser>

#include "tests/support/reason_codes.h"
#include "tests/ui/support/fake_setup_desk.h"
#include "tests/ui/support/page_picture.h"
#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/shell/display_panel.h"
#include "ui/shell/header_bar.h"
#include "ui/shell/manual_panel.h"
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
    QTest::keyClick(window_.get(), Qt::Key_Backspace);
    EXPECT_EQ(session_.sent().back().action, OperatorAction::BackToProgrammed) << entry.id;
  }
}

TEST_F(WindowTest, TouchTargetsOfEveryPageAreTwelveMillimetresAndThreeApart) {
  for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
    open(size.width(), size.height());
    const int touch = pixelsFor(kTouchMm, window_.get()), apart = pixelsFor(kTouchGapMm, window_.get());
    for (const PageEntry& entry : pageTable()) {
      window_->showPage(QLatin1String(entry.id));
      play(0.3);
      QList<QRect> places;
      QStringList names;
      for (const TouchButton* button : window_->findChildren<TouchButton*>()) {
        if (!button->isVisible()) continue;
        EXPECT_GE(button->width(), touch) << entry.id << ' ' << button->text().toStdString();
        EXPECT_GE(button->height(), touch) << entry.id << ' ' << button->text().toStdString();
        places << QRect(button->mapTo(window_.get(), QPoint()), button->size());
        names << button->text();
      }
      EXPECT_GE(places.size(), 7) << entry.id;
      for (int a = 0; a < places.size(); ++a) {
        const QRect wide = places[a].adjusted(-apart + 1, -apart + 1, apart - 1, apart - 1);
        for (int b = a + 1; b < places.size(); ++b) {
          EXPECT_FALSE(wide.intersects(places[b]))
              << entry.id << ": " << names[a].toStdString() << " and " << names[b].toStdString();
        }
      }
    }
  }
}

TEST_F(WindowTest, EverythingThatTakesTheFocusHasANameForScreenReaders) {
  open();
  for (const PageEntry& entry : pageTable()) {
    window_->showPage(QLatin1String(entry.id));
    play(0.3);
    expectNames(*window_, QLatin1String(entry.id));
  }
}

// Nobody closes the window of a machine whose main switch is turned.
TEST_F(WindowTest, WhatIsKeptIsOnTheDiskASecondLaterNotOnlyAtTheEnd) {
  const QTemporaryDir folder;
  FakeSetupDesk controller;
  session_.setSetup(&controller);
  session_.keepStateIn(folder.path());
  open();
  window_->showPage(QStringLiteral("analyse"));
  play(0.2);
  find<QComboBox>("preset")->setEditText(QStringLiteral("Mine"));
  press("save-preset");
  window_->showPage(QStringLiteral("lobes"));
  play(0.2);
  find<QDoubleSpinBox>("what-if-depth")->setValue(0.77);
  window_->showPage(QStringLiteral("setup"));
  press("setup-machine");
  auto* machine = find<QLineEdit>("machine-name");
  machine->setText(QStringLiteral("Mill 9"));
  QTest::keyClick(machine, Qt::Key_Return);
  tick(1200);

  // As after a crash: the window before has never been closed.
  MainWindow next(session_, {}, Language::English);
  next.restorePlace();
  next.tick(0);
  EXPECT_EQ(next.currentPage(), QStringLiteral("setup"));
  EXPECT_GE(next.findChild<QComboBox*>("preset")->findText(QStringLiteral("Mine")), 0);
  EXPECT_EQ(next.findChild<QLineEdit*>("machine-name")->text(), QStringLiteral("Mill 9")) << "half put together";
  next.showPage(QStringLiteral("lobes"));
  next.tick(40);
  EXPECT_DOUBLE_EQ(next.findChild<QDoubleSpinBox*>("what-if-depth")->value(), 0.77);
}

TEST_F(WindowTest, TheFirstTimeItFillsTheScreenHoweverSmall) {
  const QTemporaryDir folder;
  session_.keepStateIn(folder.path());
  open(1300, 810, ThemeKind::Light);
  window_->restorePlace();
  EXPECT_TRUE(window_->isMaximized()) << "a title bar over 1280 x 800 pushes the last line off the screen";
  window_->showNormal();
  window_->resize(1300, 810);
  window_->close();
  MainWindow next(session_, {}, Language::English);
  next.restorePlace();
  EXPECT_FALSE(next.isMaximized());
}

TEST_F(WindowTest, ThemePageAndSizeOutliveARestart) {
  const QTemporaryDir folder;
  session_.keepStateIn(folder.path());
  open(1300, 810, ThemeKind::Light);
  QTest::keyClick(window_.get(), Qt::Key_F12);
  const ThemeKind changed = window_->look().theme;
  EXPECT_EQ(changed, ThemeKind::Dark);
  const QString last = QLatin1String(pageTable().back().id);
  window_->showPage(last);
  window_->close();

  MainWindow next(session_, {}, Language::English);
  next.restorePlace();
  EXPECT_EQ(next.look().theme, changed);
  EXPECT_EQ(next.currentPage(), last);
  EXPECT_EQ(next.size(), QSize(1300, 810));
}

TEST_F(WindowTest, TextHasThreeSizesThatOutliveARestart) {
  const QTemporaryDir folder;
  session_.keepStateIn(folder.path());
  open();
  window_->showPage(QStringLiteral("sessions"));
  play(0.2);
  const auto sizes = [this] {
    std::vector<int> pixels;
    for (const QListView* list : window_->findChildren<QListView*>()) {
      if (list->objectName() == QStringLiteral("session-list")) pixels.push_back(list->font().pixelSize());
    }
    return pixels;
  };
  const int verdict = makeTheme(ThemeKind::Light, 1.0, TextSize::Largest).font(type_size::kVerdict).pixelSize();
  EXPECT_EQ(verdict, makeTheme(ThemeKind::Light, 1.0).font(type_size::kVerdict).pixelSize())
      << "what is read from far has its place";
  const std::vector<int> normal = sizes();
  ASSERT_FALSE(normal.empty());
  QTest::keyClick(window_.get(), Qt::Key_F11);
  press("text-1");
  QCoreApplication::processEvents();
  const std::vector<int> large = sizes();
  press("text-2");
  QCoreApplication::processEvents();
  const std::vector<int> largest = sizes();
  EXPECT_LT(normal.front(), large.front());
  EXPECT_LT(large.front(), largest.front());
  window_.reset();

  const MainWindow next(session_);
  EXPECT_EQ(next.look().text, TextSize::Largest);
}

TEST_F(WindowTest, LanguageAndUnitsAreChosenByTouchAndOutliveARestart) {
  const QTemporaryDir folder;
  session_.keepStateIn(folder.path());
  open();
  play(0.2);
  EXPECT_EQ(find<TouchButton>("back")->text(), "BACK TO 100 %");
  QTest::keyClick(window_.get(), Qt::Key_F11);
  press("units-1");
  press("language-1");
  QCoreApplication::processEvents();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_EQ(window_->look().language, Language::German);
  EXPECT_EQ(window_->look().units, UnitSystem::Inch);
  play(0.2);
  EXPECT_NE(find<TouchButton>("back")->text(), "BACK TO 100 %");
  press("advise");  // the bar made anew still reaches the session
  EXPECT_EQ(session_.sent().back().action, OperatorAction::SetAuthority);
  window_.reset();

  const MainWindow next(session_);
  EXPECT_EQ(next.look().language, Language::German);
  EXPECT_EQ(next.look().units, UnitSystem::Inch);
}

TEST_F(WindowTest, EveryReasonIsToldInEveryLanguage) {
  Speaker speaker(Language::English);
  for (int code = 1; test::isReason(code); ++code) {
    const Reason reason{static_cast<ReasonCode>(code), {1.0, 2.0, 3.0, 4.0}};
    speaker.speak(Language::English);
    const QString english = reasonText(reason);
    for (const Language language : {Language::German, Language::Chinese}) {
      speaker.speak(language);
      const QString told = reasonText(reason);
      EXPECT_FALSE(told.isEmpty()) << english.toStdString();
      EXPECT_NE(told, english) << languageCode(language).toStdString();
      EXPECT_FALSE(told.contains(u'{')) << told.toStdString();
    }
  }
}

TEST_F(WindowTest, AnotherSessionShowsItsOwnMachine) {
  open();
  EXPECT_TRUE(find<HeaderBar>()->accessibleName().contains(QStringLiteral("Mill 3")));
  session_.openOther("Lathe 9");
  tick(40);
  EXPECT_TRUE(find<HeaderBar>()->accessibleName().contains(QStringLiteral("Lathe 9")));
}

// The longest words, on the smallest screens.
TEST_F(WindowTest, ThatTheMachineIsSimulatedIsSaidOnEveryScreen) {
  session_.mutableInfo().simulatedMachine = true;
  for (const QSize size : {QSize(800, 480), QSize(1024, 768), QSize(1280, 800)}) {
    for (const Language language : kLanguages) {
      open(size.width(), size.height(), ThemeKind::Light, language);
      play(0.1);
      (void)picture();
      auto* header = find<HeaderBar>();
      const QRectF badge = header->badgeBox();
      const auto* first = header->findChild<TouchButton*>(QStringLiteral("page-operate"));
      EXPECT_GE(badge.left(), 0.0) << size.width() << ' ' << languageCode(language).toStdString();
      EXPECT_GT(badge.width(), 30.0);
      EXPECT_LE(badge.right(), first->x()) << size.width() << ' ' << languageCode(language).toStdString();
      EXPECT_FALSE(header->clipped()) << size.width() << ' ' << languageCode(language).toStdString();
    }
  }
}

TEST_F(WindowTest, F1OpensTheManualAtThePageInEveryLanguageAndLeavesTheBarAlone) {
  for (const Language language : kLanguages) {
    open(1280, 800, ThemeKind::Light, language);
    auto* manual = find<ManualPanel>();
    for (const PageEntry& entry : pageTable()) {
      window_->showPage(QLatin1String(entry.id));
      QTest::keyClick(window_.get(), Qt::Key_F1);
      ASSERT_TRUE(manual->isVisible()) << entry.id;
      QCoreApplication::processEvents();
      EXPECT_EQ(manual->headingOnTop(), pageTitle(entry)) << languageCode(language).toStdString();
      EXPECT_FALSE(manual->geometry().intersects(find<CommandBar>()->geometry())) << "the bar is covered";
      play(0.1);
      press("advise");
      EXPECT_EQ(session_.sent().back().action, OperatorAction::SetAuthority);
      QTest::keyClick(window_.get(), Qt::Key_Backspace);
      EXPECT_EQ(session_.sent().back().action, OperatorAction::BackToProgrammed);
      QTest::keyClick(window_.get(), Qt::Key_Escape);
      EXPECT_FALSE(manual->isVisible()) << entry.id;
    }
  }
}

TEST_F(WindowTest, TheManualGoesToItsContentsAndBack) {
  open();
  QTest::keyClick(window_.get(), Qt::Key_F1);
  auto* manual = find<ManualPanel>();
  press("manual-contents");
  EXPECT_TRUE(manual->chapter().path().endsWith(QStringLiteral("index.md")));
  press("manual-back");
  EXPECT_TRUE(manual->chapter().path().endsWith(QStringLiteral("screens.md")));
  press("manual-close");
  EXPECT_FALSE(manual->isVisible());
}

// Every link of every chapter, those for developers with them, opens the chapter it names.
TEST_F(WindowTest, EveryLinkOfTheManualOpensTheChapterItNames) {
  ASSERT_TRUE(chapterUrl(QStringLiteral("screens"), Language::German).path().endsWith(QStringLiteral("screens.de.md")));
  open();
  auto* manual = find<ManualPanel>();
  auto* text = manual->findChild<QTextBrowser*>();
  static const QRegularExpression kLink(QStringLiteral(R"(\]\(([^):]+\.md)(#[^)]*)?\))"));
  int links = 0, below = 0;
  QDirIterator chapters(QStringLiteral(":/manual"), {QStringLiteral("*.md")}, QDir::Files,
                        QDirIterator::Subdirectories);
  while (chapters.hasNext()) {
    const QString chapter = chapters.next();
    if (chapter.contains(QRegularExpression(QStringLiteral("\\.(de|zh)\\.md$"))))
      continue;  // opened in place of theirs
    const QUrl from(QStringLiteral("qrc") + chapter);
    QFile file(chapter);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString page = QString::fromUtf8(file.readAll());
    for (auto found = kLink.globalMatch(page); found.hasNext(); ++links) {
      const QString link = found.next().captured(1);
      text->setSource(from);
      emit text->anchorClicked(QUrl(link));
      EXPECT_EQ(manual->chapter(), from.resolved(QUrl(link))) << chapter.toStdString();
      below += manual->chapter().path().contains(QStringLiteral("/developers/")) ? 1 : 0;
    }
  }
  EXPECT_GT(links, 40);
  EXPECT_GT(below, 10);
}

TEST_F(WindowTest, TheGuideComesByItselfOnceAndNeverOverARunningCut) {
  const QTemporaryDir folder;
  FakeSetupDesk controller;
  session_.setSetup(&controller);
  open();
  EXPECT_FALSE(window_->offerGuide()) << "nothing is kept here, so nobody knows whether this is the first start";

  session_.keepStateIn(folder.path());
  open();
  EXPECT_TRUE(window_->offerGuide());
  EXPECT_EQ(window_->currentPage(), QStringLiteral("setup"));
  EXPECT_TRUE(find<TouchButton>("guide-simulated")->isVisible());
  open();
  EXPECT_TRUE(window_->offerGuide()) << "it was left without an answer";
  play(0.2);
  open();
  EXPECT_FALSE(window_->offerGuide()) << "a cut has run";

  const QTemporaryDir fresh;
  session_.keepStateIn(fresh.path());
  window_ = std::make_unique<MainWindow>(session_, ThemeKind::Light, Language::English);
  EXPECT_FALSE(window_->offerGuide()) << "a cut runs";
  EXPECT_EQ(window_->currentPage(), QStringLiteral("operate"));
}

TEST_F(WindowTest, ClosingTellsTheSessionOnce) {
  open();
  const QSignalSpy closed(window_.get(), &MainWindow::closed);
  window_->close();
  EXPECT_EQ(closed.count(), 1);
}

TEST_F(WindowTest, HelpIsReachedByTouchAndTheWindowHasASign) {
  open();
  press("display");
  press("help");
  tick(40);
  EXPECT_TRUE(find<ManualPanel>()->isVisible());
  EXPECT_FALSE(find<DisplayPanel>()->isVisible());
  EXPECT_FALSE(window_->windowIcon().isNull());
}

TEST_F(WindowTest, InGermanNumbersHaveACommaAndSpeedsAreByTheMinute) {
  EXPECT_EQ(number(0.62, 2), QStringLiteral("0.62"));
  open(1280, 800, ThemeKind::Light, Language::German);
  EXPECT_EQ(number(0.62, 2), QStringLiteral("0,62"));
  EXPECT_EQ(significant(3.14), QStringLiteral("3,1"));
  EXPECT_EQ(number(8800), QStringLiteral("8") + kThousandsSpace + QStringLiteral("800"));
  EXPECT_EQ(rpmUnit(), QStringLiteral("1/min"));
  const auto typed = window_->findChildren<QDoubleSpinBox*>();
  EXPECT_FALSE(typed.isEmpty());
  for (const QDoubleSpinBox* box : typed) EXPECT_EQ(box->locale().decimalPoint(), QStringLiteral(","));
  window_.reset();
  EXPECT_EQ(number(0.62, 2), QStringLiteral("0.62"));
}

}  // namespace
}  // namespace stillcut::ui
