#include "core/detect/van_dijk/parametric.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/dsp/kernels/choose.h"
#include "core/dsp/line_phase.h"

namespace stillcut::detect {
namespace {

constexpr std::array<const config::ParamDecl*, 11> kParams{&kParHarmonics, &kParMu,       &kParLambda, &kParRv,
                                                           &kParRw,        &kParDelta,    &kParRate,   &kParVariance,
                                                           &kParRoot,      &kParEvidence, &kParChatter};
constexpr std::array<std::string_view, 6> kIndicators{"variance", "h", "root", "frequency_hz", "part", "floor"};

enum Own : std::size_t { OwnHarmonics, OwnMu, OwnLambda, OwnRate, OwnVariance, OwnScale, OwnFloor };
constexpr std::array<std::string_view, 3> kWhyHarmonics{kSetByHand, "as many as the working rate hears at this speed",
                                                        "32, where the forced vibration of most cuts ends"};
constexpr std::array<std::string_view, 2> kWhyMu{kSetByHand, "a memory of two turns at this speed"};
constexpr std::array<std::string_view, 2> kWhyLambda{kSetByHand, "leaves 1 % of each harmonic"};
constexpr std::array<std::string_view, 3> kWhyRate{
    kSetByHand, "thinned by a whole factor to the paper's 10 kHz or somewhat more", "the sampling rate itself"};
constexpr std::array<std::string_view, 3> kWhyVariance{kNotLearned, kSetByHand,
                                                       "four times the noise floor, or the least growth that counts"};
constexpr std::array<std::string_view, 3> kWhyLearned{kNotLearned, kMeanOfStable, kHeldInAlarm};
constexpr std::array<AutoValueDecl, 7> kOwnValues{{
    {"parametric.harmonics", "Harmonics", "", kWhyHarmonics},
    {"parametric.mu", "NLMS step", "", kWhyMu},
    {"parametric.lambda", "NLMS leak", "", kWhyLambda},
    {"parametric.rate", "Working rate", "Hz", kWhyRate},
    {"parametric.variance", "Variance limit", "", kWhyVariance},
    {"parametric.scale", "Scale of the signal", "", kWhyLearned},
    {"parametric.floor", "Noise floor", "", kWhyLearned},
}};

constexpr double kPaperRate = 10000.0;  // Hz
constexpr int kMostHarmonics = 32;
constexpr double kUsableBand = 0.4;  // of the working rate
constexpr double kPassBand = 0.35;   // of the working rate: above it, folded lines would lie between the harmonics
constexpr int kFilterOrder = 10;
constexpr double kMemoryTurns = 2.0;
constexpr double kLeakLeaves = 0.01;
constexpr double kStartVariance = 1.0;
constexpr double kVarianceTurns = 1.0;  // averaging of the residual
constexpr double kPowerTurns = 8.0;     // of the vibration
constexpr double kLeastTaken = 0.02;    // of the vibration; noise alone loses more to the harmonics
constexpr double kScaleTurns = 40.0;    // of the scale in the stable cut
constexpr double kSettleTurns = 8.0;
constexpr double kSmallest = 0.14;   // amplitude ratio: a depth ramp shakes the modes by half of that
constexpr double kModelTurns = 2.0;  // averaging of theta
constexpr double kClearTurns = 8.0;
constexpr double kSlowest = 0.5;  // of the told speed: as far as overrides go
constexpr int kLookSteps = 2;     // half a turn
constexpr double kMeanLooks = 10.0;
constexpr double kEntryTurns = 12.0;  // a high ratio must last this long where no floor was learned
constexpr double kEntrySeconds = 0.2;
constexpr double kSameLine = 0.25;  // orders
constexpr Hertz kSpindleUnknown{20.0};

// f^(2 eta), as the energy ratio weighs a power (Caliskan 2018 eq. 28).
double weight(double f, int eta) {
  return eta == 0 ? 1.0 : eta > 0 ? f * f : 1.0 / (f * f);
}

}  // namespace

config::ParamTable parametricParams() {
  return kParams;
}

DetectorInfo ParametricDetector::describe() const {
  return {"parametric", "Parametric", "van Dijk 2010", kIndicators};
}

void ParametricDetector::prepare(const CutSetup& setup, const config::ParamSet& params) {
  const double least = params.isAutomatic(kParRate) ? kPaperRate : params.real(kParRate);
  factor_ = std::max(1, static_cast<int>(setup.rate.value / least));
  rate_ = setup.rate.value / factor_;
  const double nominal = setup.nominalSpeed.value > 0.0 ? toHertz(setup.nominalSpeed).value : kSpindleUnknown.value;
  const int allowed = std::max(1, static_cast<int>(kUsableBand * rate_ / (0.8 * nominal)));
  harmonicsSet_ = !params.isAutomatic(kParHarmonics);
  rateSet_ = !params.isAutomatic(kParRate);
  const int wanted =
      params.isAutomatic(kParHarmonics) ? kMostHarmonics : static_cast<int>(std::lround(params.real(kParHarmonics)));
  harmonics_ = std::min(wanted, allowed);
  mu_ = params.isAutomatic(kParMu) ? 0.0 : params.real(kParMu);
  lambda_ = params.isAutomatic(kParLambda) ? 0.0 : params.real(kParLambda);
  most_ = static_cast<std::size_t>(std::max(setup.blockFrames, 1));
  thinned_.assign(setup.channels.size() * most_, 0.0);
  rest_.assign(setup.channels.size() * most_, 0.0);
  history_.prepare(static_cast<int>(setup.channels.size()),
                   static_cast<int>(std::ceil((kLinePhaseTurns + 0.5) * rate_ / (kSlowest * nominal))));
  kernels_ = dsp::kernels::bestKernels();
  recursions_.prepare(static_cast<int>(setup.channels.size()), harmonics_,
                      {params.real(kParRv), params.real(kParRw), kStartVariance}, kernels_);
  judge_.prepare(setup.teeth);
  channels_.assign(setup.channels.size(), {});
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    ParametricChannel& c = channels_[i];
    c.eta = integrationFactor(setup.channels[i].quantity);
    c.weights.resize(dsp::kernels::wholeLanes(static_cast<std::size_t>(harmonics_)));
    for (std::size_t l = 0; l < c.weights.size(); ++l) c.weights[l] = weight(static_cast<double>(l + 1), c.eta);
  }
  lowPass_.assign(factor_ > 1 ? channels_.size() : 0, {});
  for (dsp::Butterworth& filter : lowPass_) filter.lowPass(kFilterOrder, Hertz(kPassBand * rate_), setup.rate);
  retune(params);
  reset();
}

