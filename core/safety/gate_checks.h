// What the gate accepts as input. Each check returns ReasonCode::None when all is well, else why not; none of them ever
// lets something doubtful pass. Pure functions, real-time safe.
#pragma once

#include "core/base/realtime.h"
#include "core/safety/gate_io.h"
#include "core/safety/gate_limits.h"

namespace stillcut::safety {

// Every number finite and such as a milling machine can have.
bool plausible(const MachineState& machine) STILLCUT_RT;
// Read, fresh, link up, overrides ours and unlocked, every number finite and plausible, program running.
Reason checkMachine(const MachineState& machine, Instant now, Seconds maxAge) STILLCUT_RT;
// Valid, fresh, finite.
Reason checkVerdict(const Verdict& verdict, Instant now, Seconds maxAge) STILLCUT_RT;
bool inCut(const Verdict& verdict) STILLCUT_RT;
// How old the samples are that it was made of, by the newest that is known of the time: the block, or what the machine
// told after it. Too old to move by.
Seconds sampleAge(const Verdict& verdict, const MachineState& machine, Instant now) STILLCUT_RT;
// Fresh, finite, plausible for this machine. Always well for None, and for Hold and Release whatever they carry.
Reason checkRequest(const OverrideRequest& request, const MachineState& machine, Instant now,
                    Seconds maxAge) STILLCUT_RT;

}  // namespace stillcut::safety
