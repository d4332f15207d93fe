// MachineState: the machine as read back, by value. The only thing that flows against the samples.
#pragma once

#include <cstdint>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut {

struct MachineState {
  Instant time{};      // when it was read, stream time
  bool valid = false;  // false: nothing was ever read, or what was read made no sense
  bool linkUp = false;
  bool programRunning = false;
  bool feedHold = false;
  bool atSpeed = false;              // the spindle has reached what is commanded
  bool overridesEnabled = true;      // false under M49 and its like
  bool controlOurs = true;           // false when another client took the overrides
  Rpm programmedSpeed{};             // S word; 0: spindle stopped
  MetresPerSecond programmedFeed{};  // F word
  Ratio operatorSpeed{1.0};          // the operator's own knobs
  Ratio operatorFeed{1.0};
  Ratio speedOverride{1.0};  // in force: knob times ours
  Ratio feedOverride{1.0};
  Rpm actualSpeed{};  // measured where the machine measures it
  MetresPerSecond actualFeed{};
  // CommandRecord::engagement: the link has let go of this one and all before it, and obeys none of them again. 0:
  // none.
  std::uint64_t endedEngagement = 0;

  Rpm targetSpeed() const { return programmedSpeed * speedOverride.value; }
};

}  // namespace stillcut
