// The tools and structures that the families cut with, scattered by seed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/milling/simulation/noise.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::bench {

enum class ToolKind {
  TwoFlute,    // 11 000 rev/min, half immersion, down
  ThreeFlute,  // 6300 rev/min, half immersion, up
  FourFlute,   // 8500 rev/min, 70 % immersion, down
  FaceMill,    // four teeth, 50 mm, 800 rev/min, 4096 Hz
};

// Speed within 6 %, modes within 5 %, damping within 25 %, runout up to a sixth of the feed per tooth.
milling::Scenario scattered(ToolKind kind, std::uint64_t seed);
std::string toolName(ToolKind kind);

// First crossing of the exact lobes at the scenario's own speed, engagement and tool.
std::optional<milling::StabilityLimit> limitOf(const milling::Scenario& scenario);

// Programme: air, then `before` for the stable part, then to `after`; times in s.
struct DepthPlan {
  double entry = 0.3, entered = 0.35;  // the depth rises from 0
  double rise = 1.0, risen = 1.3;
  double end = 2.2;
};
void planDepth(milling::Scenario& scenario, const DepthPlan& plan, double before, double after);

}  // namespace stillcut::bench
