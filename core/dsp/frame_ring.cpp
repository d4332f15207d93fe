#include "core/dsp/frame_ring.h"

#include <algorithm>

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

}  // namespace stillcut::detect
