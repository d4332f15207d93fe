// What the actuator loop costs: one sample of one axis, controller, weighting and gate, for each length of filter.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "core/active/active_loop.h"
#include "core/active/fxlms.h"
#include "core/rt/deadline_stats.h"
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

// Wide open: its cost counts, not its limits.
void open(safety::ActuatorGate& gate) {
  safety::ActuatorLimits limits;
  limits.amplitude = 1e3;
  limits.slew = 1e9;
  if (!gate.prepare(limits, Hertz(kRate)).ok()) std::abort();
  gate.engage();
}

void oneSample(benchmark::State& state) {
  active::FxlmsOptions options;
  options.filter = {.taps = static_cast<int>(state.range(0)), .step = 0.02, .normalised = true};
  if (state.range(1) != 0) options.emphasis.lines = {Hertz(339.0), Hertz(346.0), Hertz(1024.0)};
  active::FxlmsController controller;
  controller.prepare(options, path(), Hertz(kRate));
  safety::ActuatorGate gate;
  open(gate);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 1e-3);
  std::array<double, kSamples> errors{};
  for (double& e : errors) e = noise(random);
  const double asked = state.range(0) == 35 ? 45.0 : 0.0;
  bestOf(state, {.count = kSamples, .nanoseconds = asked, .signalSeconds = 1.0 / kRate}, [&] {
    gate.renew();  // once a block, as the loop does
    for (const double error : errors) {
      const double wanted = controller.process(error);
      const double written = gate.pass(wanted, error, controller.disturbance()).value();
      controller.written(written);
      benchmark::DoNotOptimize(written);
    }
  });
}
// Both axes with what they tell of themselves, in blocks of 32 as a device delivers them: how much of a block's own
// time the loop takes, at best, and at worst whatever else the machine does meanwhile.
void blocks(benchmark::State& state) {
  constexpr int kFrames = 32;
  const auto rate = static_cast<double>(state.range(0));
  active::AxisOptions axis;
  axis.controller.filter = {.taps = static_cast<int>(state.range(1)), .step = 0.02, .normalised = true};
  axis.controller.emphasis.lines = {Hertz(339.0), Hertz(346.0), Hertz(1024.0)};
  axis.path = path();
  axis.path.delay = kFrames;
  axis.limits.amplitude = 1e3;
  axis.limits.slew = 1e9;
  axis.lines = axis.controller.emphasis.lines;
  active::ActiveLoop loop;
  if (!loop.prepare({axis, axis}, Hertz(rate)).ok()) std::abort();
  loop.engage();
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 1e-3);
  rt::DeadlineStats taken;
  constexpr int kBlocks = 64;
  bestOf(state, {.count = kBlocks, .signalSeconds = kFrames / rate}, [&] {
    for (int block = 0; block < kBlocks; ++block) {
      active::AxisPair error{noise(random), noise(random)};
      const auto began = std::chrono::steady_clock::now();
      loop.begin();
      for (int frame = 0; frame < kFrames; ++frame) {
        const active::CommandPair stroke = loop.step(error);
        error[0] = -error[0] + 1e-12 * stroke[0].value();
        error[1] = -error[1] + 1e-12 * stroke[1].value();
      }
      taken.record(Seconds(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count()));
    }
  });
  state.counters["worst_of_real_time"] = taken.worst().value / (kFrames / rate);
  state.counters["p99.99_of_real_time"] = taken.quantile(0.9999).value / (kFrames / rate);
}
BENCHMARK(blocks)->ArgNames({"rate", "taps"})->Args({5000, 35})->Args({48000, 35})->Args({48000, 512});

// Single calls of one axis at 35 taps. Whatever else the machine does lengthens some call of any million; what the loop
// itself takes at worst (an old end of a delay line copied, a window judged) comes at the same call of every course.
// So: of each call the shortest over all courses, and the longest of these.
void worstCall(benchmark::State& state) {
  constexpr std::size_t kCalls = 20000;
  active::FxlmsOptions options;
  options.filter = {.taps = 35, .step = 0.02, .normalised = true};
  active::FxlmsController controller;
  controller.prepare(options, path(), Hertz(kRate));
  safety::ActuatorGate gate;
  open(gate);
  rt::DeadlineStats taken;
  std::vector<double> shortest(kCalls, 1.0);
  for (auto _ : state) {
    controller.reset();
    double error = 1e-3;
    for (double& best : shortest) {
      gate.renew();
      const auto began = std::chrono::steady_clock::now();
      const double wanted = controller.process(error);
      const double written = gate.pass(wanted, error, controller.disturbance()).value();
      controller.written(written);
      const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
      taken.record(Seconds(took));
      best = std::min(best, took);
      error = -error + 1e-12 * written;
    }
  }
  const double worst = *std::ranges::max_element(shortest);
  state.counters["own_worst_us"] = 1e6 * worst;
  state.counters["of_target"] = worst / 2e-6;
  state.counters["any_worst_us"] = 1e6 * taken.worst().value;
  state.counters["p99.99_us"] = 1e6 * taken.quantile(0.9999).value;
}
BENCHMARK(worstCall)->Iterations(100);

BENCHMARK(oneSample)->ArgNames({"taps", "weighted"})->Args({35, 0})->Args({35, 1})->Args({512, 1});

}  // namespace
}  // namespace stillcut::bench

BENCHMARK_MAIN();
