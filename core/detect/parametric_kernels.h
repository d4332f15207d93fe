// The two recursions of the parametric detector (van Dijk 2010), one file for the code that runs per sample.
//
// SpindleRegressors: cos(l phi), sin(l phi), l = 1..L, of the integrated spindle angle, once for all channels.
// NlmsHarmonics: eq. 19, one channel. ||phi||^2 = L whatever the speed (the paper computes it recursively).
// ArKalman: eq. 25 with N_d = 4, the sign of eq. 25c; D(q) = 1 - sum theta_n q^-n.
// Sums run in kLanes independent lanes, so that vector code adds in the same order as plain code: no fast-math, and the
// same results on every machine.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stillcut::detect {

class SpindleRegressors {
 public:
  static constexpr std::size_t kLanes = 8;

  void prepare(int harmonics);
  // Harmonics in use, at most as prepared: those below the band's end. The others are 0.
  void setActive(int harmonics) noexcept;
  // Angle [rad] of the next frame and step per frame [rad].
  void align(double angle, double step) noexcept;
  void advance() noexcept;

  int active() const noexcept { return active_; }
  std::size_t size() const noexcept { return cos_.size(); }  // padded to whole lanes
  const double* cosines() const noexcept { return cos_.data(); }
  const double* sines() const noexcept { return sin_.data(); }

 private:
  int active_ = 0;
  std::vector<double> cos_, sin_, stepCos_, stepSin_;
};

class NlmsHarmonics {
 public:
  void prepare(int harmonics);
  void reset() noexcept;
  // mu and lambda of eq. 19.
  void setGain(double mu, double lambda, int harmonics) noexcept;
  // eq. 19b, then 19a: the prediction error.
  double process(double a, const SpindleRegressors& phi) noexcept;
  // Mean square of harmonic l = 1.. as estimated.
  double power(int l) const noexcept;

 private:
  double step_ = 0.0;  // 2 mu / ||phi||^2
  double keep_ = 1.0;
  std::vector<double> cos_, sin_;  // theta_p
};

class ArKalman {
 public:
  static constexpr std::size_t kOrder = 4;
  using Vector = std::array<double, kOrder>;

  // rv, rw of eq. 21; startVariance: Sigma_0 = startVariance * I.
  void prepare(double rv, double rw, double startVariance) noexcept;
  void reset() noexcept;
  // One residual, scaled; updates theta. A result that is not finite restarts the filter.
  void process(double e) noexcept;
  const Vector& theta() const noexcept { return theta_; }
  void setTheta(const Vector& theta) noexcept { theta_ = theta; }

 private:
  double rv_ = 0.0;
  double rw_ = 1.0;
  double startVariance_ = 1.0;
  Vector theta_{};
  Vector past_{};  // e(k-1) .. e(k-4)
  std::array<Vector, kOrder> p_{};
};

}  // namespace stillcut::detect
