// The engine on a device that the test plays: identification, control, refusals and everything a device can do wrong.
// Time is virtual: the device hands out a block whenever it is asked.
#include "core/active/active_engine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <thread>

#include "core/active/path_filter.h"

namespace stillcut::active {
namespace {

constexpr double kRate = 5000.0;
constexpr int kFrames = 8;
const PathModel kPath{{0.0, 0.5, 0.3, -0.1}, {0.8, -0.5}};

// Two axes with a tone each; an output is heard a block later. Waits when the test has not allowed the block yet.
class PlayedDevice final : public DuplexDevice {
 public:
  explicit PlayedDevice(ManualClock& clock) : clock_(clock) {}
  std::string name() const override { return "played"; }
  Result<DuplexFormat> open() override {
    for (PathFilter& p : paths_) p.prepare(kPath);
    playing_.fill(0.0);
    written_.fill(0.0);
    gone_ = false;
    return DuplexFormat{Hertz(kRate), kFrames, keepsDelay};
  }
  DuplexEvent read(std::span<double> in) noexcept override {
    while (!gone_ && allowed_.load() <= read_.load()) std::this_thread::yield();
    if (gone_) return DuplexEvent::Gone;
    read_.fetch_add(1);
    if (owner) owner();
    clock_.set(clock_.now() + toDuration(Seconds(kFrames / kRate)));
    if (lose_.exchange(false)) {
      written_.fill(0.0);
      return DuplexEvent::Lost;
    }
    playing_ = written_;
    written_.fill(0.0);
    for (std::size_t f = 0; f < kFrames; ++f, ++now_) {
      for (std::size_t a = 0; a < 2; ++a) {
        const double hertz = a == 0 ? 339.0 : 471.0;
        const double d = loud.load() * std::sin(2.0 * std::numbers::pi * hertz / kRate * static_cast<double>(now_));
        in[a * kFrames + f] = d - paths_[a].arrive();
        paths_[a].push(playing_[a * kFrames + f]);
      }
    }
    return DuplexEvent::Block;
  }
  DuplexEvent write(std::span<const safety::ActuatorCommand> out) noexcept override {
    std::ranges::transform(out, written_.begin(), &safety::ActuatorCommand::value);
    double most = 0.0;
    for (double y : written_) most = std::max(most, std::abs(y));
    lastLargest.store(most);
    largest.store(std::max(largest.load(), most));
    return DuplexEvent::Block;
  }
  void stop() noexcept override { gone_ = true; }
  void close() noexcept override {}

