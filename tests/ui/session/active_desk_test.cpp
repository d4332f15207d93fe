// The desk of the active work-holder on a simulated cut, as fast as it goes: identify, look, start, watch, stop.
#include "app/session/active_loop_controller.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "app/compose/active_setup.h"
#include "app/session/session.h"
#include "core/milling/simulation/scenario.h"
#include "ui/shell/main_window.h"

namespace stillcut::app {
namespace {

// What the table was told, for whoever looks when it is gone.
struct TableSeen {
  std::atomic<double> last{0.0};  // share of the stroke, either way
  std::atomic<bool> closed{false};
};

// Time that the device makes: a block is as long as its samples. It stands still but for what the test allows.
class BlockTime final : public active::DuplexDevice {
 public:
  BlockTime(std::unique_ptr<active::SimulatedDuplex> device, ManualClock& clock)
      : device_(std::move(device)), clock_(clock) {}
  std::string name() const override { return device_->name(); }
  Result<active::DuplexFormat> open() override {
    auto opened = device_->open();
    stopped_ = false;
    if (opened) block_ = Seconds(opened->frames / opened->rate.value);
    return opened;
  }
  active::DuplexEvent read(std::span<double> in) noexcept override {
    while (!stopped_ && toNs(clock_.now()) >= allowed.load()) std::this_thread::yield();
    const active::DuplexEvent event = device_->read(in);
    clock_.set(clock_.now() + toDuration(block_));
    return event;
  }
  active::DuplexEvent write(std::span<const safety::ActuatorCommand> out) noexcept override {
    double farthest = 0.0;
    for (const safety::ActuatorCommand& command : out) farthest = std::max(farthest, std::abs(command.value()));
    seen->last = farthest;
    return device_->write(out);
  }
  void stop() noexcept override {
    stopped_ = true;
    device_->stop();
  }
  void close() noexcept override {
    device_->close();
    seen->closed = true;
  }

  std::atomic<std::int64_t> allowed{0};  // [ns]
  std::shared_ptr<TableSeen> seen = std::make_shared<TableSeen>();

 private:
  std::atomic<bool> stopped_{false};
  std::unique_ptr<active::SimulatedDuplex> device_;
  ManualClock& clock_;
  Seconds block_{};
};

class OnFord : public testing::Test {
 protected:
  void openDesk(const char* cut) {
    auto scenario = milling::loadScenario(std::string(STILLCUT_SOURCE_DIR "/resources/scenarios/") + cut + ".toml");
    ASSERT_TRUE(scenario.ok()) << scenario.error().line();
    auto device = std::make_unique<active::SimulatedDuplex>(*scenario, 1, 1);
    simulated_ = device.get();
    active::ActiveEngineOptions options = activeOptions(*scenario->workHolder, {});
    options.record.duration = Seconds(2.0);
    auto paced = std::make_unique<BlockTime>(std::move(device), clock_);
    time_ = paced.get();
    seen_ = time_->seen;
    owned_ = std::make_unique<ActiveLoopController>(std::move(paced), options, clock_, simulated_);
    controller_ = owned_.get();
  }
  void TearDown() override {
    if (!seen_->closed) relinquish();
  }
  // The device's time runs free, to ramp out.
  void relinquish() { time_->allowed = std::numeric_limits<std::int64_t>::max(); }

  // Until the loop's clock has gone on by so much, or earlier when it is done.
  template <class Done>
  void watch(double seconds, Done done) {
    const Instant end = clock_.now() + toDuration(Seconds(seconds));
    while (clock_.now() < end && !done()) {
      controller_->poll();
      // However late this thread is, never longer than the lease without a poll.
      time_->allowed = std::min(toNs(end), toNs(clock_.now() + std::chrono::milliseconds(200)));
      std::this_thread::yield();
    }
    time_->allowed = toNs(clock_.now());
  }
  ActiveSnapshot newest() {
    const ActiveSnapshot* told = controller_->pull();
    return told != nullptr ? *told : ActiveSnapshot{};
  }