void ParametricDetector::retune(const config::ParamSet& params) {
  delta_ = params.real(kParDelta);
  varianceLimit_ = params.isAutomatic(kParVariance) ? 0.0 : params.real(kParVariance);
  rootLimit_ = params.real(kParRoot);
  chatterRatio_ = params.real(kParChatter);
  judge_.setChatterRatio(chatterRatio_);
  for (ParametricChannel& c : channels_) c.onset.prepare({kSmallest * kSmallest, params.real(kParEvidence)});
}

double ParametricDetector::chosen(const config::ParamDecl& decl) const {
  if (decl.key == kParHarmonics.key) return harmonics_;
  return decl.key == kParRate.key ? rate_ : config::kAutomatic;
}

void ParametricDetector::reset() {
  judge_.reset();
  leaveCut();
  restart();
  for (ParametricChannel& c : channels_) c.scale = 0.0;
}

void ParametricDetector::restart() {
  recursions_.reset();
  history_.reset();
  looks_ = 0.0;
  sinceLook_ = kLookSteps;
  for (dsp::Butterworth& filter : lowPass_) filter.reset();
  for (ParametricChannel& c : channels_) {
    c.residualSum = c.inputSum = c.variance = c.power = c.taken = c.root = c.severity = 0.0;
    c.frequency = {};
    c.theta = c.thetaSum = {};
    c.roots = {};
  }
  phase_ = 0;
  inStep_ = 0;
  steadyTurns_ = 0.0;
}

void ParametricDetector::leaveCut() {
  for (ParametricChannel& c : channels_) c.onset.reset();
  highTurns_ = clearTurns_ = 0.0;
  leading_ = 0;
}

