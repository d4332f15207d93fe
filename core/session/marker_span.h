// The part of a session that a marker speaks of. Pure: any thread; set-up, not real-time.
#pragma once

#include <string>

#include "core/formats/span_reader.h"

namespace stillcut::record {

inline constexpr Seconds kAroundMoment{2.0};  // taken before and after a marker that is a moment

// `name` is a marker's label, its note, or "#3" for the one with this number; the first in time counts. An error names
// the markers there are.
Result<TimeSpan> markerSpan(const std::string& session, const std::string& name);

}  // namespace stillcut::record
