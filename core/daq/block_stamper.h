// BlockStamper: time, sequence and what is missing before it, for every block of a live device.
// Thread: driver; real-time.
#pragma once

#include "core/daq/sample_clock.h"
#include "core/model/sample_block.h"

namespace stillcut::daq {

class BlockStamper {
 public:
  // countsLosses: the device tells what it has lost; else time has to show it. lossUnit: as SampleClock says.
  void prepare(Hertz rate, int blockFrames, bool countsLosses, std::uint64_t lossUnit = 1) noexcept;
  // The stream was cut before the next block: how much is missing, the clock says.
  void anew() noexcept { anew_ = true; }
  // Samples may be missing before the next block, and nothing tells how many.
  void doubt() noexcept { doubtful_ = true; }
  // An empty block, to be filled.
  void begin(SampleBlock& block) const noexcept;
  // A filled block whose last frame was taken, or seen, at `seen`. lostFrames: what the device itself has reported.
  void finish(SampleBlock& block, Instant seen) noexcept;

 private:
  Hertz rate_{};
  int blockFrames_ = 1;
  SampleClock clock_;
  bool anew_ = false, doubtful_ = false;
  bool started_ = false;
  Instant ended_{};
  std::uint64_t sequence_ = 0;
};

}  // namespace stillcut::daq