  // Lets the loop have so many more blocks and waits until it has had them.
  void play(int blocks) {
    allowed_.fetch_add(blocks);
    while (!gone_ && read_.load() < allowed_.load()) std::this_thread::yield();
  }
  void flow() { allowed_.store(1'000'000'000); }
  void lose() { lose_ = true; }
  void unplug() { gone_ = true; }

  std::atomic<double> loud{0.0}, largest{0.0}, lastLargest{0.0};
  bool keepsDelay = true;       // before it is opened
  std::function<void()> owner;  // block by block; before it is opened

 private:
  ManualClock& clock_;
  std::array<PathFilter, 2> paths_;
  std::array<double, 2 * kFrames> playing_{}, written_{};
  std::uint64_t now_ = 0;
  std::atomic<long> allowed_{0}, read_{0};
  std::atomic<bool> gone_{false}, lose_{false};
};

class Engine : public testing::Test {
 protected:
  Engine() {
    auto device = std::make_unique<PlayedDevice>(clock_);
    device_ = device.get();
    ActiveEngineOptions options;
    options.controller.filter = {.taps = 35, .step = 0.02, .normalised = true};
    options.lines = {Hertz(339.0), Hertz(471.0)};
    options.controller.emphasis.gain = 1.0;
    for (safety::ActuatorLimits& l : options.limits) {
      l.amplitude = 10.0;
      l.slew = 1e6;
    }
    options.record.duration = Seconds(2.0);
    engine_ = std::make_unique<ActiveEngine>(std::move(device), options, clock_);
    device_->owner = [this, engine = engine_.get()] {
      if (ownerLives_) engine->renew();
    };
  }
  ~Engine() override {
    ownerLives_ = false;
    device_->flow();  // the loop may ramp out
    engine_.reset();
  }
  void identified() {
    ASSERT_TRUE(engine_->open().ok());
    ASSERT_TRUE(engine_->identify().ok());
    for (int i = 0; i < 40 && !engine_->recorded(); ++i) device_->play(100);
    ASSERT_TRUE(engine_->recorded());
    const auto found = engine_->fit();
    ASSERT_TRUE(found.ok()) << found.error().line();
    const Status ok = engine_->install(*found);
    ASSERT_TRUE(ok.ok()) << ok.error().line();
  }
  ActiveSnapshot newest() {
    device_->play(60);  // a snapshot is made every 21 blocks
    const ActiveSnapshot* told = engine_->pull();
    EXPECT_NE(told, nullptr);
    return told != nullptr ? *told : ActiveSnapshot{};
  }

  ManualClock clock_;
  PlayedDevice* device_ = nullptr;
  std::atomic<bool> ownerLives_{true};
  std::unique_ptr<ActiveEngine> engine_;
};

TEST_F(Engine, IdentifiesWithTheDelayOfItsBlocksThenControls) {
  identified();
  for (const ActivePath& path : engine_->paths()) {
    EXPECT_TRUE(path.known);
    EXPECT_LT(path.residual, 0.1);
    EXPECT_NEAR(path.delay.value, (2.0 + kFrames) / kRate, 1.5 / kRate);  // two samples of the path, and the block
    EXPECT_TRUE(path.predictedStable);
    EXPECT_GT(path.delayMargin.value, 0.0);
    EXPECT_LT(path.delayMargin.value, 0.25 / 339.0);  // a quarter of a period at the most
  }
  device_->loud = 1.0;
  ASSERT_TRUE(engine_->start().ok());
  device_->play(4000);
  const ActiveSnapshot told = newest();
  EXPECT_TRUE(told.open);
  EXPECT_EQ(told.axes[0].state, ActuatorState::On);
  EXPECT_GT(told.axes[0].lines[0].gain_dB, 20.0);
  EXPECT_GT(told.axes[1].lines[1].gain_dB, 20.0);
  EXPECT_EQ(told.underruns, 0U);
  engine_->stop();
  device_->play(20);
  EXPECT_EQ(newest().axes[0].state, ActuatorState::Off);
  EXPECT_EQ(newest().axes[0].release, ActuatorRelease::Asked);
}

TEST_F(Engine, RefusesToStartWithoutAModelOrWithAnOldOne) {
  const Status shut = engine_->start();
  ASSERT_FALSE(shut.ok());
  EXPECT_NE(shut.error().line().find("does not run"), std::string::npos);
  ASSERT_TRUE(engine_->open().ok());
  const Status none = engine_->start();
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().line().find("identify"), std::string::npos);
  identified();
  clock_.set(clock_.now() + toDuration(Seconds(2.0 * 3600.0)));
  const Status old = engine_->start();
  ASSERT_FALSE(old.ok());
  EXPECT_NE(old.error().line().find("minutes old"), std::string::npos);
}

TEST_F(Engine, ADeviceOpenedAnewMustBeIdentifiedAnew) {
  identified();
  device_->unplug();
  while (engine_->isOpen()) std::this_thread::yield();
  EXPECT_FALSE(engine_->start().ok());
  ASSERT_TRUE(engine_->open().ok());
  const Status anew = engine_->start();
  ASSERT_FALSE(anew.ok());
  EXPECT_NE(anew.error().line().find("no model"), std::string::npos);
}

TEST_F(Engine, RefusesAModelThatHearsNothingOnTheLines) {
  identified();
  auto found = engine_->fit();
  ASSERT_TRUE(found.ok());
  for (double& c : (*found)[1].report.coherence) c = 0.1;
  ASSERT_TRUE(engine_->install(*found).ok());
  const Status deaf = engine_->start();
  ASSERT_FALSE(deaf.ok());
  EXPECT_NE(deaf.error().line().find("along y"), std::string::npos);
}

// The screen stands still: the loop's thread is well, and nobody watches it.
TEST_F(Engine, AnOwnerThatStandsStillLosesTheTableAfterASecond) {
  identified();
  device_->loud = 1.0;
  ASSERT_TRUE(engine_->start().ok());
  device_->play(1000);
  EXPECT_EQ(newest().axes[0].state, ActuatorState::On);
  ownerLives_ = false;
  device_->play(500);  // 0.8 s
  EXPECT_EQ(newest().axes[0].state, ActuatorState::On);
  device_->play(125);
  device_->largest = 0.0;
  const ActiveSnapshot told = newest();
  for (const ActiveAxis& axis : told.axes) {
    EXPECT_EQ(axis.state, ActuatorState::Off);
    EXPECT_EQ(axis.release, ActuatorRelease::LeaseOver);
  }
  EXPECT_EQ(device_->largest.load(), 0.0);
  ownerLives_ = true;
  device_->play(100);
  EXPECT_EQ(newest().axes[0].state, ActuatorState::Off);  // until it is started again
}

TEST_F(Engine, WhatIsIdentifiedAnewIsNoLongerTrustedAsItWas) {
  identified();
  ASSERT_TRUE(engine_->identify().ok());
  device_->play(100);
  device_->lose();
  device_->play(2);
  ASSERT_FALSE(engine_->fit().ok());
  const Status none = engine_->start();
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().line().find("no model"), std::string::npos) << none.error().line();
}

TEST_F(Engine, ABlockLostBetweenRecordAndModelIsNotForgotten) {
  device_->keepsDelay = false;
  identified();
  const auto found = engine_->fit();
  ASSERT_TRUE(found.ok());
  device_->lose();
  device_->play(2);
  const Status refused = engine_->install(*found);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("lost"), std::string::npos);
}

// Closed while it moves: by the ramp, and with rest at the end.
TEST_F(Engine, ClosedUnderControlItEndsAtRest) {
  identified();
  device_->loud = 1.0;
  ASSERT_TRUE(engine_->start().ok());
  device_->play(2000);
  EXPECT_GT(device_->largest.load(), 0.1);
  device_->flow();
  engine_->close();
  EXPECT_FALSE(engine_->isOpen());
  EXPECT_EQ(device_->lastLargest.load(), 0.0);
}

TEST_F(Engine, ALostBlockIsCountedAndTheOutputIsZero) {
  identified();
  device_->loud = 1.0;
  ASSERT_TRUE(engine_->start().ok());
  device_->play(1000);
  EXPECT_GT(device_->largest.load(), 0.1);
  device_->lose();
  device_->play(1);
  device_->play(2);
  device_->largest = 0.0;
  const ActiveSnapshot told = newest();
  EXPECT_EQ(told.underruns, 1U);
  EXPECT_EQ(told.axes[0].release, ActuatorRelease::DeviceFault);
  EXPECT_EQ(told.axes[0].state, ActuatorState::Off);
  EXPECT_EQ(device_->largest.load(), 0.0);
  EXPECT_TRUE(engine_->start().ok());  // by hand again, with the model it has
}

TEST_F(Engine, WhereALossMayMakeThePathLaterItIsIdentifiedAnew) {
  device_->keepsDelay = false;
  identified();
  ASSERT_TRUE(engine_->start().ok());
  device_->play(100);
  device_->lose();
  device_->play(2);
  const Status refused = engine_->start();
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("do not start together"), std::string::npos) << refused.error().line();
  ASSERT_TRUE(engine_->identify().ok());
  for (int i = 0; i < 40 && !engine_->recorded(); ++i) device_->play(100);
  const auto found = engine_->fit();
  ASSERT_TRUE(found.ok()) << found.error().line();
  ASSERT_TRUE(engine_->install(*found).ok());
  EXPECT_TRUE(engine_->start().ok());
}

