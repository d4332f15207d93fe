// Feintuch's recursive LMS (Ford 2013 eq. 1a, 1b, 5; Feintuch, Proc. IEEE 64, 1976) for the secondary path:
//   r^(n) = sum a_k y(n-1-k) + sum b_k r^(n-1-k),  e = r - r^,  a_k += 2 mu e y(n-1-k),  b_k += 2 mu e r^(n-1-k)
// Eq. 1b prints the input x in the feedback weights; the recursive part is driven by the filter's own past output, and
// with e = r - r^ both signs are plus, as in lms.h. Backward 0: the plain LMS of a finite response.
// The step is no true gradient and may leave the stable region: the result is to be checked (checkPath).
// Thread: one; everything but prepare() is real-time.
#pragma once

#include <vector>

#include "core/active/delay_line.h"
#include "core/active/path_model.h"
#include "core/base/realtime.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::active {

struct IdentifierOptions {
  int forward = 35;         // taps of A
  int backward = 35;        // taps of B; 0: finite response
  int delay = 0;            // of the output before the first tap (path_model.h) [samples]
  double step = 5e-5;       // mu; with `normalised` a fraction, 0 .. 1
  bool normalised = false;  // divided by the power in both lines, which should then be of one size
};

class PathIdentifier {
 public:
  void prepare(const IdentifierOptions& options);
  // What the sensor reads now; gives the error of the model's prediction. Then output() tells what is written next.
  double reading(double r) STILLCUT_RT;
  void output(double y) STILLCUT_RT { outputs_.push(y); }

  PathModel model() const;  // allocates

 private:
  IdentifierOptions options_;
  dsp::kernels::Kernels kernels_;
  DelayLine outputs_, predictions_;
  std::vector<double> forward_, backward_;  // padded
};

}  // namespace stillcut::active
