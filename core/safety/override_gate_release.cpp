// The half of the gate that gives the machine back: trouble is told and held, then the factors go home by the ramp, or
// are dropped where nothing can be steered any more.
#include <algorithm>

#include "core/safety/gate_checks.h"
#include "core/safety/override_gate.h"

namespace stillcut::safety {
namespace {

// The way things go in every cut: the program ends, the detector learns, the machine idles. No fault, and no news with
// nothing in force.
bool ordinary(const Reason& trouble, const Verdict& verdict) noexcept {
  if (trouble.code == ReasonCode::GateMachineNotReady) return true;
  const ReasonCode why = verdict.reason.code;
  return trouble.code == ReasonCode::GateVerdictInvalid &&
         (why == ReasonCode::Learning || why == ReasonCode::SpindleRunUp || why == ReasonCode::Transient ||
          why == ReasonCode::NoAirCutting || why == ReasonCode::DriveTone);
}

// Commands still reach the machine and act on it. A program that has ended does not matter to that.
bool steerable(const Reason& machine) noexcept {
  return machine.code == ReasonCode::None || machine.code == ReasonCode::GateMachineNotReady;
}

// The machine does not have what we sent, so from where would it be moved?
bool nowhere(const Reason& trouble) noexcept {
  return trouble.code == ReasonCode::GateOverrideNotTaken;
}

}  // namespace

// Once for each trouble, until the input has been good again for as long as it was bad.
void OverrideGate::reportFault(const Reason& trouble, const GateInput& in, GateOutput& out) STILLCUT_RT {
  if (clock_.step() == StepClock::Step::First && trouble.code == ReasonCode::GateClockFault) return;
  if (trouble.code == ReasonCode::StrategyFault) return;  // has been told
  const bool plain = ordinary(trouble, in.verdict);
  if (!commanding() && (plain || authority_ == Authority::Off)) return;
  if (!said_.trouble(trouble.code)) return;
  if (plain) {
    say(out, in.now, EventLevel::Info, trouble);
  } else {
    report(out, in.now, EventLevel::Warning, trouble);
  }
}

void OverrideGate::holdThenRelease(const Reason& trouble, const GateInput& in, GateOutput& out) STILLCUT_RT {
  out.reason = trouble;
  pendingAdvice_.close();
  pendingAdvice_.carriedOut();
  if (restLeft_ > 0.0) restLeft_ = limits_.reengageDelay.value;
  if (trouble.code != ReasonCode::GateOverrideReset) reportFault(trouble, in, out);
  badTime_ = std::min(badTime_ + clock_.elapsed(), limits_.holdTime.value);
  if (!commanding()) return;
  ramp_.halt();
  const bool steered = steerable(checkMachine(in.machine, in.now, limits_.machineAge));
  if (steered)
    ramp_.keepInside(speedFactors(limits_.overrides, in.machine), feedFactors(limits_.overrides, in.machine));
  if (badTime_ < limits_.holdTime.value) return;
  const EventLevel level = ordinary(trouble, in.verdict) ? EventLevel::Info : EventLevel::Fault;
  if (steered && !nowhere(trouble)) {
    relinquish(trouble, level, in.now, out);
  } else {
    drop(trouble, level, in.now, out);
  }
}

void OverrideGate::relinquish(const Reason& why, EventLevel level, Instant now, GateOutput& out) STILLCUT_RT {
  if (!commanding()) return drop(why, level, now, out);
  if (!steering()) return;
  forget();
  ramp_.straightTo({});
  enter(GateCause::GivesUp);
  stuck_ = 0.0;
  dropReason_ = why;
  if (level != EventLevel::Fault) return;
  report(out, now, level, why);
  countFault(now, out);
}

// At full rate: it was not the cut's becoming quiet that ended it, somebody or something wants the programmed values.
void OverrideGate::goHome(const GateInput& in, GateOutput& out) STILLCUT_RT {
  pendingAdvice_.close();
  const Reason machine = checkMachine(in.machine, in.now, limits_.machineAge);
  if (!steerable(machine)) {
    said_.troubleOver();
    reportFault(machine, in, out);
    drop(dropReason_, EventLevel::Info, in.now, out);
    return;
  }
  if (ramp_.at({})) {
    drop(dropReason_, EventLevel::Info, in.now, out);
    return;
  }
  const Factors before = ramp_.now();
  RampInput ramp = rampInput(in.machine);
  // A spindle that does not follow is not waited for.
  if (dropReason_.code == ReasonCode::GateNotFollowing) ramp.actualSpeed = 0.0;
  ramp_.advance(ramp);
  const Factors& now = ramp_.now();
  stuck_ = now.speed == before.speed && now.feed == before.feed ? stuck_ + clock_.elapsed() : 0.0;
  out.reason = {ReasonCode::Recovering, {1.0}};
  // What waits for a spindle that never comes, waits as long as for one that should follow.
  badTime_ = clock_.good() ? 0.0 : badTime_ + clock_.elapsed();
  const bool noTime = badTime_ > 0.0 && badTime_ >= limits_.holdTime.value;
  if (noTime || stuck_ > limits_.followTime.value) drop(dropReason_, EventLevel::Info, in.now, out);
}

// What was wanted, advised or counted as bad so far is over.
void OverrideGate::forget() STILLCUT_RT {
  setpoint_.restart();
  pendingAdvice_.clear();
  judge_.leave();
  badTime_ = 0.0;
}

void OverrideGate::drop(const Reason& why, EventLevel level, Instant now, GateOutput& out) STILLCUT_RT {
  forget();
  ramp_.restart();
  if (!commanding()) return;
  enter(GateCause::Drops);
  dropReason_ = why;
  restLeft_ = limits_.reengageDelay.value;
  if (level == EventLevel::Fault) report(out, now, level, why);
  say(out, now, EventLevel::Info, {ReasonCode::GateReleased, {}});
  if (level == EventLevel::Fault) countFault(now, out);
}

}  // namespace stillcut::safety
