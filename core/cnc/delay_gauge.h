// DelayGauge: what a delay typically is: the median of the last ones, which one stall does not move.
// Thread: one. Real-time safe.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/base/units.h"

namespace stillcut::cnc {

class DelayGauge {
 public:
  void take(Seconds delay) noexcept {
    last_[count_ % last_.size()] = delay.value;
    ++count_;
    auto sorted = last_;
    const std::size_t n = std::min(count_, last_.size());
    std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(n));
    typical_ = Seconds(sorted[n / 2]);
  }
  // 0: none measured yet.
  Seconds typical() const noexcept { return typical_; }

 private:
  std::array<double, 15> last_{};
  std::size_t count_ = 0;
  Seconds typical_{};
};

}  // namespace stillcut::cnc
