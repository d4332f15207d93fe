// f(mu) at one speed and depth for mu on the unit circle: zero exactly where mu is a Floquet multiplier of the cut,
// real for real mu, and ~ mu^states far outside, so that states - (rounds of arg f along the circle) multipliers lie
// outside. What the search for limits needs of a cut whose pitch, helix or process damping make more of the depth than
// a factor. Thread: const members from any thread, each with its own meter; allocates.
#pragma once

#include <complex>
#include <span>

#include "core/base/units.h"
#include "core/milling/stability/work_meter.h"

namespace stillcut::milling {

enum class Fineness { Rough, Fine };  // rough: five to six digits; fine: two more

class CircleFunction {
 public:
  CircleFunction() = default;
  CircleFunction(const CircleFunction&) = delete;
  CircleFunction& operator=(const CircleFunction&) = delete;
  virtual ~CircleFunction() = default;

  virtual int states() const = 0;  // of the structure, two a mode
  // f at mu = exp(i angle), angles within 0 .. pi [rad]; false when stopped.
  virtual bool sample(double depth, std::span<const double> angles, Fineness fineness,
                      std::span<std::complex<double>> out, WorkMeter& meter) const = 0;
  // The largest line of the motion that belongs to a multiplier exp(i angle); 0 when stopped.
  virtual Hertz chatterFrequency(double angle, double depth, WorkMeter& meter) const = 0;
  // About how far the motion of one period grows at most, in e-folds, at a depth; no expansion survives very many.
  virtual double growthAt(double depth) const = 0;
};

}  // namespace stillcut::milling
