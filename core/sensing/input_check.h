// What one block shows of each channel: values that are no numbers, a constant, a limit that is reached (clip_watch.h).
// A channel with a fault is left out (left_out.h). One at its limit still tells of the cut, since what is cut flat
// repeats where the vibration does; but not that it is stable.
//
// A sensor of what only changes (acceleration, velocity, sound) that stands still is dead. A force, a current or a
// displacement may rest: they are dead where every channel stands still, since then nothing is heard. A speed beside
// them is told and no sensor of the cut.
// Thread: worker; look() and reset() are real-time.
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
  // In raw device units, so that a limit of the device shows.
  void look(const SampleBlock& block) noexcept;
  void reset() noexcept;

  // Of the block that was looked at last; none: good.
  const Reason& fault(int channel) const noexcept { return channels_[static_cast<std::size_t>(channel)].fault; }
  // No channel that measures the cut is good.
  bool allBad() const noexcept;
  // A channel, or what the driver saw, was at its limit.
  bool clipped() const noexcept { return clipped_; }

 private:
  struct InputChannel {
    SensorQuantity quantity = SensorQuantity::Acceleration;
    bool hears = true;  // the cut
    float last = 0.0F;
    int run = 0;  // equal samples in a row, across blocks
    dsp::ClipWatch clip;
    Reason fault;
  };
  Reason lookAt(std::span<const float> samples, int index) noexcept;

  bool clipped_ = false;
  int count_ = 0;    // channels of the block
  int deadRun_ = 0;  // samples
  std::array<InputChannel, kMaxChannels> channels_{};
};

}  // namespace stillcut::detect
