#include "core/active/path_promise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stillcut::active {

namespace {

constexpr double kCoherent = 0.8;

}  // namespace

ActivePath promiseOf(const IdentifiedPath& path, std::span<const Hertz> lines, Hertz rate) {
  const PathReport& r = path.report;
  ActivePath promise;
  promise.known = true;
  promise.delay = Seconds(leadingDelay(path.model) / rate.value);
  promise.residual = r.residual;
  const double width = r.frequency.size() > 1 ? r.frequency[1] - r.frequency[0] : rate.value;
  const auto wanted = [&](double f) {
    return lines.empty() || std::ranges::any_of(lines, [&](Hertz l) { return std::abs(l.value - f) <= width; });
  };
  double left = std::numeric_limits<double>::infinity();
  double late = left;
  for (std::size_t k = 0; k < r.frequency.size(); ++k) {
    if (!wanted(r.frequency[k]) || r.coherence[k] < kCoherent) continue;
    const Hertz f(r.frequency[k]);
    const double here = 0.5 * std::numbers::pi - std::abs(phaseError(path.model, r.measured[k], f, rate));
    late = std::min(late, here / (kTwoPi * f.value));
    if (here >= left) continue;
    left = here;
    promise.worstAt = f;
  }
  if (!std::isfinite(left)) return promise;  // the sensor hears nothing there: no promise
  promise.phaseLeft = left;
  promise.delayLeft = Seconds(std::max(0.0, late));
  promise.promisesStable = left > 0.0;
  return promise;
}

PathFit fitOf(const IdentifiedPath& path, const ActivePath& promise) {
  const PathReport& r = path.report;
  return {r.frequency, r.measured, r.modelled, r.coherence, promise};
}

}  // namespace stillcut::active
