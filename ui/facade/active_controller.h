// ActiveDesk: what the page of the active work-holder needs: identify the paths, start and stop the control, watch it.
// app/session implements it; the loop runs on a thread of its own. GUI thread; every function returns at once.
#pragma once

#include <QString>
#include <array>

#include "core/base/result.h"
#include "core/model/active_state.h"

namespace stillcut::ui {

class ActiveController {
 public:
  virtual ~ActiveController() = default;

  // Takes over what has been finished, and renews the lease: without it for a second, the table is let go. True: a fit
  // or the problem has changed. Every display tick.
  virtual bool poll() = 0;

  // The newest, or null before the first. Valid until the next call.
  virtual const ActiveSnapshot* pull() = 0;
  // Null: the path of that axis (0: x, 1: y) has not been identified.
  virtual const PathFit* fit(int axis) const = 0;
  // What the loop runs on, as its maker calls it: "simulated work-holder", "hw:1,0".
  virtual QString device() const = 0;
  // What went wrong last, one line in English; empty: nothing.
  virtual QString problem() const = 0;

  // Noise through both actuators for some seconds, with the tool out of the cut. Refused while control is on.
  virtual Status identify() = 0;
  // Refused, with the reason: no model, one too old, one that promises no stability, a device that has changed since.
  virtual Status start() = 0;
  // By the ramp of the gate; at any time.
  virtual void stop() = 0;
  // Acts at the next block, without a jump: the weights stay.
  virtual Status setStep(double share) = 0;
  virtual Status setLeak(double leak) = 0;
};

}  // namespace stillcut::ui
