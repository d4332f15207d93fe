#include "core/control/fuzzy.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/control/speed_request.h"

namespace stillcut::control {
namespace {

constexpr double kLearnStable = 0.5;   // [s] of stable cut whose level is 1 V
constexpr double kSteadyLevel = 0.25;  // two such stretches differ by less, or the cut is still coming in
// Averaged spectra remember what was loud. While the level is below half of what they still hold, their coherence is
// that of the past.
constexpr double kMemoryTurns = 18.0;
constexpr double kOfThePast = 0.5;
constexpr double kFalling = 0.9;      // of the level a cycle ago: what was done works
constexpr double kSeverityRef = 0.2;  // energy ratio that the detectors call full chatter
constexpr double kOvershoot = 1.1, kMostOvershoot = 2.0;
constexpr double kScalingExponent = 0.5, kScalingError = 0.5;  // alpha_E and eps_E of the input scaling
constexpr double kLeastScaling = 0.5, kMostScaling = 2.0;
constexpr int kLearnEvery = 6;

bool allUsable(const StrategyInput& in) {
  const MachineState& m = in.machine;
  return usable(m) && std::isfinite(m.programmedFeed.value) && std::isfinite(m.operatorFeed.value) &&
         in.verdict.valid && isFinite(in.verdict.severity) && positive(in.dt.value);
}

}  // namespace

StrategyInfo Fuzzy::describe() const {
  return {"fuzzy", "Fuzzy speed and feed", "Xu 2003, section 3.3", "coherence"};
}

void Fuzzy::prepare(const CutSetup& setup, const config::ParamSet& params) {
  const auto limits = config::checkOverrideLimits(params, setup, describe().id);
  if (!limits) throw std::runtime_error(limits.error().line());
  limits_ = *limits;
  const FuzzyOptions options = fuzzyOptions(params);
  if (const Status usable = checkFuzzyOptions(options); !usable) throw std::runtime_error(usable.error().line());
  options_ = options;
  shownRefused_.store(false, std::memory_order_relaxed);
  reset();
}

void Fuzzy::retune(const config::ParamSet& params) {
  const FuzzyOptions options = fuzzyOptions(params);
  const bool refused = !usableTogether(options);
  shownRefused_.store(refused, std::memory_order_relaxed);
  if (refused) return;
  // A rule that a person has changed counts as said; what was learned of the others stays.
  for (std::size_t i = 0; i < speedRules_.size(); ++i) {
    for (std::size_t j = 0; j < speedRules_[i].size(); ++j) {
      if (options.speedRules[i][j] != options_.speedRules[i][j]) speedRules_[i][j] = options.speedRules[i][j];
      if (options.feedRules[i][j] != options_.feedRules[i][j]) feedRules_[i][j] = options.feedRules[i][j];
    }
  }
  options_ = options;
  showRules();
}

void Fuzzy::showRules() {
  for (std::size_t k = 0; k < kCells; ++k) {
    const std::size_t row = k / kCoherenceSets, column = k % kCoherenceSets;
    shownRules_[k].store(static_cast<float>(speedRules_[row][column]), std::memory_order_relaxed);
    shownRules_[kCells + k].store(static_cast<float>(feedRules_[row][column]), std::memory_order_relaxed);
  }
  shownLessons_.store(lessons_, std::memory_order_relaxed);
}

bool Fuzzy::readRules(RuleTables& into) const {
  for (std::size_t k = 0; k < kCells; ++k) {
    const std::size_t row = k / kCoherenceSets, column = k % kCoherenceSets;
    into.speed[row][column] = shownRules_[k].load(std::memory_order_relaxed);
    into.feed[row][column] = shownRules_[kCells + k].load(std::memory_order_relaxed);
  }
  into.lessons = shownLessons_.load(std::memory_order_relaxed);
  into.refused = shownRefused_.load(std::memory_order_relaxed);
  return true;
}

void Fuzzy::relinquish() {
  speed_ = feed_ = 1.0;
  heldFrom_ = 0.0;
  moved_ = false;
  reason_ = {ReasonCode::NothingToDoAt, {}};
}

void Fuzzy::reset() {
  speedRules_ = options_.speedRules;
  feedRules_ = options_.feedRules;
  lessons_ = 0;
  showRules();
  programmed_ = {};
  relinquish();
  elapsed_ = levelSum_ = coherenceMax_ = counted_ = 0.0;
  stable_ = stableSum_ = stableTime_ = stableBefore_ = remembered_ = 0.0;
  coherenceKnown_ = hearsEnergy_ = false;
  sinceAlarm_ = 1e9;
  lastCoherence_ = energy1_ = energy2_ = 0.0;
  errors_.fill(0.0);
  past_ = 0;
  rising_ = 0;
}

OverrideRequest Fuzzy::decide(const StrategyInput& input) {
  if (!allUsable(input)) {
    const MachineState& m = input.machine;
    return keepOrNothing(input, moved_ ? m.programmedSpeed * (m.operatorSpeed.value * speed_) : Rpm());
  }
  if (programmedSpeedChanged(input.machine, programmed_)) {
    reset();
    programmed_ = input.machine.programmedSpeed;
  }
  gather(input);
  // A move whose effect has not come yet would be judged by the cut before it: a slow machine has a longer cycle.
  if (elapsed_ >= std::max(options_.cycle, input.machine.link.effect.value)) {
    cycle(input);
    elapsed_ = levelSum_ = coherenceMax_ = counted_ = 0.0;
    coherenceKnown_ = false;
  }
  return answer(input);
}

// E_r of eq. 3-8; where no detector makes it, the rms of the first channel. Never both: they are not in one unit.
double Fuzzy::levelOf(const StrategyInput& input) {
  if (input.energy >= 0.0 && !hearsEnergy_) {
    hearsEnergy_ = true;
    stable_ = stableSum_ = stableTime_ = stableBefore_ = remembered_ = levelSum_ = counted_ = 0.0;
  }
  const double level = hearsEnergy_ ? input.energy : input.vibration;
  return std::isfinite(level) ? level : -1.0;
}

void Fuzzy::gather(const StrategyInput& input) {
  const double dt = std::min(input.dt.value, options_.cycle);
  const Verdict& v = input.verdict;
  elapsed_ += dt;
  sinceAlarm_ = v.alarming() ? 0.0 : sinceAlarm_ + dt;
  double coherence = input.coherence;
  if (!(coherence >= 0.0)) {
    const double s = std::clamp(v.severity.value, 0.0, 1.0);
    const double ref = options_.coherenceRef;
    coherence =
        s < kSeverityRef ? ref * s / kSeverityRef : ref + (1.0 - ref) * (s - kSeverityRef) / (1.0 - kSeverityRef);
    // Where the detector itself calls the cut stable, a high ratio is no chatter.
    if (!v.alarming()) coherence = std::min(coherence, 0.5 * ref);
  }
  // Two sensors agree on a spindle that hums in air as well.
  if (v.phase == CutPhase::AirCutting) coherence = std::min(coherence, 0.5 * options_.coherenceRef);
  const double level = levelOf(input);
  if (!ofThePast(input, level, dt)) {
    coherenceMax_ = std::max(coherenceMax_, std::clamp(coherence, 0.0, 1.0));
    coherenceKnown_ = true;
  }
  if (!(level >= 0.0)) return;
  levelSum_ += level * dt;
  counted_ += dt;
  learnStable(v, level, dt);
}

// Spectra averaged over revolutions, as gamma_max comes from, forget chatter slower than it decays.
bool Fuzzy::ofThePast(const StrategyInput& input, double level, double dt) {
  if (!(input.coherence >= 0.0) || !(level >= 0.0)) return false;
  const double turns = dt * toHertz(input.machine.programmedSpeed).value;
  remembered_ = std::max(level * level, remembered_ * std::exp(-turns / kMemoryTurns));
  return level * level < kOfThePast * kOfThePast * remembered_;
}

// The level of the cut before anything chatters, once it no longer grows with the tool's coming in.
void Fuzzy::learnStable(const Verdict& v, double level, double dt) {
  if (stable_ > 0.0 || v.state != CutState::Stable || v.phase == CutPhase::Exit) return;
  stableSum_ += level * dt;
  stableTime_ += dt;
  if (stableTime_ < kLearnStable) return;
  const double mean = stableSum_ / stableTime_;
  if (std::abs(mean - stableBefore_) < kSteadyLevel * mean) stable_ = mean;
  stableBefore_ = mean;
  stableSum_ = stableTime_ = 0.0;
}

void Fuzzy::cycle(const StrategyInput& input) {
  const bool known = stable_ > 0.0 && counted_ > 0.0;
  const double energy = known ? levelSum_ / counted_ / stable_ : 0.0;
  // At its reference coherence asks for nothing.
  const double coherence = coherenceKnown_ ? coherenceMax_ : options_.coherenceRef;
  FuzzyInputs in = scaled(coherence, energy);
  in.energyKnown = known;
  lastCoherence_ = coherence;
  reason_ = said(input, coherence, energy);
  if (input.verdict.phase == CutPhase::AirCutting) {
    if (feed_ < heldFrom_) feedAgain(in, input.machine);
    reason_ = said(input, coherence, energy);
    return;  // nothing is cut that another speed could quieten, or that taught
  }
  if (coherence > options_.coherenceRef || (known && energy > options_.energyRef)) sinceAlarm_ = 0.0;
  const bool works = known && energy > options_.energyRef && energy < kFalling * energy1_;
  const double stronger = overshoot(energy) * tune(in);
  moveBy(works ? 0.0 : stronger * infer(speedRules_, in, options_.centres),
         stronger * infer(feedRules_, in, options_.centres), elapsed_ / options_.rangeTime, input.machine);
  learn(in);
  // Table 3.1, and what an impact comes to.
  if (feed_ >= heldFrom_) heldFrom_ = 0.0;
  const double before = feed_;
  if (energy > options_.energyUp) feed_ = std::min(feed_, limits_.lowestFeed.value);
  if (energy > 2.0 * options_.energyUp) feed_ = 0.0;
  if (feed_ <= 0.0) heldFrom_ = std::max(heldFrom_, before);
  reason_ = said(input, coherence, energy);
}

// Without feed there is no cut, and the detectors find air cutting: what was held there by us would stay held.
void Fuzzy::feedAgain(const FuzzyInputs& in, const MachineState& machine) {
  moveBy(0.0, infer(feedRules_, in, options_.centres), elapsed_ / options_.rangeTime, machine);
  feed_ = std::min(feed_, heldFrom_);
}

Reason Fuzzy::said(const StrategyInput& input, double coherence, double energy) const {
  const Rpm speed = programmed_ * (input.machine.operatorSpeed.value * speed_);
  const MetresPerSecond feed = input.machine.programmedFeed * (input.machine.operatorFeed.value * feed_);
  return {ReasonCode::FuzzyRules, {coherence, energy, speed.value, toMmPerMin(feed)}};
}

FuzzyInputs Fuzzy::scaled(double coherence, double energy) {
  const double ref = options_.coherenceRef;
  const double error = energy - options_.energyRef;
  errors_[past_++ % kPast] = error;
  double sum = 0.0;
  for (const double e : errors_) sum += e * e;
  const double index = std::sqrt(sum / static_cast<double>(std::min(past_, kPast)));
  const double b = std::clamp(std::pow(index / kScalingError, kScalingExponent), kLeastScaling, kMostScaling);
  FuzzyInputs in;
  in.coherence = b * (coherence - ref) / (coherence >= ref ? 1.0 - ref : ref);
  in.change = b * (coherence - lastCoherence_);
  in.energy = b * error / (error >= 0.0 ? options_.energyUp - options_.energyRef : options_.energyRef);
  return in;
}

double Fuzzy::overshoot(double energy) {
  const bool rises = energy > energy1_ && energy1_ > energy2_ && energy2_ > options_.energyRef;
  rising_ = rises ? std::min(rising_ + 1, 8) : 0;
  energy2_ = energy1_;
  energy1_ = energy;
  return std::min(kMostOvershoot, std::pow(kOvershoot, rising_));
}

// `step`: fraction of the whole range that may be gone.
void Fuzzy::moveBy(double speed, double feed, double step, const MachineState& m) {
  const config::FactorRange speeds = speedFactors(limits_, m);
  const config::FactorRange feeds = feedFactors(limits_, m);
  const double most = std::min(1.0, step);
  const double topSpeed = std::max(1.0, std::min(speeds.high, options_.highest));
  const double topFeed = std::max(1.0, std::min(feeds.high, options_.highest));
  const bool rest = speed > 0.0 && sinceAlarm_ < options_.rest;
  const double dv = rest ? 0.0 : std::clamp(speed, -1.0, 1.0) * most * (topSpeed - speeds.low);
  const double df = std::clamp(feed, -1.0, 1.0) * most * (topFeed - feeds.low);
  speed_ = std::clamp(speed_ + dv, speeds.low, topSpeed);
  // The feed per tooth stays at or below the programmed one.
  const double perTooth = std::max(feeds.low, std::min(topFeed, limits_.feedPerTooth * speed_));
  feed_ = std::clamp(feed_ + df, feeds.low, perTooth);
  moved_ = moved_ || speed_ < 1.0 - 1e-6 || feed_ < 1.0 - 1e-6 || speed_ > 1.0 + 1e-6 || feed_ > 1.0 + 1e-6;
}

OverrideRequest Fuzzy::answer(const StrategyInput& input) const {
  OverrideRequest request;
  request.time = input.now;
  request.claimsSpeed = true;
  request.claimsFeed = true;
  request.reason = reason_.code == ReasonCode::NothingToDoAt ? nothingToDoAt(input) : finite(reason_);
  if (!moved_) return request;
  const MachineState& m = input.machine;
  request.kind = RequestKind::Set;
  request.speed = m.programmedSpeed * (m.operatorSpeed.value * speed_);
  request.feed = m.programmedFeed * (m.operatorFeed.value * feed_);
  return request;
}

StrategyInfo FuzzyLearning::describe() const {
  return {"fuzzy-learning", "Fuzzy, learning its rules", "Xu 2003, section 3.4.1", "coherence"};
}

void FuzzyLearning::reset() {
  Fuzzy::reset();
  correction_ = {};
  cycles_ = 0;
}

// Eq. 3-32, 3-33. The neutral coherence error is 0: at the reference nothing is to be regulated.
void FuzzyLearning::learn(const FuzzyInputs& in) {
  const RuleTable strength = firing(in, options_.centres);
  const double delta = options_.learning * std::clamp(in.coherence, -1.0, 1.0);
  for (std::size_t i = 0; i < strength.size(); ++i) {
    for (std::size_t j = 0; j < strength[i].size(); ++j) correction_[i][j] += strength[i][j] * delta / kLearnEvery;
  }
  if (++cycles_ < kLearnEvery) return;
  for (std::size_t i = 0; i < correction_.size(); ++i) {
    for (std::size_t j = 0; j < correction_[i].size(); ++j) {
      speedRules_[i][j] = std::clamp(speedRules_[i][j] - correction_[i][j], 1.0, 9.0);
      feedRules_[i][j] = std::clamp(feedRules_[i][j] - correction_[i][j], 1.0, 9.0);
    }
  }
  correction_ = {};
  cycles_ = 0;
  ++lessons_;
  showRules();
}

StrategyInfo FuzzyDirect::describe() const {
  return {"fuzzy-direct", "Fuzzy, outputs tuned directly", "Xu 2003, section 3.4.2", "coherence"};
}

double FuzzyDirect::tune(const FuzzyInputs& in) const {
  const double coherence = options_.coherenceWeight * std::clamp(in.coherence, -1.0, 1.0);
  if (!options_.doubleTuning || !in.energyKnown) return std::abs(coherence);
  return std::min(1.0, std::abs(coherence + options_.energyWeight * std::clamp(in.energy, -1.0, 1.0)));
}

}  // namespace stillcut::control
