// Parts of a stable production, drawn at random: for how often detection alarms where nothing chatters. Thread: any.
#pragma once

#include <cstdint>

#include "core/milling/simulation/scenario.h"

namespace stillcut::test {

// A part of half a minute on the machine of `base` (its drive, overrides, sensors): a tool, a material and modes of its
// own; three to six operations, each with its speed, radial immersion and axial depth, entry, exit, and corners in
// which the immersion rises for a while. At every immersion, and at speeds 3 % around each operation's, the depth is at
// most `ofLimit` of the exact limit, so that no part of it is chatter. The same seed is the same part.
Result<milling::Scenario> drawnPart(const milling::Scenario& base, std::uint64_t seed, double ofLimit = 0.6);

}  // namespace stillcut::test
