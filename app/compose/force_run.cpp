#include "app/compose/force_run.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <utility>

#include "app/compose/active_setup.h"
#include "app/compose/line_power.h"
#include "core/active/fxlms.h"

namespace stillcut::app {
namespace {

using Complex = std::complex<double>;
using Pair = std::array<double, 2>;

constexpr std::array<const char*, 2> kAxes{"x", "y"};
constexpr double kBeside = 0.1;  // of the spindle's frequency: how far beside its line the tones are
constexpr double kTone = 0.2;    // of the stroke
constexpr double kStatic = 1.0;  // [Hz]: slower force is the cut's own
constexpr int kTaps = 512;       // 0.1 s at 5 kHz: most of a revolution, so that both parts of the tone can be made
// Of the bound: on one line the weights turn a whole filter at once, and it is measured only after path and
// weighting, some 900 samples; so slowly that it is measured before they have gone half the way.
constexpr double kStep = 0.0005;
constexpr double kLeak = 0.9999;  // the paper's for force
constexpr double kWidth = 4.0;    // [Hz] of the emphasis on the line
constexpr Seconds kListen{6.0};   // the last of the cut: the depth is reached before

// A high-pass of first order.
class DynamicPart {
 public:
  explicit DynamicPart(Hertz rate) : keep_(std::exp(-kTwoPi * kStatic / rate.value)) {}
  double process(double x) {
    mean_ = keep_ * mean_ + (1.0 - keep_) * x;
    return x - mean_;
  }

