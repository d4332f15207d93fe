// The half of the gate that asks what its moves were good for: one that did not help is counted, one that made the cut
// louder is taken back, and after two in a row Auto is at its end.
#include <algorithm>
#include <cmath>

#include "core/safety/gate_checks.h"
#include "core/safety/override_gate.h"

namespace stillcut::safety {
namespace {

constexpr double kAlike = 0.02;  // of the programmed values: the same place on the lobe

bool alike(const Factors& a, const Factors& b) noexcept {
  return std::abs(a.speed - b.speed) <= kAlike && std::abs(a.feed - b.feed) <= kAlike;
}

}  // namespace

InterventionStep OverrideGate::heard(const GateInput& in) const STILLCUT_RT {
  return {.dt = clock_.elapsed(),
          .heard = inCut(in.verdict),
          .alarming = in.verdict.alarming(),
          .vibration = in.vibration,
          .arrived = steering() && ramp_.at(setpoint_.target()) && watch_.atSpeed()};
}

// What is in force goes from `before` to the setpoint.
void OverrideGate::beginMove(const Factors& before, const GateInput& in, GateOutput& out) STILLCUT_RT {
  take(judge_.begin(before, setpoint_.target()), in.now, out);
  judgedFor_ = in.machine.programmedSpeed * (in.machine.operatorSpeed.value * setpoint_.target().speed);
}

void OverrideGate::judgeMove(const GateInput& in, GateOutput& out) STILLCUT_RT {
  // A tool that left the cut proves nothing.
  if (in.verdict.state == CutState::AirCutting) judge_.leave();
  take(judge_.judge(heard(in)), in.now, out);
}

void OverrideGate::take(Outcome outcome, Instant now, GateOutput& out) STILLCUT_RT {
  if (outcome != Outcome::None) out.judged = {outcome, judge_.timesAsLoud(), judge_.withoutHelp(), false};
  if (outcome == Outcome::Helped && judge_.louder()) {
    say(out, now, EventLevel::Info, {ReasonCode::InterventionForced, {judgedFor_.value, judge_.timesAsLoud()}});
  }
  if (outcome == Outcome::None || outcome == Outcome::Helped) return;
  const auto count = static_cast<double>(judge_.withoutHelp()), most = static_cast<double>(judge_.most());
  const bool louder = outcome == Outcome::Louder;
  report(out, now, EventLevel::Warning,
         louder ? Reason{ReasonCode::InterventionLouder, {judgedFor_.value, judge_.timesAsLoud(), count, most}}
                : Reason{ReasonCode::InterventionNoHelp, {judgedFor_.value, count, most}});
  // Under Advise each move is the operator's own, the one back as well.
  if (authority_ != Authority::Auto) return;
  if (judge_.usedUp()) {
    out.judged.endsAuto = true;
    withdrawAuto(now, out);
  } else if (louder && steering()) {
    undoMove();
  }
}

void OverrideGate::undoMove() STILLCUT_RT {
  louder_ = setpoint_.target();
  const Factors before = judge_.before();
  const bool home = alike(before, {});
  if (home) {
    setpoint_.goBack();
  } else {
    setpoint_.propose(before, true);
  }
  enter(home ? GateCause::Returns : GateCause::Follows);
}

bool OverrideGate::triedLouder(const Factors& wanted) const STILLCUT_RT {
  return authority_ == Authority::Auto && louder_ && alike(wanted, *louder_);
}

// A fault has ended what was in force: that was no help either, and a machine that is taken and let go by a fault of
// its sensor or its link is swung all the same.
void OverrideGate::countFault(Instant now, GateOutput& out) STILLCUT_RT {
  if (authority_ == Authority::Auto) take(judge_.fault(), now, out);
}

void OverrideGate::withdrawAuto(Instant now, GateOutput& out) STILLCUT_RT {
  const Reason why{ReasonCode::AutoWithoutHelp, {static_cast<double>(judge_.withoutHelp())}};
  say(out, now, EventLevel::Warning, why);
  setAuthority(Authority::Advise, now, out);
  relinquish(why, EventLevel::Info, now, out);
}

}  // namespace stillcut::safety
