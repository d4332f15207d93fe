#include "core/dsp/peak_shift.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {

double peakShift(double left, double middle, double right) noexcept {
  const double l = std::log(left + 1e-300);
  const double m = std::log(middle + 1e-300);
  const double r = std::log(right + 1e-300);
  const double curve = l - 2.0 * m + r;
  return curve < 0.0 ? std::clamp(0.5 * (l - r) / curve, -0.5, 0.5) : 0.0;
}

double hannShift(double peak, double beside) noexcept {
  const double a = peak > 0.0 ? std::sqrt(beside / peak) : 0.5;
  return std::clamp((2.0 * a - 1.0) / (1.0 + a), -0.5, 0.5);
}

}  // namespace stillcut::detect
