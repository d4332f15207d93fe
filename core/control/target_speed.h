// Where lobe rules put the spindle, and the feed that goes with it. Pure functions, real-time safe.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/realtime.h"
#include "core/base/units.h"
#include "core/config/override_limits.h"
#include "core/model/machine_state.h"

namespace stillcut::control {

// Whole waves between two teeth, at least one (van Dijk 2010 eq. 29): p = max(1, round(60 f_c / (Z Omega))).
inline int wavesBetweenTeeth(Hertz chatter, int teeth, Rpm speed) STILLCUT_RT {
  const double waves = chatter / toothPassing(speed, teeth);
  return std::isfinite(waves) ? static_cast<int>(std::clamp(std::round(waves), 1.0, 1e6)) : 1;
}

// Speed at which p waves fit between two teeth (van Dijk 2010 eq. 30): Omega = 60 f_c / (p Z).
inline Rpm speedForWaves(Hertz chatter, int teeth, int waves) STILLCUT_RT {
  return toRpm(chatter) / (static_cast<double>(waves) * teeth);
}

struct LobeTarget {
  Rpm speed{};
  int waves = 0;       // p; 0: none is in reach
  Rpm firstChoice{};   // what the rule itself asks for
  bool moved = false;  // the first choice was out of reach, this is its neighbour
};

// The pocket that eq. 29 and 30 choose, or, where the override does not reach it, the nearest of its neighbours
// (p - 1, p + 1) that it reaches.
inline LobeTarget pocketInReach(Hertz chatter, int teeth, Rpm present, const config::SpeedRange& reach) STILLCUT_RT {
  const int p = wavesBetweenTeeth(chatter, teeth, present);
  LobeTarget best;
  best.firstChoice = speedForWaves(chatter, teeth, p);
  for (const int candidate : {p, p - 1, p + 1}) {
    if (candidate < 1) continue;
    const Rpm speed = speedForWaves(chatter, teeth, candidate);
    if (!reach.contains(speed)) continue;
    const bool nearer = best.waves == 0 || std::abs((speed - present).value) < std::abs((best.speed - present).value);
    if (nearer) best = {speed, candidate, best.firstChoice, candidate != p};
    if (candidate == p) break;  // the rule's own choice, in reach
  }
  return best;
}

// The feed that keeps the operator's present feed per tooth at another speed.
inline MetresPerSecond feedFollowing(Rpm speed, const MachineState& machine) STILLCUT_RT {
  const Rpm base = machine.programmedSpeed * machine.operatorSpeed.value;
  return machine.programmedFeed * (machine.operatorFeed.value * (speed / base));
}

}  // namespace stillcut::control
