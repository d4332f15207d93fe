// The half of the gate that moves the machine: all its inputs have passed the checks.
#include <algorithm>
#include <cmath>

#include "core/safety/gate_checks.h"
#include "core/safety/override_gate.h"

namespace stillcut::safety {
namespace {

// A return is advised with the values that it leads to.
Advice adviceOf(const Factors& factors, const OverrideRequest& r, const MachineState& m) noexcept {
  Advice advice{factors, r, m.programmedSpeed};
  if (r.kind == RequestKind::Release) {
    advice.request.speed = m.programmedSpeed * m.operatorSpeed.value;
    advice.request.feed = m.programmedFeed * m.operatorFeed.value;
  }
  return advice;
}

}  // namespace

void OverrideGate::act(const GateInput& in, GateOutput& out) STILLCUT_RT {
  badTime_ = std::max(0.0, badTime_ - clock_.elapsed());
  if (badTime_ <= 0.0) said_.troubleOver();
  if (!setpoint_.budget().cooling()) said_.coolDownOver();
  if (state_ != GateState::OwesRelease) restLeft_ = std::max(0.0, restLeft_ - clock_.elapsed());
  if (!commanding()) watch_.rebase(in.machine);

  judge_.listen(heard(in));
  endOldAcceptance(in, out);
  if (commanding()) judgeMove(in, out);
  if (steering()) {
    steer(in, out);
  } else if (!commanding()) {
    tryToTake(in, out);
  }
  // Chatter needs an absolute speed; without it a turned knob scales what is in force, as its owner expects. From the
  // next wish on: this one was made with the knobs that the step before gave out.
  if (commanding() && in.verdict.alarming() && !watch_.operatorOverrideMoving()) watch_.rebase(in.machine);
}

// What was accepted for another cut, or is no longer asked for, is not carried out.
void OverrideGate::endOldAcceptance(const GateInput& in, GateOutput& out) STILLCUT_RT {
  if (pendingAdvice_.accepted() == nullptr) return;
  const Advice now{trimmed(in.request, in.machine).factors, in.request, in.machine.programmedSpeed};
  if (pendingAdvice_.stillMeant(now)) return;
  const OverrideRequest& was = pendingAdvice_.accepted()->request;
  const OverrideRequest& is = in.request.kind == RequestKind::Set ? in.request : was;
  report(out, in.now, EventLevel::Warning, {ReasonCode::AdviceChanged, {is.speed.value, toMmPerMin(is.feed)}});
  pendingAdvice_.carriedOut();
}

// Nothing of ours is in force.
void OverrideGate::tryToTake(const GateInput& in, GateOutput& out) STILLCUT_RT {
  const Advice* accepted = pendingAdvice_.accepted();
  if (authority_ == Authority::Off) {
    out.reason = {ReasonCode::AuthorityOff, {}};
    return;
  }
  const TrimmedRequest wanted = trimmed(in.request, in.machine);
  const bool again = in.request.kind == RequestKind::Set && triedLouder(wanted.factors);
  const bool wants = in.request.kind == RequestKind::Set && !again && !setpoint_.near(wanted.factors);
  if (in.request.kind != RequestKind::Set) said_.limitsOver();
  if (!wants && accepted == nullptr) {
    pendingAdvice_.close();
    if (in.request.kind == RequestKind::Set && wanted.limited.code != ReasonCode::None) {
      return refuseBeyondLimits(wanted.limited, in, out);
    }
    out.reason = in.request.reason.code != ReasonCode::None ? in.request.reason : Reason{ReasonCode::NothingToDo, {}};
    if (again) out.reason = {ReasonCode::InterventionNotAgain, {in.request.speed.value}};
    return;
  }
  if (authority_ == Authority::Advise && accepted == nullptr) {
    pendingAdvice_.put(adviceOf(wanted.factors, in.request, in.machine));
    out.reason = {ReasonCode::AdviceOnly, {}};
    return;
  }
  out.reason = notReady(in);
  if (out.reason.code != ReasonCode::None) return;
  const TrimmedRequest target = accepted != nullptr ? trimmed(accepted->request, in.machine) : wanted;
  if (setpoint_.propose(target.factors, accepted != nullptr) == Proposal::Refused) {
    refuseChange(in, out);
    return;
  }
  say(out, in.now, EventLevel::Info, accepted != nullptr ? accepted->request.reason : in.request.reason);
  pendingAdvice_.carriedOut();
  ramp_.restart();
  watch_.engage(in.machine);
  enter(GateCause::Takes);
  ++engagement_;
  beginMove({}, in, out);
  move(in, out);
  if (target.limited.code != ReasonCode::None) out.reason = target.limited;
}

Reason OverrideGate::notReady(const GateInput& in) const STILLCUT_RT {
  const MachineState& m = in.machine;
  if (state_ != GateState::Idle || restLeft_ > 0.0) return {ReasonCode::GateReengageDelay, {restLeft_}};
  if (operatorHold_) return {ReasonCode::GateOperatorHold, {}};
  if (m.feedHold) return {ReasonCode::GateFeedHold, {}};
  if (watch_.operatorOverrideMoving()) {
    return {ReasonCode::GateOperatorOverrideMoved, {100.0 * m.operatorSpeed.value, 100.0 * m.operatorFeed.value}};
  }
  if (!watch_.atSpeed()) return {ReasonCode::GateSettling, {m.actualSpeed.value, m.targetSpeed().value}};
  if (!inCut(in.verdict)) return {ReasonCode::GateNotInCut, {}};
  if (const Seconds age = sampleAge(in.verdict, m, in.now); age > kMoveAge)
    return {ReasonCode::GateOldSamples, {age.value}};
  return {};
}

OverrideGate::Freeze OverrideGate::frozen(const GateInput& in) const STILLCUT_RT {
  if (operatorHold_) return Freeze::Operator;
  if (in.machine.feedHold) return Freeze::FeedHold;
  if (watch_.operatorOverrideMoving()) return Freeze::Knob;
  return sampleAge(in.verdict, in.machine, in.now) > kMoveAge ? Freeze::OldSamples : Freeze::No;
}

// Something of ours is in force.
void OverrideGate::steer(const GateInput& in, GateOutput& out) STILLCUT_RT {
  const MachineState& m = in.machine;
  if (watch_.operatorOverrideJustMoved()) {
    say(out, in.now, EventLevel::Info,
        {ReasonCode::GateOperatorOverrideMoved, {100.0 * m.operatorSpeed.value, 100.0 * m.operatorFeed.value}});
  }
  switch (frozen(in)) {
    case Freeze::Operator:
      out.reason = {ReasonCode::GateOperatorHold, {}};
      break;
    case Freeze::FeedHold:
      out.reason = {ReasonCode::GateFeedHold, {}};
      break;
    case Freeze::Knob:
      out.reason = {ReasonCode::GateOperatorOverrideMoved,
                    {100.0 * m.operatorSpeed.value, 100.0 * m.operatorFeed.value}};
      break;
    case Freeze::OldSamples:
      out.reason = {ReasonCode::GateOldSamples, {sampleAge(in.verdict, m, in.now).value}};
      break;
    case Freeze::No:
      retarget(in, out);
      move(in, out);
      return;
  }
  ramp_.halt();
  ramp_.keepInside(speedFactors(limits_.overrides, m), feedFactors(limits_.overrides, m));
}

// Under Advise only what was accepted becomes a target, the way back to 100 % like every other move.
void OverrideGate::retarget(const GateInput& in, GateOutput& out) STILLCUT_RT {
  if (in.request.kind == RequestKind::Hold) stay();
  const Advice* accepted = pendingAdvice_.accepted();
  const OverrideRequest& r = accepted != nullptr ? accepted->request : in.request;
  const bool back = r.kind == RequestKind::Release;
  if (!back && r.kind != RequestKind::Set) {
    pendingAdvice_.close();
    return;
  }
  const TrimmedRequest wanted = trimmed(r, in.machine);
  if (authority_ == Authority::Advise && accepted == nullptr) {
    const bool there = setpoint_.near(wanted.factors) || PendingAdvice::isSame(wanted.factors, setpoint_.target());
    const bool underWay = back ? state_ == GateState::Returning : there;
    underWay ? pendingAdvice_.close() : pendingAdvice_.put(adviceOf(wanted.factors, r, in.machine));
    return;
  }
  if (back) {
    setpoint_.goBack();
  } else if (accepted == nullptr && triedLouder(wanted.factors)) {
    out.reason = {ReasonCode::InterventionNotAgain, {r.speed.value}};
    return;
  } else if (!follow(wanted.factors, accepted != nullptr, in, out)) {
    return;
  }
  enter(back ? GateCause::Returns : GateCause::Follows);
  pendingAdvice_.carriedOut();
  if (wanted.limited.code != ReasonCode::None) out.reason = wanted.limited;
}

// False: not now, or not any more.
bool OverrideGate::follow(const Factors& wanted, bool accepted, const GateInput& in, GateOutput& out) STILLCUT_RT {
  // One move at a time: what is made up while the machine is on its way was made of a cut that changes.
  const bool another = authority_ == Authority::Auto && judge_.underWay() && setpoint_.turns(wanted);
  if (another) return false;
  const Factors before = ramp_.now();
  switch (setpoint_.propose(wanted, accepted)) {
    case Proposal::Refused:
      refuseChange(in, out);
      return false;
    case Proposal::Taken:
      if (judge_.alarmedLately()) beginMove(before, in, out);
      return steering();
    case Proposal::GoesOn:
      judge_.goOn();
      return true;
    case Proposal::Same:
      return true;
  }
  return false;
}

void OverrideGate::move(const GateInput& in, GateOutput& out) STILLCUT_RT {
  const bool returning = state_ == GateState::Returning;
  if (returning && ramp_.at({})) {
    drop({ReasonCode::GateReleased, {}}, EventLevel::Info, in.now, out);
    return;
  }
  RampInput ramp = rampInput(in.machine);
  ramp.wanted = setpoint_.target();
  ramp.recovering = returning || !in.verdict.alarming();
  ramp_.advance(ramp);
  if (out.reason.code == ReasonCode::None) out.reason = inForce(in.machine);
}

// To 100 %, unless told otherwise.
RampInput OverrideGate::rampInput(const MachineState& m) const STILLCUT_RT {
  RampInput ramp;
  ramp.dt = clock_.moveTime();
  ramp.speed = speedFactors(limits_.overrides, m);
  ramp.feed = feedFactors(limits_.overrides, m);
  const Rpm base = m.programmedSpeed * m.operatorSpeed.value;
  ramp.actualSpeed = base.value > 0.0 ? m.actualSpeed / base : 0.0;
  ramp.feedInForce = m.operatorFeed.value > 0.0 ? m.feedOverride / m.operatorFeed : 0.0;
  return ramp;
}

// No hunting: after the changes of a minute are used up there is a pause, and the second time Auto is withdrawn.
void OverrideGate::refuseChange(const GateInput& in, GateOutput& out) STILLCUT_RT {
  const ChangeBudget& budget = setpoint_.budget();
  out.reason = {ReasonCode::GateCoolDown, {budget.coolDownLeft()}};
  if (said_.coolDown()) {
    const Reason usedUp{ReasonCode::GateChangesPerMinute,
                        {static_cast<double>(budget.inLastMinute()), static_cast<double>(budget.perMinute())}};
    report(out, in.now, EventLevel::Warning, usedUp);
  }
  if (budget.timesUsedUp() >= 2 && authority_ == Authority::Auto) {
    say(out, in.now, EventLevel::Warning, {ReasonCode::AutoWithdrawn, {static_cast<double>(budget.perMinute())}});
    setAuthority(Authority::Advise, in.now, out);
  }
}

// Nothing is left of what was asked: whoever sees chatter go on hears why.
void OverrideGate::refuseBeyondLimits(const Reason& limited, const GateInput& in, GateOutput& out) STILLCUT_RT {
  out.reason = limited;
  if (said_.limits()) report(out, in.now, EventLevel::Warning, limited);
}

OverrideGate::TrimmedRequest OverrideGate::trimmed(const OverrideRequest& r, const MachineState& m) const STILLCUT_RT {
  if (r.kind == RequestKind::Release) return {};  // 100 %
  const config::OverrideLimits& o = limits_.overrides;
  const config::FactorRange speeds = speedFactors(o, m);
  const config::FactorRange feeds = feedFactors(o, m);
  const double speed = r.claimsSpeed ? r.speed / (m.programmedSpeed * watch_.baseOperatorSpeed().value) : 1.0;
  const MetresPerSecond feedBase = m.programmedFeed * watch_.baseOperatorFeed().value;
  double feed = 1.0;
  // Without a feed to refer to, following the speed is the only way to keep the feed per tooth.
  if (r.claimsFeed) feed = feedBase.value > 0.0 ? r.feed / feedBase : speed;
  TrimmedRequest w;
  w.factors.speed = speeds.clamp(speed);
  w.factors.feed = feeds.clamp(o.perTooth(feed, w.factors.speed));
  if (std::abs(w.factors.speed - speed) > limits_.deadband) {
    w.limited = {ReasonCode::GateLimited, {100.0 * speed, 100.0 * w.factors.speed}};
  } else if (r.claimsFeed && std::abs(w.factors.feed - feed) > limits_.deadband) {
    w.limited = {ReasonCode::GateLimited, {100.0 * feed, 100.0 * w.factors.feed}};
  }
  return w;
}

Reason OverrideGate::inForce(const MachineState& m) const STILLCUT_RT {
  const Factors& now = ramp_.now();
  const Factors& goal = setpoint_.target();
  if (state_ == GateState::Returning && !ramp_.at(goal)) return {ReasonCode::Recovering, {goal.speed}};
  if (!ramp_.at(goal)) {
    return {ReasonCode::GateMoving, {100.0 * now.speed, 100.0 * goal.speed, 100.0 * now.feed, 100.0 * goal.feed}};
  }
  return {ReasonCode::GateInForce,
          {100.0 * now.speed, 100.0 * now.feed, 100.0 * now.speed * m.operatorSpeed.value,
           100.0 * now.feed * m.operatorFeed.value}};
}

}  // namespace stillcut::safety
