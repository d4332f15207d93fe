// ClockAligner: the samples of one device at the times of another's. Each device counts its own crystal; its driver's
// stamps put both on the clock of this computer, smoothed (sample_clock.h). Between two stamps a sample's time lies on
// the straight line through them, and a value between samples is a windowed sinc of them (16 taps of the slower of the
// two rates, Blackman: flat to 0.4 of it, images below -70 dB; J. O. Smith, Digital Audio Resampling, 2002).
// Thread: one; after prepare() real-time.
#pragma once

#include <cstdint>
#include <vector>

#include "core/model/sample_block.h"

namespace stillcut::daq {

class ClockAligner {
 public:
  // `from`: rate of the blocks pushed; `to`: rate at which they are asked for. `history`: frames kept.
  void prepare(Hertz from, Hertz to, int channels, int history);
  // The next block of the device. After a gap, what lies before it is forgotten.
  void push(const SampleBlock& block) noexcept;

  // Anything has come since the beginning or the last gap.
  bool begun() const noexcept { return anchorCount_ > 0; }
  // Once begun: value() is known for times in [first(), last()].
  Instant first() const noexcept;
  Instant last() const noexcept;
  // Channel `c` at `time`, device units.
  float value(int c, Instant time) const noexcept;

  // How well the straight line through the stamps holds: root mean square of what a stamp is off from where the one
  // before had put it, over some seconds. So far the two devices may wander apart; by which constant their transports
  // differ does not show in it.
  Seconds residual() const noexcept;
  // As the stamps have it.
  Hertz rate() const noexcept { return Hertz(period_ > 0.0 ? 1.0 / period_ : 0.0); }

 private:
  struct Anchor {
    std::int64_t frame = 0;
    double time = 0.0;  // s since origin_
  };
  double frameAt(double seconds) const noexcept;

  double nominal_ = 0.0;  // s per frame
  double period_ = 0.0;
  double width_ = 8.0;  // half of the kernel [frames]
  double cut_ = 1.0;    // of the kernel, relative to this device's rate
  int channels_ = 0;
  std::int64_t history_ = 0;
  std::vector<float> samples_;  // [channel * history + frame % history]
  std::vector<Anchor> anchors_;
  std::size_t anchorCount_ = 0, newestAnchor_ = 0;
  std::int64_t begin_ = 0, end_ = 0;  // frames held
  bool started_ = false;
  Instant origin_{};
  double residual_ = 0.0;  // mean square [s^2]
};

}  // namespace stillcut::daq