void ParametricDetector::tune(const ConditionedBlock& block) {
  spindle_ = block.spindle.value > 0.0 ? block.spindle : kSpindleUnknown;
  const double turn = rate_ / spindle_.value;
  stepFrames_ = std::max(1L, std::lround(turn / kStepsPerTurn));
  const int active = std::clamp(static_cast<int>(kUsableBand * rate_ / spindle_.value), 1, harmonics_);
  const double mu = mu_ > 0.0 ? mu_ : std::min(1.0, active / (kMemoryTurns * turn));
  const double lambda = lambda_ > 0.0 ? lambda_ : 1.0 - kLeakLeaves * mu / active;
  recursions_.tune(active, mu, lambda);
  for (ParametricChannel& c : channels_) c.onset.setSpindle(spindle_);
  tellOwn(active, mu, lambda);
}

AutoValueTable ParametricDetector::autoValues() const {
  return kOwnValues;
}

void ParametricDetector::tellOwn(int active, double mu, double lambda) {
  own_.set(OwnHarmonics, active, harmonicsSet_ ? 0 : active < kMostHarmonics ? 1 : 2);
  own_.set(OwnMu, mu, mu_ > 0.0 ? 0 : 1);
  own_.set(OwnLambda, lambda, lambda_ > 0.0 ? 0 : 1);
  own_.set(OwnRate, rate_, rateSet_ ? 0 : factor_ > 1 ? 1 : 2);
  if (channels_.empty()) return;
  const ParametricChannel& c = channels_[leading_];
  const bool known = c.onset.learned();
  const std::size_t held = judge_.calm() ? 1 : 2;
  own_.set(OwnScale, c.scale > 0.0 ? 1.0 / c.scale : config::kAutomatic, c.scale > 0.0 ? held : 0);
  own_.set(OwnFloor, known ? shareOf(c.onset.floor()) : config::kAutomatic, known ? held : 0);
  if (varianceLimit_ > 0.0) {
    own_.set(OwnVariance, varianceLimit_, 1);
  } else {
    const double least = c.onset.leastGrowth();
    own_.set(OwnVariance, known ? least * std::max(c.taken, kLeastTaken * c.power) : config::kAutomatic, known ? 2 : 0);
  }
}

// Low-passes every frame of the block and keeps one of `factor`. Number of frames kept.
std::size_t ParametricDetector::thin(const ConditionedBlock& block) {
  first_ = (factor_ - phase_) % factor_;
  phase_ = (phase_ + block.frames) % factor_;
  const std::size_t count =
      block.frames > first_ ? static_cast<std::size_t>((block.frames - first_ - 1) / factor_) + 1 : 0;
  if (lowPass_.empty()) {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const std::span<const double> in = block.channel(static_cast<int>(i));
      std::copy(in.begin(), in.end(), thinned_.data() + i * most_);
    }
    return count;
  }
  const auto stride = static_cast<std::ptrdiff_t>(most_);
  dsp::Butterworth::process(lowPass_, block.samples, block.stride, thinned_.data(), stride,
                            static_cast<std::size_t>(block.frames), kernels_);
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    double* row = thinned_.data() + i * most_;
    for (std::size_t k = 0; k < count; ++k)
      row[k] = row[static_cast<std::size_t>(first_) + k * static_cast<std::size_t>(factor_)];
  }
  return count;
}

// Frames kept, from `from` on, that belong to one step and one turn per frame.
std::size_t ParametricDetector::stretch(const ConditionedBlock& block, std::size_t from, std::size_t count) const {
  const double* step = block.angleStep + first_;
  const auto most = static_cast<std::size_t>(std::max(stepFrames_ - inStep_, 1L));
  std::size_t n = 1;
  while (n < most && from + n < count && step[(from + n) * factor_] == step[from * factor_]) ++n;
  return n;
}

void ParametricDetector::processFrames(std::size_t from, std::size_t count) {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    ParametricChannel& c = channels_[i];
    const double* x = thinned_.data() + i * most_ + from;
    double* rest = rest_.data() + i * most_;
    recursions_.process(static_cast<int>(i), x, rest, count, c.scale, c.thetaSum);
    for (std::size_t k = 0; k < count; ++k) {
      c.residualSum += rest[k] * rest[k];
      c.inputSum += x[k] * x[k];
    }
  }
  history_.push(rest_.data(), static_cast<std::ptrdiff_t>(most_), count);
  recursions_.advance(count);
  inStep_ += static_cast<long>(count);
}

