// Lobes, Tune and Sessions as a person uses them, on the simulated machine with its real lobes and on a recording of
// it: every click, key and drag goes through the window, and what comes of it is seen where it counts.
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QTemporaryDir>

#include "app/compose/scenario_rig.h"
#include "app/session/session.h"
#include "core/session/open_recording.h"
#include "tests/support/demo_cut.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/plots/lobe_chart.h"
#include "ui/plots/session_timeline.h"

namespace stillcut::app {
namespace {

class Person : public testing::Test {
 protected:
  void SetUp() override {
    auto opened = openScenarioSession(STILLCUT_RESOURCE_DIR "/scenarios/demo.toml", false);
    ASSERT_TRUE(opened) << opened.error().line();
    session_ = std::move(opened).value();
    session_->keepStateIn(folder_.path());
    window_ = std::make_unique<ui::MainWindow>(*session_, ui::ThemeKind::Light, ui::Language::English);
    window_->show();
    window_->activateWindow();
    QCoreApplication::processEvents();  // keys go to the window that is active
    run(0.4);
  }
  // The cut goes on for some seconds, and the screen with it.
  void run(double seconds) {
    for (double t = 0.0; t < seconds && session_->advance();) {
      const Snapshot* snapshot = session_->pull();
      if (snapshot == nullptr) continue;
      const double now = sinceEpoch(snapshot->time).value;
      t += now - seen_;
      seen_ = now;
      tick();
    }
  }
  void tick() { window_->tick(nowMs_ += 33); }
  bool waitFor(const std::function<bool()>& done) {
    return QTest::qWaitFor(
        [&] {
          tick();
          return done();
        },
        60'000);
  }
  template <class Widget>
  Widget* find(const QString& name = {}) const {
    return window_->findChild<Widget*>(name);
  }
  void press(const char* name) const {
    auto* button = find<ui::TouchButton>(QLatin1String(name));
    ASSERT_NE(button, nullptr) << name;
    ASSERT_TRUE(button->isEnabled()) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }
  void type(const char* name, const QString& text) const {
    auto* edit = find<QLineEdit>(QLatin1String(name));
    ASSERT_NE(edit, nullptr) << name;
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
  }

  QTemporaryDir folder_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<ui::MainWindow> window_;
  double seen_ = 0.0;
  qint64 nowMs_ = 0;
};

// resources/scenarios/demo.toml: 7 030 rpm carries 1.8 mm and more, the programmed 8 500 rpm some 1.15 mm.
TEST_F(Person, DragsDepthAndSpeedOnTheLobesAndCancelsAComputation) {
  QTest::keyClick(window_.get(), Qt::Key_3, Qt::ControlModifier);
  tick();
  ASSERT_TRUE(waitFor([this] { return session_->lobes()->diagram() != nullptr; }));
  tick();
  QCoreApplication::processEvents();
  auto* chart = find<ui::LobeChart>();
  const auto dragTo = [&](const ui::SpeedDepth& to) {
    QTest::mousePress(chart->viewport(), Qt::LeftButton, {}, chart->place(chart->handle()));
    QTest::mouseMove(chart->viewport(), chart->place(to));
    QTest::mouseRelease(chart->viewport(), Qt::LeftButton, {}, chart->place(to));
    return find<QLabel>(QStringLiteral("what-if"))->text();
  };
  EXPECT_TRUE(dragTo({Rpm(7030), Metres(1.5e-3)}).startsWith(QStringLiteral("STABLE")));
  EXPECT_TRUE(dragTo({Rpm(8500), Metres(1.8e-3)}).startsWith(QStringLiteral("CHATTER")));
  const auto before = session_->lobes()->diagram();
  press("method-sdm");
  tick();
  ASSERT_EQ(find<ui::TouchButton>(QStringLiteral("compute"))->text(), QStringLiteral("CANCEL"));
  QTest::keyClick(window_.get(), Qt::Key_F8);
  EXPECT_EQ(session_->lobes()->progress().state, ui::LobeProgress::State::Cancelled);
  tick();
  EXPECT_EQ(find<ui::TouchButton>(QStringLiteral("compute"))->text(), QStringLiteral("COMPUTE"));
  EXPECT_EQ(session_->lobes()->diagram(), before) << "the diagram before stays";
}

TEST_F(Person, TunesTheRunningCutUndoesComparesResetsAndSaves) {
  QTest::keyClick(window_.get(), Qt::Key_4, Qt::ControlModifier);
  tick();
  press("tune-expert");
  const auto inForce = [this] {
    run(0.2);
    const QStringList tuned = session_->sessions()->tunedSettings();
    const QStringList chatter = tuned.filter(QStringLiteral("energy-ratio.chatter="));
    return chatter.isEmpty() ? QString() : chatter.front().section(u'=', 1);
  };
  EXPECT_TRUE(inForce().isEmpty());
  type("energy-ratio.chatter-edit", QStringLiteral("0.33"));
  EXPECT_EQ(inForce(), QStringLiteral("0.33"));
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(inForce(), QStringLiteral("0.2"));
  press("tune-b");
  type("energy-ratio.chatter-edit", QStringLiteral("0.4"));
  EXPECT_EQ(inForce(), QStringLiteral("0.4"));
  press("tune-a");
  EXPECT_EQ(inForce(), QStringLiteral("0.2")) << "A as it was";
  press("tune-b");
  EXPECT_EQ(inForce(), QStringLiteral("0.4"));
  press("tune-reset");
  EXPECT_EQ(inForce(), QStringLiteral("0.2"));
  type("energy-ratio.chatter-edit", QStringLiteral("0.25"));
  press("tune-save");
  QFile kept(folder_.filePath(QStringLiteral("parameters.toml")));
  ASSERT_TRUE(kept.open(QIODevice::ReadOnly));
  EXPECT_TRUE(kept.readAll().contains("chatter = 0.25"));
}

class PersonWithRecordings : public Person {
 protected:
  void SetUp() override {
    for (const char* const name : {"first", "second"}) {
      const QString job = folder_.filePath(QStringLiteral("rec/Housing/T12"));
      ASSERT_TRUE(QDir().mkpath(job));
      ScenarioOptions options;
      options.methods.strategy = "monitor";
      auto built = buildScenarioRig(test::demoCut(), options);
      ASSERT_TRUE(built.ok());
      const std::string path = (job + u'/' + QLatin1String(name) + QStringLiteral(".h5")).toStdString();
      ASSERT_TRUE(built->rig->recordTo(path, "").ok());
      built->rig->runToEnd({});
      ASSERT_TRUE(built->rig->recorder()->finish().ok());
    }
    Person::SetUp();
    session_->keepRecordingsIn(folder_.filePath(QStringLiteral("rec")));
    QTest::keyClick(window_.get(), Qt::Key_5, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([this] { return controller().entries().size() == 2; }));
  }
  ui::SessionController& controller() { return *session_->sessions(); }
  void open(int row) {
    const QString before = controller().openedPath();
    auto* list = find<QListView>(QStringLiteral("session-list"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(row, 0)).center());
    ASSERT_TRUE(waitFor([&] {
      return controller().openedPath() != before && controller().replay().open && controller().summaryWhole();
    }));
  }
};

TEST_F(PersonWithRecordings, LeadsMarksComparesAndExportsARecording) {
  open(0);
  press("replay-play");
  EXPECT_TRUE(waitFor([this] { return controller().replay().position.value > 0.3; }));
  press("replay-play");
  EXPECT_FALSE(controller().replay().playing);
  auto* timeline = find<ui::SessionTimeline>();
  timeline->setFocus();
  QTest::keyClick(timeline, Qt::Key_Home);
  EXPECT_TRUE(waitFor([this] { return controller().replay().position.value < 0.1; }));

  const QPoint from(timeline->width() / 2, timeline->height() / 3), to = from + QPoint(120, 0);
  QTest::mousePress(timeline, Qt::LeftButton, {}, from);
  QTest::mouseMove(timeline, (from + to) / 2);
  QTest::mouseMove(timeline, to);
  QTest::mouseRelease(timeline, Qt::LeftButton, {}, to);
  ASSERT_TRUE(timeline->hasSelection());
  QTest::keyClick(window_.get(), Qt::Key_3, Qt::AltModifier);  // "I hear it"
  EXPECT_TRUE(waitFor([this] { return controller().markers().size() == 1 && controller().replay().open; }));

  press("sheet-compare");
  press("session-export");
  const QString wav = QFileInfo(controller().openedPath()).path() + u'/' +
                      QFileInfo(controller().openedPath()).completeBaseName() + QStringLiteral(".wav");
  EXPECT_TRUE(waitFor([&] { return !controller().task().running && QFile::exists(wav); }));
  const auto exported = record::openRecording(wav.toStdString());
  ASSERT_TRUE(exported.ok()) << exported.error().line();
  const double seconds = static_cast<double>((*exported)->format().frames) / (*exported)->format().rate.value;
  EXPECT_NEAR(seconds, (timeline->selectedTo() - timeline->selectedFrom()).value, 0.02) << "the selected span alone";

  press("session-beside");
  open(1);
  EXPECT_TRUE(timeline->besideShown());
  press("session-run");
  EXPECT_TRUE(waitFor([this] { return !controller().tracks().empty(); }));
}

}  // namespace
}  // namespace stillcut::app
