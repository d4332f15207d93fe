// The active work-holder switched on in air, long before the tool enters: as a machinist does it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "app/compose/active_setup.h"
#include "core/active/path_recorder.h"
#include "core/active/simulated_duplex.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::app {
namespace {

class Table {
 public:
  using Change = std::function<void(milling::Scenario&)>;
  explicit Table(const char* cut, const Change& change = {}) {
    auto scenario = milling::loadScenario(std::string(STILLCUT_SOURCE_DIR "/resources/scenarios/") + cut + ".toml");
    EXPECT_TRUE(scenario.ok());
    if (change) change(*scenario);
    const milling::Scenario& plant = *scenario;
    active::ActiveEngineOptions options = activeOptions(*plant.workHolder, {});
    options.record.duration = Seconds(2.0);
    device_ = std::make_unique<active::SimulatedDuplex>(plant, 1, plant.seed);
    EXPECT_TRUE(device_->open().ok());
    active::PathRecorder recorder;
    EXPECT_TRUE(recorder.prepare(options.record, options.limits, plant.rate).ok());
    while (!recorder.over()) {
      recorder.begin();
      frame([&](const active::AxisPair& e) { return recorder.step(e); });
    }
    active::PathPairFound paths;
    for (std::size_t a = 0; a < kActiveAxes; ++a) {
      auto found = active::identifyPath(recorder.output(a), recorder.reading(a), plant.rate, options.path, "path");
      EXPECT_TRUE(found.ok());
      paths[a] = std::move(found).value();
    }
    EXPECT_TRUE(loop.prepare(active::axisOptions(options, paths), plant.rate).ok());
    rate_ = plant.rate.value;
  }
  void run(double seconds) {
    const auto frames = std::llround(seconds * rate_);
    for (long n = 0; n < frames; ++n) {
      loop.begin();
      frame([&](const active::AxisPair& e) { return loop.step(e); });
    }
  }
  void enter() { device_->cut(true); }
  std::array<ActiveAxis, kActiveAxes> told() const {
    std::array<ActiveAxis, kActiveAxes> axes;
    loop.tell(axes);
    return axes;
  }

  active::ActiveLoop loop;

 private:
  template <class Step>
  void frame(Step step) {
    (void)device_->read(in_);
    const active::CommandPair out = step(active::AxisPair{in_[0], in_[1]});
    (void)device_->write(out);
  }
  std::unique_ptr<active::SimulatedDuplex> device_;
  std::array<double, 2> in_{};
  double rate_ = 1.0;
};

constexpr double kCut = 6.0;  // [s], two of them to the full depth

std::array<ActiveAxis, kActiveAxes> leftAlone() {
  Table alone("ford-unstable");
  alone.enter();
  alone.run(kCut);
  return alone.told();
}

// In air the loop learns what the sensor's noise has of lines; that is no reason to leave the cut to itself.
TEST(ActiveEntry, ACutThatBeginsAfterAWhileInAirIsHeld) {
  const auto chatter = leftAlone();
  for (const double air : {0.0, 1.0, 5.0, 10.0, 30.0}) {
    Table table("ford-unstable");
    table.loop.engage();
    table.run(air);
    table.enter();
    table.run(kCut);
    const auto held = table.told();
    for (std::size_t a = 0; a < kActiveAxes; ++a) {
      EXPECT_EQ(held[a].state, ActuatorState::On) << air << " s in air: " << actuatorReleaseText(held[a].release);
      EXPECT_LT(held[a].errorRms, 0.1 * chatter[a].errorRms) << air << " s in air";
    }
  }
}

// The tool enters at once: the vibration grows faster than the loop learns, and for a while the output with it.
TEST(ActiveEntry, ACutThatBeginsAtOnceIsHeld) {
  const auto chatter = leftAlone();
  for (const double entry : {0.01, 0.03, 0.1}) {
    Table table("ford-unstable", [entry](milling::Scenario& s) {
      s.programme.depth.segments = {{0.0, 2.0, 0.0, 0.0}, {2.0, 2.0 + entry, 0.0, 3e-3}};
    });
    table.loop.engage();
    table.enter();
    table.run(kCut);
    const auto held = table.told();
    for (std::size_t a = 0; a < kActiveAxes; ++a) {
      EXPECT_EQ(held[a].state, ActuatorState::On) << entry << " s: " << actuatorReleaseText(held[a].release);
      EXPECT_LT(held[a].errorRms, 0.1 * chatter[a].errorRms) << entry << " s";
    }
  }
}

}  // namespace
}  // namespace stillcut::app
