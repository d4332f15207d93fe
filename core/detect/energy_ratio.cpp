#include "core/detect/energy_ratio.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr std::array<const config::ParamDecl*, 5> kParams{&kErHarmonics, &kErLambda, &kErChatter, &kErOnsetAmplitude,
                                                          &kErEvidence};
constexpr std::array<std::string_view, 6> kIndicators{"er", "frequency_hz", "changed", "floor", "evidence", "purity"};

constexpr double kUsableBand = 0.45;  // of the rate
constexpr double kMemoryTurns = 2.0;  // of the harmonic filter
constexpr int kLeastHarmonics = 32;
constexpr int kToothHarmonics = 12;
constexpr int kMostHarmonics = 160;
constexpr int kMostBands = 24;
constexpr double kRatioTurns = 2.0;         // smoothing of the energy ratio
constexpr double kHysteresis = 0.5;         // chatter ends at this part of the ratio at which it began
constexpr double kEntryChatterTurns = 8.0;  // a high ratio must last this long where no floor was learned
constexpr double kEntryChatterSeconds = 0.15;
constexpr double kLineTurns = 16.0;      // window of the line finder
constexpr double kSettleTurns = 6.0;     // after a restart the filters are not believed
constexpr double kLeastSamples = 96.0;   // in the average of the turn difference: fewer scatter too much
constexpr double kLeastPurity = 0.4;     // chatter is a line; chips and knocks are not
constexpr double kLostPurity = 0.25;     // an alarm whose line sinks into the noise ...
constexpr double kLostTurns = 32.0;      // ... for so long was none, or is over
constexpr double kRisingEvidence = 1.5;  // growth that needs no spectrum is asked for more evidence
constexpr double kFastGrowth = 2.0;      // of energy from half turn to half turn
constexpr double kSlowGrowth = 1.5;      // from turn to turn
constexpr double kCalmTurns = 4.0;       // what is left of an alarm has not grown for this many turns ...
constexpr double kCalmSeconds = 0.1;     // ... and so long, where the speed has changed since,
constexpr double kLongCalm = 0.25;       // ... and so long, where it has not
constexpr double kLittle = 2.5e-3;       // 5 % of the amplitude
constexpr double kCalmGrowth = 3.0;      // in energy: more is growth, not scatter of noise
constexpr double kOtherLine = 4.0;       // a line this much stronger than the one followed takes its place
constexpr double kLineReach = 0.25;      // orders within which a line is the same
constexpr double kLeastOffset = 0.03;    // orders; nearer to a harmonic a line is forced
constexpr Hertz kSpindleUnknown{20.0};

}  // namespace

config::ParamTable energyRatioParams() {
  return kParams;
}

DetectorInfo EnergyRatioDetector::describe() const {
  return {"energy-ratio", "Energy ratio", "Caliskan, Kilic, Altintas 2018", kIndicators};
}

void EnergyRatioDetector::sizeFor(const CutSetup& setup, const config::ParamSet& params) {
  const double nominal = setup.nominalSpeed.value > 0.0 ? toHertz(setup.nominalSpeed).value : kSpindleUnknown.value;
  const int allowed = std::max(1, static_cast<int>(kUsableBand * rate_ / (0.8 * nominal)));
  int harmonics = std::clamp(std::max(kLeastHarmonics, kToothHarmonics * teeth_), 1, kMostHarmonics);
  if (!params.isAutomatic(kErHarmonics)) harmonics = static_cast<int>(std::lround(params.real(kErHarmonics)));
  harmonics = std::min(harmonics, allowed);
  const int perBand = teeth_ > 0 ? teeth_ : 4;
  const int bandCount = std::clamp((harmonics + perBand - 1) / perBand, 1, kMostBands);
  const double slowest = 0.5 * nominal;
  kalman_.prepare(channels_, harmonics);
  bands_.prepare(channels_, bandCount, Hertz(rate_), Hertz(slowest * perBand));
  turns_.prepare(channels_, Hertz(rate_), Hertz(slowest));
  lines_.prepare(channels_, std::max(64, static_cast<int>(kLineTurns * rate_ / nominal)), Hertz(rate_));
  fixedGain_ = params.isAutomatic(kErLambda) ? 0.0 : harmonicGain(params.real(kErLambda), harmonics);
}

