// The last values of a signal, newest first, always in one piece of memory, as the kernels read them.
// Thread: one; everything but prepare() is real-time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/dsp/kernels/kernels.h"

namespace stillcut::active {

class DelayLine {
 public:
  void prepare(std::size_t taps) {
    size_ = dsp::kernels::wholeLanes(std::max<std::size_t>(1, taps));
    room_ = 8 * size_;
    values_.assign(room_ + size_, 0.0);
    at_ = room_;
  }
  void reset() noexcept {
    at_ = room_;  // what lies before is written before it is read
    std::fill(values_.begin() + static_cast<std::ptrdiff_t>(room_), values_.end(), 0.0);
  }
  void push(double value) noexcept {
    if (at_ == 1) {  // once in `room_` values: bring the newest back to the end
      std::copy(values_.begin() + 1, values_.begin() + 1 + static_cast<std::ptrdiff_t>(size_),
                values_.begin() + static_cast<std::ptrdiff_t>(room_));
      at_ = room_;
    }
    values_[--at_] = value;
  }
  // data()[k] is the value k steps ago; size() of them, a multiple of kLanes. data()[-1] may be read.
  const double* data() const noexcept { return values_.data() + at_; }
  std::size_t size() const noexcept { return size_; }

 private:
  std::vector<double> values_;
  std::size_t size_ = 0, room_ = 0, at_ = 0;
};

}  // namespace stillcut::active
