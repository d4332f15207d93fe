#include "core/detect/harmonic_kalman.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

// Powers 1..n of the unit number (c, s) into re, im.
void powers(double c, double s, std::size_t n, double* re, double* im) noexcept {
  double r = c;
  double i = s;
  for (std::size_t k = 0; k < n; ++k) {
    re[k] = r;
    im[k] = i;
    const double next = r * c - i * s;
    i = r * s + i * c;
    r = next;
  }
}

}  // namespace

double harmonicGain(double lambda, int harmonics) noexcept {
  const double n = harmonics;
  const double p = lambda * n + std::sqrt(lambda * lambda * n * n + 2.0 * lambda);
  return p / (n * p + 1.0);
}

double lambdaForGain(double gain, int harmonics) noexcept {
  const double n = harmonics;
  const double p = gain / std::max(1.0 - n * gain, 1e-3);
  return p * p / (2.0 * (n * p + 1.0));
}

void HarmonicKalman::prepare(int channels, int harmonics) {
  channels_ = channels;
  harmonics_ = harmonics;
  padded_ = static_cast<std::size_t>((harmonics + kLanes - 1) / kLanes * kLanes);
  for (auto* v : {&zr_, &zi_, &wr_, &wi_}) v->assign(padded_, 0.0);
  for (auto* v : {&ar_, &ai_}) v->assign(padded_ * static_cast<std::size_t>(channels), 0.0);
  setActive(harmonics);
}

void HarmonicKalman::reset() noexcept {
  std::fill(ar_.begin(), ar_.end(), 0.0);
  std::fill(ai_.begin(), ai_.end(), 0.0);
}

void HarmonicKalman::setActive(int count) noexcept {
  const int clamped = std::clamp(count, 0, harmonics_);
  if (clamped == active_) return;
  active_ = clamped;
  used_ = static_cast<std::size_t>((active_ + kLanes - 1) / kLanes * kLanes);
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
    std::fill(ar_.begin() + static_cast<std::ptrdiff_t>(c * padded_ + static_cast<std::size_t>(active_)),
              ar_.begin() + static_cast<std::ptrdiff_t>((c + 1) * padded_), 0.0);
    std::fill(ai_.begin() + static_cast<std::ptrdiff_t>(c * padded_ + static_cast<std::size_t>(active_)),
              ai_.begin() + static_cast<std::ptrdiff_t>((c + 1) * padded_), 0.0);
  }
}

void HarmonicKalman::align(double angle, double step) noexcept {
  const auto n = static_cast<std::size_t>(active_);
  powers(std::cos(angle), std::sin(angle), n, zr_.data(), zi_.data());
  powers(std::cos(step), std::sin(step), n, wr_.data(), wi_.data());
  // Unused lanes stay silent.
  for (std::size_t k = n; k < padded_; ++k) zr_[k] = zi_[k] = wr_[k] = wi_[k] = 0.0;
}

void HarmonicKalman::process(const double* x, double* rest) noexcept {
  const double* zr = zr_.data();
  const double* zi = zi_.data();
  for (int c = 0; c < channels_; ++c) {
    double* ar = ar_.data() + static_cast<std::size_t>(c) * padded_;
    double* ai = ai_.data() + static_cast<std::size_t>(c) * padded_;
    double sum[kLanes] = {};
    for (std::size_t n = 0; n < used_; n += kLanes) {
      for (std::size_t l = 0; l < kLanes; ++l) sum[l] += ar[n + l] * zr[n + l] - ai[n + l] * zi[n + l];
    }
    const double innovation = x[c] - ((sum[0] + sum[1]) + (sum[2] + sum[3]));
    const double g = gain_ * innovation;
    for (std::size_t n = 0; n < used_; ++n) {
      ar[n] += g * zr[n];
      ai[n] -= g * zi[n];
    }
    // eq. 22 subtracts the corrected estimate: H q = H q^- + H K e, and H K = g N.
    rest[c] = innovation * (1.0 - gain_ * active_);
  }
  for (std::size_t n = 0; n < used_; ++n) {
    const double r = zr_[n] * wr_[n] - zi_[n] * wi_[n];
    zi_[n] = zr_[n] * wi_[n] + zi_[n] * wr_[n];
    zr_[n] = r;
  }
}

double HarmonicKalman::power(int channel, int n) const noexcept {
  const std::size_t i = static_cast<std::size_t>(channel) * padded_ + static_cast<std::size_t>(n - 1);
  return ar_[i] * ar_[i] + ai_[i] * ai_[i];
}

}  // namespace stillcut::detect
