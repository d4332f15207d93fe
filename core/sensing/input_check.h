// Whether a block can be believed: finite, not clipped (clip_watch.h), not dead. What cannot be believed makes the
// verdicts invalid with a reason; it never reads as "stable".
//
// A sensor of what only changes (acceleration, velocity, sound) that stands still is dead. A force, a current or a
// displacement may rest: they are dead where every channel stands still, since then nothing is heard. A speed beside
// them is told and no sensor of the cut.
// Thread: worker; check() and reset() are real-time.
#pragma once

#include <array>
#include <cstdint>

#include "core/dsp/clip_watch.h"
#include "core/model/cut_setup.h"
#include "core/model/sample_block.h"
#include "core/sensing/conditioned_block.h"

namespace stillcut::detect {

// Rests at zero: its mean and its stillness tell of the sensor, not of the cut.
constexpr bool changesOnly(SensorQuantity q) {
  return q == SensorQuantity::Acceleration || q == SensorQuantity::Velocity || q == SensorQuantity::Sound;
}

class InputCheck {
 public:
  void prepare(const CutSetup& setup);
  // ReasonCode::None when the block is good. Looks at raw device units, so that a limit of the device shows.
  Reason check(const SampleBlock& block) noexcept;
  void reset() noexcept;

 private:
  struct InputChannel {
    SensorQuantity quantity = SensorQuantity::Acceleration;
    bool hears = true;  // the cut
    float last = 0.0F;
    int run = 0;  // equal samples in a row, across blocks
    dsp::ClipWatch clip;
  };
  Reason checkChannel(std::span<const float> samples, int index) noexcept;

  int deadRun_ = 0;  // samples
  std::array<InputChannel, kMaxChannels> channels_{};
};

}  // namespace stillcut::detect
