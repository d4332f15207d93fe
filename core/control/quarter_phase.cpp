#include "core/control/quarter_phase.h"

namespace stillcut::control {
namespace {

using config::ParamDecl;

constexpr std::string_view kDirections[] = {"nearest", "down", "up"};
constexpr ParamDecl kDirection = config::choiceParam("quarter-phase.direction", "Direction", 0, kDirections,
                                                     "Speeds to choose from: the nearest, only lower, only higher");
constexpr ParamDecl kPhase = config::realParam("quarter-phase.phase", "Phase factor", "", 0.25, 0.05, 0.95,
                                               "Fraction of a wave left between two cuts (nu of eq. 3)");
constexpr ParamDecl kSmoothing =
    config::realParam("quarter-phase.smoothing", "Smoothing of the frequency", "ms", 50.0, 0.0, 2000.0,
                      "Time constant of the low-pass on the chatter frequency");
constexpr const ParamDecl* kParams[] = {&kDirection, &kPhase, &kSmoothing};

// A target within this fraction of the present speed counts as reached, whichever side of it it lies on.
constexpr double kReached = 0.02;

}  // namespace

config::ParamTable quarterPhaseParams() {
  return kParams;
}

QuarterTarget quarterPhaseSpeed(Hertz chatter, int teeth, Rpm present, double phase, SpeedDirection direction,
                                const config::SpeedRange& reach) STILLCUT_RT {
  const double waves = chatter / toothPassing(present, teeth);
  if (!std::isfinite(waves) || waves > 1e6) return {};
  // N falls as n grows: n at or above the present speed, and the next one below it.
  const double above = std::floor(waves - phase);
  QuarterTarget best;
  for (const double n : {above, above + 1.0}) {
    if (n < 0.0) continue;
    const Rpm speed = toRpm(chatter) / ((n + phase) * teeth);
    if (direction == SpeedDirection::Down && speed > present * (1.0 + kReached)) continue;
    if (direction == SpeedDirection::Up && speed < present * (1.0 - kReached)) continue;
    if (!reach.contains(speed)) continue;
    const bool nearer = best.waves <= 0.0 || std::abs((speed - present).value) < std::abs((best.speed - present).value);
    if (nearer) best = {speed, n + phase};
  }
  return best;
}

StrategyInfo QuarterPhase::describe() const {
  return {"quarter-phase", "Quarter wave between teeth", "Liao 1996, eq. 3"};
}

void QuarterPhase::prepare(const CutSetup& setup, const config::ParamSet& params) {
  prepareRule(setup, params);
}

void QuarterPhase::retune(const config::ParamSet& params) {
  direction_ = static_cast<SpeedDirection>(params.choice(kDirection));
  phase_ = params.real(kPhase);
  setOptions({Seconds(params.real(kSmoothing) / 1000.0), false, false});
}

Aim QuarterPhase::aim(const RuleView& view) {
  const QuarterTarget target =
      quarterPhaseSpeed(view.chatter, view.teeth, view.present, phase_, direction_, view.reach);
  if (target.waves > 0.0) {
    return {target.speed,
            {ReasonCode::QuarterWave, {target.speed.value, target.waves, view.chatter.value, view.present.value}}};
  }
  const config::SpeedRange everything{Rpm(0.0), Rpm(1e9)};
  const QuarterTarget wanted =
      quarterPhaseSpeed(view.chatter, view.teeth, view.present, phase_, direction_, everything);
  return {{},
          {ReasonCode::TargetOutOfRange,
           {wanted.speed.value, view.reach.low.value, view.reach.high.value, view.chatter.value}}};
}

}  // namespace stillcut::control
