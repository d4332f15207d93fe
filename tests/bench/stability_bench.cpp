// Speed of the stability methods against what is asked of them; the counter `of_target` is time/target: below 1 is met.
#include <benchmark/benchmark.h>

#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::milling {
namespace {

CutModel textbook(int modes) {
  CutModel model;
  const double omega = kTwoPi * 922.0;
  model.modes.push_back({Hertz(922.0), 0.011, 0.03993 * omega * omega, {1.0, 0.0}});
  model.engagement = {1.0, Side::Up};
  if (modes == 2) {
    model.modes.push_back(model.modes.front());
    model.modes.back().direction = {0.0, 1.0};
    model.engagement.radialImmersion = 0.5;
  }
  return model;
}

// `seconds` is the target for one iteration.
void compare(benchmark::State& state, double seconds) {
  state.counters["of_target"] =
      benchmark::Counter(seconds, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void limitCurve(benchmark::State& state) {
  const auto modes = static_cast<int>(state.range(0));
  const auto speeds = speedSteps(Rpm(5000), Rpm(25000), Rpm(100), "bench").value();
  SweepOptions options;
  options.limits = {Metres(4e-3), true, true, {}};
  options.threads = 1;
  for (auto _ : state) benchmark::DoNotOptimize(sweepLobes(textbook(modes), speeds, options, "bench"));
  compare(state, modes == 1 ? 0.100 : 0.350);
}
BENCHMARK(limitCurve)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

// 401 speeds x 201 depths, exact, two degrees of freedom; the argument is the number of threads.
void chart(benchmark::State& state) {
  const auto speeds = speedSteps(Rpm(5000), Rpm(25000), Rpm(50), "bench").value();
  std::vector<Metres> depths;
  for (int i = 0; i <= 200; ++i) depths.emplace_back(4e-3 * i / 200);
  SweepOptions options;
  options.limits = {Metres(4e-3), false, false, {}};
  options.threads = static_cast<int>(state.range(0));
  for (auto _ : state) {
    const auto sweep = sweepLobes(textbook(2), speeds, options, "bench");
    benchmark::DoNotOptimize(makeChart(*sweep, depths));
  }
  compare(state, 4.0);
}
BENCHMARK(chart)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void semiDiscretizationPoint(benchmark::State& state) {
  const auto modes = static_cast<int>(state.range(0));
  const auto sdm = SemiDiscretization::make(textbook(modes), {40, 1}, "bench");
  int i = 0;
  for (auto _ : state) {
    const Rpm speed(5000.0 + 100.0 * (i % 200));
    benchmark::DoNotOptimize(sdm->outside(speed, Metres(1e-5 * (1 + i % 150))));
    ++i;
  }
  compare(state, modes == 1 ? 0.06e-3 : 0.30e-3);
}
BENCHMARK(semiDiscretizationPoint)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stillcut::milling

BENCHMARK_MAIN();
