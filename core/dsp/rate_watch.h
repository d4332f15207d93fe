// The rate at which samples really come, against the clock that stamps the blocks: straight lines of one slope through
// the stamps (least squares), a new line after each gap. What is older than twenty seconds is forgotten: a crystal
// warms up, a device is set anew.
//
// Its error: stamps are filtered, so neighbours err alike, and a line through them scatters less than it is wrong. The
// correlation of neighbours is read from the mean square of their differences (J. von Neumann, Ann. Math. Stat. 12,
// 1941) and widens it as that of an autoregressive process of first order, up to where all err as one. What is
// wrong with all stamps alike over the whole line does not show in it: a transport's lag that wanders by a millisecond
// from its begin to its end is always allowed for.
// Thread: worker; real-time.
#pragma once

#include <cstdint>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/model/sample_block.h"

namespace stillcut::dsp {

class RateWatch {
 public:
  void prepare(Hertz nominal) noexcept;
  void reset() noexcept;
  void push(const SampleBlock& block) noexcept;

  // Known after a second; 0 before.
  Hertz rate() const noexcept { return long_.rate; }
  Hertz sd() const noexcept { return long_.sd; }
  // Seconds after which a device's rate is likely to be known; 0: it is, or the device's source is sure of it.
  double pending() const noexcept { return pending_ ? pendingFor_ : 0.0; }
  // Further from the nominal rate than frequencies may be, and than the uncertainty explains.
  bool wrong() const noexcept { return wrong(long_) || wrong(recent_); }

 private:
  struct Lines {
    void push(const SampleBlock& block, double nominal) noexcept;

    Instant first{};  // of the line that runs
    double frames = 0.0, n = 0.0, meanX = 0.0, meanY = 0.0, lastY = 0.0;
    double all = 0.0, lines = 0.0, seconds = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, steps = 0.0;
    Hertz rate{}, sd{};
  };
  bool wrong(const Lines& lines) const noexcept;

  double nominal_ = 0.0;
  bool unchecked_ = false, pending_ = false;  // the block before; since one that was, nothing is known
  double pendingFor_ = 0.0;
  Lines long_, recent_;  // begun up to twenty and up to ten seconds ago
};

}  // namespace stillcut::dsp
