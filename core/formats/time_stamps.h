// Times of day and dates as loggers print them in a cell: "2026-11-25T08:59:59.0001Z", "25.11.2026 08:59:59,0001",
// "08:59:59.0001", "8:59:59.1 PM", "2026/11/25", "25-Nov-2026",
// "20261125T085959.0001", "25.11.26 08:59:59,0001". Pure: any thread; set-up, not real-time.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace stillcut::record {

struct TimeStamp {
  bool hasDate = false;
  bool hasClock = false;
  // Days since 1970-01-01; empty: no date, or one whose day and month cannot be told apart ("03/04/2026").
  std::optional<std::int64_t> day;
  std::int64_t clock_ns = 0;            // since midnight
  std::optional<std::int64_t> zone_ns;  // east of UTC; empty: not said
};

// 1 to 12 by the first three letters of its English name, in small or large ones; empty: none.
std::optional<int> monthOfName(std::string_view name);

// Nothing: the cell is no time stamp. A plain number never is one.
std::optional<TimeStamp> parseTimeStamp(std::string_view cell);

}  // namespace stillcut::record
