#include "tests/support/known_cuts/tools.h"

#include <array>
#include <cmath>
#include <numbers>

namespace stillcut::bench {
namespace {

struct Base {
  const char* name;
  int teeth;
  double rpm, immersion;
  milling::MillingDirection side;
  double diameter, feedPerTooth;
  std::array<double, 2> frequency, damping, stiffness;
  double tangential, radial, rate;
};

constexpr std::array<Base, 4> kBases{{
    {"Z2",
     2,
     11000.0,
     0.5,
     milling::MillingDirection::Down,
     0.012,
     1e-4,
     {922.0, 980.0},
     {0.011, 0.012},
     {1.34e6, 1.52e6},
     6e8,
     2e8,
     25600.0},
    {"Z3",
     3,
     6300.0,
     0.5,
     milling::MillingDirection::Up,
     0.012,
     1e-4,
     {780.0, 822.0},
     {0.03, 0.028},
     {9.0e6, 9.4e6},
     7e8,
     2.1e8,
     25600.0},
    {"Z4",
     4,
     8500.0,
     0.7,
     milling::MillingDirection::Down,
     0.012,
     8e-5,
     {922.0, 980.0},
     {0.02, 0.02},
     {8e6, 9e6},
     6e8,
     2e8,
     25600.0},
    {"F4",
     4,
     800.0,
     0.5,
     milling::MillingDirection::Down,
     0.05,
     1e-4,
     {193.0, 208.0},
     {0.035, 0.03},
     {2.2e7, 2.4e7},
     1.9e9,
     8e8,
     4096.0},
}};

milling::ScheduleSegment segment(double from, double to, double a, double b) {
  return {from, to, a, b, a == b ? milling::RampShape::Linear : milling::RampShape::Smoothstep};
}

}  // namespace

std::string toolName(ToolKind kind) {
  return kBases[static_cast<std::size_t>(kind)].name;
}

milling::Scenario scattered(ToolKind kind, std::uint64_t seed) {
  const Base& b = kBases[static_cast<std::size_t>(kind)];
  milling::NoiseSource random(seed * 131 + static_cast<std::uint64_t>(kind));
  const auto within = [&random](double share) { return 1.0 + share * (2.0 * random.uniform() - 1.0); };
  milling::Scenario s;
  s.name = b.name;
  s.seed = seed;
  s.rate = Hertz(b.rate);
  s.blockFrames = 64;
  s.programme.speed = Rpm(b.rpm * within(0.06));
  s.programme.feedPerTooth = Metres(b.feedPerTooth);
  s.programme.unevenness = 7.4e-6;  // 0.2 % of the force up to the 70 kHz of the simulation
  if (kind == ToolKind::FaceMill) {
    // The default is a high-speed spindle, whose speed such teeth would shake by 4 % of itself.
    s.drive.inertia = 0.05;
    s.drive.torqueLimit = 100.0;
  }
  s.model.tool.teeth = b.teeth;
  s.model.tool.diameter = Metres(b.diameter);
  const double runout = b.feedPerTooth / 6.0 * random.uniform();
  const double phase = kTwoPi * random.uniform();
  for (int j = 0; j < b.teeth; ++j) {
    s.model.tool.runout.emplace_back(runout * std::cos(kTwoPi * j / b.teeth + phase));
  }
  s.model.material = {b.tangential, b.radial, 0.0, 0.0, 1.0, 0.0};
  s.model.engagement = {b.immersion, b.side};
  const double mode = within(0.05);
  for (std::size_t i = 0; i < 2; ++i) {
    s.model.modes.push_back({Hertz(b.frequency[i] * mode * within(0.01)),
                             b.damping[i] * within(0.25),
                             b.stiffness[i],
                             {i == 0 ? 1.0 : 0.0, i == 0 ? 0.0 : 1.0}});
  }
  for (const char* axis : {"x", "y"}) {
    milling::SensorSettings sensor;
    sensor.name = sensor.axis = axis;
    sensor.gain = 0.02;
    s.sensors.push_back(sensor);
  }
  return s;
}

std::optional<milling::StabilityLimit> limitOf(const milling::Scenario& scenario) {
  const auto lobes = milling::ExactLobes::make(scenario.model, scenario.name);
  if (!lobes) return std::nullopt;
  milling::LimitOptions options;
  options.maxAxialDepth = Metres(0.03);
  options.firstOnly = true;
  const auto limits = lobes->limits(scenario.programme.speed, options);
  if (!limits || !limits->hasLimit()) return std::nullopt;
  return limits->crossings.front();
}

void planDepth(milling::Scenario& scenario, const DepthPlan& plan, double before, double after) {
  scenario.programme.depth.segments = {
      segment(0.0, plan.entry, 0.0, 0.0), segment(plan.entry, plan.entered, 0.0, before),
      segment(plan.entered, plan.rise, before, before), segment(plan.rise, plan.risen, before, after)};
  scenario.programme.duration = Seconds(plan.end);
}

}  // namespace stillcut::bench
