// Orders: multiples of the spindle frequency.
// Thread: values, no state. Real-time.
#pragma once

#include <cmath>
#include <complex>
#include <span>

#include "core/base/units.h"

namespace stillcut::dsp {

// Distance of f from the nearest spindle harmonic in units of the spindle frequency, -0.5 .. 0.5.
inline double orderOffset(Hertz f, Hertz spindle) {
  const double order = f / spindle;
  return order - std::round(order);
}

inline double wrapAngle(double a) {
  a = std::fmod(a, kTwoPi);
  return a < 0.0 ? a + kTwoPi : a;
}
// To -pi .. pi.
inline double wrapPhase(double a) {
  return std::remainder(a, kTwoPi);
}

// Complex amplitude a of the tone Re(a e^{j 2 pi f t}), t = 0 at the first sample, by a rotated sum over the span
// (exact when the span holds whole periods).
std::complex<double> toneAmplitude(std::span<const double> x, Hertz f, Hertz rate) noexcept;

// Frequency of a tone near f from the phase it gains between two adjacent halves of the span; good while the true
// frequency is within rate / span size of f.
Hertz phaseDriftFrequency(std::span<const double> x, Hertz f, Hertz rate) noexcept;

}  // namespace stillcut::dsp
