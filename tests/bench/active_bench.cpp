// What the actuator loop costs: one sample of one axis, controller, weighting and gate, for each length of filter.
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

#include "core/active/fxlms.h"
#include "core/safety/actuator_gate.h"
#include "tests/bench/best_of.h"

namespace stillcut::bench {
namespace {

constexpr double kRate = 5000.0;
constexpr int kSamples = 4096;

active::PathModel path() {
  active::PathModel model;
  for (int k = 0; k < 35; ++k) {
    model.forward.push_back(k == 0 ? 0.0 : 0.5 * std::pow(-0.7, k));
    model.backward.push_back(0.02 * std::pow(0.8, k));
  }
  return model;
}

void oneSample(benchmark::State& state) {
  active::FxlmsOptions options;
  options.filter = {.taps = static_cast<int>(state.range(0)), .step = 0.02, .normalised = true};
  if (state.range(1) != 0) options.emphasis.lines = {Hertz(339.0), Hertz(346.0), Hertz(1024.0)};
  active::FxlmsController controller;
  controller.prepare(options, path(), Hertz(kRate));
  safety::ActuatorLimits limits;
  limits.amplitude = 1e3;
  limits.slew = 1e9;
  safety::ActuatorGate gate;
  if (!gate.prepare(limits, Hertz(kRate)).ok()) std::abort();
  gate.engage();
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 1e-3);
  std::array<double, kSamples> errors{};
  for (double& e : errors) e = noise(random);
  const double asked = state.range(0) == 35 ? 45.0 : 0.0;
  bestOf(state, {.count = kSamples, .nanoseconds = asked, .signalSeconds = 1.0 / kRate}, [&] {
    for (const double error : errors) {
      gate.renew();
      const double wanted = controller.process(error);
      const double written = gate.pass(wanted, error, controller.disturbance()).value();
      controller.written(written);
      benchmark::DoNotOptimize(written);
    }
  });
}
BENCHMARK(oneSample)->ArgNames({"taps", "weighted"})->Args({35, 0})->Args({35, 1})->Args({512, 1});

}  // namespace
}  // namespace stillcut::bench

BENCHMARK_MAIN();
