// The rate at which samples really come, against the clock that stamps the blocks: a straight line through the stamps
// (least squares), with the doubt that their scatter leaves. After a gap it starts anew.
// Thread: worker; real-time.
#pragma once

#include <cstdint>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/model/sample_block.h"

namespace stillcut::detect {

class RateWatch {
 public:
  void prepare(Hertz nominal) noexcept;
  void reset() noexcept;
  void push(const SampleBlock& block) noexcept;

  // Known after a second; 0 before.
  Hertz rate() const noexcept { return rate_; }
  Hertz sd() const noexcept { return sd_; }
  // Further from what was told than frequencies may be, and than the doubt explains.
  bool wrong() const noexcept;

 private:
  double nominal_ = 0.0;
  Instant first_{};
  double frames_ = 0.0;  // before this block
  double n_ = 0.0, meanX_ = 0.0, meanY_ = 0.0, xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
  Hertz rate_{}, sd_{};
};

}  // namespace stillcut::detect
