// The work of ExactLobes at one speed for a CircleFunction: bands of depth, one CircleSurface each, all zeros in it,
// their number held against the argument principle, and Newton on the fine function. Where a band does not converge it
// is halved; where that ends, the search says how deep it came.
// Thread: one, with its WorkMeter; not real-time.
#pragma once

#include <vector>

#include "core/milling/stability/any_tool/circle_function.h"
#include "core/milling/stability/any_tool/circle_surface.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::milling {

class DepthSearch {
 public:
  DepthSearch(const CircleFunction& f, Rpm speed, const LimitOptions& options, WorkMeter& meter);
  SpeedLimits run();

 private:
  bool addBand(double from, double to, const CircleSurface& surface);
  void refine(std::vector<CircleCrossing>& crossings) const;
  void append(std::vector<CircleCrossing>& crossings);

  const CircleFunction& f_;
  LimitOptions options_;
  WorkMeter& meter_;
  SpeedLimits limits_;
  int outside_ = 0;  // at the depth reached
};

}  // namespace stillcut::milling
