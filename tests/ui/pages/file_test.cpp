// The page for a file, driven as a person would: dropped on the window, asked while typing, looked at, heard, kept as a
// picture, and compared with a second one.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QTemporaryDir>
#include <QUrl>
#include <QWheelEvent>
#include <cstdlib>

#include "tests/ui/support/fake_file_desk.h"
#include "tests/ui/support/page_picture.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/pages/file/file_page.h"
#include "ui/plots/file/file_spectrum.h"
#include "ui/plots/file/spectra_map.h"
#include "ui/plots/file/state_rows.h"
#include "ui/plots/file/wave_plot.h"

namespace stillcut::ui {
namespace {

class FilePageTest : public WindowTest {
 protected:
  void openWindow(int width = 1280, int height = 800, ThemeKind theme = ThemeKind::Light,
                  Language language = Language::English) {
    session_.setFiles(&desk_);
    open(width, height, theme, language);
  }
  void openFile(const QString& path = QStringLiteral("/rec/cut.wav")) {
    window_->openFile(path);
    tick(40);
    tick(40);
  }
  void drop(const QList<QUrl>& urls) {
    QMimeData data;
    data.setUrls(urls);
    const QPointF at(600, 400);
    QDragEnterEvent enter(at.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_.get(), &event);
    tick(40);
    tick(40);
  }
  QString text(const char* name) const { return find<QLabel>(QLatin1String(name))->text(); }
  FilePage& page() const { return *find<FilePage>(); }

