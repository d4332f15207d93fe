// FrameRing: the newest `window` frames of every channel, in one piece. Thread: worker; everything but prepare() is
// real-time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace stillcut::detect {

class FrameRing {
 public:
  void prepare(int channels, int window);
  void reset() noexcept;
  // x[channel * stride + frame]; at most a window at once.
  void push(const double* x, std::ptrdiff_t stride, std::size_t frames) noexcept;
  bool full() const noexcept { return seen_ >= window_; }
  std::size_t seen() const noexcept { return seen_; }  // frames since reset(), a window at most
  // The newest window, oldest first; good until the next push().
  std::span<const double> newest(int channel) const noexcept;
  std::size_t window() const noexcept { return window_; }

 private:
  std::size_t window_ = 0;
  std::size_t end_ = 0;  // of the frames, in each channel's row of two windows
  std::size_t seen_ = 0;
  std::vector<double> rows_;
};

}  // namespace stillcut::detect
