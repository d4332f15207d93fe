#include "core/detect/caliskan/energy_ratio.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/detect/blank_verdict.h"
#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {
namespace {

constexpr std::array<const config::ParamDecl*, 6> kParams{&kErHarmonics, &kErLambda,         &kErCovariance,
                                                          &kErChatter,   &kErOnsetAmplitude, &kErEvidence};
constexpr std::array<std::string_view, 6> kIndicators{"er", "frequency_hz", "changed", "floor", "evidence", "purity"};

enum Own : std::size_t { OwnHarmonics, OwnLambda, OwnFloor, OwnOnset, OwnFull };
constexpr std::array<std::string_view, 4> kWhyHarmonics{kSetByHand, "as many as the sampling rate hears at this speed",
                                                        "the least there are, for a tool of few teeth",
                                                        "12 tooth passings"};
constexpr std::array<std::string_view, 2> kWhyLambda{kSetByHand, "a memory of two turns at this speed"};
constexpr std::array<std::string_view, 3> kWhyFloor{kNotLearned, kMeanOfStable, kHeldInAlarm};
constexpr std::array<std::string_view, 3> kWhyOnset{kNotLearned, "four times the noise floor in energy",
                                                    "the smallest onset, as set, which the noise does not reach"};
constexpr std::array<std::string_view, 2> kWhyFull{"the chatter ratio, as set",
                                                   "four times what the channel has in the calm cut"};
constexpr std::array<AutoValueDecl, 5> kOwnValues{{
    {"energy-ratio.harmonics", "Harmonics", "", kWhyHarmonics},
    {"energy-ratio.lambda", "Process noise ratio", "", kWhyLambda},
    {"energy-ratio.floor", "Noise floor", "", kWhyFloor},
    {"energy-ratio.onset", "Growth that is an onset", "", kWhyOnset},
    {"energy-ratio.full", "Full chatter", "", kWhyFull},
}};

constexpr double kMemoryTurns = 2.0;  // of the harmonic filter
constexpr int kLeastHarmonics = 32;
constexpr int kToothHarmonics = 12;
constexpr int kMostHarmonics = 160;
constexpr int kMostBands = 24;
constexpr int kBandOrdersUnknown = 4;   // teeth not told
constexpr double kRatioTurns = 2.0;     // smoothing of the energy ratio
constexpr double kLeastSamples = 96.0;  // in the average of the turn difference: fewer scatter too much
constexpr double kNoiseInOrder = 1.5;   // of white noise, times frames a turn: in a Hann window of two turns
constexpr Hertz kSpindleUnknown{20.0};
constexpr Hertz kLeastBand{2500.0};  // tools chatter up to there at any speed
constexpr int kBandOrder = 4;
constexpr double kSameBand = 0.02;
// Growth so fast that no spectrum is waited for soon holds this much of the energy, and forced vibration does not
// change by as much in a turn. Force, displacement and the spindle's speed and current hold less of chatter, which
// stands above the tooth passings; theirs is what has been asked of every kind.
constexpr double kRisingPart = 0.15;
constexpr double kRisingPartOfSlow = 0.02;
constexpr double kOfTurns = 0.8;  // of the evidence asked for, where means of a turn count: they scatter less than hops

bool hearsTheSlowMost(SensorQuantity q) {
  return isIntegral(q) || q == SensorQuantity::Force || q == SensorQuantity::Displacement;
}

}  // namespace

config::ParamTable energyRatioParams() {
  return kParams;
}

DetectorInfo EnergyRatioDetector::describe() const {
  return {"energy-ratio", "Energy ratio", "Caliskan, Kilic, Altintas 2018", kIndicators};
}

void EnergyRatioDetector::sizeFor(const CutSetup& setup, const config::ParamSet& params) {
  const double nominal = setup.nominalSpeed.value > 0.0 ? toHertz(setup.nominalSpeed).value : kSpindleUnknown.value;
  const int allowed = std::max(1, static_cast<int>(EnergyChain::kUsableBand * rate_ / (0.8 * nominal)));
  int harmonics = std::clamp(std::max(kLeastHarmonics, kToothHarmonics * teeth_), 1, kMostHarmonics);
  harmonicsSet_ = !params.isAutomatic(kErHarmonics);
  if (harmonicsSet_) harmonics = static_cast<int>(std::lround(params.real(kErHarmonics)));
  harmonics = std::min(harmonics, allowed);
  harmonics_ = harmonics;
  const int perBand = teeth_ > 0 ? teeth_ : kBandOrdersUnknown;
  const int bandCount = std::clamp((harmonics + perBand - 1) / perBand, 1, kMostBands);
  const Hertz slowest(0.5 * nominal);
  kernels_ = dsp::kernels::bestKernels();
  chain_.prepare({channels_, harmonics, bandCount, perBand, Hertz(rate_), slowest, params.choice(kErCovariance) == 1},
                 kernels_);
  turns_.prepare(channels_, Hertz(rate_), slowest);
  const int window = std::max(64, static_cast<int>(kLineTurns * rate_ / nominal));
  lines_.prepare(channels_, window, Hertz(rate_));
  newLine_.prepare(channels_, std::max(64, static_cast<int>(NewLine::kTurnsBack * rate_ / nominal)), Hertz(rate_));
  fixedGain_ = params.isAutomatic(kErLambda) ? 0.0 : harmonicGain(params.real(kErLambda), harmonics);
}

