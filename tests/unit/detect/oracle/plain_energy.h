// Caliskan 2018 eq. 16-29 for one channel, equation by equation: slow, nothing shared, nothing vectorised.
#pragma once

#include <cmath>
#include <deque>
#include <vector>

#include "core/base/units.h"
#include "tests/support/plain_band_pass.h"

namespace stillcut::detect::testing {

// eq. 16-22 with the settled gain: K = g (1, 0, 1, 0, ..).
class PlainHarmonics {
 public:
  explicit PlainHarmonics(int harmonics) : q_(2 * static_cast<std::size_t>(harmonics), 0.0) {}

  // angle [rad] of this frame; count: harmonics in use; the others are forgotten.
  double process(double x, double angle, int count, double gain) {
    const double turn = angle - angle_;
    angle_ = angle;
    double predicted = 0.0;
    for (std::size_t n = 0; n < q_.size() / 2; ++n) {
      if (static_cast<int>(n) >= count) {
        q_[2 * n] = q_[2 * n + 1] = 0.0;
        continue;
      }
      const double c = std::cos(static_cast<double>(n + 1) * turn);  // Phi, eq. 19
      const double s = std::sin(static_cast<double>(n + 1) * turn);
      const double a = c * q_[2 * n] - s * q_[2 * n + 1];
      q_[2 * n + 1] = s * q_[2 * n] + c * q_[2 * n + 1];
      q_[2 * n] = a;
      predicted += a;
    }
    double corrected = 0.0;
    for (int n = 0; n < count; ++n) {
      double& a = q_[2 * static_cast<std::size_t>(n)];
      a += gain * (x - predicted);  // eq. 21
      corrected += a;
    }
    return x - corrected;  // eq. 22
  }
  double power(int n) const { return std::norm(std::complex(q_[2 * n - 2], q_[2 * n - 1])); }  // eq. 29

 private:
  std::vector<double> q_;
  double angle_ = 0.0;
};

// One band: eq. 23 (Butterworth, 4 poles), 24-27 with lag D, averaged over a hop.
class PlainBand {
 public:
  void tune(Hertz low, Hertz high, Hertz rate) {
    rate_ = rate.value;
    filter_.tune(low, high, rate);
  }
  void setLag(int lag) { lag_ = lag; }
  void process(double rest) { s_.push_front(filter_.process(rest)); }
  // Over the newest `frames`.
  void estimate(int frames) {
    s_.resize(static_cast<std::size_t>(4 * lag_ + frames), 0.0);  // silence before the first
    double signal = 0.0;
    double difference = 0.0;
    for (int k = 0; k < frames; ++k) {
      const auto s = [&](int lags) { return s_[static_cast<std::size_t>(k + lags * lag_)]; };
      const auto y = [&](int lags) { return s(lags) - s(lags + 1); };  // y_k = s_k - s_{k-D}
      signal += s(2) * s(2) - s(3) * s(1);                             // Psi[s_{k-2D}]
      difference += (y(1) * y(1) - y(2) * y(0)) + (y(2) * y(2) - y(3) * y(1));
    }
    const double cosine = 1.0 - difference / (4.0 * signal);  // eq. 26
    valid = signal > 0.0 && 1.0 - cosine * cosine > 1e-3;
    if (!valid) return;
    frequency = std::acos(cosine) * rate_ / (kTwoPi * lag_);
    power = signal / frames / (1.0 - cosine * cosine);  // eq. 27
  }

  double power = 0.0;
  double frequency = 0.0;
  bool valid = false;

 private:
  test::PlainBandPass filter_;
  double rate_ = 1.0;
  int lag_ = 1;
  std::deque<double> s_;
};

// eq. 28.
inline double plainEnergyRatio(const PlainHarmonics& harmonics, int count, double spindle,
                               const std::vector<PlainBand>& bands, int eta) {
  double chatter = 0.0;
  for (const PlainBand& b : bands) {
    if (b.frequency > 0.0) chatter += b.power * std::pow(b.frequency, 2.0 * eta);
  }
  double forced = 0.0;
  for (int n = 1; n <= count; ++n) forced += harmonics.power(n) * std::pow(n * spindle, 2.0 * eta);
  return chatter + forced > 0.0 ? chatter / (chatter + forced) : 0.0;
}

}  // namespace stillcut::detect::testing