  FakeFileDesk desk_;
};

TEST_F(FilePageTest, AFileDroppedOnAnyPageIsOpenedAndJudged) {
  openWindow();
  EXPECT_EQ(window_->currentPage(), QStringLiteral("operate"));
  drop({QUrl::fromLocalFile(QStringLiteral("/rec/my cut.m4a"))});
  EXPECT_EQ(window_->currentPage(), QStringLiteral("file"));
  ASSERT_EQ(desk_.opened.size(), 1U);
  EXPECT_EQ(desk_.opened[0].path, QStringLiteral("/rec/my cut.m4a"));
  EXPECT_EQ(text("file-title").remove(QChar(0x200b)), QStringLiteral("my cut.m4a"));
  EXPECT_TRUE(text("file-headline").contains(QStringLiteral("40")));
  desk_.finish();
  tick(40);
  EXPECT_TRUE(text("file-headline").contains(QStringLiteral("Chatter at 1502 Hz")));
  EXPECT_TRUE(text("file-advice").contains(QStringLiteral("or less depth")));
  EXPECT_TRUE(text("file-details").contains(QStringLiteral("Judged 8.0 of 10.0 s")));
}

TEST_F(FilePageTest, EveryDoorLeadsHere) {
  openWindow();
  int chosen = 0;
  page().chooseFile = [&](const QString&, const std::function<void(const QString&)>& take) {
    ++chosen;
    take(QStringLiteral("/rec/%1.wav").arg(chosen));
  };
  window_->showPage(QStringLiteral("sessions"));
  press(QStringLiteral("session-whole"));
  window_->showPage(QStringLiteral("analyse"));
  press(QStringLiteral("analyse-file"));
  press(QStringLiteral("file-open"));
  EXPECT_EQ(chosen, 3);
  EXPECT_EQ(window_->currentPage(), QStringLiteral("file"));
  EXPECT_EQ(desk_.path(FileController::Main), QStringLiteral("/rec/3.wav"));
}

TEST_F(FilePageTest, TheDialogBeginsWhereTheLastRecordingWasAlsoAfterARestart) {
  const QTemporaryDir state, recordings;
  session_.keepStateIn(state.path());
  openWindow();
  page().chooseFile = [&](const QString&, const std::function<void(const QString&)>& take) {
    take(recordings.filePath(QStringLiteral("cut.wav")));
  };
  window_->showPage(QStringLiteral("file"));
  press(QStringLiteral("file-open"));
  window_->close();
  window_.reset();
  openWindow();
  window_->showPage(QStringLiteral("file"));
  press(QStringLiteral("file-open"));
  const auto* dialog = find<QFileDialog>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->isModal());
  EXPECT_EQ(dialog->directory(), QDir(recordings.path()));
}

TEST_F(FilePageTest, TheQuestionIsAskedAMomentAfterTheLastKey) {
  openWindow();
  openFile();
  const std::size_t before = desk_.questions.size();
  auto* teeth = find<QLineEdit>(QStringLiteral("file-teeth"));
  auto* speed = find<QLineEdit>(QStringLiteral("file-speed"));
  QTest::keyClicks(teeth, QStringLiteral("2"));
  tick(200);
  QTest::keyClicks(speed, QStringLiteral("9,5"));
  tick(200);
  QTest::keyClicks(speed, QStringLiteral("00"));
  tick(200);
  EXPECT_EQ(desk_.questions.size(), before) << "nobody is asked while somebody types";
  tick(400);
  ASSERT_EQ(desk_.questions.size(), before + 1);
  EXPECT_EQ(desk_.questions.back(), (FileQuestion{2, Rpm(9500.0)}));
  tick(1000);
  EXPECT_EQ(desk_.questions.size(), before + 1);
}

TEST_F(FilePageTest, WhatTheFileAndTheSignalSayStandsInAndUnderTheFields) {
  desk_.toldByFile = {4, Rpm(8800.0)};
  desk_.found.speed_rpm = {8765.0, 3.0, {4382.0}};
  desk_.found.teeth = {4.0, 0.0, {2.0}};
  openWindow();
  openFile();
  EXPECT_EQ(find<QLineEdit>(QStringLiteral("file-teeth"))->text(), QStringLiteral("4"));
  EXPECT_EQ(find<QLineEdit>(QStringLiteral("file-speed"))->text(), QStringLiteral("8800"));
  EXPECT_TRUE(text("file-found").contains(QStringLiteral("\u00b13")));
  EXPECT_TRUE(text("file-found").contains(QStringLiteral("382"))) << "the rival";
  EXPECT_TRUE(text("file-found").contains(QStringLiteral("Teeth by the signal: 4, or 2")));
}

TEST_F(FilePageTest, AFileThatCannotBeReadSaysWhy) {
  desk_.unreadable = QStringLiteral("/rec/letter.csv: holds no numbers");
  openWindow();
  openFile();
  desk_.judging.running = false;
  desk_.changed = true;
  tick(40);
  EXPECT_EQ(text("file-headline"), QStringLiteral("Cannot be read"));
  EXPECT_TRUE(text("file-details").contains(QStringLiteral("holds no numbers")));
  EXPECT_FALSE(find<TouchButton>(QStringLiteral("file-picture"))->isEnabled());
}

TEST_F(FilePageTest, WhatAFileDoesNotSayOfItsTimesIsAsked) {
  desk_.unreadable = QStringLiteral("/rec/cut.csv: its time has no unit; its steps of 0.1 would be 10 Hz in seconds");
  desk_.lack = FileLack::TimeUnit;
  openWindow();
  openFile();
  EXPECT_FALSE(find<QLineEdit>(QStringLiteral("file-teeth"))->isVisible());
  EXPECT_FALSE(find<QLineEdit>(QStringLiteral("file-rate"))->isVisible());
  find<TouchButton>(QStringLiteral("file-time-ms"))->click();
  tick(40);
  ASSERT_EQ(desk_.timings.size(), 1U);
  EXPECT_EQ(desk_.timings[0], (FileTiming{Hertz(), 1e-3}));
  EXPECT_TRUE(find<QLineEdit>(QStringLiteral("file-teeth"))->isVisible());
  EXPECT_FALSE(find<TouchButton>(QStringLiteral("file-time-ms"))->isVisible());

  desk_.unreadable = QStringLiteral("/rec/cut.csv: the sampling rate is not known");
  desk_.lack = FileLack::Rate;
  openFile();
  auto* rate = find<QLineEdit>(QStringLiteral("file-rate"));
  ASSERT_TRUE(rate->isVisible());
  rate->setText(QStringLiteral("many"));
  find<TouchButton>(QStringLiteral("file-rate-read"))->click();
  EXPECT_EQ(desk_.timings.size(), 1U) << "no number, nothing told";
  rate->setText(QStringLiteral("25600"));
  find<TouchButton>(QStringLiteral("file-rate-read"))->click();
  ASSERT_EQ(desk_.timings.size(), 2U);
  EXPECT_EQ(desk_.timings[1], (FileTiming{Hertz(25600.0), 0.0}));
}

TEST_F(FilePageTest, AllOfItIsShownAndWheelAndDragLookCloser) {
  openWindow();
  openFile();
  desk_.finish();
  tick(40);
  ASSERT_FALSE(desk_.requests.empty());
  EXPECT_NEAR(desk_.requests.back().second.from.value, 0.0, 1e-9);
  EXPECT_NEAR(desk_.requests.back().second.to.value, FakeFileDesk::kLength, 1e-9);
  auto* map = find<SpectraMap>();
  const QPointF middle = map->plotRect().center();
  QWheelEvent wheel(middle, map->mapToGlobal(middle), {}, QPoint(0, 600), {}, {}, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(map, &wheel);
  tick(40);
  const SpectraRequest closer = desk_.requests.back().second;
  EXPECT_LT((closer.to - closer.from).value, 5.0);
  EXPECT_NEAR(0.5 * (closer.to + closer.from).value, 5.0, 0.3);
  QTest::mousePress(map, Qt::LeftButton, {}, middle.toPoint());
  QTest::mouseMove(map, middle.toPoint() + QPoint(60, 0));
  QTest::mouseMove(map, middle.toPoint() + QPoint(120, 0));
  QTest::mouseRelease(map, Qt::LeftButton, {}, middle.toPoint() + QPoint(120, 0));
  tick(40);
  EXPECT_LT(desk_.requests.back().second.from.value, closer.from.value);
  QTest::mouseDClick(find<WavePlot>(), Qt::LeftButton, {}, find<WavePlot>()->plotRect().center());
  tick(40);
  EXPECT_NEAR(desk_.requests.back().second.to.value, FakeFileDesk::kLength, 1e-9);
}

TEST_F(FilePageTest, LengthWindowOverlapChannelAndAxesAreChosen) {
  openWindow();
  openFile();
  const auto choose = [&](const char* name, int index) {
    auto* box = find<QComboBox>(QLatin1String(name));
    box->setCurrentIndex(index);
    emit box->activated(index);
    tick(40);
  };
  choose("file-length", 5);
  choose("file-window", 1);
  choose("file-overlap", 3);
  choose("file-channel", 1);
  const SpectraRequest asked = desk_.requests.back().second;
  EXPECT_EQ(asked.length, 8192);
  EXPECT_EQ(asked.window, SpectraWindow::FlatTop);
  EXPECT_NEAR(asked.overlap, 0.9, 1e-9);
  EXPECT_EQ(asked.channel, 1);
  const QImage linear = find<SpectraMap>()->grab().toImage();
  press(QStringLiteral("file-log"));
  tick(40);
  EXPECT_NE(find<SpectraMap>()->grab().toImage(), linear);
  press(QStringLiteral("file-order"));
  desk_.finish();
  tick(40);
  page().view().setHarmonic(Hertz(1502.0));
  EXPECT_TRUE(find<FileSpectrum>()->reading().contains(QStringLiteral("order 9.48")));
}

TEST_F(FilePageTest, RecordedStatesStandAboveAndAreNotTouchedByMoving) {
  desk_.recorded = FileTrack{QStringLiteral("Recorded"), {{Seconds(2.0), Seconds(3.0), CutState::Chatter, true}}};
  desk_.wallMs = 1'793'000'000'000;
  openWindow();
  openFile();
  desk_.finish();
  tick(40);
  const auto* rows = find<StateRows>();
  ASSERT_EQ(rows->rows().size(), 5U);
  EXPECT_EQ(rows->rows().front().detector, QStringLiteral("Recorded"));
  page().view().setCursor(AnalyseView::A, Instant{} + toDuration(Seconds(7.0)));
  page().view().showTimes(Instant{} + toDuration(Seconds(6.0)), Instant{} + toDuration(Seconds(8.0)));
  tick(40);
  ASSERT_EQ(rows->rows().front().states.size(), 1U);
  EXPECT_EQ(rows->rows().front().states[0].state, CutState::Chatter);
}

TEST_F(FilePageTest, ALineOverTheStatesIsWhatTheDetectorLooksAt) {
  openWindow();
  openFile();
  desk_.finish();
  tick(40);
  auto* rows = find<StateRows>();
  ASSERT_EQ(rows->rows().size(), 4U);
  const QRect plot = rows->plotRect();
  const double height = plot.height() / 4.0;
  const QColor line = rows->shownTheme().colors.text;
  // Of the first row, at the level on a scale of one.
  const auto shown = [&](double seconds, double level) {
    const QImage image = rows->grab().toImage();
    const int x = static_cast<int>(rows->xOf(Instant{} + toDuration(Seconds(seconds))));
    const int y = static_cast<int>(plot.top() + height - height * level);
    for (int below = -3; below <= 3; ++below) {
      const QColor here = image.pixelColor(x, y + below);
      constexpr int kNear = 60;  // a thin line is blended with what is under it
      if (std::abs(here.red() - line.red()) < kNear && std::abs(here.green() - line.green()) < kNear &&
          std::abs(here.blue() - line.blue()) < kNear)
        return true;
    }
    return false;
  };
  EXPECT_TRUE(shown(6.0, 0.78));
  EXPECT_FALSE(shown(6.0, 0.4));
  EXPECT_TRUE(shown(2.5, 0.12));
  EXPECT_FALSE(shown(1.25, 0.12)) << "not judged";
  const QImage before = rows->grab().toImage();
  page().view().setCursor(AnalyseView::A, Instant{} + toDuration(Seconds(6.0)));
  tick(40);
  EXPECT_NE(rows->grab().toImage(), before) << "its value stands beside the cursor";
}

TEST_F(FilePageTest, SoundIsPlayedFromTheCursorAndSaysWhyItIsNot) {
  openWindow();
  openFile();
  page().view().setCursor(AnalyseView::A, Instant{} + toDuration(Seconds(4.0)));
  press(QStringLiteral("file-play"));
  EXPECT_NEAR(desk_.played.first.value, 4.0, 1e-6);
  EXPECT_NEAR(desk_.played.second.value, 10.0, 1e-6);
  tick(40);
  EXPECT_EQ(find<TouchButton>(QStringLiteral("file-play"))->text(), QStringLiteral("STOP"));
  press(QStringLiteral("file-play"));
  EXPECT_FALSE(desk_.heard.has_value());
  desk_.soundTrouble = QStringLiteral("this computer has no sound output: No such file or directory");
  tick(40);
  EXPECT_TRUE(text("file-status").contains(QStringLiteral("no sound output")));
}

TEST_F(FilePageTest, APictureIsWrittenBesideTheRecordingInOneTouch) {
  QTemporaryDir folder;
  openWindow();
  openFile(folder.filePath(QStringLiteral("cut.wav")));
  desk_.finish();
  tick(40);
  press(QStringLiteral("file-picture"));
  press(QStringLiteral("file-picture"));
  EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("cut-2.png")))) << "nothing is written over";
  const QImage picture(folder.filePath(QStringLiteral("cut.png")));
  EXPECT_GT(picture.width(), 600);
  EXPECT_TRUE(text("file-status").contains(QStringLiteral("cut-2.png")));
}

