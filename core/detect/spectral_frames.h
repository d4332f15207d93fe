// SpectralFrames: the newest window of every channel, and which bins of its spectrum belong to the spindle.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <span>
#include <vector>

#include "core/base/units.h"

namespace stillcut::detect {

// Newest `window` frames of every channel.
class FrameRing {
 public:
  void prepare(int channels, int window);
  void reset() noexcept;
  // One value per channel, `stride` apart.
  void push(const double* x, std::ptrdiff_t stride) noexcept;
  bool full() const noexcept { return seen_ >= window_; }
  // Oldest first.
  void copy(int channel, std::span<double> out) const noexcept;
  std::size_t window() const noexcept { return window_; }

 private:
  std::size_t window_ = 0;
  std::size_t head_ = 0;
  std::size_t seen_ = 0;
  std::vector<double> ring_;
};

// Bins of the spindle harmonics (the tooth-passing ones are among them): free() is 1 between them and 0 on them.
class HarmonicMask {
 public:
  void prepare(int bins, double binWidth);
  // halfWidth: bins to either side. doubt: of the spindle frequency, widens the mask with the order.
  // Below half the spindle frequency and above `high` nothing is free.
  void update(Hertz spindle, Hertz doubt, double halfWidth, Hertz high) noexcept;
  bool free(std::size_t bin) const noexcept { return free_[bin] != 0; }
  std::size_t first() const noexcept { return first_; }
  std::size_t last() const noexcept { return last_; }  // inclusive; the outermost bins are never in reach

 private:
  double binWidth_ = 1.0;
  std::size_t first_ = 1;
  std::size_t last_ = 0;
  std::vector<unsigned char> free_;
};

// Place of a peak between bins, from a parabola through the logarithms of three powers: -0.5 .. 0.5.
double peakShift(double left, double middle, double right) noexcept;

}  // namespace stillcut::detect