void ParametricDetector::readModel(std::size_t channel) {
  ParametricChannel& c = channels_[channel];
  if (const ArCoefficients theta = recursions_.theta(static_cast<int>(channel)); unstable(theta)) {
    ArRoots newest = rootsOf(theta);
    if (reflect(newest, delta_)) recursions_.setTheta(static_cast<int>(channel), thetaOf(newest));
  }
  const double rate = 1.0 - std::exp(-1.0 / (kModelTurns * kStepsPerTurn));
  for (std::size_t n = 0; n < c.theta.size(); ++n) {
    c.theta[n] += rate * (c.thetaSum[n] / static_cast<double>(inStep_) - c.theta[n]);
    c.thetaSum[n] = 0.0;
  }
  c.roots = rootsOf(c.theta, c.roots);
  ArRoots roots = c.roots;
  reflect(roots, delta_);
  const std::complex<double> dominant = dominantRoot(roots);
  c.root = std::abs(dominant);
  c.frequency = rootFrequency(dominant, Hertz(rate_));
}

double ParametricDetector::density(const ParametricChannel& c) const {
  if (!(c.root > 0.0)) return 0.0;  // no model yet
  ArRoots roots = c.roots;
  reflect(roots, delta_);
  return modelDensity(thetaOf(roots), c.frequency, Hertz(rate_));
}

// Energy ratio as Caliskan 2018 eq. 28 has it, of the residual at f_c against the harmonics as NLMS holds them.
double ParametricDetector::severity(std::size_t channel) const {
  const ParametricChannel& c = channels_[channel];
  if (!(c.frequency.value > 0.0)) return 0.0;
  const double chatter = c.variance * weight(c.frequency.value, c.eta);
  const double forced =
      weight(spindle_.value, c.eta) * recursions_.weightedPower(static_cast<int>(channel), c.weights.data());
  return chatter > 0.0 ? chatter / (chatter + forced) : 0.0;
}

// What the harmonics leave over what they take. The residual is averaged more shortly: it may be ahead.
double ParametricDetector::odds(const ParametricChannel& c) {
  return c.power > 0.0 ? c.variance / std::max(c.taken, kLeastTaken * c.power) : 0.0;
}

double ParametricDetector::shareOf(double odds) {
  return odds / (1.0 + odds);
}

void ParametricDetector::endChannelStep(std::size_t channel, CutPhase phase) {
  ParametricChannel& c = channels_[channel];
  const auto n = static_cast<double>(inStep_);
  const double turns = 1.0 / kStepsPerTurn;
  const double input = c.inputSum / n;
  c.variance += (1.0 - std::exp(-turns / kVarianceTurns)) * (c.residualSum / n - c.variance);
  const double rate = c.power > 0.0 ? 1.0 - std::exp(-turns / kPowerTurns) : 1.0;
  c.power += rate * (input - c.power);
  c.taken += rate * (input - c.residualSum / n - c.taken);
  c.residualSum = c.inputSum = 0.0;
  const double scale = c.power > 0.0 ? 1.0 / std::sqrt(c.power) : 0.0;
  if (!c.onset.learned()) {
    c.scale = scale;
  } else if (judge_.calm()) {
    c.scale += turns / kScaleTurns * (scale - c.scale);
  }
  readModel(channel);
  c.severity = severity(channel);
  if (phase != CutPhase::Steady || steadyTurns_ < kSettleTurns || !(c.power > 0.0)) return;
  c.onset.update(odds(c), turns, judge_.calm(), c.variance);
}

// Chatter that was there from the entry: no calm stretch was learned, so the fixed ratio decides, but only for one and
// the same root over many turns.
bool ParametricDetector::fromEntry(const ParametricChannel& c) {
  const bool same = std::abs(c.frequency.value - highLine_.value) < kSameLine * spindle_.value;
  const bool high = c.severity >= chatterRatio_ && c.root >= rootLimit_ && steadyTurns_ >= kSettleTurns;
  highTurns_ = high && same ? highTurns_ + 1.0 / kStepsPerTurn : 0.0;
  if (!same || !high) highLine_ = c.frequency;
  return highTurns_ > std::max(kEntryTurns, kEntrySeconds * spindle_.value);
}

