#include "core/detect/xu/coherence.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/fft.h"
#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr std::array<const config::ParamDecl*, 11> kParams{&kCohForm,   &kCohSharpening, &kCohSegment,  &kCohAverages,
                                                           &kCohLow,    &kCohHigh,       &kCohGammaRef, &kCohEnergyRef,
                                                           &kCohPurity, &kCohEvidence,   &kCohChatter};
constexpr std::array<std::string_view, 7> kIndicators{"gamma_max", "energy", "frequency_hz", "lead_s",
                                                      "changed",   "floor",  "purity"};

enum Own : std::size_t { OwnSegment, OwnEnergyRef, OwnFloor, OwnUsual };
constexpr std::array<std::string_view, 4> kWhySegment{kSetByHand, "12 turns at the told speed",
                                                      "the paper's, which 12 turns would exceed",
                                                      "12 turns of a slow spindle, as no speed was told"};
constexpr std::array<std::string_view, 3> kWhyEnergyRef{
    kNotLearned, kSetByHand, "of what changes from turn to turn: four times the noise floor, or the least that counts"};
constexpr std::array<std::string_view, 3> kWhyLearned{kNotLearned, kMeanOfStable, kHeldInAlarm};
constexpr std::array<AutoValueDecl, 4> kOwnValues{{
    {"coherence.segment", "Segment", "s", kWhySegment},
    {"coherence.energy-ref", "Energy reference", "", kWhyEnergyRef},
    {"coherence.floor", "Noise floor", "", kWhyLearned},
    {"coherence.usual", "Usual coherence", "", kWhyLearned},
}};

constexpr double kSegmentTurns = 12.0;
constexpr double kPaperSegment = 1.0;  // s
constexpr int kMostFrames = 1 << 16;
constexpr double kUsableBand = 0.45;  // of the rate
constexpr double kMaskBins = 1.0;     // the turn difference has taken the harmonics themselves
constexpr double kSmallest = 0.02;    // amplitude ratio: the resolution at which an onset is spoken of
constexpr double kLostPurity = 0.15;
constexpr double kEntryTurns = 16.0;  // a high ratio must last this long where no floor was learned
constexpr double kEntrySeconds = 0.15;
constexpr double kSameLine = 0.3;      // orders
constexpr double kUsualLooks = 16.0;   // before which gamma_max is not known
constexpr double kUsualMemory = 64.0;  // looks
constexpr double kUnusual = 4.0;       // scatters above the mean
constexpr double kLeastScatter = 0.03;
constexpr double kLeastGain = 0.05;  // of the turn difference, in power
constexpr Hertz kSpindleUnknown{20.0};

}  // namespace

config::ParamTable coherenceParams() {
  return kParams;
}

DetectorInfo CoherenceDetector::describe() const {
  return {"coherence", "Coherence", "Xu 2003", kIndicators};
}

void CoherenceDetector::prepare(const CutSetup& setup, const config::ParamSet& params) {
  rate_ = setup.rate.value;
  const Hertz nominal = setup.nominalSpeed.value > 0.0 ? toHertz(setup.nominalSpeed) : kSpindleUnknown;
  double seconds = std::min(kSegmentTurns / nominal.value, kPaperSegment);
  if (!params.isAutomatic(kCohSegment)) seconds = params.real(kCohSegment);
  const int frames = dsp::goodFftSize(std::clamp(static_cast<int>(seconds * rate_), 16, kMostFrames));
  hop_ = std::max(1, frames / kOverlap);
  CoherenceRatio::Settings settings;
  settings.form = params.choice(kCohForm) == 0 ? CoherenceForm::Welch : CoherenceForm::Paper;
  settings.sharpening = params.choice(kCohSharpening) == 0 ? SharpenForm::Monotone : SharpenForm::Printed;
  settings.averages = params.integer(kCohAverages);
  if (!params.isAutomatic(kCohLow) && !params.isAutomatic(kCohHigh)) {
    settings.band = {Hertz(params.real(kCohLow)), Hertz(params.real(kCohHigh))};
  }
  const auto count = setup.channels.size();
  judge_.prepare(setup.teeth);
  turns_.prepare(static_cast<int>(count), setup.rate, nominal * 0.5);
  ring_.prepare(static_cast<int>(count), frames);
  spectrum_.prepare(frames, setup.rate, dsp::WindowKind::Hann);
  mask_.prepare(spectrum_.bins(), spectrum_.binWidth());
  pairs_.assign(count > 1 ? count - 1 : 0, {});
  for (CoherenceRatio& pair : pairs_) pair.prepare(spectrum_.bins(), spectrum_.binWidth(), settings);
  channels_.assign(count, {});
  difference_.assign(count * kRow, 0.0);
  before_.assign(static_cast<std::size_t>(spectrum_.bins()), {});
  retune(params);
  reset();
  const std::size_t why = !params.isAutomatic(kCohSegment)    ? 0
                          : !(setup.nominalSpeed.value > 0.0) ? 3
                          : seconds < kPaperSegment           ? 1
                                                              : 2;
  own_.set(OwnSegment, spectrum_.segment() / rate_, why);
}

