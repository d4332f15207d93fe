// LeftOut: the channels that cannot be believed now. Each channel is judged for itself: a bad one is left out, which is
// silence for everything that is detected, and the others go on. Only where none that measures the cut is left is there
// nothing to judge.
//
// A channel is left out with the block that shows its fault, or after the one in which tenths of seconds have shown it
// (sensor_check.h). It comes back once it has had none for a second,
// or at once where no other is left: a fault that comes and goes would else begin every detector anew each time.
// Thread: worker; real-time.
#pragma once

#include <array>

#include "core/base/units.h"
#include "core/model/cut_setup.h"
#include "core/model/reason.h"
#include "core/model/sensor_status.h"

namespace stillcut::detect {

class LeftOut {
 public:
  void prepare(const CutSetup& setup) noexcept;
  void reset() noexcept;
  // Of one channel in this block: its fault, or none.
  void see(int channel, const Reason& fault, Seconds length) noexcept;

  bool is(int channel) const noexcept { return channels_[static_cast<std::size_t>(channel)].out; }
  bool any() const noexcept;
  // A channel came back in this block: what was learned was learned without it.
  bool takeReturned() noexcept;
  // Why nothing can be judged: the first fault, where no channel that measures the cut is left; none otherwise.
  Reason allOut() const noexcept;

 private:
  static constexpr double kReturns = 1.0;  // s without a fault
  struct LeftOutChannel {
    bool measuresCut = true;  // a spindle speed beside vibration says how fast, not what is cut
    bool out = false;
    double sound = 0.0;  // s since the last fault
    Reason fault;        // why it is left out
  };
  std::array<LeftOutChannel, kMaxChannels> channels_{};
  int count_ = 0;
  bool returned_ = false;
};

}  // namespace stillcut::detect
