// What families are made of: orders of one cut, for every tool and seed.
// Thread: one; not the sample path.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tests/support/known_cuts/known_cut.h"
#include "tests/support/known_cuts/tools.h"

namespace stillcut::bench {

using Orders = std::vector<SimulationOrder>;

inline constexpr std::array<ToolKind, 3> kFast{ToolKind::TwoFlute, ToolKind::ThreeFlute, ToolKind::FourFlute};
inline constexpr DepthPlan kPlan{};
inline constexpr DepthPlan kSlowPlan{.entry = 0.5, .entered = 0.7, .rise = 3.0, .risen = 5.0, .end = 9.0};

inline SimulationOrder order(const char* family, const milling::Scenario& s, AlarmRule rule,
                             const DepthPlan& plan = kPlan) {
  SimulationOrder o;
  o.family = family;
  o.name = s.name + "-" + std::to_string(s.seed);
  o.scenario = s;
  o.rule = rule;
  o.quietFrom = plan.entered;
  o.quietTo = plan.rise;
  return o;
}

// Calls make(scenario, limit) for every tool and seed that has a stability limit of this kind.
template <class Make>
void each(std::span<const ToolKind> tools, int seeds, std::uint64_t salt, const Make& make) {
  for (const ToolKind tool : tools) {
    for (int seed = 1; seed <= seeds; ++seed) {
      milling::Scenario s = scattered(tool, salt + static_cast<std::uint64_t>(seed));
      if (const auto limit = limitOf(s)) make(s, *limit);
    }
  }
}

}  // namespace stillcut::bench