void CoherenceDetector::retune(const config::ParamSet& params) {
  gammaRef_ = params.real(kCohGammaRef);
  energyRef_ = params.isAutomatic(kCohEnergyRef) ? 0.0 : params.real(kCohEnergyRef);
  purity_ = params.real(kCohPurity);
  chatterRatio_ = params.real(kCohChatter);
  judge_.setChatterRatio(chatterRatio_);
  onset_.prepare({kSmallest * kSmallest, params.real(kCohEvidence)});
}

double CoherenceDetector::chosen(const config::ParamDecl& decl) const {
  return decl.key == kCohSegment.key ? spectrum_.segment() / rate_ : config::kAutomatic;
}

void CoherenceDetector::reset() {
  judge_.reset();
  leaveCut();
  restart();
}

void CoherenceDetector::restart() {
  turns_.reset();
  ring_.reset();
  for (CoherenceRatio& pair : pairs_) pair.reset();
  std::fill(channels_.begin(), channels_.end(), CoherenceChannel{});
  peak_ = {};
  sinceLook_ = 0;
  settledSeconds_ = energy_ = changedEnergy_ = 0.0;
}

void CoherenceDetector::leaveCut() {
  onset_.reset();
  usual_ = {};
  warned_ = false;
  warnedSeconds_ = lead_ = highTurns_ = 0.0;
}

void CoherenceDetector::takeEnergies() {
  double all = 0.0;
  double changed = 0.0;
  for (CoherenceChannel& c : channels_) {
    const double e = c.sum / hop_;
    const double d = c.changed / hop_;
    all += e * e;
    changed += d * d;
    c = {};
  }
  energy_ = std::sqrt(all);
  changedEnergy_ = std::sqrt(changed);
}

void CoherenceDetector::transform() {
  peak_ = {};
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    spectrum_.transform(ring_.newest(static_cast<int>(c)));
    if (c > 0) {
      CoherenceRatio& pair = pairs_[c - 1];
      pair.update(before_, spectrum_.values());
      const CoherencePeak peak = pair.peak(mask_);
      if (c == 1 || peak.gammaMax > peak_.gammaMax) peak_ = peak;
    }
    std::copy(spectrum_.values().begin(), spectrum_.values().end(), before_.begin());
  }
}

// Coherence that leaves its usual range before the energy does.
void CoherenceDetector::warn(bool settled, double seconds) {
  const double scatter = std::max(std::sqrt(usual_.variance), kLeastScatter);
  const bool known = usual_.looks >= kUsualLooks;
  const bool high = settled && known && peak_.gammaMax >= gammaRef_ && peak_.purity >= kLostPurity &&
                    peak_.gammaMax > usual_.mean + kUnusual * scatter;
  if (judge_.alarming()) return;
  warnedSeconds_ = high ? warnedSeconds_ + seconds : 0.0;
  warned_ = high && warnedSeconds_ > 1.5 * seconds;  // not one look alone
  lead_ = 0.0;
  if (!settled || high) return;
  usual_.looks += 1.0;
  const double error = peak_.gammaMax - usual_.mean;
  const double rate = 1.0 / std::min(usual_.looks, kUsualMemory);
  usual_.mean += rate * error;
  usual_.variance += rate * (error * error - usual_.variance);
}

// Part of the energy that the chatter holds: the turn difference passes a line p orders off a harmonic with
// (2 sin pi p)^2 / sqrt 6.
double CoherenceDetector::severity(Hertz spindle) const {
  if (!(energy_ > 0.0)) return 0.0;
  const double p = dsp::orderOffset(peak_.frequency, spindle);
  const double sine = 2.0 * std::sin(0.5 * kTwoPi * p);
  const double gain = std::max(sine * sine * sine * sine / 6.0, kLeastGain);
  const double changed = changedEnergy_ / energy_;
  return std::min(changed * changed / gain, 1.0);
}

// Chatter that was there from the entry: no calm stretch was learned, so the fixed ratio decides, but only for one and
// the same coherent line over many turns.
bool CoherenceDetector::fromEntry(double severity, double turns) {
  const double spindle = turns * rate_ / hop_;
  const bool high = severity >= chatterRatio_ && peak_.gammaMax >= gammaRef_ && peak_.purity >= purity_;
  const bool same = std::abs(peak_.frequency.value - highLine_.value) < kSameLine * spindle;
  highTurns_ = high && same ? highTurns_ + turns : 0.0;
  highLine_ = peak_.frequency;
  return highTurns_ > std::max(kEntryTurns, kEntrySeconds * spindle);
}