// The dominant root tells which line; its phase tells where it is. Over half a turn it also tells of the line's mirror
// image about half a tooth passing, which beats with it: the mean over some turns is the stronger line's own.
void ParametricDetector::follow(Hertz root) {
  if (++sinceLook_ < kLookSteps) return;
  sinceLook_ = 0;
  const Hertz fine =
      linePhaseFrequency(history_.newest(static_cast<int>(leading_)), root, spindle_, Hertz(rate_), kernels_);
  const Hertz now = fine.value > 0.0 ? fine : root;
  const bool same = looks_ > 0.0 && std::abs(now.value - line_.value) < 0.5 * spindle_.value;
  if (same && !(fine.value > 0.0)) return;  // a root alone says less
  looks_ = same ? std::min(looks_ + 1.0, kMeanLooks) : 1.0;
  line_ = same ? line_ + (now - line_) * (1.0 / looks_) : now;
  judge_.follow(line_, spindle_ * (fine.value > 0.0 ? 0.02 : 0.1));
}

void ParametricDetector::endStep(const ConditionedBlock& block) {
  const double turns = 1.0 / kStepsPerTurn;
  steadyTurns_ = AlarmStateMachine::steady(block) ? steadyTurns_ + turns : 0.0;
  if (judge_.outdated(block)) leaveCut();
  bool grown = false;
  bool begins = false;
  double worst = 0.0;
  leading_ = 0;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    ParametricChannel& c = channels_[i];
    endChannelStep(i, block.phase);
    const bool over = varianceLimit_ > 0.0 ? c.variance > varianceLimit_ : c.onset.alarm();
    grown = grown || over;
    begins = begins || (over && c.root >= rootLimit_);
    worst = std::max(worst, c.severity);
    if (odds(c) > odds(channels_[leading_])) leading_ = i;
  }
  const ParametricChannel& lead = channels_[leading_];
  const bool entry = varianceLimit_ <= 0.0 && fromEntry(lead);
  const bool something = (grown || worst >= 0.5 * chatterRatio_) && lead.root >= 0.9 * rootLimit_;
  clearTurns_ = something ? 0.0 : clearTurns_ + turns;
  const Evidence evidence{begins || entry, clearTurns_ < kClearTurns, worst};
  judge_.judge(evidence, block, Seconds(static_cast<double>(inStep_) / rate_));
  if (!judge_.alarming()) {
    looks_ = 0.0;
    sinceLook_ = kLookSteps;
  } else if (lead.root >= rootLimit_) {
    follow(lead.frequency);
  }
  inStep_ = 0;
}

Verdict ParametricDetector::verdict(const ConditionedBlock& block) const {
  Verdict v = judge_.verdict(block);
  const ParametricChannel& c = channels_[leading_];
  v.indicators = {c.variance, density(c), c.root, c.frequency.value, shareOf(odds(c)), shareOf(c.onset.floor())};
  if (v.alarming()) {
    v.reason = {ReasonCode::ResidualGrowing, {shareOf(odds(c)), shareOf(c.onset.floor()), v.frequency.value}};
  } else if (v.valid && block.phase == CutPhase::Steady && !c.onset.learned()) {
    v.reason = {ReasonCode::Learning, {(OnsetTest::kLearnTurns + kSettleTurns) / spindle_.value}};
  }
  return v;
}

Verdict ParametricDetector::process(const ConditionedBlock& block) {
  if (!block.valid || channels_.empty()) return judge_.verdict(block);
  if (block.afterGap) restart();
  tune(block);
  const std::size_t count = thin(block);
  for (std::size_t k = 0; k < count;) {
    const std::size_t frame = static_cast<std::size_t>(first_) + k * static_cast<std::size_t>(factor_);
    const std::size_t frames = stretch(block, k, count);
    recursions_.align(block.angle[frame], block.angleStep[frame] * factor_);
    processFrames(k, frames);
    k += frames;
    if (inStep_ >= stepFrames_) endStep(block);
  }
  if (judge_.endBlock(block)) leaveCut();
  return verdict(block);
}

}  // namespace stillcut::detect
