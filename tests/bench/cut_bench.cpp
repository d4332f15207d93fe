// Speed of the time-domain model: a step against what is asked of it (`of_target` is time/target: below 1 is met), and
// whole simulated cuts with sensors and truth, in cut seconds per second.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <numbers>

#include "core/milling/regenerative_cut.h"
#include "core/milling/simulation/simulated_cut.h"

namespace stillcut::milling {
namespace {

CutModel textbook() {
  CutModel model;
  const double omega = kTwoPi * 922.0;
  model.modes.push_back({Hertz(922.0), 0.011, 0.03993 * omega * omega, {1.0, 0.0}});
  model.modes.push_back({Hertz(980.0), 0.012, 0.03993 * omega * omega, {0.0, 1.0}});
  return model;
}

// Two modes, two teeth; a slot, so that a tooth is always in the cut.
void step(benchmark::State& state) {
  RegenerativeCut cut(textbook(), {});
  const AngularWindow slot{0.0, std::numbers::pi};
  cut.setSpeed(11000.0 * kTwoPi / 60.0);
  cut.setFeed(1e-4 * 2 * 11000.0 / 60.0);
  cut.setWindows({&slot, 1});
  cut.setAxialDepth(1e-4);
  constexpr int kSteps = 2048;
  for ([[maybe_unused]] auto _ : state) {
    cut.advance(kSteps);
    benchmark::DoNotOptimize(cut.tip());
  }
  state.counters["of_target"] =
      benchmark::Counter(kSteps * 25e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["time_per_step"] =
      benchmark::Counter(kSteps, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(step)->Unit(benchmark::kMicrosecond);

void scenario(benchmark::State& state, const char* name) {
  const auto path = std::filesystem::path(STILLCUT_SOURCE_DIR) / "resources/scenarios" / (std::string(name) + ".toml");
  Result<Scenario> s = loadScenario(path.string());
  if (!s) {
    state.SkipWithError(s.error().line().c_str());
    return;
  }
  s->programme.duration = Seconds(2.0);
  for ([[maybe_unused]] auto _ : state) {
    SimulatedCut cut(*s);
    SampleBlock block;
    block.allocate(static_cast<int>(s->sensors.size()), s->blockFrames);
    while (cut.fill(block)) benchmark::DoNotOptimize(block.frames);
  }
  state.counters["times_real_time"] = benchmark::Counter(2.0, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(scenario, demo, "demo")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scenario, production_stable, "production-stable")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stillcut::milling

BENCHMARK_MAIN();
