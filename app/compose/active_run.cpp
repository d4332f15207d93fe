#include "app/compose/active_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>

#include "app/compose/active_setup.h"
#include "app/compose/force_run.h"
#include "app/compose/line_power.h"
#include "core/active/simulated_duplex.h"

namespace stillcut::app {
namespace {

constexpr std::array<const char*, 2> kAxes{"x", "y"};

using Errors = std::array<std::vector<double>, 2>;

active::ActiveEngineOptions engineOptions(const milling::Scenario& scenario, const ActiveOptions& options) {
  active::ActiveEngineOptions engine = activeOptions(*scenario.workHolder, options.params);
  engine.record.seed = options.seed != 0 ? options.seed : scenario.seed;
  return engine;
}

// One block after the other through whatever makes strokes of errors.
template <class Step>
void runBlock(active::SimulatedDuplex& device, std::vector<double>& in, std::vector<safety::ActuatorCommand>& out,
              Step step) {
  (void)device.read(in);
  const std::size_t frames = in.size() / 2;
  for (std::size_t f = 0; f < frames; ++f) {
    const active::CommandPair strokes = step(active::AxisPair{in[f], in[frames + f]});
    out[f] = strokes[0];
    out[frames + f] = strokes[1];
  }
  (void)device.write(out);
}

Result<active::PathPairFound> identify(const milling::Scenario& scenario, const ActiveOptions& options,
                                       const active::ActiveEngineOptions& engine) {
  active::SimulatedDuplex device(scenario, active::simulatedFrames(options.params), options.seed);
  const auto format = device.open();
  if (!format) return format.error();
  active::PathRecorder recorder;
  if (Status ok = recorder.prepare(engine.record, engine.limits, scenario.rate); !ok) return ok.error();
  std::vector<double> in(2 * static_cast<std::size_t>(format->frames));
  std::vector<safety::ActuatorCommand> out(in.size());
  while (!recorder.over()) {
    recorder.begin();
    runBlock(device, in, out, [&](const active::AxisPair& errors) { return recorder.step(errors); });
  }
  if (Status whole = recorder.complete(); !whole) return whole.error();
  if (options.recorded) options.recorded(recorder);
  active::PathRequest request = engine.path;
  request.sweep = engine.record.excitation == active::Excitation::Sweep;
  active::PathPairFound paths;
  for (std::size_t a = 0; a < 2; ++a) {
    auto found = active::identifyPath(recorder.output(a), recorder.reading(a), scenario.rate, request,
                                      scenario.name + ": path to the accelerometer along " + kAxes[a]);
    if (!found) return found.error();
    paths[a] = std::move(found).value();
  }
  return paths;
}

struct Course {
  Errors errors;
  std::array<double, 2> releasedAt{};
  bool chatter = false;
  double chatterHz = 0.0;
};

std::size_t framesOf(const milling::Scenario& scenario) {
  return static_cast<std::size_t>(std::llround(scenario.programme.duration.value * scenario.rate.value));
}

// The whole cut through a device of its own: `step` makes strokes of errors, `afterBlock` looks at what a block did.
template <class Step, class AfterBlock>
Course course(const milling::Scenario& scenario, active::SimulatedDuplex& device, Step step, AfterBlock afterBlock) {
  Course made;
  device.cut(true);
  const auto format = device.open();
  if (!format) return made;
  const double last = scenario.programme.duration.value - 1.0;
  std::vector<double> in(2 * static_cast<std::size_t>(format->frames));
  std::vector<safety::ActuatorCommand> out(in.size());
  while (made.errors[0].size() < framesOf(scenario)) {
    runBlock(device, in, out, [&](const active::AxisPair& errors) {
      for (std::size_t a = 0; a < 2; ++a) made.errors[a].push_back(errors[a]);
      return step(errors);
    });
    const milling::SimulatedCut& plant = device.plant();
    made.chatter = made.chatter || (plant.time().value >= last && plant.truth().chattering());
    afterBlock(made, plant);
  }
  made.chatterHz = device.plant().truth().chatterFrequency().value;
  return made;
}

Course leftAlone(const milling::Scenario& scenario, const ActiveOptions& options) {
  active::SimulatedDuplex device(scenario, active::simulatedFrames(options.params), options.seed);
  return course(
      scenario, device, [](const active::AxisPair&) { return active::CommandPair{}; },
      [](Course&, const milling::SimulatedCut&) {});
}

Course controlled(const milling::Scenario& scenario, const ActiveOptions& options, active::ActiveLoop& loop) {
  active::SimulatedDuplex device(scenario, active::simulatedFrames(options.params), options.seed);
  device.observe = options.observe;
  loop.engage();
  loop.begin();
  return course(
      scenario, device, [&](const active::AxisPair& errors) { return loop.step(errors); },
      [&](Course& made, const milling::SimulatedCut& plant) {
        loop.renewModels();
        for (std::size_t a = 0; a < 2; ++a) {
          if (made.releasedAt[a] > 0.0 || loop.gate(a).why() == ActuatorRelease::None) continue;
          made.releasedAt[a] = plant.time().value;
        }
        loop.begin();  // the next block
      });
}

// Mean square of both axes over a stretch of a course [frames].
double power(const Errors& errors, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (const std::vector<double>& e : errors) {
    for (std::size_t n = from; n < to; ++n) sum += e[n] * e[n];
  }
  return sum / static_cast<double>(to - from);
}

// Whether the controlled cut chatters, or is worse than left alone. Its truth (chatter_truth.h) goes by the growth that
// the linearised cut has without a controller, so of a cut that chatters when left alone it cannot tell a vibration
// that is held from one that grows. But chatter that nothing holds grows until teeth leave the cut: to what it is when
// left alone.
bool chatters(const Course& alone, const Course& held, double ratio, double growth) {
  constexpr double kAsLoud = 0.5;
  constexpr double kLouder = 1.5;
  constexpr double kGrowing = 0.3;  // [1/s]: tenfold within a usual programme
  if (growth > kGrowing) return true;
  return alone.chatter ? ratio > kAsLoud : held.chatter || ratio > kLouder;
}

// Lines worth telling: chatter, the modes an actuator of this bandwidth is for, what is to be quietened, tooth passing
// and spindle.
std::vector<double> linesOf(const milling::Scenario& s, double chatterHz, const char* axis) {
  std::vector<double> lines;
  if (chatterHz > 0.0) lines.push_back(chatterHz);
  for (const milling::Mode& m : s.model.modes) {
    const bool along = std::string(axis) == "x" ? m.direction[0] != 0.0 : m.direction[1] != 0.0;
    if (along && m.frequency.value > 250.0) lines.push_back(m.frequency.value);
  }
  for (const Hertz line : s.workHolder->quieten) {
    if (std::find(lines.begin(), lines.end(), line.value) == lines.end()) lines.push_back(line.value);
  }
  const double spindle = s.programme.speed.value / 60.0;
  lines.push_back(spindle);
  lines.push_back(spindle * s.model.tool.teeth);
  std::sort(lines.begin(), lines.end());
  return lines;
}

}  // namespace

Result<ActiveResult> runActive(const milling::Scenario& scenario, const ActiveOptions& options) {
  if (active::forceFeedback(options.params)) return runForce(scenario, options);
  if (Status ok = active::SimulatedDuplex::check(scenario); !ok) return ok.error();
  const active::ActiveEngineOptions engine = engineOptions(scenario, options);
  auto paths = identify(scenario, options, engine);
  if (!paths) return paths.error();

  std::array<ActivePath, 2> promises;
  for (std::size_t a = 0; a < 2; ++a) {
    promises[a] = active::stabilityMarginOf((*paths)[a], engine.lines, scenario.rate);
    if (Status promised = active::checkStabilityMargin(promises[a], kAxes[a]); !promised) return promised.error();
  }
  const auto loop = std::make_unique<active::ActiveLoop>();
  if (Status ok = loop->prepare(active::axisOptions(engine, *paths), scenario.rate); !ok) return ok.error();
  const Course alone = leftAlone(scenario, options);
  const Course held = controlled(scenario, options, *loop);

  const std::size_t end = framesOf(scenario);
  const auto second = std::min(end / 2, static_cast<std::size_t>(scenario.rate.value));
  const double now = power(held.errors, end - second, end);
  ActiveResult result;
  result.chatterAlone = alone.chatter;
  result.chatterHz = alone.chatterHz;
  result.finalRatio = std::sqrt(now / power(alone.errors, end - second, end));
  result.growth = 0.5 * std::log(now / power(held.errors, end - 2 * second, end - second));
  result.chatterControlled = chatters(alone, held, result.finalRatio, *result.growth);
  for (std::size_t a = 0; a < 2; ++a) {
    AxisResult axis;
    axis.axis = kAxes[a];
    axis.margin = promises[a];
    axis.path = std::move((*paths)[a]);
    axis.released = loop->gate(a).why();
    axis.releasedAt = held.releasedAt[a];
    axis.strokeUsed = loop->gate(a).strokeUsed();
    axis.limitedFraction =
        static_cast<double>(loop->gate(a).limitedSamples()) / static_cast<double>(held.errors[a].size());
    result.axes.push_back(std::move(axis));
    for (const double f : linesOf(scenario, alone.chatterHz, kAxes[a])) {
      const double before = linePower(std::span(alone.errors[a]).first(end), f, scenario.rate);
      const double after = linePower(std::span(held.errors[a]).first(end), f, scenario.rate);
      if (before > 0.0 && after > 0.0) {
        result.attenuation.push_back({kAxes[a], f, 10.0 * std::log10(before / after), before});
      }
    }
  }
  return result;
}

}  // namespace stillcut::app