TEST_F(FilePageTest, TwoCutsAreComparedByTheirAnswersAndLevelsInFourTouches) {
  desk_.besideLouderDb = 6.0;
  openWindow();
  int asked = 0;
  page().chooseFile = [&](const QString&, const std::function<void(const QString&)>& take) {
    take(++asked == 1 ? QStringLiteral("/rec/after.wav") : QStringLiteral("/rec/before.wav"));
  };
  window_->showPage(QStringLiteral("file"));  // one touch, the second, and one on each of two files
  press(QStringLiteral("file-beside"));
  tick(40);
  tick(40);
  EXPECT_EQ(asked, 2) << "where nothing is open both are asked for";
  EXPECT_EQ(desk_.path(FileController::Main), QStringLiteral("/rec/after.wav"));
  ASSERT_EQ(desk_.path(FileController::Beside), QStringLiteral("/rec/before.wav"));
  QTest::keyClicks(find<QLineEdit>(QStringLiteral("file-beside-teeth")), QStringLiteral("4"));
  QTest::keyClicks(find<QLineEdit>(QStringLiteral("file-beside-speed")), QStringLiteral("7100"));
  tick(40);
  tick(400);
  EXPECT_EQ(desk_.asked(FileController::Beside), (FileQuestion{4, Rpm(7100.0)}));
  EXPECT_EQ(desk_.asked(FileController::Main), FileQuestion()) << "the first keeps its own";
  desk_.finish();
  desk_.finishBeside();
  tick(40);
  tick(40);
  EXPECT_TRUE(text("file-beside-title").remove(QChar(0x200b)).contains(QStringLiteral("before.wav")));
  EXPECT_EQ(text("file-beside-headline"), QStringLiteral("Chatter at 1502 Hz from 4.0 s on"));
  EXPECT_TRUE(text("file-beside-level").contains(QStringLiteral("louder")));
  EXPECT_TRUE(text("file-beside-level").startsWith(u'6'));
  EXPECT_EQ(find<StateRows>()->rows().back().detector, QStringLiteral("compared"));
  press(QStringLiteral("file-beside"));
  tick(40);
  EXPECT_FALSE(find<QLabel>(QStringLiteral("file-beside-title"))->isVisible());
  EXPECT_EQ(find<StateRows>()->rows().size(), 4U);
}

