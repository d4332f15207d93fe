// MachineWatch: does the machine still do what program, operator and we have agreed on? Sees the program change its
// speed, the operator turn a knob, the override not being taken, the spindle not following.
// Thread: worker. Real-time after prepare(). look() is given plausible machine states only (gate_checks.h).
#pragma once

#include "core/model/machine_state.h"
#include "core/model/reason.h"
#include "core/safety/override_ramp.h"

namespace stillcut::safety {

class MachineWatch {
 public:
  void prepare(const GateLimits& limits);
  // The gate takes the overrides: what is agreed from here on.
  void engage(const MachineState& machine) STILLCUT_RT;
  // One step. `commanding`: `ours` is in force, sent in earlier steps.
  void look(const MachineState& machine, const Factors& ours, bool commanding, double dt) STILLCUT_RT;
  // The knobs as they are become the base of absolute wishes. Between two such moments turning a knob scales the
  // product, as the operator expects, instead of being undone by us.
  void rebase(const MachineState& machine) STILLCUT_RT;

  // None, GateOverrideNotTaken, GateOverrideReset (it had been taken, and stands where the knobs alone put it: neither
  // the program's lock, which the machine tells, nor a machine that never took it) or GateNotFollowing.
  Reason trouble() const STILLCUT_RT { return trouble_; }
  bool programChanged() const STILLCUT_RT { return programChanged_; }
  bool operatorOverrideMoving() const STILLCUT_RT { return knobLeft_ > 0.0; }
  bool operatorOverrideJustMoved() const STILLCUT_RT { return knobJustMoved_; }
  bool atSpeed() const STILLCUT_RT { return atSpeed_; }
  Rpm programmed() const STILLCUT_RT { return programmed_; }  // when the overrides were taken
  Ratio baseOperatorSpeed() const STILLCUT_RT { return baseSpeed_; }
  Ratio baseOperatorFeed() const STILLCUT_RT { return baseFeed_; }

 private:
  void lookAtKnobs(const MachineState& machine, double dt) STILLCUT_RT;
  void lookAtResponse(const MachineState& machine, const Factors& ours, double dt) STILLCUT_RT;

  GateLimits limits_;
  bool seen_ = false;
  Rpm programmed_{};
  Ratio speedKnob_{1.0}, feedKnob_{1.0};  // newest
  Ratio baseSpeed_{1.0}, baseFeed_{1.0};
  double knobLeft_ = 0.0;
  double notTaken_ = 0.0;
  bool wasTaken_ = false;  // ours has been seen in force
  double notFollowing_ = 0.0;
  bool knobJustMoved_ = false;
  bool programChanged_ = false;
  bool atSpeed_ = false;
  Reason trouble_;
};

}  // namespace stillcut::safety
