// The clock on the wall, as files tell it: most know no zone, and mean that of the computer beside the machine, which
// is taken to be this one. Pure but for this computer's zone: any thread; set-up, not real-time.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace stillcut::record {

// ns since 1970 UTC of what a clock of this computer's zone shows as so many ns since 1970.
std::int64_t localTime(std::int64_t shown_ns);

// "2026-11-25 08:59:59.25", "2026-11-25T08:59:59Z" as ns since 1970 UTC; empty: no date, no time of day, or neither.
std::optional<std::int64_t> wallTime(std::string_view text);

// The same from its parts: of a month from 1, seconds since midnight. Empty: there is no such day.
std::optional<std::int64_t> wallTime(int year, int month, int day, double seconds);

}  // namespace stillcut::record
