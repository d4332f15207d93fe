// The window on the simulated machine: the demonstration's cut, block by block, with its real lobes.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <memory>

#include "app/session/session.h"
#include "app/session/session_view.h"
#include "core/cnc/simulated_machine.h"
#include "core/daq/simulated/simulated_source.h"
#include "tests/support/demo_cut.h"
#include "ui/models/lobe_view.h"
#include "ui/pages/analyse_page.h"
#include "ui/plots/spectrogram/history_map.h"
#include "ui/plots/spectrum_plot.h"
#include "ui/shell/main_window.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::app {
namespace {

class Desktop : public testing::Test {
 protected:
  void SetUp() override {
    auto opened = openScenarioSession(STILLCUT_RESOURCE_DIR "/scenarios/demo.toml", false);
    ASSERT_TRUE(opened) << opened.error().line();
    session_ = std::move(opened).value();
    window_ = std::make_unique<ui::MainWindow>(*session_, ui::ThemeKind::Light, ui::Language::English);
    window_->show();
  }
  // Runs the cut to `until` [s], with a display tick every 33 ms of it.
  void run(double until) {
    while (t_ < until && session_->advance()) {
      const Snapshot* snapshot = session_->pull();
      if (snapshot == nullptr) continue;
      t_ = sinceEpoch(snapshot->time).value;
      if (t_ * 1e3 < shown_ + ui::kDisplayTickMs) continue;
      shown_ = t_ * 1e3;
      window_->tick(static_cast<qint64>(shown_));
    }
  }
  // Lets the background work end; a minute is far more than it takes.
  void waitForLobes() {
    QElapsedTimer clock;
    clock.start();
    while (session_->lobes()->progress().state == ui::LobeProgress::State::Running && clock.elapsed() < 60'000) {
      QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }
  }

