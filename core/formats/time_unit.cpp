#include "core/formats/time_unit.h"

#include <array>
#include <cstdio>
#include <utility>

namespace stillcut::record {
namespace {

// [Hz] Vibration of a cut is sampled within these; the first less what the last digit of a time may hide.
constexpr double kSlowest = 100.0 * (1.0 - 1e-4);
constexpr double kFastest = 1e6 * (1.0 + 1e-4);

std::string shortNumber(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

// "ms (10000 Hz) or us (1e+07 Hz)": the units in which it would be vibration.
std::string likelyUnits(double step) {
  std::string likely;
  for (const auto& [unit, seconds] : {std::pair{"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}) {
    const double rate = 1.0 / (step * seconds);
    if (rate < kSlowest || rate > kFastest) continue;
    likely += (likely.empty() ? "" : " / ") + std::string(unit) + " (" + shortNumber(rate) + " Hz)";
  }
  return likely;
}

}  // namespace

Status checkAssumedSeconds(const std::string& where, double step) {
  if (1.0 / step >= kSlowest) return Done{};
  const std::string likely = likelyUnits(step);
  return Error{where,
               message("its time has no unit; its steps of %1 would be %2 Hz in seconds", shortNumber(step),
                       shortNumber(1.0 / step)),
               likely.empty() ? message("say --time-unit s, ms, us or ns, or give --rate HZ")
                              : message("say --time-unit %1, or s if it is that slow", likely)};
}

}  // namespace stillcut::record
