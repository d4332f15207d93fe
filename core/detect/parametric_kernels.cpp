#include "core/detect/parametric_kernels.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr std::size_t kLanes = SpindleRegressors::kLanes;

std::size_t padded(int harmonics) {
  return (static_cast<std::size_t>(std::max(harmonics, 1)) + kLanes - 1) / kLanes * kLanes;
}

double predict(const double* c, const double* s, const double* a, const double* b, std::size_t n) noexcept {
  std::array<double, kLanes> sum{};
  for (std::size_t i = 0; i < n; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) sum[k] += a[i + k] * c[i + k] + b[i + k] * s[i + k];
  }
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

void correct(const double* __restrict c, const double* __restrict s, double* __restrict a, double* __restrict b,
             std::size_t n, double keep, double gain) noexcept {
  for (std::size_t i = 0; i < n; ++i) {
    a[i] = keep * a[i] + gain * c[i];
    b[i] = keep * b[i] + gain * s[i];
  }
}

void rotate(double* __restrict c, double* __restrict s, const double* __restrict dc, const double* __restrict ds,
            std::size_t n) noexcept {
  for (std::size_t i = 0; i < n; ++i) {
    const double re = c[i] * dc[i] - s[i] * ds[i];
    s[i] = c[i] * ds[i] + s[i] * dc[i];
    c[i] = re;
  }
}

// e^{j l angle}, l = 1..active, by products; zero beyond.
void fill(double angle, int active, std::vector<double>& c, std::vector<double>& s) noexcept {
  const double re = std::cos(angle);
  const double im = std::sin(angle);
  double x = 1.0;
  double y = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double next = x * re - y * im;
    y = x * im + y * re;
    x = next;
    const bool used = i < static_cast<std::size_t>(active);
    c[i] = used ? x : 0.0;
    s[i] = used ? y : 0.0;
  }
}

}  // namespace

void SpindleRegressors::prepare(int harmonics) {
  for (auto* v : {&cos_, &sin_, &stepCos_, &stepSin_}) v->assign(padded(harmonics), 0.0);
  active_ = harmonics;
}

void SpindleRegressors::setActive(int harmonics) noexcept {
  active_ = std::clamp(harmonics, 1, static_cast<int>(size()));
}

void SpindleRegressors::align(double angle, double step) noexcept {
  fill(angle, active_, cos_, sin_);
  fill(step, active_, stepCos_, stepSin_);
}

void SpindleRegressors::advance() noexcept {
  rotate(cos_.data(), sin_.data(), stepCos_.data(), stepSin_.data(), cos_.size());
}

void NlmsHarmonics::prepare(int harmonics) {
  cos_.assign(padded(harmonics), 0.0);
  sin_.assign(padded(harmonics), 0.0);
}

void NlmsHarmonics::reset() noexcept {
  std::fill(cos_.begin(), cos_.end(), 0.0);
  std::fill(sin_.begin(), sin_.end(), 0.0);
}

void NlmsHarmonics::setGain(double mu, double lambda, int harmonics) noexcept {
  step_ = 2.0 * mu / harmonics;
  keep_ = lambda;
}

double NlmsHarmonics::process(double a, const SpindleRegressors& phi) noexcept {
  const double e = a - predict(phi.cosines(), phi.sines(), cos_.data(), sin_.data(), cos_.size());
  if (!std::isfinite(e)) {
    reset();
    return 0.0;
  }
  correct(phi.cosines(), phi.sines(), cos_.data(), sin_.data(), cos_.size(), keep_, step_ * e);
  return e;
}

double NlmsHarmonics::power(int l) const noexcept {
  const auto i = static_cast<std::size_t>(l - 1);
  return 0.5 * (cos_[i] * cos_[i] + sin_[i] * sin_[i]);
}

void ArKalman::prepare(double rv, double rw, double startVariance) noexcept {
  rv_ = rv;
  rw_ = rw;
  startVariance_ = startVariance;
  reset();
}

void ArKalman::reset() noexcept {
  theta_ = past_ = {};
  p_ = {};
  for (std::size_t i = 0; i < kOrder; ++i) p_[i][i] = startVariance_;
}

void ArKalman::process(double e) noexcept {
  Vector t{};
  double s = rw_;
  double prediction = 0.0;
  for (std::size_t i = 0; i < kOrder; ++i) {
    for (std::size_t j = 0; j < kOrder; ++j) t[i] += p_[i][j] * past_[j];
  }
  for (std::size_t i = 0; i < kOrder; ++i) {
    s += past_[i] * t[i];
    prediction += past_[i] * theta_[i];
  }
  const double gain = 1.0 / s;
  const double error = e - prediction;
  if (!std::isfinite(gain * error)) {
    reset();
    return;
  }
  for (std::size_t i = 0; i < kOrder; ++i) {
    theta_[i] += t[i] * gain * error;
    for (std::size_t j = 0; j < kOrder; ++j) p_[i][j] -= gain * (t[i] * t[j]);  // stays symmetric to the last bit
    p_[i][i] += rv_;
  }
  for (std::size_t i = kOrder - 1; i > 0; --i) past_[i] = past_[i - 1];
  past_[0] = e;
}

}  // namespace stillcut::detect
