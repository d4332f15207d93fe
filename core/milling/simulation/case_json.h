// Import of the shared reference cuts (JSON) as scenarios. Two sensors x, y of acceleration.
//
// What the file says is taken as it stands: modes, coefficients, tool, runout, speed and, in `process`, whatever varies
// over time (depth_segments, immersion_segments, speed_segments, feed_segments), entry and exit. Spindle and feed
// drives follow what is programmed without delay. What the file says beyond the cut (results, remarks) is kept as
// `reference`.
//
// What the file does not say: the reference is never quite still. Its truth tables show 1 mN of white random force per
// step in air, and in a stable cut, once entry and ramps have died out, a chatter part 4 (c1, c2), 8 (c6) and 60 (c7b)
// times as large as that force would leave. Both are met by a cutting force that varies by 6e-4 rms, white, per step of
// the reference (5.6e-4 to 7.3e-4 case by case). These two are what a quiet cut leaves its forced vibration by: c2 and
// c7b chatter from the transients of their own ramps and hardly care, c6 cuts stably for 0.7 s before it becomes
// unstable and would reach 20 % 150 ms late without them.
// Thread: set-up. Errors: one line with file, place and cause.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::milling {

Result<Scenario> loadCaseJson(const std::string& path);

}  // namespace stillcut::milling
