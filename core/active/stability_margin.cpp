#include "core/active/stability_margin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stillcut::active {

namespace {

constexpr double kCoherent = 0.8;

}  // namespace

ActivePath stabilityMarginOf(const IdentifiedPath& path, std::span<const Hertz> lines, Hertz rate) {
  const PathReport& r = path.report;
  ActivePath margin;
  margin.known = true;
  margin.delay = Seconds(leadingDelay(path.model) / rate.value);
  margin.residual = r.residual;
  const double width = r.frequency.size() > 1 ? r.frequency[1] - r.frequency[0] : rate.value;
  double left = std::numeric_limits<double>::infinity();
  double late = left;
  const auto hears = [&](std::size_t k) {
    if (r.coherence[k] < kCoherent) return false;
    const Hertz f(r.frequency[k]);
    const double here = 0.5 * std::numbers::pi - std::abs(phaseError(path.model, r.measured[k], f, rate));
    late = std::min(late, here / (kTwoPi * f.value));
    if (here < left) {
      left = here;
      margin.worstFrequency = f;
    }
    return true;
  };
  bool all = true;  // of the lines have a response
  for (const Hertz line : lines) {
    bool heard = false;
    for (std::size_t k = 0; k < r.frequency.size(); ++k) {
      if (std::abs(line.value - r.frequency[k]) <= width && hears(k)) heard = true;
    }
    if (!heard && all) margin.worstFrequency = line;
    all = all && heard;
  }
  for (std::size_t k = 0; lines.empty() && k < r.frequency.size(); ++k) (void)hears(k);
  if (!all || !std::isfinite(left)) return margin;  // no response there: no margin
  margin.phaseMargin = left;
  margin.delayMargin = Seconds(std::max(0.0, late));
  margin.predictedStable = left > 0.0;
  return margin;
}

Status checkStabilityMargin(const ActivePath& margin, const std::string& axis) {
  if (margin.predictedStable) return Done{};
  return Error{message("active work-holder"),
               message("the model along %1 has no phase margin on the lines to quieten, worst at %2 Hz", axis,
                       std::to_string(std::lround(margin.worstFrequency.value))),
               message("its phase is off by 90 degrees or more, or the sensor measures nothing of the actuator there")};
}

PathFit fitOf(const IdentifiedPath& path, const ActivePath& margin) {
  const PathReport& r = path.report;
  return {r.frequency, r.measured, r.modelled, r.coherence, margin};
}

}  // namespace stillcut::active
