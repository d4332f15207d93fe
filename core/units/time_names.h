// Names of columns and variables that hold times, with the unit that is part of such a name.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stillcut::record {

// "time", "Zeit/ms", "timeMs", "elapsed seconds", "Epoch", "in s".
bool isTimeName(std::string_view name);

// "TIME_MS", "Zeit/ms", "Time, s", "t_us", "seconds_elapsed": the unit, as unitFromText() reads it; empty: the name has
// none, or is no name of times.
std::string timeUnitInName(std::string_view name);

// Seconds per unit of a number that lies between 1990 and 2100 in exactly one unit since 1970: these ranges do not
// overlap. Nothing: it is no such time.
std::optional<double> epochUnit(double first);
// Whether so many seconds since 1970 lie there.
bool isEpoch(double seconds);

}  // namespace stillcut::record