void EnergyRatioDetector::prepare(const CutSetup& setup, const config::ParamSet& params) {
  rate_ = setup.rate.value;
  teeth_ = setup.teeth;
  channels_ = static_cast<int>(setup.channels.size());
  sizeFor(setup, params);
  channelStates_.assign(static_cast<std::size_t>(channels_), {});
  for (int c = 0; c < channels_; ++c) {
    RatioChannel& s = channelStates_[static_cast<std::size_t>(c)];
    s.quantity = setup.channels[static_cast<std::size_t>(c)].quantity;
    s.forced.prepare(teeth_, integrationFactor(s.quantity));
    s.load.prepare(teeth_);
    s.orders.prepare(teeth_, integrationFactor(s.quantity), harmonics_);
  }
  const auto all = [&](auto is) {
    return std::all_of(setup.channels.begin(), setup.channels.end(), [&](const auto& c) { return is(c.quantity); });
  };
  integrals_ = all(isIntegral);
  sideLines_ = integrals_ || all([](SensorQuantity q) { return q == SensorQuantity::Force; });
  retune(params);
  lowPass_.assign(static_cast<std::size_t>(channels_), {});
  for (auto* v : {&compared_, &difference_, &news_}) v->assign(static_cast<std::size_t>(channels_ * kRow), 0.0);
  reset();
}

void EnergyRatioDetector::retune(const config::ParamSet& params) {
  const double amplitude = params.real(kErOnsetAmplitude);
  smallest_ = amplitude * amplitude;
  judge_.prepare(teeth_, params.real(kErChatter));
  const OnsetTest::Limits limits{smallest_, params.real(kErEvidence)};
  for (RatioChannel& s : channelStates_) {
    // A load that ends is a step in an integral of the torque, which a whole turn takes the edge off.
    const bool atOnce = !isIntegral(s.quantity);
    const OnsetTest::Limits ofTurns{smallest_, kOfTurns * limits.evidence};
    const double part = hearsTheSlowMost(s.quantity) ? kRisingPartOfSlow : kRisingPart;
    s.growth.prepare(atOnce ? limits : ofTurns, {RevolutionDifference::kDifferenceArrival, atOnce, part});
    s.news.prepare(atOnce ? limits : ofTurns, {RevolutionDifference::kNewsArrival, atOnce, part});
    s.orders.setEvidence(ofTurns.evidence);
  }
}

double EnergyRatioDetector::chosen(const config::ParamDecl& decl) const {
  return decl.key == kErHarmonics.key ? harmonics_ : config::kAutomatic;
}

AutoValueTable EnergyRatioDetector::autoValues() const {
  return kOwnValues;
}

void EnergyRatioDetector::tellOwn(double gain) {
  const int active = chain_.active();
  const int teeth = kToothHarmonics * teeth_;
  own_.set(OwnHarmonics, active,
           harmonicsSet_                               ? 0
           : active < std::max(teeth, kLeastHarmonics) ? 1
           : teeth < kLeastHarmonics                   ? 2
                                                       : 3);
  own_.set(OwnLambda, lambdaForGain(gain, active), fixedGain_ > 0.0 ? 0 : 1);
  own_.set(OwnFull, judge_.full(), judge_.usualIsHigh() ? 1 : 0);
  const OnsetTest* lead = nullptr;
  for (const RatioChannel& s : channelStates_) {
    const OnsetTest& onset = s.growth.onset();
    if (lead == nullptr || onset.evidence() >= lead->evidence()) lead = &onset;  // as RatioJudge::weigh
  }
  if (lead == nullptr || !lead->learned()) {
    own_.set(OwnFloor, config::kAutomatic, 0);
    own_.set(OwnOnset, config::kAutomatic, 0);
    return;
  }
  const double least = lead->leastGrowth();
  own_.set(OwnFloor, lead->floor(), judge_.alarming() ? 2 : 1);
  own_.set(OwnOnset, least, least > smallest_ ? 1 : 2);
}

