#include "core/detect/spectral_frames.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {

void FrameRing::prepare(int channels, int window) {
  window_ = static_cast<std::size_t>(window);
  rows_.assign(static_cast<std::size_t>(channels) * 2 * window_, 0.0);
  reset();
}

void FrameRing::reset() noexcept {
  std::fill(rows_.begin(), rows_.end(), 0.0);
  end_ = window_;
  seen_ = 0;
}

void FrameRing::push(const double* x, std::ptrdiff_t stride, std::size_t frames) noexcept {
  const std::size_t row = 2 * window_;
  const bool full = end_ + frames > row;
  for (std::size_t c = 0; c * row < rows_.size(); ++c) {
    double* begin = rows_.data() + c * row;
    if (full) std::copy(begin + end_ - window_, begin + end_, begin);
    std::copy_n(x + static_cast<std::ptrdiff_t>(c) * stride, frames, begin + (full ? window_ : end_));
  }
  end_ = (full ? window_ : end_) + frames;
  seen_ = std::min(seen_ + frames, window_);
}

std::span<const double> FrameRing::newest(int channel) const noexcept {
  return {rows_.data() + static_cast<std::size_t>(channel) * 2 * window_ + end_ - window_, window_};
}

void HarmonicMask::prepare(int bins, double binWidth) {
  const auto size = static_cast<std::size_t>(bins);
  kernels_ = dsp::kernels::bestKernels();
  bins_ = size;
  free_.assign(dsp::kernels::wholeLanes(size), 0.0);
  binWidth_ = binWidth;
  first_ = 1;
  last_ = 0;
  for (auto& weights : weights_) weights.assign(size, 1.0);
  for (std::size_t b = 1; b < size; ++b) {
    const double f = static_cast<double>(b) * binWidth;
    weights_[0][b] = 1.0 / (f * f);
    weights_[2][b] = f * f;
  }
}

void HarmonicMask::update(Hertz spindle, Hertz doubt, double halfWidth, Hertz high) noexcept {
  const double spacing = spindle.value / binWidth_;
  const double spread = doubt.value / binWidth_;
  first_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(0.5 * spacing)));
  last_ = std::min(static_cast<std::size_t>(high.value / binWidth_), bins_ - 2);
  kernels_.maskHarmonics({spacing, spread, halfWidth, first_, last_, free_.size(), free_.data()});
}

}  // namespace stillcut::detect
