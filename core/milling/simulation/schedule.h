// Profile: how one quantity of the cut (depth, immersion, speed) runs along time or along the travelled path.
// Thread: plain value; at() is real-time safe.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace stillcut::milling {

enum class Along { Time, Path };
enum class RampShape { Linear, Smoothstep };  // smoothstep: 3 u^2 - 2 u^3, no kink at either end

struct ScheduleSegment {
  double from = 0.0, to = 0.0;            // [s] or [m]
  double fromValue = 0.0, toValue = 0.0;  // SI
  RampShape shape = RampShape::Linear;
  bool operator==(const ScheduleSegment&) const = default;
};

struct Schedule {
  Along along = Along::Time;
  std::vector<ScheduleSegment> segments;  // in order, not overlapping

  bool operator==(const Schedule&) const = default;
  bool empty() const { return segments.empty(); }
  // Value at time [s] and path [m]; before the first and after the last segment, and in gaps, the nearest earlier
  // (or first) value holds. Empty: `otherwise`.
  double at(double seconds, double metres, double otherwise) const noexcept;
  double highest(double otherwise) const;
  double lowest(double otherwise) const;
};

Schedule constantSchedule(double value);

// Segments in order, finite, values within [lowest, highest].
Status check(const Schedule& profile, double lowest, double highest, const std::string& where);

}  // namespace stillcut::milling