void EnergyRatioDetector::reset() {
  spindle_ = {};
  judge_.setState(CutState::AirCutting);
  leaveCut();
  restart();
}

void EnergyRatioDetector::restart() {
  chain_.reset();
  turns_.reset();
  lines_.reset();
  newLine_.reset();
  for (dsp::Butterworth& filter : lowPass_) filter.reset();
  for (RatioChannel& s : channelStates_) {
    for (EnergyGrowth* g : {&s.growth, &s.news}) g->restart();
    s.orders.restart();
    s.ratio = 0.0;
  }
  inHop_ = 0;
  steadyTurns_ = 0.0;
  marks_.reset();
  judge_.restart();
}

void EnergyRatioDetector::leaveCut() {
  relearn();
  for (RatioChannel& s : channelStates_) {
    s.orders.restart();
    s.forced.reset();
    s.load.reset();
    s.usual.reset();
  }
  judge_.leaveCut();
}

void EnergyRatioDetector::relearn() {
  for (RatioChannel& s : channelStates_) {
    for (EnergyGrowth* g : {&s.growth, &s.news}) g->relearn();
    s.orders.relearn();
  }
}

void EnergyRatioDetector::tune(const ConditionedBlock& block) {
  spindle_ = block.spindle.value > 0.0 ? block.spindle : kSpindleUnknown;
  const double turn = rate_ / spindle_.value;
  hopFrames_ = std::max(1L, std::lround(turn / kHopsPerTurn));
  windowHops_ = std::clamp(static_cast<int>(std::ceil(kLeastSamples / static_cast<double>(hopFrames_))), kHopsPerTurn,
                           EnergyGrowth::kLevelHops / 2);
  const double gain = fixedGain_ > 0.0 ? fixedGain_ : 2.0 / (kMemoryTurns * turn);
  chain_.tune(spindle_, gain);
  tellOwn(gain);
  for (RatioChannel& s : channelStates_) {
    for (EnergyGrowth* g : {&s.growth, &s.news}) g->setSpindle(spindle_);
    s.orders.setSpindle(spindle_);
  }
  followBand();
  lines_.setSideLines(sideLines_ ? spindle_ * teeth_ : Hertz(), integrals_);
  if (!block.speedChanging) turns_.setTurn(spindle_);
  if (turnsCompare_ && !block.revolutionsComparable) {
    relearn();
    judge_.loseFloor();
  }
  turnsCompare_ = block.revolutionsComparable;
}

// Noise above the harmonics that are removed only hides what grows among them.
void EnergyRatioDetector::followBand() {
  const Hertz highest(
      std::min(std::max(spindle_.value * (chain_.active() + 0.5), kLeastBand.value), EnergyChain::kUsableBand * rate_));
  if (std::abs(highest.value - highest_.value) < kSameBand * highest.value) return;
  highest_ = highest;
  for (dsp::Butterworth& filter : lowPass_) filter.lowPass(kBandOrder, highest, Hertz(rate_));
}