void EnergyRatioDetector::prepare(const CutSetup& setup, const config::ParamSet& params) {
  rate_ = setup.rate.value;
  teeth_ = setup.teeth;
  channels_ = static_cast<int>(setup.channels.size());
  chatterRatio_ = params.real(kErChatter);
  const double amplitude = params.real(kErOnsetAmplitude);
  smallest_ = amplitude * amplitude;
  sizeFor(setup, params);
  channelStates_.assign(static_cast<std::size_t>(channels_), {});
  for (int c = 0; c < channels_; ++c) {
    ChannelState& s = channelStates_[static_cast<std::size_t>(c)];
    s.eta = integrationFactor(setup.channels[static_cast<std::size_t>(c)].quantity);
    s.onset.prepare({smallest_, params.real(kErEvidence)});
  }
  for (auto* v : {&frame_, &rest_, &difference_}) v->assign(static_cast<std::size_t>(channels_), 0.0);
  reset();
}

void EnergyRatioDetector::reset() noexcept {
  spindle_ = {};
  state_ = CutState::Air;
  leaveCut();
  restart();
}

void EnergyRatioDetector::restart() noexcept {
  kalman_.reset();
  bands_.reset();
  turns_.reset();
  lines_.reset();
  for (ChannelState& s : channelStates_) {
    s.sums = {};
    s.hops = {};
    s.ratio = s.changed = 0.0;
  }
  inHop_ = hopCount_ = 0;
  steadyTurns_ = 0.0;
  marks_ = {};
  frameCount_ = angleCount_ = 0.0;
}

void EnergyRatioDetector::leaveCut() noexcept {
  relearn();
  line_ = {};
  highTurns_ = severity_ = evidence_ = floor_ = changed_ = changedSlow_ = 0.0;
  learned_ = false;
  frequency_ = {};
  frequencySd_ = purity_ = sinceOnset_ = feedSinceOnset_ = 0.0;
}

void EnergyRatioDetector::relearn() noexcept {
  for (ChannelState& s : channelStates_) s.onset.reset();
  floorGone_ = false;
  calmSeconds_ = calmLevel_ = 0.0;
}

void EnergyRatioDetector::tune(const ConditionedBlock& block) noexcept {
  spindle_ = block.spindle.value > 0.0 ? block.spindle : kSpindleUnknown;
  const double turn = rate_ / spindle_.value;
  hopFrames_ = std::max(1L, std::lround(turn / kHopsPerTurn));
  windowHops_ = std::clamp(static_cast<int>(std::ceil(kLeastSamples / static_cast<double>(hopFrames_))), kHopsPerTurn,
                           kLevelHops / 2);
  kalman_.setActive(static_cast<int>(kUsableBand * rate_ / spindle_.value));
  kalman_.setGain(fixedGain_ > 0.0 ? fixedGain_ : 2.0 / (kMemoryTurns * turn));
  const int perBand = teeth_ > 0 ? teeth_ : 4;
  bands_.tune(spindle_ * perBand, spindle_ * 0.5);
  if (!block.speedMoving) turns_.setTurn(spindle_);
  if (turnsCompare_ && !block.turnsCompare) {
    for (ChannelState& s : channelStates_) s.onset.reset();
    floorGone_ = true;
  }
  turnsCompare_ = block.turnsCompare;
}

// While the speed changes, one turn ago is where the angle was one turn less.
void EnergyRatioDetector::followTurns() noexcept {
  const auto ago = [this](double turns) {
    const double wanted = angleCount_ - kTwoPi * turns;
    AngleMark after{frameCount_, angleCount_};
    for (int k = 1; k < kAngleHops; ++k) {
      const AngleMark& m = marks_[static_cast<std::size_t>((hopCount_ - k + kAngleHops) % kAngleHops)];
      if (m.angle > wanted) {
        after = m;
        continue;
      }
      if (!(after.angle > m.angle)) break;
      return frameCount_ - m.frame - (after.frame - m.frame) * (wanted - m.angle) / (after.angle - m.angle);
    }
    return turns * rate_ / spindle_.value;
  };
  turns_.setTurns(ago(1.0), ago(2.0));
}

