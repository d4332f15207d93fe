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
  double left = std::numeric_limits<double>::infinity();
  double late = left;
  const auto hears = [&](std::size_t k) {
    if (r.coherence[k] < kCoherent) return false;
    const Hertz f(r.frequency[k]);
    const double here = 0.5 * std::numbers::pi - std::abs(phaseError(path.model, r.measured[k], f, rate));
    late = std::min(late, here / (kTwoPi * f.value));
    if (here < left) {
      left = here;
      promise.worstAt = f;
    }
    return true;
  };
  bool all = true;  // of the lines are heard
  for (const Hertz line : lines) {
    bool heard = false;
    for (std::size_t k = 0; k < r.frequency.size(); ++k) {
      if (std::abs(line.value - r.frequency[k]) <= width && hears(k)) heard = true;
    }
    if (!heard && all) promise.worstAt = line;
    all = all && heard;
  }
  for (std::size_t k = 0; lines.empty() && k < r.frequency.size(); ++k) (void)hears(k);
  if (!all || !std::isfinite(left)) return promise;  // the sensor hears nothing there: no promise
  promise.phaseLeft = left;
  promise.delayLeft = Seconds(std::max(0.0, late));
  promise.promisesStable = left > 0.0;
  return promise;
}

Status checkPromise(const ActivePath& promise, const std::string& axis) {
  if (promise.promisesStable) return Done{};
  return Error{message("active work-holder"),
               message("the model along %1 promises no stability on the lines to quieten, worst at %2 Hz", axis,
                       std::to_string(std::lround(promise.worstAt.value))),
               message("its phase is off by 90 degrees or more, or the sensor does not hear the actuator there")};
}

PathFit fitOf(const IdentifiedPath& path, const ActivePath& promise) {
  const PathReport& r = path.report;
  return {r.frequency, r.measured, r.modelled, r.coherence, promise};
}

}  // namespace stillcut::active
