// The paper's Kalman filter with its whole covariance: Caliskan 2018 eq. 16-22, nothing settled beforehand.
//
// Phi of eq. 19 only turns each pair of states, and Q = lambda R I does not notice: in the frame that turns with the
// spindle P stands still but for eq. 20's Q, and H turns, h = (cos n theta, sin n theta). So the filter costs one pass
// over half of P per frame, which does eq. 20 and prepares P h for the next frame; all channels share it.
// Against RotatingHarmonicFilter with the settled gain: right from the first turn on, and with harmonics that are close
// against the filter's memory, at some twenty times the cost.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

class FullHarmonicKalman {
 public:
  void prepare(int channels, int harmonics, const dsp::kernels::Kernels& kernels);
  void reset();
  // Uses only the first `count`.
  void setActive(int count);
  int active() const { return active_; }
  // Q / R of eq. 20.
  void setLambda(double lambda);

  // Spindle angle of the next frame and turn per frame [rad]; once before the first process().
  void align(double angle, double step);
  // Every channel: x[channel * stride + frame] to the rest after correction (eq. 22), rest[channel * residualStride +
  // frame]. Numbers that are not finite start the filter anew and leave silence.
  void process(const double* x, std::ptrdiff_t stride, double* residual, std::ptrdiff_t residualStride,
               std::size_t frames);

  // Amplitude squared of harmonic n (1-based) of a channel (eq. 29).
  double power(int channel, int n) const;
  // A_n of x = Re sum A_n e^{j n theta}, of the first harmonics.
  void amplitudes(int channel, std::span<std::complex<double>> out) const;
  // Sum of weight[n - 1] times that over the harmonics; weight in whole lanes.
  double weightedPower(int channel, const double* weight) const;

 private:
  dsp::kernels::CovarianceRun run();

  dsp::kernels::Kernels kernels_;
  std::size_t channels_ = 0;
  int harmonics_ = 0;
  int active_ = 0;
  std::size_t lanes_ = 0;
  double lambda_ = 0.0;
  double angle_ = 0.0;
  double step_ = 0.0;
  std::size_t turned_ = 0;  // frames since the regressors were made
  std::vector<double> p_, ph_, h_, rotationRe_, rotationIm_, drift_, states_, scratch_;
};

}  // namespace stillcut::detect
