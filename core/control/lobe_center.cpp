#include "core/control/lobe_center.h"

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

}  // namespace

config::ParamTable lobeCenterParams() {
  return kParams;
}

StrategyInfo LobeCenter::describe() const {
  return {"lobe-center", "Centre of the lobe", "van Dijk 2010, section 4.1"};
}

void LobeCenter::prepare(const CutSetup& setup, const config::ParamSet& params) {
  prepareRule(setup, params);
}

void LobeCenter::retune(const config::ParamSet& params) {
  setOptions({Seconds(params.real(kSmoothing) / 1000.0), params.choice(kActOn) == 1, params.boolean(kFreeze)});
}

Aim LobeCenter::aim(const RuleView& view) {
  const LobeTarget pocket = pocketInReach(view.chatter, view.teeth, view.present, view.reach);
  if (pocket.waves == 0) {
    return {{},
            {ReasonCode::TargetOutOfRange,
             {pocket.firstChoice.value, view.reach.low.value, view.reach.high.value, view.chatter.value}}};
  }
  const auto waves = static_cast<double>(pocket.waves);
  if (pocket.moved) {
    return {pocket.speed,
            {ReasonCode::NextPocketInRange, {pocket.speed.value, waves, pocket.firstChoice.value, view.chatter.value}}};
  }
  return {pocket.speed,
          {ReasonCode::CentreOfNextPocket, {pocket.speed.value, waves, view.chatter.value, view.present.value}}};
}

}  // namespace stillcut::control
