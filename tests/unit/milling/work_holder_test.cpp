#include "core/milling/simulation/work_holder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/milling/simulation/scenario.h"
#include "core/milling/simulation/simulated_cut.h"
#include "tests/support/temp_folder.h"

namespace stillcut::milling {
namespace {

constexpr double kRate = 20000.0;

// Largest stroke of a tone of this amplitude after its start.
double strokeOf(double amplitude, double frequency, bool& saturated, const WorkHolderSettings& settings = {}) {
  WorkHolderAxis axis(settings, Hertz(kRate));
  double largest = 0.0;
  saturated = false;
  for (int n = 0; n < 20000; ++n) {
    axis.step(amplitude * std::sin(kTwoPi * frequency * n / kRate));
    saturated = saturated || axis.saturated();
    if (n > 10000) largest = std::max(largest, std::abs(axis.stroke()));
  }
  return largest;
}

TEST(WorkHolder, FollowsSmallCommandsAndSaysWhereItEnds) {
  bool saturated = false;
  EXPECT_NEAR(strokeOf(1e-6, 50.0, saturated), 1e-6, 0.01e-6);
  EXPECT_FALSE(saturated);
  EXPECT_LE(strokeOf(9e-6, 50.0, saturated), 3e-6 * (1.0 + 1e-12));
  EXPECT_TRUE(saturated);
}

TEST(WorkHolder, TheAmplifiersCurrentLimitsFastLargeMoves) {
  WorkHolderSettings slow;
  slow.slew = 0.005;
  bool saturated = false;
  // A tone of 2.5 um at 1 kHz wants 0.016 m/s; a triangle at 0.005 m/s reaches 1.25 um.
  EXPECT_NEAR(strokeOf(2.5e-6, 1000.0, saturated, slow), 1.25e-6, 0.1e-6);
  EXPECT_TRUE(saturated);
}

TEST(WorkHolder, TheReconstructionFilterIsThreeDecibelsDownAtItsEdge) {
  WorkHolderSettings settings;
  settings.amplifier = Hertz(1e6);  // out of the way
  bool saturated = false;
  EXPECT_NEAR(strokeOf(1e-8, 4000.0, saturated, settings) / 1e-8, std::sqrt(0.5), 0.05);
}

TEST(WorkHolder, ItsForceBendsTheFlexureByTheStroke) {
  const WorkHolderSettings settings;
  WorkHolderAxis axis(settings, Hertz(kRate));
  double force = 0.0;
  for (int n = 0; n < 2000; ++n) force = axis.step(2e-6);
  EXPECT_NEAR(force / workHolderModes(settings)[0].stiffness, 2e-6, 1e-12);
}

TEST(WorkHolder, NonsenseIsRefused) {
  const auto refused = [](auto&& change) {
    WorkHolderSettings s;
    change(s);
    return !check(s, "file").ok();
  };
  EXPECT_TRUE(check(WorkHolderSettings{}, "file").ok());
  EXPECT_TRUE(refused([](WorkHolderSettings& s) { s.stroke = Metres(0.0); }));
  EXPECT_TRUE(refused([](WorkHolderSettings& s) { s.damping = 1.5; }));
  EXPECT_TRUE(refused([](WorkHolderSettings& s) { s.slew = std::nan(""); }));
}

Scenario ford() {
  return loadScenario(std::string(STILLCUT_SOURCE_DIR) + "/resources/scenarios/ford-unstable.toml").value();
}

TEST(WorkHolder, StandsInItsScenarioAndSurvivesSaving) {
  const Scenario s = ford();
  ASSERT_TRUE(s.workHolder.has_value());
  EXPECT_EQ(s.workHolder->stroke, Metres(3e-6));
  const record::TempFolder folder;
  const std::string path = folder / "work_holder.toml";
  ASSERT_TRUE(saveScenario(s, path).ok());
  EXPECT_EQ(loadScenario(path)->workHolder, s.workHolder);
}

// In air: the workpiece moves by what the table is told, below its flexure's frequency, along its own axis alone.
TEST(WorkHolder, MovesTheWorkpieceInThePlant) {
  Scenario s = ford();
  s.programme.depth = {};
  s.programme.randomForce = 0.0;
  s.programme.duration = Seconds(0.4);
  for (SensorSettings& sensor : s.sensors) sensor.noise = 0.0;
  SimulatedCut plant(s);
  SampleBlock block;
  block.allocate(static_cast<int>(s.sensors.size()), 1);
  const double w = kTwoPi * 100.0;
  // What of each reading keeps time with the command: -a sin(wt) and the part a quarter period off.
  std::array<std::array<double, 2>, 2> part{};
  const int from = 1000;
  int count = 0;
  for (int n = 0; plant.fill(block); ++n) {
    plant.setWorkHolder(1e-6 * std::sin(w * n / s.rate.value), 0.0);
    if (n < from) continue;
    ++count;
    for (std::size_t c = 0; c < 2; ++c) {
      const double a = block.channel(static_cast<int>(c))[0] / s.sensors[c].gain;
      part[c][0] += a * std::sin(w * n / s.rate.value);
      part[c][1] += a * std::cos(w * n / s.rate.value);
    }
  }
  const auto amplitude = [&](std::size_t c) { return 2.0 * std::hypot(part[c][0], part[c][1]) / count; };
  EXPECT_EQ(count % 50, 0);  // whole periods
  EXPECT_NEAR(amplitude(0) / (1e-6 * w * w), 1.0, 0.05);
  EXPECT_LT(part[0][0], 0.0);  // acceleration against displacement
  EXPECT_LT(amplitude(1), 0.01 * amplitude(0));
}

// What the table shakes in time with the spindle is forced vibration, however much of it there is beside the chatter.
TEST(WorkHolder, ItsMotionIsNotTakenForChatter) {
  Scenario s = ford();
  s.programme.duration = Seconds(4.0);
  constexpr double kStroke = 2.5e-6;
  const double spindle = kTwoPi * s.programme.speed.value / 60.0, w = 88.0 * spindle;  // 700 Hz, far from the modes
  struct Seen {
    double vibration, ratio;
  };
  const auto run = [&](double stroke) {
    SimulatedCut plant(s);
    SampleBlock block;
    block.allocate(static_cast<int>(s.sensors.size()), 1);
    for (int n = 0; plant.fill(block); ++n) {
      if (plant.time() < Seconds(3.0)) continue;  // it chatters by then
      const double command = stroke * std::sin(w * n / s.rate.value);
      plant.setWorkHolder(command, command);
    }
    EXPECT_TRUE(plant.truth().chattering());
    return Seen{plant.truth().vibration(), plant.truth().chatterRatio()};
  };
  const Seen alone = run(0.0), shaken = run(kStroke);
  const auto share = [w](double hz) { return w / (kTwoPi * hz); };
  const WorkHolderSettings& table = *s.workHolder;
  // Both axes; the flexure amplifies below its frequency, the amplifier lags.
  const double shake = kStroke * w * w / (1.0 - std::pow(share(table.flexure.value), 2.0)) /
                       std::hypot(1.0, share(table.amplifier.value));
  EXPECT_GT(shake, 10.0 * alone.vibration / alone.ratio);
  EXPECT_NEAR(shaken.ratio * shake / alone.vibration, 1.0, 0.1);
}

}  // namespace
}  // namespace stillcut::milling
