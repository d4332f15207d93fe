// Whether a block can be believed: finite, not clipped, not dead. What cannot be believed makes the verdicts invalid
// with a reason; it never reads as "stable".
// Thread: worker; check() and reset() are real-time.
#pragma once

#include <array>
#include <cstdint>

#include "core/detect/conditioned_block.h"
#include "core/model/cut_setup.h"
#include "core/model/sample_block.h"

namespace stillcut::detect {

class InputCheck {
 public:
  void prepare(const CutSetup& setup);
  // ReasonCode::None when the block is good. Looks at raw device units, so that a limit of the device shows.
  Reason check(const SampleBlock& block) noexcept;
  void reset() noexcept;

 private:
  struct Channel {
    float last = 0.0F;
    int run = 0;           // equal samples in a row, across blocks
    float extreme = 0.0F;  // largest magnitude so far
    int flatTops = 0;      // runs of equal samples at exactly that magnitude
  };
  Reason checkChannel(std::span<const float> samples, int index) noexcept;

  int deadRun_ = 0;  // samples
  std::array<Channel, kMaxChannels> channels_{};
};

}  // namespace stillcut::detect