double EnergyRatioDetector::energyRatio(int channel) const noexcept {
  const int eta = channelStates_[static_cast<std::size_t>(channel)].eta;
  const auto weight = [eta](double f) { return eta == 0 ? 1.0 : eta > 0 ? f * f : 1.0 / (f * f); };
  double chatter = 0.0;
  for (int m = 0; m < bands_.active(); ++m) {
    const BandEstimate& b = bands_.band(channel, m);
    if (b.power > 0.0 && b.frequency.value > 0.0) chatter += b.power * weight(b.frequency.value);
  }
  double forced = 0.0;
  for (int n = 1; n <= kalman_.active(); ++n) forced += kalman_.power(channel, n) * weight(n * spindle_.value);
  const double all = forced + chatter;
  return all > 0.0 ? chatter / all : 0.0;
}

void EnergyRatioDetector::endChannelHop(int channel, CutPhase phase) noexcept {
  ChannelState& s = channelStates_[static_cast<std::size_t>(channel)];
  s.hops[static_cast<std::size_t>(hopCount_ % kLevelHops)] = s.sums;
  s.sums = {};
  double changed = 0.0;
  double all = 0.0;
  for (int k = 0; k < kLevelHops; ++k) {
    const Energies& e = s.hops[static_cast<std::size_t>((hopCount_ - k + kLevelHops) % kLevelHops)];
    if (k < windowHops_) changed += e.changed;
    all += e.all;
  }
  all *= static_cast<double>(windowHops_) / kLevelHops;
  s.changed = all > 0.0 ? changed / all : 0.0;
  const double rate = 1.0 - std::exp(-1.0 / (kRatioTurns * kHopsPerTurn));
  s.ratio += rate * (energyRatio(channel) - s.ratio);
  if (phase != CutPhase::Steady || steadyTurns_ < kSettleTurns || !turnsCompare_) return;
  s.onset.update(s.changed, 1.0 / windowHops_, state_ == CutState::Stable);
}

void EnergyRatioDetector::judge(CutPhase phase, double seconds) noexcept {
  severity_ = changed_ = evidence_ = 0.0;
  bool onset = false;
  learned_ = true;
  for (const ChannelState& s : channelStates_) {
    severity_ = std::max(severity_, s.ratio);
    if (s.onset.evidence() >= evidence_) {
      evidence_ = s.onset.evidence();
      floor_ = s.onset.floor();
    }
    changed_ = std::max(changed_, s.changed);
    onset = onset || s.onset.alarm();
    learned_ = learned_ && s.onset.learned();
  }
  const bool alarming = state_ == CutState::Onset || state_ == CutState::Chatter;
  const bool high = severity_ >= chatterRatio_ * (state_ == CutState::Chatter ? kHysteresis : 1.0);
  watchCalm(alarming ? seconds : 0.0);
  const bool entry = fromEntry(high && phase == CutPhase::Steady && !alarming);
  if (alarming) {
    const bool lost = lostTurns_ > kLostTurns;
    const bool over = lost || calm() || !(high || onset || floorGone_);
    // A ratio that rises while the speed changes may be forced vibration that changes with it.
    const bool full = high && (turnsCompare_ || state_ == CutState::Chatter);
    state_ = over ? CutState::Stable : full ? CutState::Chatter : CutState::Onset;
    if (over) relearn();
  } else if (phase == CutPhase::Steady && turnsCompare_ && (entry || (onset && (rising() || lineStands())))) {
    state_ = high ? CutState::Chatter : CutState::Onset;
  } else {
    state_ = CutState::Stable;
  }
  const bool now = state_ == CutState::Onset || state_ == CutState::Chatter;
  sinceOnset_ = now ? sinceOnset_ + seconds : 0.0;
  if (!now) feedSinceOnset_ = 0.0;
}

// An alarm whose speed was changed cannot fall below its old floor, for the floor has changed as well: it is over when
// little is left and does not grow.
void EnergyRatioDetector::watchCalm(double seconds) noexcept {
  changedSlow_ += (1.0 - std::exp(-1.0 / (kCalmTurns * kHopsPerTurn))) * (changed_ - changedSlow_);
  const bool little = severity_ < kHysteresis * chatterRatio_ && (floorGone_ || changed_ < kLittle);
  if (!(seconds > 0.0) || !little || changedSlow_ > kCalmGrowth * calmLevel_) {
    calmSeconds_ = 0.0;
    calmLevel_ = changedSlow_;
    return;
  }
  calmSeconds_ += seconds;
  calmLevel_ = std::min(calmLevel_, changedSlow_);
}

