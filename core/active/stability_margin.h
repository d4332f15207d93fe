// The margins that an identified path gives the control, before it is started. FXLMS steps the wrong way where the
// model's phase is off by more than 90 degrees (Morgan 1980), so what is left of them on the lines to quieten says
// whether the loop will be stable there and how much later it may become: a delay of t shifts a line of f by 2 pi f t.
// Thread: set-up; allocates.
#pragma once

#include <span>
#include <string>

#include "core/active/identify_path.h"
#include "core/model/active_state.h"

namespace stillcut::active {

// Without lines: over everything that the record tells of. `identified` is left to the caller.
ActivePath stabilityMarginOf(const IdentifiedPath& path, std::span<const Hertz> lines, Hertz rate);

// Refuses a model without phase margin, with the reason. `axis`: "x".
Status checkStabilityMargin(const ActivePath& margin, const std::string& axis);

PathFit fitOf(const IdentifiedPath& path, const ActivePath& margin);

}  // namespace stillcut::active
