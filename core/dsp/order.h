// Orders: multiples of the spindle frequency.
// Thread: values, no state. Real-time.
#pragma once

#include <cmath>

#include "core/base/units.h"

namespace stillcut::dsp {

// Distance of f from the nearest spindle harmonic in units of the spindle frequency, -0.5 .. 0.5.
inline double orderOffset(Hertz f, Hertz spindle) {
  const double order = f / spindle;
  return order - std::round(order);
}

// To -pi .. pi.
inline double wrapPhase(double a) {
  return std::remainder(a, kTwoPi);
}

}  // namespace stillcut::dsp
