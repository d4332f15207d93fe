// The secondary path: from what is written to the converter to what the error sensor reads, as a recursive filter.
//   r(n) = sum_k forward[k] y(n-1-delay-k) + sum_k backward[k] r(n-1-k)
// The output y(n) leaves after e(n) was read, so it acts on e(n+1) at the earliest: the first coefficient belongs to
// the output one sample ago; a converter that works by blocks is `delay` samples later. In Ford 2013 eq. 5 (H = A + B
// there means A/(1 - B)). Thread: plain values.
#pragma once

#include <complex>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"

namespace stillcut::active {

inline constexpr int kMostDelay = 4096;

struct PathModel {
  std::vector<double> forward;   // a; empty: no model
  std::vector<double> backward;  // b; empty: finite impulse response
  int delay = 0;                 // whole samples before the first coefficient, 0 .. kMostDelay

  bool empty() const { return forward.empty(); }
  std::complex<double> response(Hertz frequency, Hertz rate) const;
  std::vector<double> impulse(int samples) const;  // r(1), r(2), ... after one unit output
  // Largest pole of the backward part; below 1 is stable.
  double largestPole() const;
};

// Refuses what the controllers cannot use: no taps, too many, numbers that are not finite, poles on or outside the unit
// circle, a model that does nothing.
Status checkPath(const PathModel& model, const std::string& where);

// First of the path's impulse response that counts: where a hundredth of its energy has come [samples, 1 or more].
int leadingDelay(const PathModel& model);

// Between the model and the path itself [rad], -pi .. pi; beyond +-pi/2 FXLMS steps the wrong way (Morgan 1980).
double phaseError(const PathModel& model, std::complex<double> measured, Hertz frequency, Hertz rate);

}  // namespace stillcut::active
