#include "core/safety/machine_watch.h"

#include <algorithm>
#include <cmath>

namespace stillcut::safety {
namespace {

constexpr double kKnobClick = 0.004;      // smaller differences are rounding of what is read back
constexpr double kSpeedWordShare = 1e-3;  // a new S word differs at least this much

bool differs(double a, double b, double by) noexcept {
  return std::abs(a - b) > by;
}

}  // namespace

void MachineWatch::prepare(const GateLimits& limits) {
  *this = MachineWatch{};
  limits_ = limits;
}

void MachineWatch::engage(const MachineState& machine) STILLCUT_RT {
  programmed_ = machine.programmedSpeed;
  notTaken_ = 0.0;
  wasTaken_ = false;
  notFollowing_ = 0.0;
  trouble_ = {};
}

void MachineWatch::rebase(const MachineState& machine) STILLCUT_RT {
  baseSpeed_ = machine.operatorSpeed;
  baseFeed_ = machine.operatorFeed;
}

void MachineWatch::look(const MachineState& machine, const Factors& ours, bool commanding, double dt) STILLCUT_RT {
  lookAtKnobs(machine, dt);
  const double expected = machine.programmedSpeed.value * machine.operatorSpeed.value * (commanding ? ours.speed : 1.0);
  // A machine that does not measure its speed reports 0; then its own word has to do.
  const bool near = machine.actualSpeed.value <= 0.0 ||
                    !differs(machine.actualSpeed.value, expected, limits_.speedTolerance * expected);
  atSpeed_ = machine.atSpeed && near;
  programChanged_ = false;
  trouble_ = {};
  if (!commanding) {
    notTaken_ = 0.0;
    notFollowing_ = 0.0;
    return;
  }
  programChanged_ = differs(machine.programmedSpeed.value, programmed_.value, kSpeedWordShare * programmed_.value);
  lookAtResponse(machine, ours, dt);
}

void MachineWatch::lookAtKnobs(const MachineState& machine, double dt) STILLCUT_RT {
  knobJustMoved_ = seen_ && (differs(machine.operatorSpeed.value, speedKnob_.value, kKnobClick) ||
                             differs(machine.operatorFeed.value, feedKnob_.value, kKnobClick));
  if (!seen_) rebase(machine);
  if (knobJustMoved_) {
    knobLeft_ = limits_.operatorPause.value;
  } else {
    knobLeft_ = std::max(0.0, knobLeft_ - dt);
  }
  if (!seen_ || knobJustMoved_) {
    speedKnob_ = machine.operatorSpeed;
    feedKnob_ = machine.operatorFeed;
  }
  seen_ = true;
}

void MachineWatch::lookAtResponse(const MachineState& machine, const Factors& ours, double dt) STILLCUT_RT {
  const double room = limits_.speedTolerance + kReadbackRounding;
  const double speed = machine.operatorSpeed.value * ours.speed;
  const double feed = machine.operatorFeed.value * ours.feed;
  const bool speedTaken = !differs(machine.speedOverride.value, speed, room);
  // Machines report 0 % while the feed is on hold.
  const bool feedTaken = machine.feedHold || !differs(machine.feedOverride.value, feed, room);
  notTaken_ = speedTaken && feedTaken ? 0.0 : notTaken_ + dt;
  const bool moved = differs(ours.speed, 1.0, room) || differs(ours.feed, 1.0, room);
  wasTaken_ = wasTaken_ || (moved && speedTaken && feedTaken);
  // Each override that is not ours stands at the operator's knob.
  const bool atKnobs = (speedTaken || !differs(machine.speedOverride.value, machine.operatorSpeed.value, room)) &&
                       (feedTaken || !differs(machine.feedOverride.value, machine.operatorFeed.value, room));
  notFollowing_ = atSpeed_ ? 0.0 : notFollowing_ + dt;
  if (notTaken_ > limits_.takeTime.value) {
    trouble_ = {wasTaken_ && atKnobs ? ReasonCode::GateOverrideReset : ReasonCode::GateOverrideNotTaken,
                {100.0 * (speedTaken ? machine.feedOverride.value : machine.speedOverride.value),
                 100.0 * (speedTaken ? feed : speed)}};
  } else if (notFollowing_ > limits_.followTime.value) {
    const double expected = machine.programmedSpeed.value * speed;
    trouble_ = {ReasonCode::GateNotFollowing, {machine.actualSpeed.value, expected}};
  }
}

}  // namespace stillcut::safety
