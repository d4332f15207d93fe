#include "core/control/frequency_rule.h"

#include <stdexcept>

#include "core/control/speed_request.h"

namespace stillcut::control {
namespace {

// A frequency that jumps this fraction of the tooth-passing frequency is another member of the family, not noise:
// averaging the two would aim between them.
constexpr double kFamilyJump = 0.25;

}  // namespace

void FrequencyRule::prepareRule(const CutSetup& setup, const config::ParamSet& params) {
  const auto limits = config::checkOverrideLimits(params, setup, describe().id);
  if (!limits) throw std::runtime_error(limits.error().line());
  limits_ = *limits;
  retune(params);
  teeth_ = setup.teeth;
  reset();
}

void FrequencyRule::reset() {
  programmed_ = {};
  chatter_ = {};
  target_ = {};
  alarmed_ = false;
  heard_ = {};
  reason_ = {ReasonCode::NothingToDoAt, {}};
  forget();
}

OverrideRequest FrequencyRule::decide(const StrategyInput& input) {
  const MachineState& m = input.machine;
  const Verdict& v = input.verdict;
  if (!usable(m) || !v.valid || !isFinite(v.frequency) || !positive(input.dt.value)) {
    return keepOrNothing(input, target_);
  }
  if (programmedSpeedChanged(m, programmed_)) {
    reset();
    programmed_ = m.programmedSpeed;
  }
  const Rpm present = actualOrCommandedSpeed(m);
  const bool alarm = options_.waitForChatter ? v.state == CutState::Chatter : v.alarming();
  if (teeth_ <= 0) {
    reason_ = teethNotKnown(input);
  } else if (alarm && v.frequency.value > 0.0) {
    smooth(v, input.dt, toothPassing(present, teeth_));
    heard_ = chatter_;
    take(aim(look(input, present)));
  } else if (!alarm && target_.value > 0.0) {
    if (alarmed_ && options_.freeze) target_ = present;
    chatter_ = {};
    take(whenQuiet(look(input, present)));
  }
  alarmed_ = alarm;
  return speedRequest(input, target_, reason_);
}

Aim FrequencyRule::whenQuiet(const RuleView& /*view*/) {
  return {{}, {ReasonCode::KeepingSpeed, {target_.value, heard_.value}}};
}

void FrequencyRule::smooth(const Verdict& verdict, Seconds dt, Hertz toothPass) {
  const bool jump = std::abs((verdict.frequency - chatter_).value) > kFamilyJump * toothPass.value;
  if (!alarmed_ || chatter_.value <= 0.0 || jump) {
    chatter_ = verdict.frequency;
    return;
  }
  chatter_ += (verdict.frequency - chatter_) * (dt.value / (dt.value + options_.smoothing.value));
}

RuleView FrequencyRule::look(const StrategyInput& input, Rpm present) const {
  const MachineState& m = input.machine;
  RuleView view;
  view.now = input.now;
  view.dt = input.dt;
  view.chatter = chatter_;
  view.teeth = teeth_;
  view.present = present;
  view.programmed = m.programmedSpeed * m.operatorSpeed.value;
  view.perturbation = std::isfinite(input.perturbation) ? input.perturbation : -1.0;
  view.level = view.perturbation >= 0.0 ? view.perturbation : shown(input.verdict.severity.value);
  view.effect = m.link.effect;
  view.vibration = std::isfinite(input.vibration) ? input.vibration : -1.0;
  view.air = input.verdict.state == CutState::AirCutting;
  view.reach = reachableSpeeds(limits_, m);
  return view;
}

void FrequencyRule::take(const Aim& aim) {
  if (positive(aim.speed.value)) target_ = aim.speed;
  if (aim.reason.code != ReasonCode::None) reason_ = aim.reason;
}

}  // namespace stillcut::control