  std::unique_ptr<Session> session_;
  std::unique_ptr<ui::MainWindow> window_;
  double t_ = 0.0, shown_ = -1e3;
};

TEST_F(Desktop, LobesOfTheDemonstrationAreWhatItsFileSays) {
  run(0.5);
  window_->showPage(QStringLiteral("lobes"));
  window_->tick(1000);
  waitForLobes();
  const auto diagram = session_->lobes()->diagram();
  ASSERT_TRUE(diagram) << session_->lobes()->progress().problem.toStdString();
  // resources/scenarios/demo.toml: a limit near 1.15 mm at the programmed 8 500 rpm; 7 030 rpm carries 1.8 mm and more.
  EXPECT_NEAR(ui::limitAt(*diagram, Rpm(8500))->value, 1.15e-3, 0.08e-3);
  EXPECT_GT(ui::limitAt(*diagram, Rpm(7030))->value, 1.8e-3);
  bool found = false;
  for (const ui::Pocket& pocket : ui::pocketsAt(*diagram, session_->lobes()->frame(), Metres(1.8e-3))) {
    found = found || (pocket.from < Rpm(7030) && pocket.to > Rpm(7030) && pocket.reachable);
  }
  EXPECT_TRUE(found);
}

TEST_F(Desktop, AQuestionInTheBackgroundCanBeCancelled) {
  ui::LobeService& lobes = *session_->lobes();
  ui::LobeQuestion question;
  question.from = lobes.frame().lowest;
  question.to = lobes.frame().highest;
  question.steps = 5000;
  question.maxAxialDepth = lobes.frame().maxAxialDepth;
  lobes.ask(question);
  lobes.cancel();
  EXPECT_EQ(lobes.progress().state, ui::LobeProgress::State::Cancelled);
  EXPECT_FALSE(lobes.diagram());
  question.maxAxialDepth = Metres(-1.0);
  lobes.ask(question);
  waitForLobes();
  EXPECT_EQ(lobes.progress().state, ui::LobeProgress::State::Failed);
  EXPECT_FALSE(lobes.progress().problem.isEmpty());
}

TEST_F(Desktop, AnalyseShowsTheCutWithItsChatter) {
  window_->showPage(QStringLiteral("analyse"));
  run(7.0);
  auto* page = window_->findChild<ui::AnalysePage*>();
  auto* spectrum = window_->findChild<ui::SpectrumPlot*>();
  // The cut has met chatter by now; where it did, its line is the strongest off the teeth.
  const auto& view = page->view();
  EXPECT_GT(secondsBetween(view.first(), view.newest()).value, 6.0);
  ASSERT_TRUE(spectrum->spectrum().known);
  EXPECT_FALSE(spectrum->spectrum().toothPassing.empty());
  QTest::keyClick(spectrum, Qt::Key_H);
  ASSERT_TRUE(view.harmonic());
  window_->tick(static_cast<qint64>(shown_) + 33);
  EXPECT_TRUE(spectrum->spectrum().reading.contains(QStringLiteral("Hz")));
}

TEST_F(Desktop, TheDepthIsTheProgrammesAtThatMoment) {
  run(9.0);
  EXPECT_NEAR(session_->lobes()->axialDepthAt(instantFromNs(2'000'000'000)).value, 0.7e-3, 1e-6);
  EXPECT_NEAR(session_->lobes()->axialDepthAt(instantFromNs(9'000'000'000)).value, 1.5e-3, 1e-6);
}

// Waits on the real clock, as long as the cut needs; a minute is far more.
template <class Done>
bool waitFor(Done&& done) {
  return QTest::qWaitFor(std::forward<Done>(done), 60'000);
}

TEST(FirstStart, OneTouchOfTheGuideEndsInARunningSimulatedCut) {
  const QTemporaryDir folder;
  auto session = openScenarioSession(STILLCUT_RESOURCE_DIR "/scenarios/demo.toml", true);
  ASSERT_TRUE(session) << session.error().line();
  (*session)->keepStateIn(folder.path());
  (*session)->keepFlightsIn(folder.filePath(QStringLiteral("flights")).toStdString());
  (*session)->demonstrateWith(STILLCUT_RESOURCE_DIR "/scenarios/demo.toml");
  {
    ui::MainWindow window(**session, ui::ThemeKind::Light, ui::Language::English);
    (*session)->endWith(window, [](const Error& error) { ADD_FAILURE() << error.line(); });
    window.show();
    ASSERT_TRUE(window.offerGuide());
    window.tick(0);
    QTest::mouseClick(window.findChild<ui::TouchButton*>(QStringLiteral("guide-simulated")), Qt::LeftButton);
    EXPECT_EQ(window.currentPage(), QStringLiteral("operate"));
    EXPECT_TRUE(waitFor([&] {
      const Snapshot* s = (*session)->pull();
      return s != nullptr && s->running && s->columnCount > 3 && s->machine.valid;
    }));
    window.tick(33);
    window.close();
  }
  ui::MainWindow next(**session, ui::ThemeKind::Light, ui::Language::English);
  EXPECT_FALSE(next.offerGuide());
}

// The real window on the live simulated machine: Auto has moved the spindle, the window is closed, and the plant has
// its programmed values back.
TEST(Closing, MidCutReturnsTheMachineToItsProgrammedValues) {
  const QTemporaryDir folder;
  milling::Scenario cut = test::demoCut(30.0);
  cut.programme.depth.segments = {{0.0, 0.9, 0.7e-3, 1.5e-3, milling::RampShape::Linear}};
  const auto port = std::make_shared<milling::PlantPort>();
  auto source = std::make_unique<daq::SimulatedSource>(cut, 0, port, daq::SimulatedPace{.realTime = true});
  daq::SimulatedSource& plant = *source;
  RigSpec spec;
  spec.device = std::move(source);
  spec.link = std::make_unique<cnc::SimulatedMachine>(cut, port);
  spec.setup = cut.cutSetup();
  spec.autoAllowed = spec.watched = true;
  auto rig = Rig::build(std::move(spec));
  ASSERT_TRUE(rig) << rig.error().line();
  ui::SessionInfo info = sessionInfo(**rig);
  Session session(std::make_unique<CutRun>(std::move(rig).value(), std::move(info), ""));
  session.keepFlightsIn(folder.filePath(QStringLiteral("flights")).toStdString());
  session.send({OperatorAction::GrantBySimulation, Authority::Auto}, session.generation());

  ui::MainWindow window(session, ui::ThemeKind::Light, ui::Language::English);
  session.endWith(window, [](const Error& error) { ADD_FAILURE() << error.line(); });
  session.start();
  window.start();
  window.show();
  ASSERT_TRUE(waitFor([&] {
    const Snapshot* s = session.pull();
    return s != nullptr && s->commanding && std::abs(s->machine.speedOverride.value - 1.0) > 0.02;
  })) << "the cut was never moved: nothing to give back";
  window.close();

  // The threads are off; whatever was left for the plant acts on it now.
  port->serve(plant.plant());
  SampleBlock block;
  block.allocate(static_cast<int>(cut.sensors.size()), static_cast<int>(cut.rate.value));
  ASSERT_TRUE(plant.plant().fill(block));
  EXPECT_DOUBLE_EQ(plant.plant().machineState().speedOverride.value, 1.0);
  EXPECT_DOUBLE_EQ(plant.plant().machineState().feedOverride.value, 1.0);
}

}  // namespace
}  // namespace stillcut::app
