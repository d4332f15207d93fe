// Least mean squares (Ford 2013 eq. 1, 3; Widrow and Stearns): a transversal filter that learns to make d out of x.
//   y(n) = sum h_k x(n-k),  e = d - y,  h <- leak h + 2 mu e x
// Eq. 1 prints a minus; with e = d - y of eq. 3 the gradient of e^2 is -2 e x, so that going down it is plus (the test
// with the printed sign diverges). Stable in the mean square for 0 < mu < 1/(3 L P), P the mean square of x.
// Thread: one; everything but prepare() is real-time.
#pragma once

#include <vector>

#include "core/active/delay_line.h"
#include "core/base/realtime.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::active {

inline constexpr int kMostTaps = 512;

struct LmsOptions {
  int taps = 35;            // 1 .. kMostTaps
  double step = 0.1;        // mu; with `normalised` the fraction of the largest stable step, 0 .. 1
  double leak = 1.0;        // gamma of eq. 2, 0 < gamma <= 1
  bool normalised = false;  // mu divided by the power of the values in the filter
};

class Lms {
 public:
  void prepare(const LmsOptions& options);
  void reset() noexcept;
  // Takes the input and what is to be made of it; gives the error before the step.
  double process(double x, double wanted) STILLCUT_RT;

  const double* weights() const noexcept { return weights_.data(); }
  int taps() const noexcept { return options_.taps; }

 private:
  LmsOptions options_;
  dsp::kernels::Kernels kernels_;
  DelayLine line_;
  std::vector<double> weights_;
};

// Half the step that makes the a-posteriori error vanish: e_after = e (1 - 2 mu' P), mu' = fraction/(2 (P + floor)).
inline double normalisedStep(double share, double power) noexcept {
  constexpr double kFloor = 1e-30;  // silence asks for no step
  return power > kFloor ? 0.5 * share / power : 0.0;
}

}  // namespace stillcut::active
