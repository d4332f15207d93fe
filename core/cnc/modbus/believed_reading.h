// BelievedReading: what a register says, as far as it is believed. A value that is not far from the one before is
// believed at once; one that is, and the first, when two readings on end show it: an answer that belonged to another
// question, or a bit that fell over, is not read twice.
// Thread: link thread. Real-time safe.
#pragma once

#include <cmath>

#include "core/base/time.h"

namespace stillcut::cnc {

class BelievedReading {
 public:
  // `far`: a difference from which on it is a jump. False: in doubt, so it is to be read again at once.
  bool take(double value, double far, Instant now) noexcept {
    const bool nearBelieved = ever_ && std::abs(value - value_) < far;
    const bool nearDoubted = inDoubt_ && std::abs(value - doubted_) < far;
    inDoubt_ = !nearBelieved && !nearDoubted;
    doubted_ = value;
    if (inDoubt_) return false;
    value_ = value;
    when_ = now;
    ever_ = true;
    return true;
  }
  // 0 before there was one.
  double value() const noexcept { return value_; }
  bool ever() const noexcept { return ever_; }
  Instant when() const noexcept { return when_; }  // of the value that is believed

 private:
  double value_ = 0.0, doubted_ = 0.0;
  bool ever_ = false, inDoubt_ = false;
  Instant when_{};
};

}  // namespace stillcut::cnc
