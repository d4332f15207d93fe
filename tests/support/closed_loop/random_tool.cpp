#include "tests/support/closed_loop/random_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include "app/compose/known_lobes.h"
#include "core/milling/stability/exact_lobes.h"
#include "tests/support/dominant_multiplier.h"

namespace stillcut::test {
namespace {

// Same numbers on every standard library: the engine is specified, its distributions are not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }
  double ratio(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }
  int whole(int low, int high) { return low + static_cast<int>(uniform(0.0, 1.0) * (high - low + 1)); }

 private:
  std::mt19937_64 engine_;
};

constexpr double kFastest = 24000.0;  // rev/min, a milling spindle's
constexpr double kStable = 0.6;       // of the limit, while the detectors learn
constexpr double kDeepFrom = 1.0, kDeepAt = 1.4, kSeconds = 6.5;

milling::CutModel randomModel(Dice& dice) {
  milling::CutModel m;
  const int perAxis = dice.whole(1, 2);
  const double first = dice.ratio(350.0, 1400.0);
  const double stiffness = dice.ratio(5e6, 3e7);
  for (int axis = 0; axis < 2; ++axis) {
    double frequency = first * (axis == 0 ? 1.0 : dice.uniform(0.95, 1.12));
    double k = stiffness * (axis == 0 ? 1.0 : dice.uniform(0.8, 1.3));
    for (int i = 0; i < perAxis; ++i) {
      milling::Mode mode;
      mode.frequency = Hertz(frequency);
      mode.damping = dice.uniform(0.01, 0.05);
      mode.stiffness = k;
      mode.direction = axis == 0 ? std::array{1.0, 0.0} : std::array{0.0, 1.0};
      m.modes.push_back(mode);
      frequency *= dice.uniform(1.35, 2.2);
      k *= dice.uniform(1.5, 4.0);
    }
  }
  m.tool.teeth = dice.whole(2, 6);
  m.tool.diameter = Metres(dice.ratio(0.008, 0.025));
  for (int i = 0; i < m.tool.teeth; ++i) m.tool.runout.emplace_back(dice.uniform(-4e-6, 4e-6));
  const bool steel = dice.whole(0, 2) == 0;
  m.material.tangential = steel ? dice.uniform(1.8e9, 2.4e9) : dice.uniform(6e8, 9e8);
  m.material.radial = m.material.tangential * dice.uniform(0.25, 0.5);
  m.engagement.radialImmersion = dice.uniform(0.1, 1.0);
  m.engagement.side = dice.whole(0, 1) == 0 ? milling::MillingDirection::Up : milling::MillingDirection::Down;
  return m;
}

milling::SensorSettings accelerometer(const char* axis, std::size_t modes) {
  milling::SensorSettings s;
  s.name = s.axis = axis;
  s.quantity = SensorQuantity::Acceleration;
  s.place.assign(modes, 0.02);
  s.gain = 0.0102;
  s.bandwidth = Hertz(4500.0);
  s.noise = 5e-4;
  s.fullScale = 10.0;
  s.step = 1.2e-6;
  return s;
}

milling::Scenario around(const milling::CutModel& model, Rpm speed, double depth, double stable, Dice& dice) {
  milling::Scenario s;
  s.machine = "Simulated mill";
  s.model = model;
  s.rate = Hertz(10240.0);
  s.blockFrames = 128;
  s.seed = static_cast<std::uint64_t>(dice.whole(1, 1'000'000));
  s.grantsAuto = true;
  s.drive.inertia = 0.008;
  s.drive.torqueLimit = 60.0;
  s.drive.acceleration = 20000.0;
  milling::Programme& p = s.programme;
  p.speed = speed;
  p.feedPerTooth = Metres(dice.uniform(0.05e-3, 0.12e-3));
  p.duration = Seconds(kSeconds);
  p.depth.segments = {{0.0, kDeepFrom, stable, stable, milling::RampShape::Linear},
                      {kDeepFrom, kDeepAt, stable, depth, milling::RampShape::Smoothstep}};
  p.entry = milling::Passage{milling::Along::Time, 0.05};
  p.randomForce = 2e-3;
  p.unevenness = 1.85e-5;  // 0.5 % of the force up to the 70 kHz of the simulation
  s.sensors = {accelerometer("x", model.modes.size()), accelerometer("y", model.modes.size())};
  return s;
}

// Empty: this draw is no cut that chatters at its programmed speed.
std::optional<RandomTool> draw(Dice& dice, const std::string& name) {
  const milling::CutModel model = randomModel(dice);
  RandomTool tool;
  tool.waves = dice.uniform(1.1, 4.0);
  const Rpm speed = toRpm(model.modes.front().frequency) / (tool.waves * model.tool.teeth);
  tool.timesLimit = dice.uniform(1.15, 2.0);
  if (speed.value > kFastest) return std::nullopt;
  const auto lobes = milling::ExactLobes::make(model, name);
  if (!lobes) throw std::runtime_error(lobes.error().line());
  milling::LimitOptions options;
  options.maxAxialDepth = Metres(0.05);
  options.firstOnly = true;
  options.frequencies = false;
  const auto limits = lobes->limits(speed, options);
  if (!limits || !limits->hasLimit()) return std::nullopt;
  const double limit = limits->crossings.front().depth.value;
  const double depth = tool.timesLimit * limit;
  // Above a limit there may be an island of stability: then it is another cut.
  const auto multiplier = dominantMultiplier(*lobes, speed, Metres(depth));
  if (!multiplier || std::abs(*multiplier) <= 1.0) return std::nullopt;
  tool.scenario = around(model, speed, depth, kStable * limit, dice);
  tool.scenario.name = name;
  if (!milling::check(tool.scenario, name)) return std::nullopt;
  const auto known = app::stableSpeeds(tool.scenario);
  if (!known) return std::nullopt;
  tool.known = *known;
  for (const StableSpeeds::Range& r : known->ranges) {
    tool.widest = std::max(tool.widest, (r.to - r.from) / r.to);
  }
  tool.scenario.expect = known->ranges.empty() ? milling::Expectation::NoStableSpeed : milling::Expectation::Stable;
  return tool;
}

}  // namespace

bool stableByLobes(const RandomTool& tool, Rpm speed) {
  const auto lobes = milling::ExactLobes::make(tool.scenario.model, tool.scenario.name);
  if (!lobes) throw std::runtime_error(lobes.error().line());
  const auto multiplier = dominantMultiplier(*lobes, speed, Metres(tool.scenario.programme.depth.highest(0.0)));
  return multiplier && std::abs(*multiplier) < 1.0;
}

RandomTool randomTool(std::uint64_t number) {
  Dice dice(number * 7919 + 17);
  const std::string name = "tool-" + std::to_string(number);
  for (int tries = 0; tries < 200; ++tries) {
    if (auto tool = draw(dice, name)) return *tool;
  }
  throw std::runtime_error(name + ": no cut could be drawn");
}

}  // namespace stillcut::test
