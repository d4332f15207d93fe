// The third line of identification of a dataset 58: when its function was made, "25-NOV-26 09:00:00". Pure but for this
// computer's zone, which is taken, since the line knows none: any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace stillcut::uff {

// ns since 1970 UTC; empty: the line says something else. Of a year of two digits 70 is 1970 and 69 is 2069.
std::optional<std::int64_t> madeAt(std::string_view line);

}  // namespace stillcut::uff