bool EnergyRatioDetector::calm() const noexcept {
  return calmSeconds_ > std::max(floorGone_ ? kCalmSeconds : kLongCalm, kCalmTurns / spindle_.value);
}

// Chatter that was there from the entry: no calm stretch was ever learned, so the paper's fixed ratio decides, but only
// for one and the same line over many turns.
bool EnergyRatioDetector::fromEntry(bool high) noexcept {
  if (!high || steadyTurns_ < kSettleTurns) {
    highTurns_ = 0.0;
    return false;
  }
  const Hertz before = line_.frequency;
  const bool stands = lineStands();
  const bool same = std::abs(line_.frequency.value - before.value) < spindle_.value * 4.0 / kLineTurns;
  highTurns_ = stands && same ? highTurns_ + 1.0 / kHopsPerTurn : 0.0;
  return highTurns_ > std::max(kEntryChatterTurns, kEntryChatterSeconds * spindle_.value);
}

// Exponential growth shows before any spectrum can: three stretches in a row, each well above the one before. A knock
// rises once and decays.
bool EnergyRatioDetector::rising() const noexcept {
  const auto sum = [this](const ChannelState& s, int from, int count) {
    double e = 0.0;
    for (int k = from; k < from + count; ++k) {
      e += s.hops[static_cast<std::size_t>((hopCount_ - k + kLevelHops) % kLevelHops)].changed;
    }
    return e;
  };
  const auto grows = [&](const ChannelState& s, int hops, double factor) {
    const double now = sum(s, 0, hops);
    const double before = sum(s, hops, hops);
    return now > factor * before && before > factor * sum(s, 2 * hops, hops);
  };
  return std::any_of(channelStates_.begin(), channelStates_.end(), [&](const ChannelState& s) {
    return s.onset.alarm() && s.onset.evidence() > kRisingEvidence * s.onset.evidenceLimit() &&
           (grows(s, kHopsPerTurn / 2, kFastGrowth) || grows(s, kHopsPerTurn, kSlowGrowth));
  });
}

// Growth or a high ratio alone may be a knock or a lost speed; chatter is a line between the spindle harmonics.
bool EnergyRatioDetector::lineStands() noexcept {
  line_ = lines_.find(spindle_ * 0.5, spindle_ * (kalman_.active() + 0.5));
  purity_ = line_.purity;
  return line_.purity >= kLeastPurity && std::abs(dsp::orderOffset(line_.frequency, spindle_)) >= kLeastOffset;
}

void EnergyRatioDetector::track(double seconds) noexcept {
  const bool alarming = state_ == CutState::Onset || state_ == CutState::Chatter;
  if (!alarming) {
    frequency_ = {};
    frequencySd_ = lostTurns_ = 0.0;
    return;
  }
  const FoundLine line = lines_.find(spindle_ * 0.5, spindle_ * (kalman_.active() + 0.5));
  purity_ = line.purity;
  lostTurns_ = purity_ < kLostPurity ? lostTurns_ + 1.0 / kHopsPerTurn : 0.0;
  if (!(line.frequency.value > 0.0)) return;
  // While the speed changes lines are smeared, and what is left when it has arrived rings down at the mode's own
  // frequency: the chatter's is the one from before.
  if (frequency_.value > 0.0 && (!turnsCompare_ || (floorGone_ && severity_ < chatterRatio_))) return;
  Hertz next = line.frequency;
  if (frequency_.value > 0.0 && std::abs(next.value - frequency_.value) > kLineReach * spindle_.value) {
    const LineFinder::Peak held = lines_.near(frequency_, spindle_ * kLineReach);
    const LineFinder::Peak strongest = lines_.near(next, spindle_ * kLineReach);
    if (strongest.power < kOtherLine * held.power) next = held.frequency;
  }
  if (!(frequency_.value > 0.0)) {
    frequencySd_ = spindle_.value / kLineTurns;
  } else {
    const double jump = std::abs(next.value - frequency_.value);
    frequencySd_ += (1.0 - std::exp(-seconds * spindle_.value)) * (jump - frequencySd_);
  }
  frequency_ = next;
}

