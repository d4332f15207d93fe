#include "core/milling/simulation/schedule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillcut::milling {

double Schedule::at(double seconds, double metres, double otherwise) const noexcept {
  if (segments.empty()) return otherwise;
  const double s = along == Along::Time ? seconds : metres;
  double value = segments.front().fromValue;
  for (const ScheduleSegment& g : segments) {
    if (s < g.from) break;
    if (s >= g.to || !(g.to > g.from)) {
      value = g.toValue;
      continue;
    }
    double u = (s - g.from) / (g.to - g.from);
    if (g.shape == RampShape::Smoothstep) u = u * u * (3.0 - 2.0 * u);
    return g.fromValue + u * (g.toValue - g.fromValue);
  }
  return value;
}

double Schedule::highest(double otherwise) const {
  if (segments.empty()) return otherwise;
  double top = -std::numeric_limits<double>::infinity();
  for (const ScheduleSegment& g : segments) top = std::max({top, g.fromValue, g.toValue});
  return top;
}

double Schedule::lowest(double otherwise) const {
  if (segments.empty()) return otherwise;
  double bottom = std::numeric_limits<double>::infinity();
  for (const ScheduleSegment& g : segments) bottom = std::min({bottom, g.fromValue, g.toValue});
  return bottom;
}

Schedule constantSchedule(double value) {
  Schedule p;
  p.segments.push_back({0.0, 0.0, value, value, RampShape::Linear});
  return p;
}

Status check(const Schedule& profile, double lowest, double highest, const std::string& where) {
  double end = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < profile.segments.size(); ++i) {
    const ScheduleSegment& g = profile.segments[i];
    const std::string place = where + ": segment " + std::to_string(i + 1);
    if (!std::isfinite(g.from) || !std::isfinite(g.to)) return Error{place, message("its ends must be finite")};
    if (g.to < g.from) return Error{place, message("it ends before it begins")};
    if (g.from < end) return Error{place, message("it begins before the previous one ends")};
    for (double v : {g.fromValue, g.toValue}) {
      if (!(v >= lowest) || !(v <= highest)) return Error{place, message("a value is out of range")};
    }
    end = g.to;
  }
  return Done{};
}

}  // namespace stillcut::milling
