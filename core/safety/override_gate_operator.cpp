// The half of the gate that listens to the person at the machine.
#include <array>

#include "core/safety/override_gate.h"

namespace stillcut::safety {

void OverrideGate::obeyOperator(const GateInput& in, GateOutput& out) STILLCUT_RT {
  for (const OperatorInput& input : in.inputs) {
    switch (input.action) {
      case OperatorAction::SetAuthority:
        setAuthority(input.authority, in.now, out);
        break;
      case OperatorAction::GrantBySimulation:
        setAuthority(Authority::Auto, in.now, out);
        if (authority_ == Authority::Auto) {
          say(out, in.now, EventLevel::Info, {ReasonCode::AutoGrantedBySimulation, {}});
        }
        break;
      case OperatorAction::Accept:
        acceptAdvice(input.advice, in.now, out);
        break;
      case OperatorAction::Refuse:
        refuseAdvice(in.now, out);
        break;
      case OperatorAction::BackToProgrammed:
        say(out, in.now, EventLevel::Info, {ReasonCode::BackToProgrammed, {}});
        setAuthority(Authority::Off, in.now, out);
        operatorHold_ = false;
        releaseWhatWasLeft();
        break;
      case OperatorAction::Hold:
        operatorHold_ = true;
        break;
      case OperatorAction::EndHold:
        operatorHold_ = false;
        break;
      case OperatorAction::TrueAlarm:
      case OperatorAction::FalseAlarm:
      case OperatorAction::ReportChatter:
      case OperatorAction::SetParameter:
      case OperatorAction::UndoMark:
        break;  // for the detectors' thresholds and the record, not for the machine
    }
  }
}

// Nothing of this run is in force, but something of a run that was killed may be: only the link can tell, and a Release
// changes nothing where there is nothing.
void OverrideGate::releaseWhatWasLeft() STILLCUT_RT {
  if (commanding()) return;
  enter(GateCause::Recalls);
  dropReason_ = {ReasonCode::BackToProgrammed, {}};
  restLeft_ = limits_.reengageDelay.value;
}

void OverrideGate::setAuthority(Authority wanted, Instant now, GateOutput& out) STILLCUT_RT {
  if (!grants(wanted, limits_.autoAllowed)) {
    report(out, now, EventLevel::Warning, {ReasonCode::AutoNotAllowed, {}});
    return;
  }
  if (wanted != authority_) {
    const Reason change{ReasonCode::AuthorityChanged, {static_cast<double>(authority_), static_cast<double>(wanted)}};
    report(out, now, EventLevel::Info, change);
    authority_ = wanted;
    authoritySince_ = now;
    pendingAdvice_.clear();
    setpoint_.forgiveChanges();
    judge_.forget();
    louder_.reset();
    said_.limitsOver();
    said_.troubleOver();  // whoever takes or gives authority hears what stands in the way
    if (wanted == Authority::Advise && steering()) stay();
  }
  if (authority_ == Authority::Off) relinquish({ReasonCode::AuthorityOff, {}}, EventLevel::Info, now, out);
}

// From now on each move is asked for, the rest of one that was under way included.
void OverrideGate::stay() STILLCUT_RT {
  setpoint_.stopAt(ramp_.now());
  ramp_.halt();
  enter(GateCause::Follows);
}

// A target that jumped as the finger landed is another advice, and nobody has accepted that one.
void OverrideGate::acceptAdvice(std::uint32_t number, Instant now, GateOutput& out) STILLCUT_RT {
  if (authority_ != Authority::Advise || !pendingAdvice_.open()) return;
  const OverrideRequest& r = pendingAdvice_.advice().request;
  const std::array<double, 4> values{r.speed.value, toMmPerMin(r.feed)};
  if (pendingAdvice_.accept(number)) {
    say(out, now, EventLevel::Info, {ReasonCode::AdviceAccepted, values});
  } else {
    report(out, now, EventLevel::Warning, {ReasonCode::AdviceChanged, values});
  }
}

void OverrideGate::refuseAdvice(Instant now, GateOutput& out) STILLCUT_RT {
  if (authority_ != Authority::Advise || !pendingAdvice_.refuse()) return;
  const OverrideRequest& r = pendingAdvice_.advice().request;
  const Reason answer{ReasonCode::AdviceRefused, {r.speed.value, toMmPerMin(r.feed)}};
  report(out, now, EventLevel::Info, answer);
}

}  // namespace stillcut::safety
