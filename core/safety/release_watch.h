// ReleaseWatch: whether what was released has been read back. From the first Set on something of ours may stand in the
// machine; after a Release it may until the machine shows the operator's own overrides in a reading that came after it.
// A machine that cannot be read back has nothing to show, and is believed once it was heard after it. Thread: link
// thread. Real-time.
#pragma once

#include <cmath>

#include "core/base/realtime.h"
#include "core/model/machine_state.h"

namespace stillcut::safety {

class ReleaseWatch {
 public:
  // Ours is in force, or about to be.
  void set() STILLCUT_RT {
    stands_ = true;
    released_ = {};
  }
  // The overrides were told to go back, at `now`; also where nothing of this run was in force, for an earlier run may
  // have left something.
  void release(Instant now) STILLCUT_RT {
    if (released_ == Instant{}) released_ = now;
    stands_ = true;
  }
  // The newest reading.
  void look(const MachineState& m) STILLCUT_RT {
    if (!stands_ || released_ == Instant{} || !m.valid || !m.linkUp) return;
    const bool readable = m.link.overrides != Instant{};
    if (m.time <= released_ || (readable && m.link.overrides <= released_)) return;
    // Overrides that the program has switched off are not in force, whoever set them.
    if (!readable || !m.overridesEnabled || isBack(m)) stands_ = false;
  }
  // Released, and not seen in the machine yet.
  bool notYetBack() const STILLCUT_RT { return stands_ && released_ != Instant{}; }

 private:
  // Overrides are read back in steps of 1 %.
  static bool isBack(const MachineState& m) STILLCUT_RT {
    constexpr double kStep = 0.006;
    const bool speed = std::abs(m.speedOverride.value - m.operatorSpeed.value) < kStep;
    // Machines report 0 % while the feed is on hold.
    return speed && (m.feedHold || std::abs(m.feedOverride.value - m.operatorFeed.value) < kStep);
  }

  bool stands_ = false;
  Instant released_{};  // 0: ours is in force
};

}  // namespace stillcut::safety
