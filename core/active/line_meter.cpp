#include "core/active/line_meter.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::active {

namespace {

constexpr double kWindow = 0.2;  // [s]
constexpr int kAveraged = 5;     // windows

}  // namespace

void LineMeter::prepare(std::span<const Hertz> lines, Hertz rate) {
  static_assert(kActiveLines % dsp::kernels::kLanes == 0);
  kernels_ = dsp::kernels::bestKernels();
  count_ = 0;
  rotationRe_ = rotationIm_ = {};
  for (const Hertz line : lines) {
    if (count_ == kActiveLines || line.value <= 0.0 || line.value >= 0.5 * rate.value) continue;
    const auto l = static_cast<std::size_t>(count_++);
    frequency_[l] = line;
    rotationRe_[l] = std::cos(kTwoPi * line.value / rate.value);
    rotationIm_[l] = std::sin(kTwoPi * line.value / rate.value);
  }
  window_.resize(static_cast<std::size_t>(std::max(8.0, std::round(kWindow * rate.value))));
  for (std::size_t n = 0; n < window_.size(); ++n) {
    window_[n] = 1.0 - std::cos(kTwoPi * (static_cast<double>(n) + 0.5) / static_cast<double>(window_.size()));
  }
  reset();
}

void LineMeter::reset() noexcept {
  at_ = filled_ = 0;
  windows_ = 0;
  re_.fill(1.0);
  im_ = errorRe_ = errorIm_ = withoutRe_ = withoutIm_ = errorPower_ = withoutPower_ = {};
}

void LineMeter::take() STILLCUT_RT {
  for (std::size_t n = 0; n < filled_; ++n) {
    error_[n] *= window_[at_ + n];
    without_[n] *= window_[at_ + n];
  }
  kernels_.lineSums({.x = error_.data(),
                     .y = without_.data(),
                     .frames = filled_,
                     .lanes = static_cast<std::size_t>(kActiveLines),
                     .re = re_.data(),
                     .im = im_.data(),
                     .rotationRe = rotationRe_.data(),
                     .rotationIm = rotationIm_.data(),
                     .xRe = errorRe_.data(),
                     .xIm = errorIm_.data(),
                     .yRe = withoutRe_.data(),
                     .yIm = withoutIm_.data()});
  at_ += filled_;
  filled_ = 0;
  if (at_ == window_.size()) finish();
}

void LineMeter::finish() STILLCUT_RT {
  windows_ = std::min(windows_ + 1, kAveraged);
  for (std::size_t l = 0; l < kActiveLines; ++l) {
    const double error = errorRe_[l] * errorRe_[l] + errorIm_[l] * errorIm_[l];
    const double without = withoutRe_[l] * withoutRe_[l] + withoutIm_[l] * withoutIm_[l];
    errorPower_[l] += (error - errorPower_[l]) / windows_;
    withoutPower_[l] += (without - withoutPower_[l]) / windows_;
  }
  // Begun anew, so that no rounding of the oscillators adds up.
  re_.fill(1.0);
  im_ = errorRe_ = errorIm_ = withoutRe_ = withoutIm_ = {};
  at_ = 0;
}

LineAttenuation LineMeter::line(int index) const STILLCUT_RT {
  const auto l = static_cast<std::size_t>(index);
  const bool known = windows_ > 1 && errorPower_[l] > 0.0 && withoutPower_[l] > 0.0;
  return {frequency_[l], known ? 10.0 * std::log10(withoutPower_[l] / errorPower_[l]) : 0.0, known};
}

}  // namespace stillcut::active
