// A sweep refined where it matters: speeds are added between its own until the limit runs straight from one to the
// next, which finds the tips and the valleys of the lobes, and until the edges of the pockets at one depth are known to
// the speed asked for. Nothing is added where more would not show. Thread: any; ends on a stop request as sweeps do.
#pragma once

#include <string>

#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::milling {

struct RefineOptions {
  Rpm from{}, to{};               // stretch of the sweep to refine
  double depthError = 0.005;      // of the limit, between two speeds; half of what the manual says
  Rpm finest{1.0};                // no two speeds are closer than half of this
  Metres edgesAt{};               // depth whose pockets have their edges refined to `finest`; 0: none
  std::size_t mostSpeeds = 2000;  // altogether; what is left then stays as it is
};

// `sweep` as it came from sweepLobes() with the same model and options, by rising speed.
Result<LobeSweep> refineLobes(LobeSweep sweep, const CutModel& model, const SweepOptions& options,
                              const RefineOptions& refine, const std::string& where, const std::stop_token& stop = {});

// Of one speed: its first crossing, or as far as was searched.
Metres limitingDepth(const SpeedLimits& limits);

// Speeds from the lowest to the highest, `steps` even ones and closer where lobes of the fastest mode would fall
// between two; the last one lies below `highest` where more than 5000 would be needed.
std::vector<Rpm> speedsAcross(const CutModel& model, Rpm lowest, Rpm highest, int steps);

}  // namespace stillcut::milling
