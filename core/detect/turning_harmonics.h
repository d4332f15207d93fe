// A signal's harmonics of the spindle, followed by a recursion with a settled gain, and what they leave of it.
//
// The states q_n = A e^{j n theta} turn with the spindle and are measured by their real parts:
//   e = x - sum Re q_n,  q_n <- e^{j n step} (keep q_n + gain e).
// Kalman filter (Caliskan 2018 eq. 16-22; Phi of eq. 19 turns, H = [1 0 1 0 ..]): the covariance does not depend on the
// data (eq. 20) and settles to P = p I between sparse harmonics, with p^2 / (2 (N p + R)) = lambda R per step, hence
// one gain g = p / (N p + R) for every harmonic and channel, keep = 1. Departure from the paper: g is used from the
// start instead of the settling P (which only shortens the first turns). NLMS (van Dijk 2010 eq. 19): gain = 2 mu /
// |phi|^2, keep = lambda; theta_p cos, sin are q in the frame that turns. The plain recursions of both papers are the
// oracles in the tests. Thread: worker; everything but prepare() is real-time.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

// Converged gain for a ratio lambda = Q/R and N harmonics, and back.
double harmonicGain(double lambda, int harmonics);
double lambdaForGain(double gain, int harmonics);

class RotatingHarmonicFilter {
 public:
  void prepare(int channels, int harmonics, const dsp::kernels::Kernels& kernels);
  void reset();
  int harmonics() const { return harmonics_; }
  // Uses only the first `count` (those below the usable band at the present speed).
  void setActive(int count);
  int active() const { return active_; }
  void setGain(double gain, double keep = 1.0);

  // Spindle angle of the next frame and turn per frame [rad]. An angle that is not where the last frames led turns the
  // states along.
  void align(double angle, double step);
  // Predicts one channel, corrects its harmonics, writes the rest times `after`. A rest that is not finite starts the
  // channel anew and leaves silence.
  void process(int channel, const double* x, double* residual, std::size_t frames, double after);
  // Every channel: x[channel * stride + frame], rest the same with residualStride.
  void process(const double* x, std::ptrdiff_t stride, double* residual, std::ptrdiff_t residualStride,
               std::size_t frames, double after);
  // The same for a kernel that does more with each rest; finished() is to follow.
  dsp::kernels::HarmonicRun run(int channel, const double* x, double* residual, std::size_t frames, double after);
  bool finished(int channel, double* residual, std::size_t frames);
  // After the correction: x - sum Re q (Caliskan 2018 eq. 22), as a part of the rest before it.
  double afterCorrection() const { return 1.0 - gain_ * active_; }
  // After every channel has had the same frames.
  void advance(std::size_t frames);

  // Amplitude squared of harmonic n (1-based) of a channel (eq. 29).
  double power(int channel, int n) const;
  // A_n: q_n against the spindle's angle, of the first harmonics.
  void amplitudes(int channel, std::span<std::complex<double>> out) const;
  // Sum of weight[n - 1] times that over the harmonics; weight in whole lanes.
  double weightedPower(int channel, const double* weight) const;

 private:
  std::size_t row(int channel) const { return static_cast<std::size_t>(channel) * padded_; }
  void makeTurn();

  dsp::kernels::Kernels kernels_;
  int channels_ = 0;
  int harmonics_ = 0;
  int active_ = 0;
  std::size_t padded_ = 0;
  std::size_t used_ = 0;  // whole lanes with the active ones
  double gain_ = 0.0;
  double keep_ = 1.0;
  double angle_ = 0.0;
  double step_ = 0.0;
  std::vector<double> re_, im_;                  // states for the next frame, [channel * padded + n]
  std::vector<double> rotationRe_, rotationIm_;  // keep e^{j n step}; 0 beyond the active ones
  std::vector<double> jumpRe_, jumpIm_;          // of the angle, scratch
};

}  // namespace stillcut::detect