TEST_F(FilePageTest, ASecondRecordingLiesBesideAndGoesAgain) {
  openWindow();
  openFile();
  page().chooseFile = [](const QString&, const std::function<void(const QString&)>& take) {
    take(QStringLiteral("/rec/before.wav"));
  };
  press(QStringLiteral("file-beside"));
  tick(40);
  tick(40);
  EXPECT_EQ(desk_.path(FileController::Beside), QStringLiteral("/rec/before.wav"));
  EXPECT_EQ(desk_.requests.back().first, FileController::Beside);
  page().view().setHarmonic(Hertz(1502.0));
  EXPECT_TRUE(find<FileSpectrum>()->reading().contains(QStringLiteral("compared")));
  press(QStringLiteral("file-beside"));
  tick(40);
  EXPECT_TRUE(desk_.path(FileController::Beside).isEmpty());
}

TEST_F(FilePageTest, ALongerRecordingBesideIsSeenToItsEnd) {
  openWindow();
  openFile();
  const Seconds own = page().view().options().span;
  page().chooseFile = [](const QString&, const std::function<void(const QString&)>& take) {
    take(QStringLiteral("/rec/longer.wav"));
  };
  press(QStringLiteral("file-beside"));
  tick(40);
  tick(40);
  EXPECT_NEAR(page().view().options().span.value, 2.5 * own.value, 1e-6);
  EXPECT_NEAR(desk_.requests.back().second.to.value, 2.5 * own.value, 1e-6) << "its spectra as well";
  page().view().showTimes(Instant{} + toDuration(own * 1.5), Instant{} + toDuration(own * 2.0));
  tick(40);
  for (const auto& [place, request] : desk_.requests) EXPECT_LT(request.from, request.to);
  press(QStringLiteral("file-beside"));
  tick(40);
  EXPECT_LE(sinceEpoch(page().view().to()), own) << "nothing is left there";
  page().view().follow();
  EXPECT_EQ(page().view().options().span, own);
}

}  // namespace
}  // namespace stillcut::ui