 private:
  double keep_, mean_ = 0.0;
};

Result<Pair> errorSensorsOf(const milling::Scenario& scenario) {
  Pair ears{};
  for (std::size_t a = 0; a < 2; ++a) {
    const auto at = std::ranges::find_if(scenario.sensors, [&](const milling::SensorSettings& s) {
      return s.quantity == SensorQuantity::Force && s.axis == kAxes[a];
    });
    if (at == scenario.sensors.end()) {
      return Error{scenario.name, message("no force sensor along %1", kAxes[a]),
                   message("force feedback needs one per axis")};
    }
    ears[a] = static_cast<double>(at - scenario.sensors.begin());
  }
  return ears;
}

struct Course {
  std::array<std::vector<double>, 2> force;  // [N]
  std::array<std::vector<double>, 2> dynamic;
  bool chatter = false;
  double chatterHz = 0.0;
};

// `strokes`: of the dynamic forces read and the spindle's angle [rad], frame by frame.
Course run(const milling::Scenario& scenario, const ActiveOptions& options, const Pair& ears,
           const std::function<Pair(const Pair&, double)>& strokes, bool observed = false) {
  Course course;
  milling::SimulatedCut plant(scenario, options.seed);
  SampleBlock frame;
  frame.allocate(static_cast<int>(scenario.sensors.size()), 1);
  std::array<DynamicPart, 2> highPass{DynamicPart(scenario.rate), DynamicPart(scenario.rate)};
  const double last = scenario.programme.duration.value - 1.0;
  double angle = 0.0;
  while (plant.fill(frame)) {
    if (observed && options.observe) options.observe(frame, plant);
    Pair dynamic{};
    for (std::size_t a = 0; a < 2; ++a) {
      const auto ear = static_cast<std::size_t>(ears[a]);
      course.force[a].push_back(frame.channel(static_cast<int>(ear))[0] / scenario.sensors[ear].gain);
      dynamic[a] = highPass[a].process(course.force[a].back());
      course.dynamic[a].push_back(dynamic[a]);
    }
    angle = std::fmod(angle + kTwoPi * plant.machineState().actualSpeed.value / 60.0 / scenario.rate.value, kTwoPi);
    const Pair moved = strokes(dynamic, angle);
    plant.setWorkHolder(moved[0], moved[1]);
    course.chatter = course.chatter || (plant.time().value >= last && plant.truth().chattering());
  }
  course.chatterHz = plant.truth().chatterFrequency().value;
  return course;
}

// Amplitude and phase of a tone over the last of a record, Hann window.
Complex toneIn(std::span<const double> x, double frequency, Hertz rate) {
  const auto length = std::min(x.size(), static_cast<std::size_t>(kListen.value * rate.value));
  Complex sum = 0.0;
  for (std::size_t n = x.size() - length; n < x.size(); ++n) {
    const double at = static_cast<double>(n - (x.size() - length)) / static_cast<double>(length);
    const double window = 1.0 - std::cos(kTwoPi * at);
    sum += window * x[n] * std::polar(1.0, -kTwoPi * frequency * static_cast<double>(n) / rate.value);
  }
  return 2.0 * sum / static_cast<double>(length);
}

// Two coefficients a quarter of a period apart make any response at one frequency.
active::PathModel modelOf(Complex response, double frequency, Hertz rate) {
  const auto quarter = static_cast<std::size_t>(std::lround(0.25 * rate.value / frequency));
  const double w = kTwoPi * frequency / rate.value;
  const Complex first = std::polar(1.0, -w), second = std::polar(1.0, -w * static_cast<double>(quarter + 1));
  const double determinant = first.real() * second.imag() - first.imag() * second.real();
  active::PathModel model;
  model.forward.assign(quarter + 1, 0.0);
  model.forward.front() = (response.real() * second.imag() - response.imag() * second.real()) / determinant;
  model.forward.back() = (first.real() * response.imag() - first.imag() * response.real()) / determinant;
  return model;
}

struct Axis {
  active::FxlmsController controller;
  safety::ActuatorGate gate;
};

}  // namespace

// Longer than a screen: one simulated cut from set-up to its result, as the paper describes it
Result<ActiveResult> runForce(const milling::Scenario& scenario, const ActiveOptions& options) {
  if (!scenario.workHolder) {
    return Error{scenario.name, message("has no active work-holder"),
                 message("strategy 'active' needs a table [work_holder]")};
  }
  const auto ears = errorSensorsOf(scenario);
  if (!ears) return ears.error();
  const Hertz rate = scenario.rate;
  const double spindle = scenario.programme.speed.value / 60.0;
  if (0.25 * rate.value / spindle >= active::kMostTaps) {
    return Error{scenario.name, message("turns too slowly for its rate"),
                 message("a quarter of a revolution must fit into 512 samples")};
  }
  const active::ActiveEngineOptions engine = activeOptions(*scenario.workHolder, options.params);

  const Course alone = run(scenario, options, *ears, [](const Pair&, double) { return Pair{}; });
  const Pair beside{(1.0 - kBeside) * spindle, (1.0 + kBeside) * spindle};
  std::array<std::vector<double>, 2> tones;
  const double amplitude = kTone * scenario.workHolder->stroke.value;
  std::array<safety::ActuatorGate, 2> gates;
  for (std::size_t a = 0; a < 2; ++a) {
    if (Status ok = gates[a].prepare(engine.limits[a], rate); !ok) return ok.error();
    gates[a].engage();
  }
  const Course moved = run(scenario, options, *ears, [&](const Pair& force, double) {
    Pair stroke{};
    for (std::size_t a = 0; a < 2; ++a) {
      gates[a].renew();
      const double at = static_cast<double>(tones[a].size()) / rate.value;
      stroke[a] = gates[a].drive(amplitude * std::cos(kTwoPi * beside[a] * at), force[a]).value();
      tones[a].push_back(stroke[a]);
    }
    return stroke;
  });

  const auto path = [&](std::size_t force, std::size_t actuator) {
    return -toneIn(moved.dynamic[force], beside[actuator], rate) / toneIn(tones[actuator], beside[actuator], rate);
  };
  const bool crossed = std::abs(path(0, 1) * path(1, 0)) > std::abs(path(0, 0) * path(1, 1));
  const auto mover = [crossed](std::size_t force) { return crossed ? 1 - force : force; };
  std::array<Axis, 2> axes;  // by the force that they quieten
  for (std::size_t a = 0; a < 2; ++a) {
    const active::PathModel model = modelOf(path(a, mover(a)), spindle, rate);
    if (Status ok = active::checkPath(model, std::string("path to the force along ") + kAxes[a]); !ok)
      return ok.error();
    active::FxlmsOptions controller;
    controller.filter = {.taps = kTaps, .step = kStep, .leak = kLeak, .normalised = true};
    controller.reference = active::Reference::Feedforward;
    controller.emphasis = {{Hertz(spindle)}, 20.0, Hertz(kWidth)};
    axes[a].controller.prepare(controller, model, rate);
    if (Status ok = axes[a].gate.prepare(engine.limits[mover(a)], rate); !ok) return ok.error();
  }
  const double from = scenario.programme.duration.value - kListen.value - 3.0;
  std::size_t n = 0;
  Pair releasedAt{};
  const Course held = run(
      scenario, options, *ears,
      [&](const Pair& force, double angle) {
        const double time = static_cast<double>(n++) / rate.value;
        Pair stroke{};
        for (std::size_t a = 0; a < 2; ++a) {
          Axis& axis = axes[a];
          if (time < from) continue;
          if (time < from + 1.0 / rate.value) axis.gate.engage();
          axis.gate.renew();
          const double wanted = axis.controller.process(force[a], std::cos(angle));
          double& written = stroke[mover(a)];
          written = axis.gate.pass(wanted, force[a], axis.controller.disturbance()).value();
          axis.controller.written(written);
          if (releasedAt[a] == 0.0 && axis.gate.why() != ActuatorRelease::None) releasedAt[a] = time;
        }
        return stroke;
      },
      true);

  ActiveResult result;
  result.chatterAlone = alone.chatter;
  result.chatterControlled = held.chatter;
  result.chatterHz = alone.chatterHz;
  double before = 0.0, after = 0.0;
  for (std::size_t a = 0; a < 2; ++a) {
    AxisResult axis;
    axis.axis = kAxes[mover(a)];  // gate and stroke are the actuator's
    axis.released = axes[a].gate.why();
    axis.releasedAt = releasedAt[a];
    axis.strokeUsed = axes[a].gate.strokeUsed();
    axis.limitedFraction = static_cast<double>(axes[a].gate.limitedSamples()) / static_cast<double>(n);
    result.axes.push_back(std::move(axis));
    for (const double line : {spindle, spindle * scenario.model.tool.teeth}) {
      const double quiet = linePower(held.dynamic[a], line, rate), loud = linePower(alone.dynamic[a], line, rate);
      if (quiet > 0.0 && loud > 0.0)
        result.attenuation.push_back({kAxes[a], line, 10.0 * std::log10(loud / quiet), loud});
    }
    const auto second = static_cast<std::ptrdiff_t>(rate.value);
    for (auto e = alone.dynamic[a].end() - second; e != alone.dynamic[a].end(); ++e) before += *e * *e;
    for (auto e = held.dynamic[a].end() - second; e != held.dynamic[a].end(); ++e) after += *e * *e;
  }
  result.finalRatio = std::sqrt(after / before);
  return result;
}

}  // namespace stillcut::app
