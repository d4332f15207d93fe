#include "core/active/error_weighting.h"

#include <algorithm>
#include <cmath>

namespace stillcut::active {

Emphasis foreseen(Emphasis emphasis, Seconds ahead) {
  constexpr double kForeseen = 0.8;
  if (ahead.value > 0.0) {
    const double widest = -2.0 * std::log(kForeseen) / (kTwoPi * ahead.value);
    emphasis.width = Hertz(std::min(emphasis.width.value, widest));
  }
  return emphasis;
}

// The peaking filter of second order: `gain` on the line, its geometric mean with 1 half a width to either side.
void ErrorWeighting::prepare(const Emphasis& emphasis, Hertz rate) {
  peaks_.clear();
  const double root = std::sqrt(emphasis.gain);
  for (const Hertz line : emphasis.lines) {
    if (line.value <= 0.0 || line.value >= 0.5 * rate.value) continue;
    const double angle = kTwoPi * line.value / rate.value;
    const double alpha = 0.5 * std::sin(angle) * emphasis.width.value / line.value;
    const double whole = 1.0 + alpha / root;
    peaks_.push_back({.b0 = (1.0 + alpha * root) / whole,
                      .b1 = -2.0 * std::cos(angle) / whole,
                      .b2 = (1.0 - alpha * root) / whole,
                      .a1 = -2.0 * std::cos(angle) / whole,
                      .a2 = (1.0 - alpha / root) / whole});
  }
}

void ErrorWeighting::reset() noexcept {
  for (Peak& p : peaks_) p.state1 = p.state2 = 0.0;
}

}  // namespace stillcut::active
