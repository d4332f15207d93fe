// OverrideRamp: how our two factors travel. Low-pass on the wanted values, then the rate limits, then the order (speed
// rises before feed, feed falls before speed), then the limits, then the finite check last.
//
// After every advance(): both factors finite, inside their ranges and the feed per tooth, and no further from
// the step before than step and slew allow. One exception: where the range itself moved past a factor (the operator
// turned a knob), the factor goes to the edge at once; that is always toward 100 %, because every range contains it.
// Thread: worker. Real-time after prepare().
#pragma once

#include "core/safety/gate_limits.h"

namespace stillcut::safety {

struct Factors {
  double speed = 1.0;
  double feed = 1.0;
};

struct RampInput {
  double dt = 0.0;  // [s], finite, >= 0
  Factors wanted;
  config::FactorRange speed, feed;  // both contain 1; speed.low >= feed.low / feedPerTooth
  // Actual spindle speed over programmed speed times knob; 0: not measured. Feed does not rise ahead of it.
  double actualSpeed = 0.0;
  // Feed override in force over the knob; 0: the machine does not tell. Speed does not fall ahead of it.
  double feedInForce = 0.0;
  bool recovering = false;  // nothing chatters: the way toward 100 % is slow
};

class OverrideRamp {
 public:
  void prepare(const GateLimits& limits);
  // Both factors at 100 %.
  void restart() STILLCUT_RT;
  // Stop where we are: nothing is left in the filter.
  void halt() STILLCUT_RT;
  // The next wish has been made already: nothing is left of the ones before, and it is not smoothed.
  void straightTo(const Factors& wanted) STILLCUT_RT { filtered_ = wanted; }
  // Back inside the ranges and the feed per tooth without going anywhere else.
  void keepInside(const config::FactorRange& speed, const config::FactorRange& feed) STILLCUT_RT;
  void advance(const RampInput& in) STILLCUT_RT;
  const Factors& now() const STILLCUT_RT { return now_; }
  bool at(const Factors& f) const STILLCUT_RT;

 private:
  double orderedSpeed(const RampInput& in, double speed) const STILLCUT_RT;
  double orderedFeed(const RampInput& in, double feed) const STILLCUT_RT;
  void accept(const Factors& next) STILLCUT_RT;

  GateLimits limits_;
  Factors now_;
  Factors filtered_;
};

}  // namespace stillcut::safety
