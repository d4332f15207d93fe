#include "core/formats/wall_clock.h"

#include <chrono>
#include <cmath>
#include <ctime>

#include "core/formats/time_stamps.h"
#include "core/units/unit_names.h"

namespace stillcut::record {

namespace {
constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kDay_ns = 86'400 * kSecond_ns;
}  // namespace

std::int64_t localTime(std::int64_t shown_ns) {
  const std::time_t whole = shown_ns / kSecond_ns;
  std::tm parts{};
  gmtime_r(&whole, &parts);
  parts.tm_isdst = -1;
  return static_cast<std::int64_t>(std::mktime(&parts)) * kSecond_ns + shown_ns % kSecond_ns;
}

std::optional<std::int64_t> wallTime(std::string_view text) {
  const std::optional<TimeStamp> stamp = parseTimeStamp(trimmed(text));
  if (!stamp || !stamp->day || !stamp->hasClock) return std::nullopt;
  const std::int64_t shown_ns = *stamp->day * kDay_ns + stamp->clock_ns;
  return stamp->zone_ns ? shown_ns - *stamp->zone_ns : localTime(shown_ns);
}

std::optional<std::int64_t> wallTime(int year, int month, int day, double seconds) {
  constexpr int kFirst = 1970, kLast = 2200;  // nanoseconds of other years do not fit, or are no recording's
  constexpr double kDay = 86'400.0;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (year < kFirst || year > kLast || !date.ok() || !(seconds >= 0.0 && seconds < kDay)) return std::nullopt;
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return localTime(days * kDay_ns + std::llround(seconds * 1e9));
}

}  // namespace stillcut::record
