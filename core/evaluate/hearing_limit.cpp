#include "core/evaluate/hearing_limit.h"

#include <algorithm>
#include <cmath>

namespace stillcut::evaluate {
namespace {

constexpr double kUsableBand = 0.45;       // of the sampling rate, of every detector
constexpr double kThinnedBand = 0.35;      // of the working rate of `parametric`
constexpr Hertz kLeastBand{2500.0};        // of `energy-ratio`, whatever its harmonics
constexpr Hertz kHighestOfTorque{2500.0};  // where the conditioner ends speed and current

double ownValue(const detect::Detector& detector, std::string_view key) {
  const detect::AutoValueTable table = detector.autoValues();
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].key == key) return detector.own(i).value;
  }
  return config::kAutomatic;
}

}  // namespace

Hertz hearingLimit(const detect::Detector& detector, const CutSetup& setup, Hertz spindle) {
  Hertz limit = setup.rate * kUsableBand;
  const double harmonics = ownValue(detector, "energy-ratio.harmonics");
  if (std::isfinite(harmonics) && spindle.value > 0.0) {
    limit = std::min(limit, std::max(kLeastBand, spindle * (harmonics + 0.5)));
  }
  if (const double working = ownValue(detector, "parametric.rate");
      std::isfinite(working) && working < setup.rate.value)
    limit = std::min(limit, Hertz(working * kThinnedBand));
  const bool torqueOnly = std::all_of(setup.channels.begin(), setup.channels.end(), [](const ChannelInfo& c) {
    return c.quantity == SensorQuantity::SpindleSpeed || c.quantity == SensorQuantity::Current;
  });
  return torqueOnly ? std::min(limit, kHighestOfTorque) : limit;
}

}  // namespace stillcut::evaluate
