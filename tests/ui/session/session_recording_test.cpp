// What a profile says of recordings, done by the session of the desktop: modes, names by job, tool and time, who was
// there.
#include <gtest/gtest.h>

#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "app/session/session.h"
#include "core/evaluate/session_summary_builder.h"
#include "core/session/file/session_markers.h"
#include "core/session/session_glance.h"

namespace stillcut::app {
namespace {

class RecordedByProfile : public testing::Test {
 protected:
  // Puts a profile of the simulated mill in force, as the Set up page does.
  void start(const std::string& mode, const QString& asked = {},
             const std::string& scenario = STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml") {
    auto opened = openScenarioSession(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml", true);
    ASSERT_TRUE(opened.ok()) << opened.error().line();
    session_ = std::move(opened).value();
    session_->keepStateIn(folder_.filePath(QStringLiteral("state")));
    session_->keepRecordingsIn(folder_.filePath(QStringLiteral("usual")));
    session_->keepFlightsIn(folder_.filePath(QStringLiteral("flights")).toStdString());
    if (!asked.isEmpty()) {
      askedFor_ = session_->recordAsAsked(asked.toStdString());
      session_->start();
    }
    ui::SetupController& controller = *session_->setup();
    config::ParamCatalog catalog;
    catalog.add(controller.recordParams());
    config::Profile profile;
    profile.cut.machine = "Simulated mill";
    profile.cut.tool = "T12 D12 Z4";
    profile.cut.teeth = 4;
    profile.cut.nominalSpeed = Rpm(8500.0);
    profile.operatorName = "Ada";
    profile.recording = {recordings().toStdString(), "Housing 7"};
    profile.source = {"simulated", {{"scenario", scenario}}};
    profile.link = {"simulated", {}};
    ASSERT_TRUE(profile.params.set(catalog, "record.mode", mode, "test").ok());
    const Status begun = controller.start(profile, QStringLiteral("mill"));
    ASSERT_TRUE(begun.ok()) << begun.error().line();
    const auto back = controller.load(QStringLiteral("mill"));
    ASSERT_TRUE(back.ok()) << back.error().line();
    EXPECT_EQ(back->recording.job, "Housing 7");
  }
  QString recordings() const { return folder_.filePath(QStringLiteral("recordings")); }
  bool comes(ui::RecordingNow::State state) {
    return QTest::qWaitFor(
        [&] {
          (void)session_->pull();
          return session_->setup()->recordingNow().state == state && session_->recorder().length.value > 0.3;
        },
        60'000);
  }
  // The one file there is, below job and tool.
  std::string onlyFile() const { return onlyFileIn(recordings()); }
  static std::string onlyFileIn(const QString& folder) {
    QDirIterator files(folder + QStringLiteral("/Housing 7/T12 D12 Z4"), {QStringLiteral("*.h5")}, QDir::Files);
    EXPECT_TRUE(files.hasNext());
    const QString file = files.hasNext() ? files.next() : QString();
    EXPECT_FALSE(files.hasNext()) << "one file";
    return file.toStdString();
  }

  QTemporaryDir folder_;
  std::unique_ptr<Session> session_;
  Status askedFor_ = Done{};
};

TEST_F(RecordedByProfile, EverythingIsKeptWithWhoAndWhatFor) {
  start("continuous");
  ASSERT_TRUE(comes(ui::RecordingNow::State::Writes));
  EXPECT_EQ(session_->recorder().state, ui::RecorderView::State::Recording);
  EXPECT_EQ(session_->sessions()->folder(), recordings()) << "the Sessions page lists them";
  ASSERT_TRUE(session_->stop().ok());
  const auto summary = evaluate::summarizeRecording(onlyFile());
  ASSERT_TRUE(summary.ok()) << summary.error().line();
  EXPECT_GT(summary->length.value, 0.2);
  EXPECT_EQ(summary->operatorName, "Ada");
  EXPECT_EQ(summary->job, "Housing 7");
  EXPECT_GT(summary->started_ns, 0);
}

// --record goes before what a profile says, also when the profile is put in force from the page.
TEST_F(RecordedByProfile, WhatWasAskedForAtTheStartHoldsForEveryProfile) {
  const QString asked = folder_.filePath(QStringLiteral("asked"));
  ASSERT_TRUE(QDir().mkpath(asked));
  start("continuous", asked);
  ASSERT_TRUE(comes(ui::RecordingNow::State::Writes));
  EXPECT_TRUE(session_->setup()->recordingNow().path.startsWith(asked)) << "the page says so";
  EXPECT_EQ(session_->sessions()->folder(), asked);
  ASSERT_TRUE(session_->stop().ok());
  EXPECT_TRUE(evaluate::glimpseOf(onlyFileIn(asked)).ok());
  EXPECT_FALSE(QFileInfo::exists(recordings()));
}

// A share that is gone, a folder for reading: the cut before and the one of the profile are watched, and the screen
// says what is not recorded.
TEST_F(RecordedByProfile, WhereNothingCanBeRecordedTheCutIsWatchedAllTheSame) {
  start("continuous", QStringLiteral("/proc/cut.h5"));
  EXPECT_FALSE(askedFor_.ok());
  EXPECT_TRUE(QTest::qWaitFor([&] { return session_->pull() != nullptr; }, 60'000));
  EXPECT_EQ(session_->recorder().state, ui::RecorderView::State::Failed);
  EXPECT_TRUE(session_->recorder().problem.contains(QStringLiteral("/proc/cut.h5")));
  EXPECT_EQ(session_->setup()->recordingNow().state, ui::RecordingNow::State::Stopped);
  EXPECT_FALSE(session_->stop().ok());
}

TEST_F(RecordedByProfile, AFileThatWasAskedForIsFollowedByTheNext) {
  const QString asked = folder_.filePath(QStringLiteral("cut.h5"));
  start("continuous", asked);
  ASSERT_TRUE(comes(ui::RecordingNow::State::Writes));
  const QString next = folder_.filePath(QStringLiteral("cut-2.h5"));
  EXPECT_EQ(session_->setup()->recordingNow().path, next);
  ASSERT_TRUE(session_->stop().ok());
  const auto first = evaluate::glimpseOf(asked.toStdString()), second = evaluate::glimpseOf(next.toStdString());
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_NE(first->configuration, second->configuration) << "the one before is left as it was";
  EXPECT_FALSE(QFileInfo::exists(recordings()));
}

TEST_F(RecordedByProfile, AroundEventsNothingIsWrittenBeforeATouchAndThenWhatWasBefore) {
  start("around-events");
  ASSERT_TRUE(comes(ui::RecordingNow::State::Waits));
  EXPECT_TRUE(session_->recorder().waiting);
  session_->send({OperatorAction::ReportChatter}, session_->generation());
  ASSERT_TRUE(comes(ui::RecordingNow::State::Writes));
  EXPECT_FALSE(session_->recorder().waiting);
  ASSERT_TRUE(session_->stop().ok());
  const std::string file = onlyFile();
  const auto summary = evaluate::summarizeRecording(file);
  ASSERT_TRUE(summary.ok()) << summary.error().line();
  ASSERT_EQ(summary->markers.size(), 1U);
  EXPECT_EQ(summary->markers[0].label, kLabelOperatorChatter);
  EXPECT_EQ(summary->markers[0].author, "Ada");
  EXPECT_GT(sinceEpoch(summary->markers[0].begin).value, 0.2) << "what was before it is kept";
}

TEST_F(RecordedByProfile, FeaturesAreKeptWithoutSamples) {
  start("features");
  ASSERT_TRUE(comes(ui::RecordingNow::State::Writes));
  Instant began{};
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const Snapshot* now = session_->pull();
        if (now == nullptr || now->verdicts[0].state != CutState::Chatter) return false;
        if (toNs(began) == 0) began = now->time;
        return secondsBetween(began, now->time).value > 2.5;
      },
      60'000));
  ASSERT_TRUE(session_->stop().ok());
  const auto glimpse = evaluate::glimpseOf(onlyFile());
  ASSERT_TRUE(glimpse.ok()) << glimpse.error().line();
  EXPECT_GT(glimpse->length.value, 2.5);
  const auto summary = evaluate::summarizeRecording(onlyFile());
  ASSERT_TRUE(summary.ok()) << summary.error().line();
  EXPECT_TRUE(summary->spectrogram.empty()) << "no samples";
  EXPECT_TRUE(summary->sensors.empty()) << "nothing can be said of them";
  EXPECT_EQ(summary->alarms, 1U);
  // The screen has counted every block.
  ASSERT_NE(session_->pull(), nullptr);
  EXPECT_NEAR(summary->chatterTime.value, session_->pull()->chatterTime.value, 0.1);
  ui::SessionController& controller = *session_->sessions();
  controller.open(QString::fromStdString(onlyFile()));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        controller.poll();
        return controller.replay().open && controller.summaryWhole() && !controller.task().running;
      },
      60'000));
  EXPECT_TRUE(controller.task().problem.isEmpty()) << controller.task().problem.toStdString();
  controller.setPace(0.0);
  controller.play();
  EXPECT_TRUE(QTest::qWaitFor([&] { return controller.replay().finished; }, 60'000)) << "it comes to its end";
}

TEST_F(RecordedByProfile, TheFileIsClosedWhenTheRunEndsAndTheRunCanBeHadAgain) {
  QFile demo(QStringLiteral(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml"));
  ASSERT_TRUE(demo.open(QIODevice::ReadOnly));
  QFile brief(folder_.filePath(QStringLiteral("brief.toml")));
  ASSERT_TRUE(brief.open(QIODevice::WriteOnly));
  brief.write(demo.readAll().replace("duration_s = 30.0", "duration_s = 3.0"));
  brief.close();
  start("continuous", {}, brief.fileName().toStdString());
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        (void)session_->pull();
        return session_->mayRunAgain();
      },
      60'000));
  (void)session_->pull();
  const auto seen = record::glanceAtSession(onlyFile());
  ASSERT_TRUE(seen) << "while the program goes on";
  EXPECT_GT(seen->length.value, 1.0);
  EXPECT_EQ(session_->recorder().state, ui::RecorderView::State::Off);
}

TEST_F(RecordedByProfile, AFolderThatCannotBeMadeIsSaidBeforeTheCut) {
  QFile inTheWay(recordings());
  ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
  inTheWay.close();
  auto opened = openScenarioSession(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml", true);
  ASSERT_TRUE(opened.ok());
  const Status recording = (*opened)->run().recordInto(recordings().toStdString());
  ASSERT_FALSE(recording.ok());
  EXPECT_NE(recording.error().line().find("cannot be made"), std::string::npos) << recording.error().line();
}

}  // namespace
}  // namespace stillcut::app
