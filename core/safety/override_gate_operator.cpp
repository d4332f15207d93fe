// The half of the gate that listens to the person at the machine.
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
        break;
      case OperatorAction::Hold:
        operatorHold_ = true;
        break;
      case OperatorAction::EndHold:
        operatorHold_ = false;
        break;
      case OperatorAction::TrueAlarm:
      case OperatorAction::FalseAlarm:
      case OperatorAction::HearChatter:
      case OperatorAction::SetParameter:
        break;  // for the detectors' thresholds and the record, not for the machine
    }
  }
}

void OverrideGate::setAuthority(Authority wanted, Instant now, GateOutput& out) STILLCUT_RT {
  const bool known = wanted == Authority::Off || wanted == Authority::Advise || wanted == Authority::Auto;
  if (!known || (wanted == Authority::Auto && !limits_.autoAllowed)) {
    say(out, now, EventLevel::Warning, {ReasonCode::AutoNotAllowed, {}});
    keepFlight(out, {ReasonCode::AutoNotAllowed, {}});
    return;
  }
  if (wanted != authority_) {
    const Reason change{ReasonCode::AuthorityChanged, {static_cast<double>(authority_), static_cast<double>(wanted)}};
    say(out, now, EventLevel::Info, change);
    keepFlight(out, change);
    authority_ = wanted;
    authoritySince_ = now;
    desk_.clear();
    keeper_.forgiveChanges();
  }
  if (authority_ == Authority::Off) drop({ReasonCode::AuthorityOff, {}}, EventLevel::Info, now, out);
}

// A target that jumped as the finger landed is another advice, and nobody has accepted that one.
void OverrideGate::acceptAdvice(std::uint32_t number, Instant now, GateOutput& out) STILLCUT_RT {
  if (authority_ != Authority::Advise || !desk_.open()) return;
  const OverrideRequest& r = desk_.advice().request;
  const bool same = desk_.accept(number);
  const Reason answer{same ? ReasonCode::AdviceAccepted : ReasonCode::AdviceChanged,
                      {r.speed.value, toMmPerMin(r.feed)}};
  say(out, now, same ? EventLevel::Info : EventLevel::Warning, answer);
  if (!same) keepFlight(out, answer);
}

void OverrideGate::refuseAdvice(Instant now, GateOutput& out) STILLCUT_RT {
  if (authority_ != Authority::Advise || !desk_.refuse()) return;
  const OverrideRequest& r = desk_.advice().request;
  const Reason answer{ReasonCode::AdviceRefused, {r.speed.value, toMmPerMin(r.feed)}};
  say(out, now, EventLevel::Info, answer);
  keepFlight(out, answer);
}

}  // namespace stillcut::safety
