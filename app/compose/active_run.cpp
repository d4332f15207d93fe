#include "app/compose/active_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "app/compose/active_setup.h"
#include "core/active/simulated_duplex.h"
#include "core/dsp/spectrum.h"

namespace stillcut::app {
namespace {

constexpr std::array<const char*, 2> kAxes{"x", "y"};

using Errors = std::array<std::vector<double>, 2>;

active::EngineOptions engineOptions(const milling::Scenario& scenario, const ActiveOptions& options) {
  active::EngineOptions engine = activeOptions(*scenario.workHolder, options.params);
  engine.controller.emphasis.lines = engine.lines;
  engine.record.seed = options.seed != 0 ? options.seed : scenario.seed;
  return engine;
}

// One block after the other through whatever makes strokes of errors.
template <class Step>
void runBlock(active::SimulatedDuplex& device, std::vector<double>& in, std::vector<double>& out, Step step) {
  (void)device.read(in);
  const std::size_t frames = in.size() / 2;
  for (std::size_t f = 0; f < frames; ++f) {
    const active::AxisPair strokes = step(active::AxisPair{in[f], in[frames + f]});
    out[f] = strokes[0];
    out[frames + f] = strokes[1];
  }
  (void)device.write(out);
}

Result<active::PathPairFound> identify(const milling::Scenario& scenario, const ActiveOptions& options,
                                       const active::EngineOptions& engine) {
  active::SimulatedDuplex device(scenario, active::simulatedFrames(options.params), options.seed);
  const auto format = device.open();
  if (!format) return format.error();
  active::PathRecorder recorder;
  if (Status ok = recorder.prepare(engine.record, engine.limits, scenario.rate); !ok) return ok.error();
  std::vector<double> in(2 * static_cast<std::size_t>(format->frames)), out(in.size());
  while (!recorder.over()) {
    recorder.begin();
    runBlock(device, in, out, [&](const active::AxisPair& errors) { return recorder.step(errors); });
  }
  if (Status whole = recorder.complete(); !whole) return whole.error();
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
  double tip = 0.0;  // mean square of the tip's acceleration over the last second
  bool chatter = false;
  double chatterHz = 0.0;
};

Course cut(const milling::Scenario& scenario, const ActiveOptions& options, active::ActiveLoop* loop) {
  Course course;
  active::SimulatedDuplex device(scenario, active::simulatedFrames(options.params), options.seed);
  device.cut(true);
  const auto format = device.open();
  if (!format) return course;
  const auto total = static_cast<std::size_t>(std::llround(scenario.programme.duration.value * scenario.rate.value));
  const double last = scenario.programme.duration.value - 1.0;
  std::vector<double> in(2 * static_cast<std::size_t>(format->frames)), out(in.size());
  double blocks = 0.0;
  if (loop != nullptr) device.observe = options.observe;
  while (course.errors[0].size() < total) {
    if (loop != nullptr) loop->begin();
    runBlock(device, in, out, [&](const active::AxisPair& errors) {
      for (std::size_t a = 0; a < 2; ++a) course.errors[a].push_back(errors[a]);
      return loop != nullptr ? loop->step(errors) : active::AxisPair{};
    });
    if (loop != nullptr) loop->renewModels();
    const milling::SimulatedCut& plant = device.plant();
    for (std::size_t a = 0; a < 2 && loop != nullptr; ++a) {
      if (course.releasedAt[a] > 0.0 || loop->gate(a).why() == ActuatorRelease::None) continue;
      course.releasedAt[a] = plant.time().value;
    }
    if (plant.time().value < last) continue;
    ++blocks;
    for (const double e : in) course.tip += e * e;
    course.chatter = course.chatter || plant.truth().chattering();
  }
  for (std::vector<double>& e : course.errors) e.resize(total);
  course.tip /= std::max(1.0, blocks);
  course.chatterHz = device.plant().truth().chatterFrequency().value;
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
  if (Status ok = active::SimulatedDuplex::check(scenario); !ok) return ok.error();
  const active::EngineOptions engine = engineOptions(scenario, options);
  auto paths = identify(scenario, options, engine);
  if (!paths) return paths.error();

  std::array<active::AxisOptions, 2> axes;
  for (std::size_t a = 0; a < 2; ++a) {
    axes[a] = {engine.controller, (*paths)[a].model, engine.limits[a], engine.lines, {}};
    axes[a].online.rms = engine.auxiliary * engine.limits[a].amplitude;
    axes[a].online.seed += a;
  }
  const auto loop = std::make_unique<active::ActiveLoop>();
  if (Status ok = loop->prepare(axes, scenario.rate); !ok) return ok.error();
  loop->engage();
  const Course alone = cut(scenario, options, nullptr);
  const Course controlled = cut(scenario, options, loop.get());

  ActiveResult result;
  result.chatterAlone = alone.chatter;
  result.chatterControlled = controlled.chatter;
  result.chatterHz = alone.chatterHz;
  result.finalRatio = std::sqrt(controlled.tip / alone.tip);
  for (std::size_t a = 0; a < 2; ++a) {
    AxisResult axis;
    axis.axis = kAxes[a];
    axis.promise = active::promiseOf((*paths)[a], engine.lines, scenario.rate);
    axis.path = std::move((*paths)[a]);
    axis.released = loop->gate(a).why();
    axis.releasedAt = controlled.releasedAt[a];
    axis.strokeUsed = loop->gate(a).strokeUsed();
    axis.limitedShare =
        static_cast<double>(loop->gate(a).limitedSamples()) / static_cast<double>(alone.errors[a].size());
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
