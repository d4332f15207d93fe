#include "core/units/time_names.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

constexpr std::string_view kSeparators = " _-/.,:";

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

// Its own name, or a word for time with its unit or its kind behind it or before it: "time_ms", "elapsed seconds".
bool isPlainTimeName(std::string_view n) {
  constexpr auto kNames = std::to_array<std::string_view>({"t",          "time",         "times",
                                                           "timestamp",  "time stamp",   "timestamps",
                                                           "x_value",    "zeit",         "zeitstempel",
                                                           "tiempo",     "tempo",        "temps",
                                                           "second",     "seconds",      "secs",
                                                           "sec",        "millis",       "milliseconds",
                                                           "micros",     "microseconds", "nanoseconds",
                                                           "elapsed",    "elapsedtime",  "datetime",
                                                           "date/time",  "date time",    "datum/zeit",
                                                           "zeit/datum", "epoch",        "unixtime",
                                                           "unix time",  "utc",          "\xE6\x97\xB6\xE9\x97\xB4",
                                                           "t_s",        "t_ms",         "t_us",
                                                           "t_ns"});
  constexpr auto kBeginnings =
      std::to_array<std::string_view>({"time ", "time_", "time-", "timestamp ", "timestamp_", "elapsed ", "elapsed_",
                                       "zeit ", "zeit_", "relative time", "rel. time", "rel time"});
  constexpr auto kEnds = std::to_array<std::string_view>({"_elapsed", " elapsed", "_time", " time", "_timestamp"});
  const auto begins = [&n](std::string_view word) { return n.starts_with(word); };
  const auto ends = [&n](std::string_view word) { return n.ends_with(word); };
  if (std::find(kNames.begin(), kNames.end(), n) != kNames.end()) return true;
  if (std::any_of(kBeginnings.begin(), kBeginnings.end(), begins)) return true;
  return std::any_of(kEnds.begin(), kEnds.end(), ends);
}

// A word that is a unit of time; "min" in a name is rather a minimum.
std::string unitWord(std::string_view word) {
  const std::optional<UnitMeaning> meaning = unitFromText(word);
  return meaning && meaning->kind == UnitKind::Time && word != "min" ? std::string(word) : "";
}

// "timems", "elapsedus": what is left of "timeMs" in small letters.
std::string unitGrownOn(std::string_view n) {
  for (const std::string_view word : {"timestamp", "time", "zeit", "elapsed"}) {
    if (!n.starts_with(word)) continue;
    const std::string_view rest = n.substr(word.size());
    if (rest == "ms" || rest == "us" || rest == "ns" || rest == "sec" || rest == "msec" || rest == "usec")
      return std::string(rest);
  }
  return "";
}

// "t/s", "time.ms", "zeit in s", "in s": a name of times, a separator, and the unit.
std::string unitBehind(std::string_view n) {
  const std::size_t last = n.find_last_of(kSeparators);
  if (last == std::string_view::npos) return "";
  std::string_view base = n.substr(0, last);
  base = base.substr(0, base.find_last_not_of(kSeparators) + 1);
  if (base.ends_with(" in")) base = trimmed(base.substr(0, base.size() - 3));
  return base == "in" || isPlainTimeName(base) ? unitWord(n.substr(last + 1)) : "";
}

}  // namespace

bool isTimeName(std::string_view name) {
  const std::string n = lower(trimmed(name));
  return isPlainTimeName(n) || !unitBehind(n).empty() || !unitGrownOn(n).empty();
}

std::string timeUnitInName(std::string_view name) {
  const std::string n = lower(trimmed(name));
  if (std::string unit = unitBehind(n); !unit.empty()) return unit;
  if (std::string unit = unitGrownOn(n); !unit.empty()) return unit;
  if (!isPlainTimeName(n)) return "";
  constexpr std::string_view kGaps = "_ ";
  const std::size_t last = n.find_last_of(kGaps);
  if (last == std::string::npos) return n.size() > 1 ? unitWord(n) : "";
  std::string end = unitWord(std::string_view(n).substr(last + 1));
  const std::string begin = n.substr(0, n.find_first_of(kGaps));
  return end.empty() && begin.size() > 1 ? unitWord(begin) : end;
}

bool isEpoch(double seconds) {
  constexpr double kFrom = 631'152'000.0, kTo = 4'102'444'800.0;  // 1990 to 2100
  return seconds >= kFrom && seconds < kTo;
}

std::optional<double> epochUnit(double first) {
  for (const double unit : {1.0, 1e-3, 1e-6, 1e-9}) {
    if (isEpoch(first * unit)) return unit;
  }
  return std::nullopt;
}

}  // namespace stillcut::record