void CoherenceDetector::analyse(const ConditionedBlock& block) {
  const double seconds = hop_ / rate_;
  const double turns = block.spindle.value * seconds;
  takeEnergies();
  if (!(turns > 0.0) || !turns_.ready() || !ring_.full()) return;
  mask_.update(block.spindle, Hertz(), kMaskBins, Hertz(kUsableBand * rate_));
  transform();
  settledSeconds_ = AlarmStateMachine::steady(block) ? settledSeconds_ + seconds : 0.0;
  if (judge_.outdated(block)) onset_.reset();
  onset_.setSpindle(block.spindle);
  const bool settled = settledSeconds_ * rate_ > static_cast<double>(ring_.window());
  const double changed = energy_ > 0.0 ? changedEnergy_ / energy_ : 0.0;
  if (settled) onset_.update(changed * changed, turns, judge_.calm());
  warn(settled, seconds);
  const double part = severity(block.spindle);
  const bool coherent = peak_.gammaMax >= gammaRef_ && peak_.purity >= purity_;
  const bool grown = energyRef_ > 0.0 ? energy_ > energyRef_ : onset_.alarm();
  const bool entry = energyRef_ <= 0.0 && settled && fromEntry(part, turns);
  const bool lasts = (grown || part >= 0.5 * chatterRatio_) && peak_.purity >= kLostPurity;
  tellOwn();
  const bool before = judge_.alarming();
  judge_.judge({(grown && coherent) || entry, lasts, part}, block, Seconds(seconds));
  if (!before && judge_.alarming() && warned_) lead_ = warnedSeconds_;
  judge_.follow(peak_.frequency, Hertz(0.25 * spectrum_.binWidth()));
}

AutoValueTable CoherenceDetector::autoValues() const {
  return kOwnValues;
}

void CoherenceDetector::tellOwn() {
  const bool known = onset_.learned();
  own_.set(OwnFloor, known ? onset_.floor() : config::kAutomatic, !known ? 0 : judge_.calm() ? 1 : 2);
  const bool usual = usual_.looks >= kUsualLooks;
  own_.set(OwnUsual, usual ? usual_.mean : config::kAutomatic, !usual ? 0 : judge_.calm() ? 1 : 2);
  if (energyRef_ > 0.0) {
    own_.set(OwnEnergyRef, energyRef_, 1);
    return;
  }
  own_.set(OwnEnergyRef, known ? energy_ * std::sqrt(onset_.leastGrowth()) : config::kAutomatic, known ? 2 : 0);
}

Verdict CoherenceDetector::verdict(const ConditionedBlock& block) const {
  Verdict v = judge_.verdict(block);
  const double changed = energy_ > 0.0 ? changedEnergy_ / energy_ : 0.0;
  v.indicators = {peak_.gammaMax,    energy_,        peak_.frequency.value, lead_,
                  changed * changed, onset_.floor(), peak_.purity};
  v.earlyWarning = v.valid && warned_ && !v.alarming();
  if (v.alarming()) {
    v.reason = {ReasonCode::CoherenceHigh, {peak_.gammaMax, gammaRef_, v.frequency.value}};
  } else if (v.valid && block.phase == CutPhase::Steady && !onset_.learned()) {
    v.reason = {ReasonCode::Learning,
                {static_cast<double>(ring_.window()) / rate_ + OnsetTest::kLearnTurns / block.spindle.value}};
  }
  return v;
}

// At most kRow frames.
void CoherenceDetector::compare(const ConditionedBlock& block, int first, int frames) {
  const auto count = static_cast<std::size_t>(frames);
  turns_.process(block.samples + first, block.stride, count, difference_.data(), nullptr, kRow);
  ring_.push(difference_.data(), kRow, count);
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const double* x = block.samples + static_cast<std::ptrdiff_t>(c) * block.stride + first;
    const double* d = difference_.data() + c * kRow;
    CoherenceChannel& channel = channels_[c];
    for (std::size_t f = 0; f < count; ++f) {
      channel.sum += std::abs(x[f]);
      channel.changed += std::abs(d[f]);
    }
  }
}

Verdict CoherenceDetector::process(const ConditionedBlock& block) {
  if (!block.valid) return judge_.verdict(block);
  if (pairs_.empty()) {
    Verdict v = judge_.verdict(block);
    v.valid = false;
    v.reason = {ReasonCode::NeedsTwoChannels, {static_cast<double>(channels_.size())}};
    return v;
  }
  if (block.afterGap) restart();
  turns_.setTurn(block.spindle.value > 0.0 ? block.spindle : kSpindleUnknown);
  for (int f = 0; f < block.frames;) {
    const int frames = std::min({hop_ - sinceLook_, block.frames - f, kRow});
    compare(block, f, frames);
    f += frames;
    sinceLook_ += frames;
    if (sinceLook_ < hop_) continue;
    sinceLook_ = 0;
    analyse(block);
  }
  if (judge_.endBlock(block)) leaveCut();
  return verdict(block);
}

}  // namespace stillcut::detect
