#include "tests/support/known_cuts/sensor_kinds.h"

#include <array>

#include "tests/support/known_cuts/tools.h"

namespace stillcut::bench {
namespace {

using milling::Scenario;
using Orders = std::vector<SimulationOrder>;

constexpr std::array<ToolKind, 3> kTools{ToolKind::TwoFlute, ToolKind::FourFlute, ToolKind::FaceMill};
constexpr DepthPlan kPlan{};
constexpr DepthPlan kSlowPlan{.entry = 0.5, .entered = 0.7, .rise = 3.0, .risen = 5.0, .end = 9.0};

// What hears the cut, how fast it is read, and its noise as a share of the stable vibration; where the noise is the
// sensor's own, in its own unit, it stands in the sensor.
struct Ear {
  milling::SensorSettings sensor;
  double rate = 0.0, slowRate = 0.0;  // Hz; of the end mills, of the face mill
  double noise = 0.0;
  AlarmRule rule = AlarmRule::Weak;  // of the torque and its integrals, in which nothing amplifies the chatter
};

// A metre away in a cabin that answers, and a spindle that hums: a tenth of the cut.
Ear microphone() {
  Ear e{{}, 25600.0, 4096.0, 0.1, AlarmRule::Sharp};
  e.sensor.quantity = SensorQuantity::Sound;
  e.sensor.echoes = {{Seconds(0.003), 1.0}, {Seconds(0.007), 0.4}, {Seconds(0.015), 0.25}};
  return e;
}

// A table dynamometer, filtered below its own resonance, along one axis.
Ear force() {
  Ear e{{}, 10000.0, 4096.0, 0.02};
  e.sensor.quantity = SensorQuantity::Force;
  e.sensor.axis = "x";
  e.sensor.bandwidth = Hertz(1000.0);
  return e;
}

// An encoder of 2048 lines in the motor, and what its noise leaves of 14 bits between them.
Ear spindleSpeed() {
  Ear e{{}, 10000.0, 2000.0, 0.0};
  e.sensor.quantity = SensorQuantity::SpindleSpeed;
  e.sensor.counts = 1 << 24;
  return e;
}

// The drive's own current, 12 bits of +-25 A.
Ear motorCurrent() {
  Ear e{{}, 10000.0, 2000.0, 0.0};
  e.sensor.quantity = SensorQuantity::Current;
  e.sensor.noise = 0.01;
  e.sensor.step = 50.0 / 4096.0;
  return e;
}

void listen(Scenario& s, const Ear& ear, ToolKind tool) {
  s.rate = Hertz(tool == ToolKind::FaceMill ? ear.slowRate : ear.rate);
  s.sensors.insert(s.sensors.begin(), ear.sensor);
  s.sensors.front().name = std::string(name(ear.sensor.quantity));
  s.drive.bandwidth = Hertz(100.0);
  s.drive.torqueLoop = Hertz(1000.0);
}

Orders heardBy(const Ear& ear, const char* family, int seeds) {
  Orders orders;
  const auto add = [&](const Scenario& s, const char* kind, AlarmRule rule, const DepthPlan& plan) {
    SimulationOrder o;
    o.family = family;
    o.name = s.name + "-" + std::to_string(s.seed) + "-" + kind;
    o.scenario = s;
    o.rule = rule;
    o.quietFrom = plan.entered;
    o.quietTo = plan.rise;
    o.noise = ear.noise;
    o.heard = 1;
    orders.push_back(o);
  };
  for (const ToolKind tool : kTools) {
    const bool slow = tool == ToolKind::FaceMill;
    const DepthPlan& plan = slow ? kSlowPlan : kPlan;
    for (int seed = 1; seed <= seeds; ++seed) {
      Scenario s = scattered(tool, 1500 + static_cast<std::uint64_t>(seed));
      listen(s, ear, tool);
      const auto limit = limitOf(s);
      if (!limit) continue;
      const double depth = limit->depth.value;
      planDepth(s, plan, 0.5 * depth, 1.3 * depth);
      add(s, "hopf", ear.rule == AlarmRule::Sharp && slow ? AlarmRule::Slow : ear.rule, plan);
      planDepth(s, plan, 0.5 * depth, 0.8 * depth);
      add(s, "stable", AlarmRule::Silent, plan);
      planDepth(s, plan, 0.5 * depth, 0.5 * depth);
      s.programme.entry = milling::Passage{milling::Along::Time, 2.0 * plan.entry};
      s.programme.exit = milling::Passage{milling::Along::Time, 0.85 * plan.end};
      s.programme.depth.segments = {{0.0, 0.1, 0.5 * depth, 0.5 * depth}};
      DepthPlan within = plan;
      within.entered = 0.5 * plan.end;
      within.rise = 0.7 * plan.end;
      add(s, "entry-exit", AlarmRule::Silent, within);
    }
  }
  return orders;
}

Orders byMicrophone(int seeds) {
  return heardBy(microphone(), "sensor: microphone", seeds);
}
Orders byForce(int seeds) {
  return heardBy(force(), "sensor: force", seeds);
}
Orders bySpeed(int seeds) {
  return heardBy(spindleSpeed(), "sensor: spindle speed", seeds);
}
Orders byCurrent(int seeds) {
  return heardBy(motorCurrent(), "sensor: motor current", seeds);
}

constexpr std::array<CutFamily, 4> kFamilies{{
    {"sensor: microphone", "the sound of both axes, echoes, a tenth of noise", byMicrophone},
    {"sensor: force", "one axis up to 1 kHz", byForce},
    {"sensor: spindle speed", "the torque through the inertia, in steps of an encoder", bySpeed},
    {"sensor: motor current", "the torque through inertia and loops", byCurrent},
}};

}  // namespace

std::span<const CutFamily> sensorKindFamilies() {
  return kFamilies;
}

}  // namespace stillcut::bench
