#include "ui/plots/nice_ticks.h"

#include <algorithm>
#include <cmath>

namespace stillcut::ui {

int decimalsFor(double step) {
  return step > 0.0 ? std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 6) : 0;
}

std::vector<double> niceTicks(double from, double to, int most) {
  if (!std::isfinite(from) || !std::isfinite(to) || !(to > from) || most < 1) return {};
  const double least = (to - from) / most;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10.0 * decade;
  for (const double lead : {1.0, 2.0, 5.0}) {
    if (lead * decade >= least) {
      step = lead * decade;
      break;
    }
  }
  std::vector<double> ticks;
  const double tolerance = step * 1e-9;
  for (double k = std::ceil((from - tolerance) / step); k * step <= to + tolerance; k += 1.0) ticks.push_back(k * step);
  if (static_cast<int>(ticks.size()) > most) ticks.pop_back();
  return ticks;
}

}  // namespace stillcut::ui
