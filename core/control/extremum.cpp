#include "core/control/extremum.h"

#include <algorithm>
#include <cmath>

namespace stillcut::control {
namespace {

using config::ParamDecl;

constexpr ParamDecl kMu = config::realParam("extremum.mu", "Step size", "", 0.7, 0.01, 2.0, "mu_c of eq. 32");
constexpr ParamDecl kLambda =
    config::realParam("extremum.lambda", "Smoothing of the level", "", 0.3, 0.01, 1.0, "lambda_c of eq. 33");
constexpr ParamDecl kUnit = config::realParam("extremum.unit", "Unit of a step", "%", 0.5, 0.01, 5.0,
                                              "What a step of 1 in eq. 32 is, in percent of the programmed speed");
constexpr ParamDecl kPeriod = config::realParam("extremum.period", "Control period", "ms", 100.0, 1.0, 5000.0,
                                                "Time from one step of eq. 32 to the next");
constexpr ParamDecl kSmoothing = config::realParam("extremum.smoothing", "Smoothing of the frequency", "ms", 50.0, 0.0,
                                                   2000.0, "Time constant of the low-pass on the chatter frequency");
constexpr ParamDecl kSeekStep =
    config::realParam("extremum.seek-step", "Step of the search", "%", 1.0, 0.2, 5.0,
                      "Distance of neighbouring trials, in percent of the programmed speed");
constexpr ParamDecl kSeekDwell =
    config::realParam("extremum.seek-dwell", "Longest time per trial", "ms", 400.0, 20.0, 10000.0,
                      "The vibration at each trial is averaged no longer than this");
constexpr ParamDecl kSeekTurns =
    config::realParam("extremum.seek-turns", "Revolutions per trial", "", 80.0, 5.0, 1000.0,
                      "The vibration at each trial is averaged over so many revolutions, or as long as is allowed");
constexpr const ParamDecl* kParams[] = {&kMu,        &kLambda,   &kUnit,      &kPeriod,
                                        &kSmoothing, &kSeekStep, &kSeekDwell, &kSeekTurns};

constexpr double kOnHarmonic = 1e-3;      // of the frequency: closer, the sign of Delta f is noise
constexpr double kChatterPatience = 1.0;  // [s] that chatter may take to die at the next trial
constexpr double kBeyond = 1.5;           // steps that the search may go past Delta f = 0: one trial
constexpr int kMostSearches = 2;          // per programmed speed: no hunting

}  // namespace

config::ParamTable extremumParams() {
  return kParams;
}

StrategyInfo Extremum::describe() const {
  if (seek_)
    return {"extremum-seek", "Least vibration", "van Dijk 2010, section 4.2, then a true search", "parametric"};
  return {"extremum-paper", "Toward less vibration", "van Dijk 2010, section 4.2", "parametric"};
}

void Extremum::prepare(const CutSetup& setup, const config::ParamSet& params) {
  prepareRule(setup, params);
}

void Extremum::retune(const config::ParamSet& params) {
  mu_ = params.real(kMu);
  lambda_ = params.real(kLambda);
  unit_ = params.real(kUnit) / 100.0;
  period_ = Seconds(params.real(kPeriod) / 1000.0);
  MinimumSearch::Options options;
  options.step = seekStep_ = params.real(kSeekStep) / 100.0;
  options.turns = params.real(kSeekTurns);
  options.dwell = Seconds(params.real(kSeekDwell) / 1000.0);
  search_.configure(options);
  setOptions({Seconds(params.real(kSmoothing) / 1000.0), false, false});
}

void Extremum::forget() {
  search_.forget();
  alarmed_ = false;
  alarmedFor_ = 0.0;
  searches_ = 0;
  started_ = false;
  settles_ = settledFrom_ = quietAt_ = {};
  heard_.fill({});
  alarms_ = 0;
}

// What the search compares: the vibration itself, where it is known.
double Extremum::compared(const RuleView& view) {
  return view.vibration >= 0.0 ? view.vibration : view.level;
}

// Up to the nearest speeds on either side that have chattered, and no more than a trial past where Delta f = 0: there
// the next lobe begins, unheard.
config::SpeedRange Extremum::quietReach(const RuleView& view) const {
  config::SpeedRange reach = view.reach;
  const Rpm beyond = view.programmed * (kBeyond * seekStep_);
  const bool fromAbove = settledFrom_ > settles_;
  if (reach.contains(settles_) && fromAbove) reach.low = std::max(reach.low, settles_ - beyond);
  if (reach.contains(settles_) && !fromAbove) reach.high = std::min(reach.high, settles_ + beyond);
  for (const Rpm speed : heard_) {
    if (speed.value <= 0.0) continue;
    if (speed < view.present) reach.low = std::max(reach.low, speed);
    if (speed > view.present) reach.high = std::min(reach.high, speed);
  }
  return reach;
}

Aim Extremum::aim(const RuleView& view) {
  const bool goesOn = searchGoesOn(view);
  if (!alarmed_) heard_[alarms_++ % kHeard] = view.present;
  alarmed_ = true;
  return goesOn ? searching(view) : law(view);
}

// Chatter came back during the search: the search is informed once, and again if the next trial does not end it.
bool Extremum::searchGoesOn(const RuleView& view) {
  if (search_.state() == MinimumSearch::State::Idle) return false;
  alarmedFor_ = alarmed_ ? alarmedFor_ + view.dt.value : 0.0;
  if (alarmed_ && alarmedFor_ < kChatterPatience) return true;
  alarmedFor_ = 0.0;
  if (search_.chattered()) return true;
  // Where the law would settle it chatters: back to where the cut became quiet, and search from there.
  if (!(quietAt_.value > 0.0)) return false;
  search_.start(quietAt_, view.programmed);
  quietAt_ = {};
  return true;
}

// Eq. 31-33.
Aim Extremum::law(const RuleView& view) {
  if (!started_) {
    started_ = true;
    theta_ = view.present / view.programmed - 1.0;
    gamma_ = 0.0;
    sincePeriod_ = std::max(period_.value, view.effect.value);
  }
  sincePeriod_ += view.dt.value;
  // A step whose effect has not come says nothing of the next: a slow machine is stepped slower.
  if (sincePeriod_ < std::max(period_.value, view.effect.value)) return {};
  sincePeriod_ = 0.0;

  const double root = std::sqrt(std::max(0.0, view.level));
  gamma_ = (1.0 - lambda_) * gamma_ + lambda_ * root;
  const double relative = gamma_ > 0.0 ? root / gamma_ : 0.0;
  const int waves = wavesBetweenTeeth(view.chatter, view.teeth, view.present);
  const Hertz apart = view.chatter - toothPassing(view.present, view.teeth) * waves;
  settles_ = speedForWaves(view.chatter, view.teeth, waves);
  settledFrom_ = view.present;
  if (std::abs(apart.value) > kOnHarmonic * view.chatter.value) {
    theta_ += std::copysign(2.0 * mu_ * relative * unit_, apart.value);
  }
  const Rpm wanted = view.programmed * (1.0 + theta_);
  const Rpm target = std::clamp(wanted, view.reach.low, view.reach.high);
  theta_ = target / view.programmed - 1.0;
  if (target == wanted) return {target, {ReasonCode::TowardLowerLevel, {target.value, apart.value, relative}}};
  return {
      target,
      {ReasonCode::TargetOutOfRange, {wanted.value, view.reach.low.value, view.reach.high.value, view.chatter.value}}};
}

Aim Extremum::whenQuiet(const RuleView& view) {
  if (view.air) return {};
  alarmed_ = false;
  started_ = false;
  if (!seek_) return FrequencyRule::whenQuiet(view);
  if (search_.state() == MinimumSearch::State::Idle) {
    if (searches_ >= kMostSearches) return FrequencyRule::whenQuiet(view);
    ++searches_;
    const bool farther = quietReach(view).contains(settles_);
    quietAt_ = farther ? view.present : Rpm();
    search_.start(farther ? settles_ : view.present, view.programmed);
  }
  search_.advance({view.dt.value, compared(view), view.present, quietReach(view), view.perturbation});
  if (search_.best().value > 0.0) quietAt_ = {};
  return searching(view);
}

Aim Extremum::searching(const RuleView& view) const {
  const Rpm speed = search_.trying();
  if (search_.state() == MinimumSearch::State::Done) {
    return {speed, {ReasonCode::MinimumFound, {speed.value, search_.bestLevel()}}};
  }
  const double level = compared(view);
  const bool first = !(search_.best().value > 0.0);
  return {speed,
          {ReasonCode::SeekingMinimum,
           {speed.value, level, first ? level : search_.bestLevel(), first ? speed.value : search_.best().value}}};
}

}  // namespace stillcut::control
