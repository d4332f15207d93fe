// What an operator and an engineer do with a recording, in the real window: marks by key during the cut are found in
// the file, and a changed threshold is answered with what it would have done.
#include <gtest/gtest.h>

#include <QDir>
#include <QLineEdit>
#include <QListView>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <optional>

#include "app/compose/recording_score.h"
#include "app/compose/scenario_rig.h"
#include "app/session/session.h"
#include "core/detect/liao/spectral.h"
#include "core/session/file/session_markers.h"
#include "core/session/file/session_reader.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"
#include "tests/support/demo_cut.h"
#include "ui/facade/session_controller.h"
#include "ui/shell/main_window.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::app {
namespace {

class RecordedDesktop : public testing::Test {
 protected:
  void open(Status (*record)(Session&, const std::string&), const QString& folder) {
    auto opened = openScenarioSession(STILLCUT_RESOURCE_DIR "/scenarios/demo.toml", false);
    ASSERT_TRUE(opened) << opened.error().line();
    session_ = std::move(opened).value();
    if (record != nullptr) {
      ASSERT_TRUE(record(*session_, path_).ok());
    }
    session_->keepRecordingsIn(folder);
    window_ = std::make_unique<ui::MainWindow>(*session_, ui::ThemeKind::Light, ui::Language::English);
    window_->show();
    window_->activateWindow();
    QCoreApplication::processEvents();
  }
  // Goes on with the cut until `done`, with a display tick for every block.
  bool runUntil(const std::function<bool(const Snapshot&)>& done) {
    while (session_->advance()) {
      const Snapshot* snapshot = session_->pull();
      if (snapshot == nullptr) continue;
      now_ = snapshot->time;
      window_->tick(toNs(now_) / 1'000'000);
      if (done(*snapshot)) return true;
    }
    return false;
  }
  bool runFor(double seconds) {
    const Instant until = now_ + toDuration(Seconds(seconds));
    return runUntil([until](const Snapshot& s) { return s.time >= until; });
  }
  // A key, and the time of the cut when it was struck.
  Instant strike(Qt::Key key) {
    QTest::keyClick(window_.get(), key);
    return now_;
  }
  void press(const char* name) const {
    auto* button = window_->findChild<ui::TouchButton*>(QLatin1String(name));
    ASSERT_NE(button, nullptr) << name;
    ASSERT_TRUE(button->isEnabled()) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }
  // On the screen's clock; a minute is far more than anything here takes.
  bool waitFor(const std::function<bool()>& done) {
    return QTest::qWaitFor(
        [&] {
          window_->tick(now_ms_ += 40);
          return done();
        },
        60'000);
  }
  bool says(const QString& text) const { return words().contains(text); }
  // All that the page tells.
  QString words() const {
    QString all;
    for (const ui::TextLabel* label : window_->findChildren<ui::TextLabel*>()) {
      if (label->isVisible()) all += label->text() + u'\n';
    }
    return all;
  }

  QTemporaryDir folder_;
  std::string path_ = folder_.filePath(QStringLiteral("cut.h5")).toStdString();
  std::unique_ptr<Session> session_;
  std::unique_ptr<ui::MainWindow> window_;
  Instant now_{};
  qint64 now_ms_ = 0;
};

TEST_F(RecordedDesktop, MarksByKeyDuringTheCutAreFoundInTheFile) {
  open([](Session& session, const std::string& path) { return session.run().recordTo(path); }, {});
  ASSERT_TRUE(runUntil([](const Snapshot& s) { return s.time >= instantFromNs(1'500'000'000); }));
  const Instant heard = strike(Qt::Key_F8);
  ASSERT_TRUE(runUntil([](const Snapshot& s) { return s.interventionCount > 0; }))
      << "the demonstration never chattered";
  // Both in so short a time that no second alarm can come between them: that one would have a word of its own.
  strike(Qt::Key_F9);
  ASSERT_TRUE(runFor(0.02));
  const Instant wasFalse = strike(Qt::Key_F10);
  ASSERT_TRUE(runFor(0.2));
  ASSERT_TRUE(session_->stop().ok());

  const auto markers = record::readMarkers(path_);
  ASSERT_TRUE(markers.ok()) << markers.error().line();
  ASSERT_EQ(markers->size(), 2U) << "the second word on one alarm takes the place of the first";
  const CutSetup& setup = session_->info().setup;
  const double block = setup.blockFrames / setup.rate.value;
  const std::pair<const char*, Instant> struck[] = {{kLabelOperatorChatter, heard}, {kLabelFalseAlarm, wasFalse}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Marker& marker = markers.value()[i];
    EXPECT_EQ(marker.label, struck[i].first);
    EXPECT_EQ(marker.begin, marker.end);
    EXPECT_NEAR(secondsBetween(struck[i].second, marker.begin).value, 0.0, 2.0 * block) << marker.label;
  }
}

// The short demonstration without control, whose alarm the operator has called false, and the page that is asked what a
// threshold out of reach would have done.
TEST_F(RecordedDesktop, AChangedThresholdIsAnsweredInASentence) {
  {
    ScenarioOptions options;
    options.methods.strategy = "monitor";
    auto built = buildScenarioRig(test::demoCut(), options);
    ASSERT_TRUE(built.ok() && built->rig->recordTo(path_, "").ok());
    // Touched during the cut, and back to automatic: may not overrule what is asked afterwards.
    built->rig->send({OperatorAction::SetParameter, Authority::Off, 0, config::parameterId(detect::kSpeThreshold.key),
                      config::kAutomatic});
    built->rig->runToEnd({});
    ASSERT_TRUE(built->rig->recorder()->finish().ok());
    const Instant late = instantFromNs(4'500'000'000);
    ASSERT_TRUE(record::addMarker(path_, {0, late, late, kLabelFalseAlarm, "operator", "", 0}).ok());
  }
  const auto truth = evaluate::truthOf(path_);
  ASSERT_TRUE(truth.ok() && truth.value());
  const auto before =
      scoreRecording(path_, *truth.value(), {.detectors = {"energy-ratio"}, .params = {}, .settings = {}, .goOn = {}});
  ASSERT_TRUE(before.ok());
  ASSERT_EQ(before->byDetector.at("energy-ratio").alarms, 1);
  ASSERT_EQ(before->byDetector.at("energy-ratio").falseAlarms, 1);

  open(nullptr, folder_.path());
  window_->showPage(QStringLiteral("sessions"));
  auto* list = window_->findChild<QListView*>(QStringLiteral("session-list"));
  ASSERT_TRUE(waitFor([list] { return list->model()->rowCount() == 1; }));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
  ASSERT_TRUE(waitFor([this] { return session_->sessions()->replay().open; }));
  press("sheet-compare");
  auto* settings = window_->findChild<QLineEdit*>(QStringLiteral("session-settings"));
  settings->setFocus();
  QTest::keyClicks(settings, QStringLiteral("spectral.threshold=1000000"));  // m/s2: no line is as strong
  press("session-run");
  EXPECT_TRUE(waitFor([this] {
    return says(
        QStringLiteral("Spectral line would have alarmed not at all; as recorded: once, 1 of them marked false"));
  })) << words().toStdString();
  EXPECT_TRUE(says(QStringLiteral(
      "Energy ratio would have alarmed once, 1 of them marked false; as recorded: once, 1 of them marked false")));
  settings->clear();
  press("session-run");
  EXPECT_TRUE(waitFor([this] { return says(QStringLiteral("Energy ratio alarmed once, 1 of them marked false")); }));
}

// A terminal that is closed, Ctrl-C or a polite kill end the program as its window does: in order.
TEST(DesktopProgram, InterruptedItEndsItsRecordingAndItself) {
  const QTemporaryDir folder;
  for (const char* home : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"}) qputenv(home, folder.path().toUtf8());
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    SCOPED_TRACE(number);
    const std::string path = folder.filePath(QStringLiteral("cut%1.h5").arg(number)).toStdString();
    const std::string demo = STILLCUT_RESOURCE_DIR "/scenarios/demo.toml";
    cnc::testing::Child program({STILLCUT_DESKTOP, "--scenario", demo, "--record", path});
    ASSERT_TRUE(cnc::testing::within(Seconds(30.0), [&] { return std::filesystem::exists(path); }));
    program.signal(number);
    std::optional<int> status;
    ASSERT_TRUE(cnc::testing::within(Seconds(30.0), [&] { return (status = program.ended()).has_value(); }));
    EXPECT_TRUE(WIFEXITED(*status) && WEXITSTATUS(*status) == 0) << *status;
    const auto repaired = record::repairSession(path);
    ASSERT_TRUE(repaired.ok()) << repaired.error().line();
    EXPECT_FALSE(*repaired) << "it was not closed";
  }
}

}  // namespace
}  // namespace stillcut::app
