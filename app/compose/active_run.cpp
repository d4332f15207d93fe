#include "app/compose/active_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "core/dsp/spectrum.h"

namespace stillcut::app {
namespace {

constexpr std::array<const char*, 2> kAxes{"x", "y"};

// Which channel of the scenario hears an axis, and its SI units per device unit.
struct Ear {
  int channel = 0;
  double scale = 1.0;
};

Result<std::array<Ear, 2>> findEars(const milling::Scenario& scenario) {
  std::array<Ear, 2> ears;
  for (std::size_t a = 0; a < 2; ++a) {
    const auto& all = scenario.sensors;
    const auto found = std::find_if(all.begin(), all.end(), [&](const milling::SensorSettings& s) {
      return s.quantity == SensorQuantity::Acceleration && s.axis == kAxes[a];
    });
    if (found == all.end()) {
      return Error{scenario.name, std::string("no accelerometer along ") + kAxes[a],
                   "the active table needs one per axis"};
    }
    ears[a] = {static_cast<int>(found - all.begin()), 1.0 / found->gain};
  }
  return ears;
}

// One frame of the plant: what the two accelerometers read [m/s^2].
class Frames {
 public:
  Frames(const milling::Scenario& scenario, std::uint64_t seed, const std::array<Ear, 2>& ears)
      : plant_(scenario, seed), ears_(ears) {
    block_.allocate(static_cast<int>(scenario.sensors.size()), 1);
  }
  bool next(std::array<double, 2>& errors) {
    if (!plant_.fill(block_)) return false;
    for (std::size_t a = 0; a < 2; ++a) errors[a] = ears_[a].scale * block_.channel(ears_[a].channel)[0];
    return true;
  }
  milling::SimulatedCut& plant() { return plant_; }
  const SampleBlock& block() const { return block_; }

