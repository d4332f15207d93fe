// A tool that nobody chose: one or two modes per axis, two to six teeth, a programmed speed anywhere in the first three
// lobes, and a depth of 1.15 to 2 times the limit there (by the exact lobes). For tests and tables.
#pragma once

#include <cstdint>
#include <optional>

#include "core/milling/simulation/scenario.h"
#include "core/model/cut_setup.h"

namespace stillcut::test {

struct RandomTool {
  milling::Scenario scenario;  // a few seconds: stable first, then too deep; expect says what the lobes allow
  double timesLimit = 0.0;     // depth over the limit at the programmed speed
  double waves = 0.0;          // between two teeth at the programmed speed, first mode
  StableSpeeds known;          // what a strategy is told where the modes are known
  double widest = 0.0;         // of its stable ranges, as a share of the speed
};

// Narrower than what the gate takes for "at speed" (gate.speed-tolerance): no spindle can be asked to find it.
inline constexpr double kNarrow = 0.02;

// Whether its final depth is stable at `speed` by the exact lobes: what the simulation's own truth, which compares one
// turn with the next, cannot see where chatter locks onto the spindle's harmonics.
bool stableByLobes(const RandomTool& tool, Rpm speed);

// The same number gives the same tool. Throws std::runtime_error where the lobes cannot be had.
RandomTool randomTool(std::uint64_t number);

}  // namespace stillcut::test
