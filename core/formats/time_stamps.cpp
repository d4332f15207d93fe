#include "core/formats/time_stamps.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <string>

namespace stillcut::record {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kMinute_ns = 60 * kSecond_ns;
constexpr std::int64_t kHour_ns = 60 * kMinute_ns;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

struct Digits {
  int value = 0;
  std::size_t count = 0;
};

// Takes the digits `text` begins with, at most nine.
Digits takeDigits(std::string_view& text) {
  Digits found;
  while (found.count < text.size() && found.count < 9 && isDigit(text[found.count])) ++found.count;
  std::from_chars(text.data(), text.data() + found.count, found.value);
  text.remove_prefix(found.count);
  return found;
}

bool takeOne(std::string_view& text, std::string_view among, char* taken = nullptr) {
  if (text.empty() || among.find(text.front()) == std::string_view::npos) return false;
  if (taken != nullptr) *taken = text.front();
  text.remove_prefix(1);
  return true;
}

// Between 1900 and 2200: nanoseconds of other years do not fit.
std::optional<std::int64_t> dayNumber(int year, int month, int day) {
  if (year < 1900 || year > 2200) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count();
}

// "25-Nov-2026" and "25 Nov 2026".
bool takeNamedDate(std::string_view& text, TimeStamp& stamp) {
  std::string_view rest = text;
  const Digits day = takeDigits(rest);
  char sign = 0;
  if (day.count == 0 || day.count > 2 || !takeOne(rest, "- ", &sign) || rest.size() < 3) return false;
  const std::optional<int> month = monthOfName(rest.substr(0, 3));
  if (!month) return false;
  rest.remove_prefix(3);
  if (!takeOne(rest, {&sign, 1})) return false;
  const Digits year = takeDigits(rest);
  if (year.count != 4) return false;
  stamp.day = dayNumber(year.value, *month, day.value);
  stamp.hasDate = stamp.day.has_value();
  if (stamp.hasDate) text = rest;
  return stamp.hasDate;
}

// Year first, or day and month first. With points the day is first; with other signs only a number above 12 tells.
bool takeDate(std::string_view& text, TimeStamp& stamp) {
  std::string_view rest = text;
  std::array<Digits, 3> parts;
  char sign = 0;
  parts[0] = takeDigits(rest);
  if (parts[0].count == 0 || !takeOne(rest, "-/.", &sign)) return false;
  parts[1] = takeDigits(rest);
  if (parts[1].count == 0 || parts[1].count > 2 || !takeOne(rest, {&sign, 1})) return false;
  parts[2] = takeDigits(rest);
  const auto [a, b, c] = parts;
  if (a.count == 4 && c.count >= 1 && c.count <= 2) {
    stamp.day = dayNumber(a.value, b.value, c.value);
    if (!stamp.day) return false;
  } else if (a.count <= 2 && c.count == 4) {
    const std::optional<std::int64_t> dayFirst = dayNumber(c.value, b.value, a.value);
    const std::optional<std::int64_t> monthFirst = dayNumber(c.value, a.value, b.value);
    if (!dayFirst && !monthFirst) return false;
    if (sign == '.') stamp.day = dayFirst;
    if (sign != '.' && (!dayFirst || !monthFirst || a.value == b.value)) stamp.day = dayFirst ? dayFirst : monthFirst;
  } else if (sign == '.' && a.count == 2 && b.count == 2 && c.count == 2) {
    constexpr int kCentury = 2000;
    stamp.day = dayNumber(kCentury + c.value, b.value, a.value);  // as German programs write it
    if (!stamp.day) return false;
  } else {
    return false;
  }
  stamp.hasDate = true;
  text = rest;
  return true;
}

// ".0001", ",0001", or ":123" and ":123456", as some loggers part milliseconds and microseconds.
bool takeFraction(std::string_view& text, std::int64_t& ns) {
  char sign = 0;
  if (!takeOne(text, ".,:", &sign)) return true;
  std::size_t count = 0;
  std::int64_t unit = kSecond_ns;
  ns = 0;
  while (count < text.size() && isDigit(text[count])) {
    unit /= 10;
    ns += unit * (text[count] - '0');
    ++count;
  }
  text.remove_prefix(count);
  return sign == ':' ? count == 3 || count == 6 : count >= 1 && count <= 12;
}

bool takeZone(std::string_view& text, TimeStamp& stamp) {
  while (takeOne(text, " ")) {
  }
  if (text == "UTC" || text == "GMT") text.remove_prefix(3);
  if (text.empty() || takeOne(text, "Zz")) {
    stamp.zone_ns = 0;
    return true;
  }
  char sign = 0;
  if (!takeOne(text, "+-", &sign)) return false;
  const Digits hours = takeDigits(text);
  if (hours.count == 4) {
    stamp.zone_ns = hours.value / 100 * kHour_ns + hours.value % 100 * kMinute_ns;
  } else {
    Digits minutes;
    if (hours.count != 2) return false;
    if (takeOne(text, ":")) minutes = takeDigits(text);
    stamp.zone_ns = hours.value * kHour_ns + minutes.value * kMinute_ns;
  }
  if (sign == '-') stamp.zone_ns = -*stamp.zone_ns;
  return true;
}

// "20261125T235958.0001", the basic form of ISO 8601.
bool takeBasic(std::string_view& text, TimeStamp& stamp) {
  constexpr std::string_view kForm = "00000000T000000";
  if (text.size() < kForm.size()) return false;
  for (std::size_t i = 0; i < kForm.size(); ++i) {
    if (kForm[i] == '0' ? !isDigit(text[i]) : text[i] != 'T') return false;
  }
  const auto number = [&text](std::size_t at, std::size_t count) {
    int value = 0;
    std::from_chars(text.data() + at, text.data() + at + count, value);
    return value;
  };
  const int hours = number(9, 2), minutes = number(11, 2), seconds = number(13, 2);
  stamp.day = dayNumber(number(0, 4), number(4, 2), number(6, 2));
  if (!stamp.day || hours > 24 || minutes > 59 || seconds > 60) return false;
  text.remove_prefix(kForm.size());
  std::int64_t fraction_ns = 0;
  if (!takeFraction(text, fraction_ns)) return false;
  stamp.clock_ns = hours * kHour_ns + minutes * kMinute_ns + seconds * kSecond_ns + fraction_ns;
  stamp.hasDate = stamp.hasClock = true;
  return text.empty() || takeZone(text, stamp);
}

// "am" and "pm" behind a clock of twelve hours.
bool takeHalf(std::string_view& text, std::int64_t& hours) {
  while (takeOne(text, " ")) {
  }
  if (text.size() < 2 || (text[1] != 'm' && text[1] != 'M')) return false;
  char half = 0;
  if (!takeOne(text, "aApP", &half)) return false;
  text.remove_prefix(1);
  if (hours < 1 || hours > 12) return false;
  hours = hours % 12 + (half == 'p' || half == 'P' ? 12 : 0);
  return true;
}

// "8:59:59", "08:59:59.0001", "8:59:59 PM", and "59:59.5", minutes first, where a fraction shows that seconds are last.
bool takeClock(std::string_view& text, TimeStamp& stamp) {
  const Digits first = takeDigits(text);
  if (first.count == 0 || first.count > 2 || !takeOne(text, ":")) return false;
  const Digits second = takeDigits(text);
  if (second.count != 2 || second.value > 59) return false;
  std::int64_t hours = 0;
  std::int64_t minutes = first.value;
  std::int64_t seconds = second.value;
  std::int64_t fraction_ns = 0;
  if (takeOne(text, ":")) {
    const Digits third = takeDigits(text);
    if (third.count != 2 || third.value > 60) return false;  // 60: a leap second
    hours = first.value;
    minutes = second.value;
    seconds = third.value;
  } else if (text.empty() || (text.front() != '.' && text.front() != ',')) {
    return false;
  }
  if (minutes > 59 || !takeFraction(text, fraction_ns)) return false;
  if (!text.empty() && text.find_first_of("mM") != std::string_view::npos && !takeHalf(text, hours)) return false;
  if (hours > 24) return false;
  stamp.clock_ns = hours * kHour_ns + minutes * kMinute_ns + seconds * kSecond_ns + fraction_ns;
  stamp.hasClock = true;
  return text.empty() || takeZone(text, stamp);
}

}  // namespace

std::optional<int> monthOfName(std::string_view name) {
  constexpr std::array<std::string_view, 12> kMonths{"jan", "feb", "mar", "apr", "may", "jun",
                                                     "jul", "aug", "sep", "oct", "nov", "dec"};
  std::string small(name);
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto month = std::find(kMonths.begin(), kMonths.end(), small);
  if (month == kMonths.end()) return std::nullopt;
  return static_cast<int>(month - kMonths.begin()) + 1;
}

std::optional<TimeStamp> parseTimeStamp(std::string_view cell) {
  TimeStamp stamp;
  if (cell.size() < 5 || !isDigit(cell.front())) return std::nullopt;
  if (std::string_view basic = cell; takeBasic(basic, stamp))
    return basic.empty() ? std::optional(stamp) : std::nullopt;
  stamp = {};
  if (takeNamedDate(cell, stamp) || takeDate(cell, stamp)) {
    if (cell.empty()) return stamp;
    if (!takeOne(cell, "T t_")) return std::nullopt;
    while (takeOne(cell, " ")) {
    }
  }
  if (!takeClock(cell, stamp) || !cell.empty()) return std::nullopt;
  return stamp;
}

}  // namespace stillcut::record
