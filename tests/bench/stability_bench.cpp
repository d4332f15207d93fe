// Speed of the stability methods against what is asked of them; the counter `of_target` is time/target: below 1 is met.
#include <benchmark/benchmark.h>
#include <ctime>

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::milling {
namespace {

CutModel textbook(int modes) {
  CutModel model;
  const double omega = kTwoPi * 922.0;
  model.modes.push_back({Hertz(922.0), 0.011, 0.03993 * omega * omega, {1.0, 0.0}});
  model.engagement = {1.0, MillingDirection::Up};
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

// What shops cut, against the plain cut's 50 ms for 201 speeds: `of_target` asks for no more than 20 times that.
CutModel ofShop(int kind) {
  CutModel model = textbook(2);
  model.tool.teeth = 4;
  if (kind == 0) model.tool.pitch = {70.0, 110.0, 70.0, 110.0};
  for (double& angle : model.tool.pitch) angle *= kTwoPi / 360.0;
  if (kind == 1) model.tool.helix = 0.6;
  if (kind == 2) model.tool.toothHelix = {0.6, 0.66, 0.6, 0.66};
  if (kind == 3) model.material.processDamping = 2e4;
  return model;
}

void shopCurve(benchmark::State& state) {
  const auto speeds = speedSteps(Rpm(5000), Rpm(25000), Rpm(100), "bench").value();
  SweepOptions options;
  options.limits = {Metres(4e-3), true, true, {}};
  options.threads = 1;
  const CutModel model = ofShop(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(sweepLobes(model, speeds, options, "bench"));
  compare(state, 20 * 0.050);
}
BENCHMARK(shopCurve)->ArgName("pitch0_helix1_helices2_damping3")->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

// An uneven pitch whose pattern is a whole revolution, at speeds where many waves fit into it: against 20 times what
// the plain cut takes there.
void slowPitchCurve(benchmark::State& state) {
  const auto speeds = speedSteps(Rpm(1500), Rpm(3000), Rpm(75), "bench").value();
  SweepOptions options;
  options.limits = {Metres(4e-3), true, true, {}};
  options.threads = 1;
  CutModel model = textbook(2);
  model.tool.teeth = 4;
  if (state.range(0) == 1) model.tool.pitch = {80.0, 95.0, 85.0, 100.0};
  for (double& angle : model.tool.pitch) angle *= kTwoPi / 360.0;
  for (auto _ : state) benchmark::DoNotOptimize(sweepLobes(model, speeds, options, "bench"));
}
BENCHMARK(slowPitchCurve)->ArgName("even0_uneven1")->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

// 401 speeds x 201 depths, exact, two degrees of freedom.
void computeChart(int threads) {
  static const std::vector<Rpm> kSpeeds = speedSteps(Rpm(5000), Rpm(25000), Rpm(50), "bench").value();
  std::vector<Metres> depths;
  for (int i = 0; i <= 200; ++i) depths.emplace_back(4e-3 * i / 200);
  SweepOptions options;
  options.limits = {Metres(4e-3), false, false, {}};
  options.threads = threads;
  const auto sweep = sweepLobes(textbook(2), kSpeeds, options, "bench");
  int stable = 0;
  for (const auto& limits : sweep->speeds) {
    for (Metres depth : depths) stable += limits.stableAt(depth) ? 1 : 0;
  }
  benchmark::DoNotOptimize(stable);
}

void chart(benchmark::State& state) {
  for (auto _ : state) computeChart(static_cast<int>(state.range(0)));
  compare(state, 4.0);
}
BENCHMARK(chart)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

double seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// One thread against two, best of each. `by_clock` needs two idle cores; `by_share` is what they would give: the
// processor time of one thread over that of the busier of two, which counts what the division of the work costs.
void speedUpOfTwoCores(benchmark::State& state) {
  double oneClock = 1e300, twoClock = 1e300, oneWork = 1e300, busier = 1e300;
  for (auto _ : state) {
    const double from = seconds(CLOCK_MONOTONIC);
    const double work = seconds(CLOCK_PROCESS_CPUTIME_ID);
    computeChart(1);
    oneClock = std::min(oneClock, seconds(CLOCK_MONOTONIC) - from);
    oneWork = std::min(oneWork, seconds(CLOCK_PROCESS_CPUTIME_ID) - work);
    const double again = seconds(CLOCK_MONOTONIC);
    const double all = seconds(CLOCK_PROCESS_CPUTIME_ID);
    const double own = seconds(CLOCK_THREAD_CPUTIME_ID);
    computeChart(2);
    const double mine = seconds(CLOCK_THREAD_CPUTIME_ID) - own;
    const double others = seconds(CLOCK_PROCESS_CPUTIME_ID) - all - mine;
    twoClock = std::min(twoClock, seconds(CLOCK_MONOTONIC) - again);
    busier = std::min(busier, std::max(mine, others));
  }
  state.counters["by_clock"] = oneClock / twoClock;
  state.counters["by_share"] = oneWork / busier;
  state.counters["of_target"] = 1.8 / (oneWork / busier);
}
BENCHMARK(speedUpOfTwoCores)->Unit(benchmark::kMillisecond)->Iterations(10);

// From the request to stop until sweepLobes() has returned, at the speeds where one expansion takes longest.
void cancelling(benchmark::State& state) {
  const auto speeds = speedSteps(Rpm(40), Rpm(100), Rpm(1), "bench").value();
  SweepOptions options;
  options.method = static_cast<LobeMethod>(state.range(0));
  options.limits = {Metres(1.0), false, true, {}};
  options.sdm = {2000, 1};
  double worst = 0.0;
  int after = 0;
  for (auto _ : state) {
    std::stop_source stop;
    std::jthread worker(
        [&] { benchmark::DoNotOptimize(sweepLobes(textbook(2), speeds, options, "bench", stop.get_token())); });
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + 13 * (after++ % 20)));
    const double asked = seconds(CLOCK_MONOTONIC);
    stop.request_stop();
    worker.join();
    worst = std::max(worst, seconds(CLOCK_MONOTONIC) - asked);
  }
  state.counters["worst_ms"] = 1e3 * worst;
  state.counters["of_target"] = worst / 0.050;
}
BENCHMARK(cancelling)
    ->Arg(static_cast<int>(LobeMethod::Exact))
    ->Arg(static_cast<int>(LobeMethod::SemiDiscretization))
    ->Arg(static_cast<int>(LobeMethod::ZerothOrder))
    ->Unit(benchmark::kMillisecond)
    ->Iterations(20);

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