  // Identifies and starts; the tool enters under control.
  void control() {
    ASSERT_TRUE(controller_->identify().ok());
    watch(600.0, [&] { return controller_->fit(1) != nullptr || !controller_->problem().isEmpty(); });
    ASSERT_TRUE(controller_->problem().isEmpty()) << controller_->problem().toStdString();
    const Status begun = controller_->start();
    ASSERT_TRUE(begun.ok()) << begun.error().line();
    watch(9.0, [] { return false; });
  }

  ManualClock clock_;
  active::SimulatedDuplex* simulated_ = nullptr;
  BlockTime* time_ = nullptr;
  std::shared_ptr<TableSeen> seen_;
  ActiveLoopController* controller_ = nullptr;
  std::unique_ptr<ActiveLoopController> owned_;
  std::unique_ptr<Session> session_;  // where it is given one
};

TEST_F(OnFord, TellsWhatItIdentified) {
  openDesk("ford-unstable");
  EXPECT_EQ(controller_->pull(), nullptr);
  EXPECT_EQ(controller_->fit(0), nullptr);
  EXPECT_FALSE(controller_->start().ok());  // without a model

  ASSERT_TRUE(controller_->identify().ok());
  EXPECT_FALSE(controller_->identify().ok());  // one at a time
  watch(600.0, [&] { return controller_->fit(1) != nullptr || !controller_->problem().isEmpty(); });
  ASSERT_TRUE(controller_->problem().isEmpty()) << controller_->problem().toStdString();
  for (const int axis : {0, 1}) {
    const PathFit* fit = controller_->fit(axis);
    ASSERT_NE(fit, nullptr);
    EXPECT_EQ(fit->frequency.size(), fit->measured.size());
    EXPECT_EQ(fit->frequency.size(), fit->modelled.size());
    EXPECT_EQ(fit->frequency.size(), fit->coherence.size());
    EXPECT_LT(fit->path.residual, 0.1);
    EXPECT_TRUE(fit->path.predictedStable);
  }
  EXPECT_EQ(controller_->fit(2), nullptr);
}

TEST_F(OnFord, HoldsTheUnstableCutUntilItIsStopped) {
  openDesk("ford-unstable");
  control();
  const ActiveSnapshot held = newest();
  EXPECT_TRUE(held.open);
  for (const ActiveAxis& axis : held.axes) {
    EXPECT_EQ(axis.state, ActuatorState::On) << actuatorReleaseText(axis.release);
    EXPECT_LT(axis.strokePeak, 1.0);
    EXPECT_EQ(axis.lineCount, 3);
  }
  EXPECT_FALSE(controller_->identify().ok());  // while the table moves
  controller_->stop();
  watch(1.0, [] { return false; });
  EXPECT_EQ(newest().axes[0].state, ActuatorState::Off);
  EXPECT_EQ(newest().axes[0].release, ActuatorRelease::Asked);
}

// On a session beside a cut, as the desktop has it.
class OnFordInASession : public OnFord {
 protected:
  void controlInASession() {
    openDesk("ford-unstable");
    control();
    ASSERT_GT(seen_->last, 0.0) << "the table does not move: nothing to stop";
    auto opened = openScenarioSession(kDemo, false);
    ASSERT_TRUE(opened.ok()) << opened.error().line();
    session_ = std::move(opened).value();
    session_->keepFlightsIn(folder_.filePath(QStringLiteral("flights")).toStdString());
    session_->run().setActive(std::move(owned_));
  }
  static constexpr const char* kDemo = STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml";
  const QTemporaryDir folder_;
};

TEST_F(OnFordInASession, ClosingTheWindowStopsTheTable) {
  controlInASession();
  {
    ui::MainWindow window(*session_, ui::ThemeKind::Light, ui::Language::English);
    session_->endWith(window, [](const Error& error) { ADD_FAILURE() << error.line(); });
    window.show();
    window.close();
  }
  watch(1.0, [] { return false; });
  for (const ActiveAxis& axis : newest().axes) {
    EXPECT_EQ(axis.state, ActuatorState::Off);
    EXPECT_EQ(axis.release, ActuatorRelease::Asked) << actuatorReleaseText(axis.release);
  }
  EXPECT_EQ(seen_->last, 0.0);
}

TEST_F(OnFordInASession, AnotherCutInItsPlaceBringsTheTableToRest) {
  controlInASession();
  session_->demonstrateWith(kDemo);
  relinquish();
  const Status begun = session_->setup()->startDemonstration();
  ASSERT_TRUE(begun.ok()) << begun.error().line();
  EXPECT_TRUE(seen_->closed);
  EXPECT_EQ(seen_->last, 0.0) << "ramped out, not cut off";
  EXPECT_EQ(session_->active(), nullptr) << "the demonstration has no table";
  EXPECT_TRUE(session_->stop().ok());
}

TEST_F(OnFord, TellsWhatItEarnsOnTheLineOfTheStableCut) {
  openDesk("ford-stable");
  control();
  const ActiveAxis y = newest().axes[1];
  ASSERT_EQ(y.lineCount, 2);
  EXPECT_EQ(y.lines[1].frequency, Hertz(1000.0));
  ASSERT_TRUE(y.lines[1].known);
  EXPECT_GT(y.lines[1].gain_dB, 16.0);
  EXPECT_LT(y.errorRms, y.uncontrolledRms);
  EXPECT_FALSE(controller_->setStep(2.0).ok());
  EXPECT_FALSE(controller_->setLeak(0.5).ok());
  EXPECT_TRUE(controller_->setLeak(0.9999).ok());
}

TEST_F(OnFord, ADeviceThatIsGoneIsSaidAndMustBeIdentifiedAnew) {
  openDesk("ford-unstable");
  ASSERT_TRUE(controller_->identify().ok());
  watch(600.0, [&] { return controller_->fit(0) != nullptr; });
  ASSERT_NE(controller_->fit(0), nullptr);
  time_->stop();
  while (!controller_->poll()) std::this_thread::yield();
  EXPECT_EQ(controller_->fit(0), nullptr);
  EXPECT_FALSE(controller_->problem().isEmpty());
  EXPECT_FALSE(controller_->start().ok());
  EXPECT_TRUE(controller_->identify().ok());
  EXPECT_TRUE(controller_->problem().isEmpty());
}

// The operator's one way out, on whatever page and in whatever window it is touched.
TEST_F(OnFord, BackToProgrammedLetsTheTableGo) {
  openDesk("ford-unstable");
  control();
  ASSERT_EQ(newest().axes[0].state, ActuatorState::On);
  auto session = openScenarioSession(STILLCUT_SOURCE_DIR "/resources/scenarios/ford-unstable.toml", false);
  ASSERT_TRUE(session.ok()) << session.error().line();
  session_ = std::move(session).value();
  session_->run().setActive(std::move(owned_));
  session_->send({OperatorAction::Hold}, session_->generation());
  watch(0.5, [] { return false; });
  EXPECT_EQ(newest().axes[0].state, ActuatorState::On) << "a hold is of the overrides";
  session_->send({OperatorAction::BackToProgrammed}, session_->generation());
  watch(1.0, [] { return false; });
  for (const ActiveAxis& axis : newest().axes) {
    EXPECT_EQ(axis.state, ActuatorState::Off);
    EXPECT_EQ(axis.release, ActuatorRelease::Asked);
  }
}

TEST(ActiveSession, AScenarioOfAWorkHolderOpensWithItsDesk) {
  for (const char* name : {"ford-unstable", "ford-stable"}) {
    const auto session =
        openScenarioSession(std::string(STILLCUT_SOURCE_DIR "/resources/scenarios/") + name + ".toml", false);
    ASSERT_TRUE(session.ok()) << session.error().line();
    ASSERT_NE((*session)->active(), nullptr);
    EXPECT_TRUE((*session)->active()->device().contains(QLatin1String(name)));
    EXPECT_TRUE((*session)->advance());
  }
  const auto without = openScenarioSession(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml", false);
  ASSERT_TRUE(without.ok());
  EXPECT_EQ((*without)->active(), nullptr);
}

}  // namespace
}  // namespace stillcut::app
