#include "core/control/lobe_center.h"

#include <stdexcept>

namespace stillcut::control {
namespace {

using config::ParamDecl;

constexpr ParamDecl kSmoothing =
    config::realParam("lobe-center.smoothing", "Smoothing of the frequency", "ms", 50.0, 0.0, 2000.0,
                      "Time constant of the low-pass on the chatter frequency");
constexpr std::string_view kActOnChoices[] = {"onset", "chatter"};
constexpr ParamDecl kActOn = config::choiceParam("lobe-center.act-on", "Act on", 0, kActOnChoices,
                                                 "Move at the onset of chatter, or only when it is full chatter");
constexpr ParamDecl kFreeze =
    config::booleanParam("lobe-center.freeze", "Freeze when quiet", false,
                         "Stay at the actual speed once chatter clears, for narrow lobes, instead of going on to the "
                         "last target");
constexpr const ParamDecl* kParams[] = {&kSmoothing, &kActOn, &kFreeze};

// A frequency that jumps this share of the tooth-passing frequency is another member of the family, not noise:
// averaging the two would aim between them.
constexpr double kFamilyJump = 0.25;
constexpr double kSpeedWordShare = 1e-3;

Rpm presentSpeed(const MachineState& m) noexcept {
  return m.actualSpeed.value > 0.0 ? m.actualSpeed : m.targetSpeed();
}

bool usable(const MachineState& m) noexcept {
  return m.valid && std::isfinite(m.programmedSpeed.value) && m.programmedSpeed.value > 0.0 &&
         std::isfinite(m.operatorSpeed.value) && m.operatorSpeed.value > 0.0 && std::isfinite(presentSpeed(m).value) &&
         presentSpeed(m).value > 0.0;
}

}  // namespace

config::ParamTable lobeCenterParams() {
  return kParams;
}

StrategyInfo LobeCenter::describe() const {
  return {"lobe-center", "Centre of the lobe", "van Dijk 2010, section 4.1", true, true};
}

void LobeCenter::prepare(const CutSetup& setup, const config::ParamSet& params) {
  const auto limits = config::checkOverrideLimits(params, setup, "lobe-center");
  if (!limits) throw std::runtime_error(limits.error().line());
  limits_ = *limits;
  teeth_ = setup.teeth;
  smoothing_ = Seconds(params.real(kSmoothing) / 1000.0);
  waitForChatter_ = params.choice(kActOn) == 1;
  freeze_ = params.boolean(kFreeze);
  reset();
}

void LobeCenter::reset() noexcept {
  programmed_ = {};
  chatter_ = {};
  target_ = {};
  alarmed_ = false;
  reason_ = {ReasonCode::NothingToDo, {}};
}

OverrideRequest LobeCenter::decide(const StrategyInput& input) noexcept {
  const MachineState& m = input.machine;
  const Verdict& v = input.verdict;
  if (!usable(m) || !v.valid || !isFinite(v.frequency)) {
    OverrideRequest hold;
    hold.time = input.now;
    hold.kind = target_.value > 0.0 ? RequestKind::Hold : RequestKind::None;
    hold.reason = {ReasonCode::VerdictNotUsable, {}};
    return hold;
  }
  // Another S word is another cut: what was found for the old one says nothing.
  if (std::abs((m.programmedSpeed - programmed_).value) > kSpeedWordShare * m.programmedSpeed.value) {
    reset();
    programmed_ = m.programmedSpeed;
  }
  const Rpm present = presentSpeed(m);
  const bool alarm = waitForChatter_ ? v.state == CutState::Chatter : v.alarming();
  if (teeth_ <= 0) {
    reason_ = {ReasonCode::NoTeeth, {}};
  } else if (alarm && v.frequency.value > 0.0) {
    follow(v, input.dt, toothPassing(present, teeth_));
    aim(input, present);
  } else if (alarmed_ && !alarm) {
    chatter_ = {};
    if (freeze_ && target_.value > 0.0) target_ = present;
    if (target_.value > 0.0) reason_ = {ReasonCode::KeepingSpeed, {target_.value}};
  }
  alarmed_ = alarm;
  return answer(input);
}

void LobeCenter::follow(const Verdict& verdict, Seconds dt, Hertz toothPass) noexcept {
  const bool jump = std::abs((verdict.frequency - chatter_).value) > kFamilyJump * toothPass.value;
  if (!alarmed_ || chatter_.value <= 0.0 || jump || !(dt.value > 0.0)) {
    chatter_ = verdict.frequency;
    return;
  }
  chatter_ += (verdict.frequency - chatter_) * (dt.value / (dt.value + smoothing_.value));
}

void LobeCenter::aim(const StrategyInput& input, Rpm present) noexcept {
  const MachineState& m = input.machine;
  const config::SpeedRange reach = reachableSpeeds(limits_, m.programmedSpeed, m.operatorSpeed, m.operatorFeed);
  const Pocket pocket = pocketInReach(chatter_, teeth_, present, reach);
  if (pocket.waves == 0) {
    reason_ = {ReasonCode::TargetOutOfRange, {pocket.firstChoice.value, reach.low.value, reach.high.value}};
    return;
  }
  target_ = pocket.speed;
  if (pocket.moved) {
    reason_ = {ReasonCode::NextPocketInRange,
               {target_.value, static_cast<double>(pocket.waves), pocket.firstChoice.value, chatter_.value}};
  } else {
    reason_ = {ReasonCode::CentreOfNextPocket,
               {target_.value, static_cast<double>(pocket.waves), chatter_.value, present.value}};
  }
}

OverrideRequest LobeCenter::answer(const StrategyInput& input) const noexcept {
  OverrideRequest request;
  request.time = input.now;
  request.claimsSpeed = true;
  request.claimsFeed = true;
  request.reason = reason_;
  if (target_.value <= 0.0) return request;
  request.kind = RequestKind::Set;
  request.speed = target_;
  request.feed = feedFollowing(target_, input.machine);
  return request;
}

}  // namespace stillcut::control