TEST_F(Engine, ALostBlockEndsAnIdentification) {
  ASSERT_TRUE(engine_->open().ok());
  ASSERT_TRUE(engine_->identify().ok());
  device_->play(100);
  EXPECT_FALSE(engine_->identify().ok());  // one at a time
  device_->lose();
  device_->play(2);
  ASSERT_TRUE(engine_->recorded());
  const auto found = engine_->fit();
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().line().find("lost a block"), std::string::npos);
  const ActiveSnapshot told = newest();
  EXPECT_EQ(told.axes[0].state, ActuatorState::Off);
  EXPECT_EQ(told.axes[0].release, ActuatorRelease::DeviceFault);
}

TEST_F(Engine, ASweepIdentifiesTheSamePaths) {
  ActiveEngineOptions options;
  options.lines = {Hertz(339.0), Hertz(471.0)};
  for (safety::ActuatorLimits& l : options.limits) {
    l.amplitude = 10.0;
    l.slew = 1e6;
  }
  options.record = {.excitation = Excitation::Sweep, .duration = Seconds(8.0)};
  auto made = std::make_unique<PlayedDevice>(clock_);
  PlayedDevice* device = made.get();
  ActiveEngine engine(std::move(made), options, clock_);
  device->owner = [&] { engine.renew(); };
  ASSERT_TRUE(engine.open().ok());
  ASSERT_TRUE(engine.identify().ok());
  for (int i = 0; i < 80 && !engine.recorded(); ++i) device->play(100);
  const auto found = engine.fit();
  ASSERT_TRUE(found.ok()) << found.error().line();
  for (std::size_t a = 0; a < 2; ++a) {
    PathModel truth = kPath;
    truth.delay = kFrames;
    for (double f : {339.0, 471.0, 1000.0}) {
      EXPECT_LT(std::abs(phaseError((*found)[a].model, truth.response(Hertz(f), Hertz(kRate)), Hertz(f), Hertz(kRate))),
                0.2)
          << a << " " << f;
    }
  }
  device->flow();
}

}  // namespace
}  // namespace stillcut::active
