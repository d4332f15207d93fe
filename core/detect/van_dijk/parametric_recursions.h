// The two recursions of the parametric detector (van Dijk 2010): NLMS on the spindle harmonics of the integrated
// spindle angle (eq. 19; |phi|^2 = L whatever the speed, the paper computes it recursively), then the random-walk
// Kalman filter of an AR(4) on what they leave (eq. 25, the sign of 25c): D(q) = 1 - sum theta_n q^-n. Thread: worker;
// everything but prepare() is real-time.
#pragma once

#include <array>

#include "core/detect/turning_harmonics.h"

namespace stillcut::detect {

inline constexpr std::size_t kArOrder = 4;
using ArCoefficients = std::array<double, kArOrder>;

class ParametricRecursions {
 public:
  // rv, rw of eq. 21; startVariance: Sigma_0 = startVariance * I.
  struct Noise {
    double rv = 0.0;
    double rw = 1.0;
    double startVariance = 1.0;
  };
  void prepare(int channels, int harmonics, const Noise& noise, const dsp::kernels::Kernels& kernels);
  void reset();

  // Harmonics in use; mu and lambda of eq. 19.
  void tune(int active, double mu, double lambda);
  int active() const { return harmonics_.active(); }
  // Spindle angle of the next frame and turn per frame [rad].
  void align(double angle, double step) { harmonics_.align(angle, step); }
  // One channel: eq. 19b to `rest`, times `scale` to eq. 25; adds theta of every frame. What is not finite starts the
  // channel anew.
  void process(int channel, const double* x, double* rest, std::size_t frames, double scale, ArCoefficients& thetaSum);
  // After every channel has had the same frames.
  void advance(std::size_t frames) { harmonics_.advance(frames); }

  ArCoefficients theta(int channel) const;
  void setTheta(int channel, const ArCoefficients& theta);
  // Sum of weight[l - 1] times the mean square of harmonic l as estimated; weight in whole lanes.
  double weightedPower(int channel, const double* weight) const {
    return 0.5 * harmonics_.weightedPower(channel, weight);
  }

 private:
  void restart(dsp::kernels::ArState& ar) const;

  dsp::kernels::Kernels kernels_;
  Noise noise_;
  RotatingHarmonicFilter harmonics_;
  std::vector<dsp::kernels::ArState> ar_;
};

}  // namespace stillcut::detect
