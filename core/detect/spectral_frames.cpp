#include "core/detect/spectral_frames.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {

void FrameRing::prepare(int channels, int window) {
  window_ = static_cast<std::size_t>(window);
  ring_.assign(static_cast<std::size_t>(channels) * window_, 0.0);
  reset();
}

void FrameRing::reset() noexcept {
  std::fill(ring_.begin(), ring_.end(), 0.0);
  head_ = seen_ = 0;
}

void FrameRing::push(const double* x, std::ptrdiff_t stride) noexcept {
  const std::size_t channels = ring_.size() / window_;
  for (std::size_t c = 0; c < channels; ++c) {
    ring_[c * window_ + head_] = x[static_cast<std::ptrdiff_t>(c) * stride];
  }
  head_ = head_ + 1 == window_ ? 0 : head_ + 1;
  seen_ = std::min(seen_ + 1, window_);
}

void FrameRing::copy(int channel, std::span<double> out) const noexcept {
  const auto begin = ring_.begin() + channel * static_cast<std::ptrdiff_t>(window_);
  const auto middle = begin + static_cast<std::ptrdiff_t>(head_);
  std::copy(begin, middle, std::copy(middle, begin + static_cast<std::ptrdiff_t>(window_), out.begin()));
}

void HarmonicMask::prepare(int bins, double binWidth) {
  free_.assign(static_cast<std::size_t>(bins), 0);
  binWidth_ = binWidth;
  first_ = 1;
  last_ = 0;
}

void HarmonicMask::update(Hertz spindle, Hertz doubt, double halfWidth, Hertz high) noexcept {
  const double spacing = spindle.value / binWidth_;
  const double spread = doubt.value / binWidth_;
  const auto size = free_.size();
  first_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(0.5 * spacing)));
  last_ = std::min(static_cast<std::size_t>(high.value / binWidth_), size - 2);
  for (std::size_t b = 0; b < size; ++b) {
    const double order = std::round(static_cast<double>(b) / spacing);
    const double distance = std::abs(static_cast<double>(b) - order * spacing);
    const double width = std::min(halfWidth + spread * order, 0.45 * spacing);
    free_[b] = b >= first_ && b <= last_ && distance >= width ? 1 : 0;
  }
}

double peakShift(double left, double middle, double right) noexcept {
  const double l = std::log(left + 1e-300);
  const double m = std::log(middle + 1e-300);
  const double r = std::log(right + 1e-300);
  const double curve = l - 2.0 * m + r;
  return curve < 0.0 ? std::clamp(0.5 * (l - r) / curve, -0.5, 0.5) : 0.0;
}

}  // namespace stillcut::detect