void EnergyRatioDetector::endHop(const ConditionedBlock& block) {
  const CutPhase phase = block.phase;
  const Seconds length(static_cast<double>(inHop_) / rate_);
  inHop_ = 0;
  chain_.endHop();
  marks_.endHop();
  hopOfTurn_ = (hopOfTurn_ + 1) % kHopsPerTurn;
  steadyTurns_ = phase == CutPhase::Steady && turnsCompare_ ? steadyTurns_ + 1.0 / kHopsPerTurn : 0.0;
  // An alarm may end while the cut becomes so much quieter that the tool might leave.
  const bool ends = judge_.alarming() && phase == CutPhase::Exit && turnsCompare_;
  const bool test = ends || (phase == CutPhase::Steady && steadyTurns_ >= kSettleTurns && turnsCompare_);
  const double rate = 1.0 - std::exp(-1.0 / (kRatioTurns * kHopsPerTurn));
  for (int c = 0; c < channels_; ++c) {
    RatioChannel& s = channelStates_[static_cast<std::size_t>(c)];
    for (EnergyGrowth* g : {&s.growth, &s.news}) g->endHop(windowHops_, length);
    s.growth.leapWith(s.news);
    s.news.leapWith(s.growth);
    for (EnergyGrowth* g : {&s.growth, &s.news}) {
      if (test) g->test(windowHops_, judge_.state() == CutState::Stable);
    }
    // The difference hears no steady change of the load; the news does.
    if (s.news.standsStill()) s.news.relearn();
    s.orders.endHop(chain_, c);
    s.forced.endHop(chain_, c);
    if (hopOfTurn_ == 0) {
      const double noise = kNoiseInOrder * s.growth.onset().floor() * spindle_.value / rate_;
      s.load.endTurn(chain_, newLine_, c, spindle_, noise);
      s.orders.setLoad(s.load.mostOfAnOrder());
    }
    // A load that leaps takes its own pattern of runout along, and so does one that changes within a few turns.
    const bool held = s.growth.turnsSinceLeap() < kSettleTurns || s.load.changesQuickly();
    if (held && judge_.state() == CutState::Stable) s.orders.relearn();
    if (!block.speedChanging && hopOfTurn_ % (kHopsPerTurn / 2) == 0)
      s.orders.endHalfTurn(newLine_, c, spindle_, test && !held);
    if (test && !held)
      s.orders.test(1.0 / kHopsPerTurn, judge_.state() == CutState::Stable, block.spindleSd / spindle_);
    s.ratio += rate * (chain_.ratio(c, integrationFactor(s.quantity)) - s.ratio);
  }
  if (judge_.judge(channelStates_, lines_,
                   {phase, length, Hertz(rate_), spindle_, block.spindleSd, teeth_, highest_, steadyTurns_,
                    turnsCompare_, block.levelTrend, &chain_, &newLine_, block.speedChanging ? &marks_ : nullptr,
                    &block.series, block.isolatedLine.value > 0.0, block.alarmWait}))
    relearn();
}

Verdict EnergyRatioDetector::verdict(const ConditionedBlock& block) const {
  Verdict v = blankVerdict(block);
  if (v.valid) judge_.fill(v, spindle_);
  doubtOverloaded(v, block);
  return v;
}

// Frames from `first` on that belong to one hop and one turn per frame.
int EnergyRatioDetector::stretch(const ConditionedBlock& block, int first) const {
  const auto most = static_cast<int>(std::clamp<long>(hopFrames_ - inHop_, 1, block.frames - first));
  int frames = 1;
  while (frames < most && block.angleStep[first + frames] == block.angleStep[first]) ++frames;
  return frames;
}

void EnergyRatioDetector::processFrames(const ConditionedBlock& block, int first, int frames) {
  const double step = block.angleStep[first];
  chain_.align(block.angle[first], step);
  chain_.process(block.samples + first, block.stride, static_cast<std::size_t>(frames));
  for (int done = 0; done < frames;) {
    const int now = std::min(frames - done, kRow);
    compare(block, first + done, now);
    done += now;
  }
  marks_.advance(step, frames);
  inHop_ += frames;
}

// At most kRow frames, one turn with the next.
void EnergyRatioDetector::compare(const ConditionedBlock& block, int first, int frames) {
  const auto count = static_cast<std::size_t>(frames);
  dsp::Butterworth::process(lowPass_, block.samples + first, block.stride, compared_.data(), kRow, count, kernels_);
  turns_.process(compared_.data(), kRow, count, difference_.data(), news_.data(), kRow);
  lines_.push(difference_.data(), kRow, count);
  newLine_.push(compared_.data(), kRow, count);
  for (int c = 0; c < channels_; ++c) {
    RatioChannel& s = channelStates_[static_cast<std::size_t>(c)];
    const auto row = static_cast<std::size_t>(c * kRow);
    const std::span<const double> x = std::span<const double>(compared_).subspan(row, count);
    s.growth.add(x, std::span<const double>(difference_).subspan(row, count));
    s.news.add(x, std::span<const double>(news_).subspan(row, count));
  }
}

Verdict EnergyRatioDetector::process(const ConditionedBlock& block) {
  if (!block.valid) return verdict(block);
  if (block.afterGap) restart();
  tune(block);
  const double turn = rate_ / spindle_.value;
  for (int f = 0; f < block.frames;) {
    const int frames = stretch(block, f);
    processFrames(block, f, frames);
    f += frames;
    if (inHop_ < hopFrames_) continue;
    endHop(block);
    if (!block.speedChanging) continue;
    const double last = marks_.framesAgo(1.0, turn);
    turns_.setTurns(last, marks_.framesAgo(2.0, last + turn));
  }
  if (block.phase == CutPhase::AirCutting) {
    judge_.setState(CutState::AirCutting);
    leaveCut();
  } else if (judge_.alarming()) {
    judge_.addFeed(block.feed.value * block.frames / rate_);
  }
  return verdict(block);
}

}  // namespace stillcut::detect
