// A cable that breaks in the cut: one channel falls by 20 dB from one window to the next while another of its kind goes
// on as it was (within 3 dB, and 6 dB above its own air) for half a second. Where all of them fall, the cut has ended.
// A channel that is alone of its kind is told by how it ends (abrupt_end.h): a structure rings on, a cable does not.
// It stands until the channel shows life again, 6 dB above what was left of it.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/model/cut_setup.h"
#include "core/model/sensor_status.h"
#include "core/sensing/cut_gate.h"

namespace stillcut::detect {

class CableWatch {
 public:
  void prepare(const CutSetup& setup);
  void reset() noexcept;
  // One window of one channel, `perSecond` of which make a second, and the one before it.
  void look(int channel, std::span<const double> window, std::span<const double> windowBefore, double meanSquare,
            double perSecond, const CutGate& gate) noexcept;
  bool broken(int channel) const noexcept { return channels_[static_cast<std::size_t>(channel)].broken; }

 private:
  struct CableChannel {
    SensorQuantity quantity = SensorQuantity::Acceleration;
    double latest = 0.0;  // mean square of the last window
    double level = 0.0;   // ... over about a second
    double left = 0.0;    // after a fall; 0: none
    double before = 0.0;
    int windows = 0;  // since the fall
    bool broken = false;
    bool alone = false;                         // of its kind, and of what only changes
    bool cutOff = false;                        // it fell as no structure does
    std::array<double, kMaxChannels> beside{};  // levels of all channels when it fell
  };
  bool anotherGoesOn(std::size_t channel, const CutGate& gate) const noexcept;

  int hop_ = 0;  // frames of a millisecond
  std::vector<CableChannel> channels_;
};

}  // namespace stillcut::detect