 private:
  milling::SimulatedCut plant_;
  std::array<Ear, 2> ears_;
  SampleBlock block_;
};

Result<std::array<active::IdentifiedPath, 2>> identify(const milling::Scenario& cut, const ActiveOptions& options,
                                                       const std::array<Ear, 2>& ears) {
  milling::Scenario air = cut;
  air.programme.depth = {};
  air.programme.duration = options.identifyTime;
  Frames frames(air, options.seed, ears);
  std::mt19937_64 random(options.seed != 0 ? options.seed : cut.seed);
  std::normal_distribution<double> noise(0.0, options.identifyRms);
  std::array<std::vector<double>, 2> written, read;
  std::array<double, 2> errors{};
  while (frames.next(errors)) {
    const std::array<double, 2> push{noise(random), noise(random)};
    frames.plant().setWorkHolder(push[0], push[1]);
    for (std::size_t a = 0; a < 2; ++a) {
      written[a].push_back(push[a]);
      read[a].push_back(-errors[a]);  // e = d - s * y: the path that is taken off
    }
  }
  std::array<active::IdentifiedPath, 2> paths;
  for (std::size_t a = 0; a < 2; ++a) {
    auto found = active::identifyPath(written[a], read[a], cut.rate, options.path,
                                      cut.name + ": path to the accelerometer along " + kAxes[a]);
    if (!found) return found.error();
    paths[a] = std::move(found).value();
  }
  return paths;
}

struct Axis {
  active::FxlmsController controller;
  safety::ActuatorGate gate;
  double releasedAt = 0.0;
};

struct Course {
  std::array<std::vector<double>, 2> errors;
  double tip = 0.0;  // mean square of the tip's acceleration over the last second
  bool chatter = false;
  double chatterHz = 0.0;
};

Course cut(Frames& frames, const milling::Scenario& scenario, std::array<std::unique_ptr<Axis>, 2>* axes,
           const ActiveOptions& options) {
  Course course;
  std::array<double, 2> errors{};
  const double last = scenario.programme.duration.value - 1.0;
  double frames_ = 0.0;
  while (frames.next(errors)) {
    for (std::size_t a = 0; a < 2; ++a) course.errors[a].push_back(errors[a]);
    milling::SimulatedCut& plant = frames.plant();
    if (axes != nullptr) {
      std::array<double, 2> stroke{};
      for (std::size_t a = 0; a < 2; ++a) {
        Axis& axis = *(*axes)[a];
        axis.gate.renew();
        const double wanted = axis.controller.process(errors[a]);
        stroke[a] = axis.gate.pass(wanted, errors[a], axis.controller.disturbance()).value();
        axis.controller.written(stroke[a]);
        if (axis.releasedAt == 0.0 && axis.gate.state() == safety::ActuatorState::RampOut) {
          axis.releasedAt = plant.time().value;
        }
      }
      plant.setWorkHolder(stroke[0], stroke[1]);
      if (options.observe) options.observe(frames.block(), plant);
    }
    if (plant.time().value < last) continue;
    ++frames_;
    for (const double e : errors) course.tip += e * e;
    course.chatter = course.chatter || plant.truth().chattering();
  }
  course.tip /= std::max(1.0, frames_);
  course.chatterHz = frames.plant().truth().chatterFrequency().value;
  return course;
}

// Power within 5 Hz of a line over the last second.
double powerAt(const std::vector<double>& x, double frequency, Hertz rate) {
  const int length = static_cast<int>(rate.value);
  if (static_cast<int>(x.size()) < length) return 0.0;
  dsp::Spectrum spectrum;
  spectrum.prepare(length, rate, dsp::WindowKind::Hann);
  spectrum.transform(std::span(x).last(static_cast<std::size_t>(length)));
  double sum = 0.0;
  for (int k = 0; k < spectrum.bins(); ++k) {
    if (std::abs(k * spectrum.binWidth() - frequency) <= 5.0) sum += spectrum.density(k);
  }
  return sum;
}

// Lines worth telling: chatter, the modes an actuator of this bandwidth is for, tooth passing and spindle.
std::vector<double> linesOf(const milling::Scenario& s, double chatterHz, const char* axis) {
  std::vector<double> lines;
  if (chatterHz > 0.0) lines.push_back(chatterHz);
  for (const milling::Mode& m : s.model.modes) {
    const bool along = std::string(axis) == "x" ? m.direction[0] != 0.0 : m.direction[1] != 0.0;
    if (along && m.frequency.value > 250.0) lines.push_back(m.frequency.value);
  }
  for (const double fixed : {339.0, 1000.0, 1024.0}) {
    if (std::find(lines.begin(), lines.end(), fixed) == lines.end()) lines.push_back(fixed);
  }
  const double spindle = s.programme.speed.value / 60.0;
  lines.push_back(spindle);
  lines.push_back(spindle * s.model.tool.teeth);
  std::sort(lines.begin(), lines.end());
  return lines;
}

}  // namespace

Result<ActiveResult> runActive(const milling::Scenario& scenario, const ActiveOptions& options) {
  if (!scenario.workHolder) {
    return Error{scenario.name, "has no active work-holder", "strategy 'active' needs a table [work_holder]"};
  }
  const auto ears = findEars(scenario);
  if (!ears) return ears.error();
  auto paths = identify(scenario, options, *ears);
  if (!paths) return paths.error();

  std::array<std::unique_ptr<Axis>, 2> axes;
  active::FxlmsOptions controller = options.controller;
  controller.emphasis.lines = scenario.workHolder->quieten;
  safety::ActuatorLimits limits;
  limits.amplitude = scenario.workHolder->stroke.value;
  limits.slew = scenario.workHolder->slew;
  for (std::size_t a = 0; a < 2; ++a) {
    axes[a] = std::make_unique<Axis>();
    axes[a]->controller.prepare(controller, (*paths)[a].model, scenario.rate);
    if (Status ok = axes[a]->gate.prepare(limits, scenario.rate); !ok) return ok.error();
    axes[a]->gate.engage();
  }
  Frames left(scenario, options.seed, *ears);
  const Course alone = cut(left, scenario, nullptr, options);
  Frames held(scenario, options.seed, *ears);
  const Course controlled = cut(held, scenario, &axes, options);

  ActiveResult result;
  result.chatterAlone = alone.chatter;
  result.chatterControlled = controlled.chatter;
  result.chatterHz = alone.chatterHz;
  result.finalRatio = std::sqrt(controlled.tip / alone.tip);
  for (std::size_t a = 0; a < 2; ++a) {
    AxisResult axis;
    axis.axis = kAxes[a];
    axis.path = std::move((*paths)[a]);
    axis.released = axes[a]->gate.why();
    axis.releasedAt = axes[a]->releasedAt;
    axis.strokeUsed = axes[a]->gate.strokeUsed();
    axis.limitedShare =
        static_cast<double>(axes[a]->gate.limitedSamples()) / static_cast<double>(alone.errors[a].size());
    result.axes.push_back(std::move(axis));
    for (const double f : linesOf(scenario, alone.chatterHz, kAxes[a])) {
      const double before = powerAt(alone.errors[a], f, scenario.rate);
      const double after = powerAt(controlled.errors[a], f, scenario.rate);
      if (before > 0.0 && after > 0.0) {
        result.attenuation.push_back({kAxes[a], f, 10.0 * std::log10(before / after), before});
      }
    }
  }
  return result;
}

}  // namespace stillcut::app