void EnergyRatioDetector::endHop(CutPhase phase) noexcept {
  const double seconds = static_cast<double>(inHop_) / rate_;
  bands_.estimate();
  marks_[static_cast<std::size_t>(hopCount_ % kAngleHops)] = {frameCount_, angleCount_};
  steadyTurns_ = phase == CutPhase::Steady && turnsCompare_ ? steadyTurns_ + 1.0 / kHopsPerTurn : 0.0;
  for (int c = 0; c < channels_; ++c) endChannelHop(c, phase);
  judge(phase, seconds);
  track(seconds);
  ++hopCount_;
  inHop_ = 0;
}

// Period doubling sits half way between the tooth-passing harmonics, whatever the speed; Hopf chatter anywhere else.
ChatterKind EnergyRatioDetector::kind() const noexcept {
  if (teeth_ < 1 || !(frequency_.value > 0.0)) return ChatterKind::Unknown;
  const double offset = std::abs(dsp::orderOffset(frequency_, spindle_ * teeth_));
  const double doubt = 0.02 + 2.0 * frequencySd_ / (spindle_.value * teeth_);
  return 0.5 - offset < doubt ? ChatterKind::Flip : ChatterKind::Hopf;
}

Verdict EnergyRatioDetector::verdict(const ConditionedBlock& block) const noexcept {
  Verdict v;
  v.time = block.end();
  v.blockSequence = block.sequence;
  v.phase = block.phase;
  v.spindle = block.spindle;
  v.valid = block.valid;
  v.reason = block.reason;
  if (!block.valid) return v;
  v.state = block.phase == CutPhase::Air ? CutState::Air : state_;
  v.severity = Ratio(severity_);
  v.frequency = frequency_;
  v.frequencySd = Hertz(frequencySd_);
  v.sinceOnset = Seconds(sinceOnset_);
  v.feedSinceOnset = Metres(feedSinceOnset_);
  v.indicators = {severity_, frequency_.value, changed_, floor_, evidence_, purity_};
  if (v.state == CutState::Chatter) {
    v.reason = {ReasonCode::EnergyRatioHigh, {severity_, chatterRatio_}};
  } else if (v.state == CutState::Onset) {
    v.reason = {ReasonCode::EnergyRatioGrowing, {changed_, floor_}};
  } else if (block.phase == CutPhase::RunUp) {
    v.reason = {ReasonCode::SpindleRunUp, {toRpm(block.spindle).value}};
  } else if (block.phase == CutPhase::Steady && !learned_) {
    v.reason = {ReasonCode::Learning, {(OnsetTest::kLearnTurns + kSettleTurns) / spindle_.value}};
  }
  if (v.alarming()) v.kind = kind();
  return v;
}

Verdict EnergyRatioDetector::process(const ConditionedBlock& block) noexcept {
  if (!block.valid) return verdict(block);
  if (block.afterGap) restart();
  tune(block);
  const double seconds = block.frames / rate_;
  double step = -1.0;
  for (int f = 0; f < block.frames; ++f) {
    if (block.angleStep[f] != step) {
      step = block.angleStep[f];
      kalman_.align(block.angle[f], step);
    }
    for (int c = 0; c < channels_; ++c) frame_[static_cast<std::size_t>(c)] = block.samples[c * block.stride + f];
    kalman_.process(frame_.data(), rest_.data());
    bands_.process(rest_.data());
    turns_.process(frame_.data(), difference_.data());
    lines_.push(difference_.data());
    for (int c = 0; c < channels_; ++c) {
      const auto i = static_cast<std::size_t>(c);
      channelStates_[i].sums.all += frame_[i] * frame_[i];
      channelStates_[i].sums.changed += difference_[i] * difference_[i];
    }
    frameCount_ += 1.0;
    angleCount_ += step;
    if (++inHop_ < hopFrames_) continue;
    endHop(block.phase);
    if (block.speedMoving) followTurns();
  }
  if (block.phase == CutPhase::Air) {
    state_ = CutState::Air;
    leaveCut();
  } else if (state_ == CutState::Onset || state_ == CutState::Chatter) {
    feedSinceOnset_ += block.feed.value * seconds;
  }
  return verdict(block);
}

}  // namespace stillcut::detect
