// The plant: determinism, blocks and stream time, overrides on a spindle, sensors, truth, no allocation.
#include "core/milling/simulation/simulated_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/path_counter.h"
#include "tests/unit/milling/small_cut.h"

namespace stillcut::milling {
namespace {

Instant at(double seconds) {
  return Instant{} + toDuration(Seconds(seconds));
}

// A short stable cut with two accelerometers.
Scenario shortCut() {
  Scenario s = smallCut("short", Rpm(9000.0), Seconds(1.0), 3e-4);
  s.programme.randomForce = 1e-3;
  s.programme.unevenness = 7e-5;
  for (const char* axis : {"x", "y"}) {
    SensorSettings c;
    c.name = c.axis = axis;
    c.gain = 0.01;
    c.noise = 1e-3;
    s.sensors.push_back(c);
  }
  return s;
}

std::vector<float> samples(const Scenario& s, std::uint64_t seed, bool override) {
  SimulatedCut cut(s, seed);
  SampleBlock block;
  block.allocate(static_cast<int>(s.sensors.size()), s.blockFrames);
  std::vector<float> all;
  int blocks = 0;
  while (cut.fill(block)) {
    for (int c = 0; c < block.channels; ++c) {
      const auto v = block.channel(c);
      all.insert(all.end(), v.begin(), v.end());
    }
    if (override && ++blocks == 20) cut.setOverrides(Ratio(0.9), Ratio(0.9), block.end());
  }
  return all;
}

TEST(SimulatedCut, SameScenarioSeedAndCommandsGiveTheSameSamples) {
  const Scenario s = shortCut();
  EXPECT_EQ(samples(s, 5, true), samples(s, 5, true));
  EXPECT_NE(samples(s, 5, true), samples(s, 6, true));
  EXPECT_NE(samples(s, 5, true), samples(s, 5, false));
}

TEST(SimulatedCut, BlocksCarryExactTimesSequenceAndEnd) {
  Scenario s = shortCut();
  s.programme.duration = Seconds(0.1);
  SimulatedCut cut(s);
  cut.setStart(at(100.0));
  SampleBlock block;
  block.allocate(2, 256);
  std::uint64_t frames = 0, sequence = 0;
  bool ended = false;
  while (cut.fill(block)) {
    EXPECT_EQ(block.sequence, sequence++);
    EXPECT_EQ(block.firstSample, at(100.0) + toDuration(Seconds(static_cast<double>(frames) / 25600.0)));
    EXPECT_FALSE(ended);
    ended = block.has(kBlockEnd);
    frames += static_cast<std::uint64_t>(block.frames);
  }
  EXPECT_TRUE(ended);
  EXPECT_EQ(frames, 2560U);
  EXPECT_FALSE(cut.machineState().programRunning);
}

TEST(SimulatedCut, FillingNeitherAllocatesNorLocks) {
  if (!test::PathCounter::works()) GTEST_SKIP() << "a sanitizer counts here";
  Scenario s = shortCut();
  s.model.tool.helix = 0.5;
  s.programme.immersion.segments = {{0.0, 0.5, 0.2, 0.9, RampShape::Linear}};
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(2, 256);
  const test::PathCounter counter;
  bool more = cut.fill(block);
  while (more) {
    cut.setOverrides(Ratio(0.8 + 0.001 * static_cast<double>(block.sequence)), Ratio(0.9), block.end());
    more = cut.fill(block) && cut.machineState().valid;
  }
  EXPECT_TRUE(counter.counts().none());
}

// The override waits out its delay, then spindle and feed follow; the programmed values stay what they were.
TEST(SimulatedCut, OverrideActsAfterItsDelayOnSpindleAndFeed) {
  const Scenario s = shortCut();
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(2, 64);
  double leftAt = 0.0;
  bool commanded = false;
  while (cut.fill(block)) {
    const MachineState m = cut.machineState();
    const double t = sinceEpoch(block.end()).value;
    if (!commanded && t >= 0.2) {
      cut.setOverrides(Ratio(0.9), Ratio(0.8), block.end());
      commanded = true;
    }
    if (leftAt == 0.0 && m.speedOverride.value < 1.0) leftAt = t;
  }
  EXPECT_GE(leftAt, 0.2 + 0.040);
  EXPECT_LE(leftAt, 0.2 + 0.070 + 2 * 64.0 / 25600.0);
  const MachineState end = cut.machineState();
  EXPECT_NEAR(end.programmedSpeed.value, 9000.0, 1e-9);
  EXPECT_NEAR(end.actualSpeed.value, 8100.0, 10.0);
  EXPECT_NEAR(toMmPerMin(end.actualFeed), 0.8 * 0.1 * 3 * 9000.0, 1.0);
  EXPECT_TRUE(end.atSpeed);
}

TEST(SimulatedCut, DisabledOverridesAndKnobs) {
  SimulatedCut cut(shortCut());
  SampleBlock block;
  block.allocate(2, 256);
  cut.setOperatorOverrides(Ratio(0.8), Ratio(0.5));
  cut.setOverrides(Ratio(0.9), Ratio(1.0), Instant{});
  for (int i = 0; i < 40; ++i) cut.fill(block);
  EXPECT_NEAR(cut.machineState().speedOverride.value, 0.72, 1e-9);
  EXPECT_NEAR(cut.machineState().feedOverride.value, 0.5, 1e-9);
  cut.setOverridesEnabled(false);
  EXPECT_EQ(cut.machineState().speedOverride.value, 1.0);
  EXPECT_FALSE(cut.machineState().overridesEnabled);
  cut.setFeedHold(true);
  for (int i = 0; i < 40; ++i) cut.fill(block);
  EXPECT_TRUE(cut.machineState().feedHold);
  EXPECT_NEAR(cut.machineState().actualFeed.value, 0.0, 1e-4);
}

// Every quantity in its own unit: the tooth-passing line of displacement, velocity and acceleration differ by omega.
TEST(SimulatedCut, SensorsAgreeWithEachOther) {
  Scenario s = shortCut();
  s.programme.randomForce = s.programme.unevenness = 0.0;
  s.drive.inertia = 1e3;
  s.drive.torqueLimit = 1e6;
  s.sensors.clear();
  for (SensorQuantity q : {SensorQuantity::Displacement, SensorQuantity::Velocity, SensorQuantity::Acceleration,
                           SensorQuantity::SpindleSpeed, SensorQuantity::Current, SensorQuantity::Force}) {
    SensorSettings c;
    c.name = std::string(name(q));
    c.quantity = q;
    c.axis = "x";
    s.sensors.push_back(c);
  }
  SimulatedCut cut(s);
  SampleBlock block;
  const int frames = 5120;  // 30 revolutions, 90 tooth passings
  block.allocate(6, frames);
  for (int i = 0; i < 3; ++i) cut.fill(block);
  const auto line = [&](int channel) {
    double c = 0.0, sn = 0.0;
    for (int i = 0; i < frames; ++i) {
      const double angle = kTwoPi * 450.0 * i / 25600.0;
      const auto v = static_cast<double>(block.channel(channel)[static_cast<std::size_t>(i)]);
      c += v * std::cos(angle);
      sn += v * std::sin(angle);
    }
    return 2.0 * std::hypot(c, sn) / frames;
  };
  const double w = kTwoPi * 450.0;
  EXPECT_NEAR(line(1) / line(0), w, 1e-3 * w);
  EXPECT_NEAR(line(2) / line(1), w, 1e-3 * w);
  EXPECT_NEAR(static_cast<double>(block.channel(3)[100]), 9000.0, 5.0);
  // The force moves the tool as its receptance says.
  const double k = 8e6, r = 450.0 / 900.0;
  EXPECT_NEAR(line(0), line(5) / (k * std::hypot(1.0 - r * r, 2.0 * 0.03 * r)), 0.01 * line(0));
}

TEST(SimulatedCut, SensorsClipQuantiseAndSaySo) {
  Scenario s = shortCut();
  s.sensors[0].fullScale = 0.5;
  s.sensors[0].step = 0.01;
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(2, 4096);
  cut.fill(block);
  EXPECT_TRUE(block.has(kBlockClipped));
  for (float v : block.channel(0)) {
    EXPECT_LE(std::abs(v), 0.5F);
    const double steps = static_cast<double>(v) / 0.01;
    EXPECT_NEAR(steps, std::round(steps), 1e-4);
  }
}

TEST(SimulatedCut, MicrophoneHearsLaterAndTheRoomAnswers) {
  Scenario s = shortCut();
  s.programme.randomForce = s.programme.unevenness = 0.0;
  s.sensors.resize(1);
  s.sensors[0] = SensorSettings{};
  s.sensors[0].name = "mic";
  s.sensors[0].quantity = SensorQuantity::Sound;
  s.sensors[0].echoes = {{Seconds(0.01), 1.0}, {Seconds(0.05), 0.5}};
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(1, 1024);
  cut.fill(block);
  const auto v = block.channel(0);
  const auto loud = std::find_if(v.begin(), v.end(), [](float x) { return std::abs(x) > 1e-6F; });
  EXPECT_NEAR(static_cast<double>(loud - v.begin()) / 25600.0, 0.01, 0.002);
}

TEST(SimulatedCut, DeepCutChattersAndTheMarkedPathGrows) {
  Scenario s = shortCut();
  s.programme.speed = Rpm(7500.0);  // 2.4 waves between teeth: far from a pocket
  s.programme.depth.segments = {{0.0, 0.3, 3e-4, 3e-4, RampShape::Linear}, {0.3, 0.5, 3e-4, 6e-3, RampShape::Linear}};
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(2, 256);
  while (cut.fill(block)) {
  }
  EXPECT_GT(cut.truth().onset().at20, 0.3);
  EXPECT_LT(cut.truth().onset().at20, 0.6);
  EXPECT_NEAR(cut.truth().chatterFrequency().value, 930.0, 60.0);
  EXPECT_GT(cut.truth().marked().value, 0.01);
}

}  // namespace
}  // namespace stillcut::milling
