// f(exp(i theta), w) over all angles and a band of depths as a Laurent polynomial in mu whose real coefficients are
// Chebyshev series in the depth: f is analytic in both, so both converge geometrically. Some hundred values of a
// CircleFunction make one; afterwards f and its derivatives cost a microsecond or two.
// Thread: one, with its WorkMeter; not real-time.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "core/milling/stability/any_tool/circle_function.h"
#include "core/milling/stability/crossing_finder.h"

namespace stillcut::milling {

class CircleSurface {
 public:
  // Empty when the series does not converge within the terms allowed (take a thinner band), or when stopped.
  static std::optional<CircleSurface> build(const CircleFunction& f, double from, double to, WorkMeter& meter);

  CircleValue at(double angle, double depth) const;
  std::complex<double> valueAt(double angle, double depth) const;
  int states() const { return states_; }
  double effort() const { return 6.0 * static_cast<double>(series_.size()); }  // operations of at()

 private:
  int states_ = 0;
  int lowest_ = 0;  // power of mu of the first row
  double middle_ = 0.0, half_ = 1.0;
  std::size_t terms_ = 1;       // in the depth
  std::vector<double> series_;  // [power of mu][term]
};

}  // namespace stillcut::milling
