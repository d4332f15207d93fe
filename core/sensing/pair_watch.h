// Two channels that claim different axes and deliver the same: a doubled input, whatever its gain or sign. Each sensor
// has its own noise, so that two of them are never proportional to 80 dB; nor, where the steps of whole numbers hide
// that, to what the rounding of both leaves, a twelfth of a step squared each, 40 dB below them. A channel that says no
// axis claims the one it is called by. One pair is compared at a time, in turn.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <cstddef>
#include <vector>

#include "core/dsp/finding.h"
#include "core/model/cut_setup.h"
#include "core/model/sample_block.h"

namespace stillcut::detect {

class PairWatch {
 public:
  void prepare(const CutSetup& setup);
  void reset() noexcept;
  void push(const SampleBlock& block) noexcept;

  // The channel that delivers what `channel` ought to measure alone; -1: none.
  int twinOf(int channel) const noexcept;

 private:
  struct Pair {
    int first = 0, second = 0;
    dsp::Finding same;
  };
  void begin() noexcept;
  void judge(Pair& pair) noexcept;

  std::vector<Pair> pairs_;
  std::size_t turn_ = 0;
  int window_ = 0;
  int frames_ = 0;
  double xStep_ = 0.0, yStep_ = 0.0;  // least differences of two values so far; 0: none
  double x0_ = 0.0, y0_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, yy_ = 0.0, xy_ = 0.0;
};

}  // namespace stillcut::detect
