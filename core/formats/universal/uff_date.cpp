#include "core/formats/universal/uff_date.h"

#include <array>
#include <cstdio>
#include <string>

#include "core/formats/time_stamps.h"
#include "core/formats/wall_clock.h"

namespace stillcut::uff {

std::optional<std::int64_t> madeAt(std::string_view line) {
  int day = 0, year = 0, hour = 0, minute = 0, second = 0, years = 0, yearsEnd = 0;
  std::array<char, 4> word{};
  const std::string text(line);
  if (std::sscanf(text.c_str(), "%2d-%3[A-Za-z]-%n%4d%n %2d:%2d:%2d", &day, word.data(), &years, &year, &yearsEnd,
                  &hour, &minute, &second) != 6)
    return record::wallTime(line);
  const std::optional<int> month = record::monthOfName(word.data());
  if (!month || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  constexpr int kTwoDigits = 2, kTurn = 70;
  if (yearsEnd - years == kTwoDigits) year += year < kTurn ? 2000 : 1900;
  return record::wallTime(year, *month, day, 3600.0 * hour + 60.0 * minute + second);
}

}  // namespace stillcut::uff
