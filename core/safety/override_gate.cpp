#include "core/safety/override_gate.h"

#include <algorithm>
#include <cmath>

#include "core/model/event_slots.h"
#include "core/safety/gate_checks.h"

namespace stillcut::safety {

void OverrideGate::prepare(const GateLimits& limits) {
  enter(GateCause::Drops);
  limits_ = limits;
  ramp_.prepare(limits);
  setpoint_.prepare(limits);
  watch_.prepare(limits);
  pendingAdvice_.clear();
  judge_.prepare(limits.interventions);
  louder_.reset();
  authority_ = Authority::Off;
  authoritySince_ = clock_.last();
  operatorHold_ = false;
  strategyFailed_ = false;
  clock_.restart();
  said_ = {};
  badTime_ = 0.0;
  restLeft_ = 0.0;
}

GateOutput OverrideGate::step(const GateInput& in) STILLCUT_RT {
  GateOutput out;
  passTime(in, out);
  obeyOperator(in, out);
  endWhatCannotGoOn(in, out);
  const Reason trouble = findTrouble(in, out);
  if (state_ == GateState::LettingGo) {
    goHome(in, out);
  } else if (trouble.code != ReasonCode::None) {
    holdThenRelease(trouble, in, out);
  } else {
    act(in, out);
  }
  issue(in, out);
  return out;
}

// Time that stands still, goes back or jumps past the lease ends what is in force: the link has let go by now, or
// cannot tell that it should.
void OverrideGate::passTime(const GateInput& in, GateOutput& out) STILLCUT_RT {
  switch (clock_.advance(in.now, in.dt, limits_.lease)) {
    case StepClock::Step::First:
      return;
    case StepClock::Step::Back:
    case StepClock::Step::Jump: {
      const bool back = clock_.step() == StepClock::Step::Back;
      const Reason why{back ? ReasonCode::GateClockFault : ReasonCode::LeaseExpired, {clock_.passed()}};
      if (commanding()) said_.trouble(ReasonCode::GateClockFault);  // by the drop
      drop(why, EventLevel::Fault, in.now, out);
      return;
    }
    case StepClock::Step::Unmeasured:
    case StepClock::Step::Good:
      pendingAdvice_.advance(clock_.elapsed());
      setpoint_.advance(clock_.elapsed(), ramp_.at(setpoint_.target()));
      return;
  }
}

// Faults that leave nothing to hold: the link has let go already, or the wish that is in force has lost its author.
void OverrideGate::endWhatCannotGoOn(const GateInput& in, GateOutput& out) STILLCUT_RT {
  if (commanding() && in.machine.endedEngagement >= engagement_) {
    drop({ReasonCode::LeaseExpired, {limits_.lease.value}}, EventLevel::Fault, in.now, out);
  }
  if (!in.strategyFailed || strategyFailed_) return;
  strategyFailed_ = true;
  const Reason why{ReasonCode::StrategyFault, {}};
  if (!steering()) report(out, in.now, EventLevel::Fault, why);
  relinquish(why, EventLevel::Fault, in.now, out);
}

// With authority reportFault() says what is wrong.
void OverrideGate::watchLink(const GateInput& in, GateOutput& out) STILLCUT_RT {
  switch (said_.link(in.machine.linkUp)) {
    case SaidOnce::LinkNews::Back:
      say(out, in.now, EventLevel::Info, {ReasonCode::LinkBack, {}});
      break;
    case SaidOnce::LinkNews::Lost:
      if (commanding() || authority_ != Authority::Off) break;
      report(out, in.now, EventLevel::Warning,
             {ReasonCode::LinkLost, {std::max(0.0, secondsBetween(in.machine.time, in.now).value)}});
      break;
    case SaidOnce::LinkNews::None:
      break;
  }
}

Reason OverrideGate::findTrouble(const GateInput& in, GateOutput& out) STILLCUT_RT {
  watchLink(in, out);
  Reason trouble = checkMachine(in.machine, in.now, limits_.machineAge);
  if (trouble.code != ReasonCode::None) return trouble;
  watch_.look(in.machine, ramp_.now(), commanding(), clock_.elapsed());
  if (steering() && watch_.programChanged()) {
    // Whatever else is wrong: our factors were meant for another speed.
    const Reason why{ReasonCode::GateProgramChanged, {watch_.programmed().value, in.machine.programmedSpeed.value}};
    say(out, in.now, EventLevel::Info, why);
    louder_.reset();
    relinquish(why, EventLevel::Info, in.now, out);
    return why;
  }
  if (!clock_.good()) return {ReasonCode::GateClockFault, {}};
  trouble = watch_.trouble();
  if (trouble.code == ReasonCode::GateOverrideReset) {
    // The programmed values are in force already: to hold ours would be to take it back from whoever did it.
    report(out, in.now, EventLevel::Warning, trouble);
    drop(trouble, EventLevel::Info, in.now, out);
    return trouble;
  }
  if (trouble.code == ReasonCode::None) trouble = checkVerdict(in.verdict, in.now, limits_.verdictAge);
  if (trouble.code == ReasonCode::None) {
    trouble = checkRequest(in.request, in.machine, in.now, limits_.verdictAge);
  }
  // Whatever comes in its name: there is nobody whose wishes to follow.
  if (trouble.code == ReasonCode::None && strategyFailed_) trouble = {ReasonCode::StrategyFault, {}};
  return trouble;
}

// The one place where commands are made. The finite check is the last thing that happens to a number.
void OverrideGate::issue(const GateInput& in, GateOutput& out) STILLCUT_RT {
  const Factors& now = ramp_.now();
  if (commanding() && !(std::isfinite(now.speed) && std::isfinite(now.feed) && now.speed > 0.0 && now.feed >= 0.0)) {
    drop({ReasonCode::GateNotFinite, {}}, EventLevel::Fault, in.now, out);
  }
  if (state_ != GateState::Idle) {
    CommandRecord record;
    record.time = in.now;
    record.sequence = ++sequence_;
    record.engagement = engagement_;
    record.lease = toDuration(limits_.lease);
    if (state_ == GateState::OwesRelease) {
      record.kind = CommandKind::Release;
      record.reason = dropReason_;
      enter(GateCause::Sends);
    } else {
      record.kind = CommandKind::Set;
      record.speed = Ratio(now.speed);
      record.feed = Ratio(now.feed);
      record.reason = out.reason;
    }
    out.command.emplace(OverrideCommand(record));
  }
  out.commanding = commanding();
  if (commanding()) out.knobs = {watch_.baseOperatorSpeed(), watch_.baseOperatorFeed()};
  out.authority = authority_;
  out.authoritySince = authoritySince_;
  out.autoAllowed = limits_.autoAllowed;
  out.adviceOpen = pendingAdvice_.open();
  out.adviceNumber = pendingAdvice_.number();
  if (out.adviceOpen) out.advice = pendingAdvice_.advice().request;
  out.operatorHold = operatorHold_;
}

void OverrideGate::report(GateOutput& out, Instant now, EventLevel level, const Reason& reason) const STILLCUT_RT {
  say(out, now, level, reason);
  keepFlight(out, reason);
}

void OverrideGate::keepFlight(GateOutput& out, const Reason& cause) STILLCUT_RT {
  if (!out.flight) out.flightCause = cause;
  out.flight = true;
}

void OverrideGate::say(GateOutput& out, Instant now, EventLevel level, const Reason& reason) const STILLCUT_RT {
  out.eventsLost += addEvent(out.events, out.eventCount, {.time = now, .number = 0, .level = level, .reason = reason});
}

}  // namespace stillcut::safety
