#include "core/milling/engagement_windows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::milling {

EngagedAngles engagedAngles(AngularWindow full, double entered, double remaining) noexcept {
  EngagedAngles result;
  const auto add = [&](double from, double to) {
    if (to > from) result.windows[static_cast<std::size_t>(result.count++)] = {from, to};
  };
  if (entered <= 0.0 || remaining <= 0.0) return result;
  const double low = entered < 1.0 ? std::asin(1.0 - entered) : 0.0;
  const double from = std::max(full.from, low), to = std::min(full.to, std::numbers::pi - low);
  if (remaining >= 1.0) {
    add(from, to);
    return result;
  }
  const double high = std::asin(remaining);
  add(from, std::min(to, high));
  add(std::max(from, std::numbers::pi - high), to);
  return result;
}

}  // namespace stillcut::milling
