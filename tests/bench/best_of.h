// The best of many runs of a piece of work, for a machine that does other things as well, against its target.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace stillcut::bench {

struct Target {
  double count = 1.0;          // things that one run does
  double nanoseconds = 0.0;    // asked for one of them; 0: nothing asked
  double signalSeconds = 0.0;  // of signal that one of them is worth
};

// Counters: `ns` for one thing, `of_target` (below 1 is met), `of_real_time` (part of the signal's own time).
template <class Work>
void bestOf(benchmark::State& state, const Target& target, const Work& work) {
  using Clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity();
  for (auto _ : state) {
    const auto began = Clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(Clock::now() - began).count());
  }
  const double each = best / target.count;
  state.counters["ns"] = each * 1e9;
  if (target.nanoseconds > 0.0) state.counters["of_target"] = each * 1e9 / target.nanoseconds;
  if (target.signalSeconds > 0.0) state.counters["of_real_time"] = each / target.signalSeconds;
}

}  // namespace stillcut::bench
