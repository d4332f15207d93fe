// The feed a cut is made with, as far as it is known: the machine's where a machine is heard, else what was set up.
// Thread: any; real-time.
#pragma once

#include "core/model/machine_state.h"

namespace stillcut::detect {

// `setUp` is the profile's or session's nominal feed; 0: unknown, also in the result.
inline MetresPerSecond feedNow(const MachineState& machine, MetresPerSecond setUp) noexcept {
  if (!machine.valid) return setUp;
  return machine.actualFeed.value > 0.0 ? machine.actualFeed : machine.programmedFeed * machine.feedOverride.value;
}

}  // namespace stillcut::detect
