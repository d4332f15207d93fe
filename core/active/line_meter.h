// LineMeter: what named lines hold of two signals, the error and the same without control, now. Sums over Hann windows
// of a fifth of a second, about 5 Hz to either side of a line, and their power averaged over about a second. Thread:
// one; everything but prepare() is real-time.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/realtime.h"
#include "core/dsp/kernels/kernels.h"
#include "core/model/active_state.h"

namespace stillcut::active {

class LineMeter {
 public:
  // The first kActiveLines lines below half the rate count.
  void prepare(std::span<const Hertz> lines, Hertz rate);
  void reset() noexcept;
  void add(double error, double without) STILLCUT_RT {
    error_[filled_] = error;
    without_[filled_] = without;
    if (++filled_ == kChunk || at_ + filled_ == window_.size()) take();
  }
  int lines() const noexcept { return count_; }
  LineAttenuation line(int index) const STILLCUT_RT;

 private:
  static constexpr std::size_t kChunk = 64;
  using Lines = std::array<double, kActiveLines>;
  void take() STILLCUT_RT;
  void finish() STILLCUT_RT;

  dsp::kernels::Kernels kernels_;
  int count_ = 0;
  std::array<Hertz, kActiveLines> frequency_{};
  std::vector<double> window_;
  std::size_t at_ = 0;      // in the window, of the first value of the chunk
  std::size_t filled_ = 0;  // of the chunk
  std::array<double, kChunk> error_{}, without_{};
  Lines re_{}, im_{}, rotationRe_{}, rotationIm_{};
  Lines errorRe_{}, errorIm_{}, withoutRe_{}, withoutIm_{};
  Lines errorPower_{}, withoutPower_{};
  int windows_ = 0;  // averaged so far, at most a second's
};

}  // namespace stillcut::active
