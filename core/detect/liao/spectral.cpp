#include "core/detect/liao/spectral.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/dsp/fft.h"
#include "core/dsp/kernels/choose.h"
#include "core/dsp/peak_shift.h"

namespace stillcut::detect {
namespace {

constexpr std::array<const config::ParamDecl*, 7> kParams{&kSpeWindow, &kSpeOverlap,  &kSpeThreshold, &kSpeMask,
                                                          &kSpePurity, &kSpeEvidence, &kSpeChatter};
constexpr std::array<std::string_view, 6> kIndicators{"peak", "frequency_hz", "part", "floor", "evidence", "purity"};

enum Own : std::size_t { OwnWindow, OwnThreshold, OwnFloor };
constexpr std::array<std::string_view, 4> kWhyWindow{kSetByHand, "28 turns at the told speed",
                                                     "1.5 s, the most, which 28 turns would exceed",
                                                     "the paper's, as no speed was told"};
constexpr std::array<std::string_view, 3> kWhyThreshold{kNotLearned, kSetByHand,
                                                        "four times the noise floor, or the least growth that counts"};
constexpr std::array<std::string_view, 3> kWhyFloor{kNotLearned, kMeanOfStable, kHeldInAlarm};
constexpr std::array<AutoValueDecl, 3> kOwnValues{{
    {"spectral.window", "Window", "s", kWhyWindow},
    {"spectral.threshold", "Line threshold", "", kWhyThreshold},
    {"spectral.floor", "Noise floor", "", kWhyFloor},
}};

constexpr double kWindowTurns = 28.0;
constexpr double kLongest = 1.5;  // s
constexpr double kPaperWindow = 0.512;
constexpr int kMostFrames = 1 << 16;
constexpr double kUsableBand = 0.45;  // of the rate
constexpr double kSmallest = 0.25;    // amplitude ratio; the paper waits for an intense line
constexpr double kLostPurity = 0.15;
constexpr double kEntryTurns = 16.0;  // a high ratio must last this long where no floor was learned
constexpr double kEntrySeconds = 0.15;
constexpr double kSameLine = 0.2;  // orders

}  // namespace

config::ParamTable spectralParams() {
  return kParams;
}

DetectorInfo SpectralDetector::describe() const {
  return {"spectral", "Spectral line", "Liao 1996", kIndicators};
}

void SpectralDetector::prepare(const CutSetup& setup, const config::ParamSet& params) {
  rate_ = setup.rate.value;
  const double nominal = toHertz(setup.nominalSpeed).value;
  double seconds = nominal > 0.0 ? std::min(kWindowTurns / nominal, kLongest) : kPaperWindow;
  if (!params.isAutomatic(kSpeWindow)) seconds = params.real(kSpeWindow);
  const int frames = dsp::goodFftSize(std::clamp(static_cast<int>(seconds * rate_), 16, kMostFrames));
  hop_ = std::max(1, frames / params.integer(kSpeOverlap));
  kernels_ = dsp::kernels::bestKernels();
  judge_.prepare(setup.teeth);
  spectrum_.prepare(frames, setup.rate, dsp::WindowKind::Hann);
  ring_.prepare(static_cast<int>(setup.channels.size()), frames);
  mask_.prepare(spectrum_.bins(), spectrum_.binWidth());
  power_.assign(static_cast<std::size_t>(spectrum_.bins()), 0.0);
  channels_.assign(setup.channels.size(), {});
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    channels_[i].eta = integrationFactor(setup.channels[i].quantity);
  }
  retune(params);
  reset();
  const std::size_t why = !params.isAutomatic(kSpeWindow) ? 0 : !(nominal > 0.0) ? 3 : seconds < kLongest ? 1 : 2;
  own_.set(OwnWindow, spectrum_.segment() / rate_, why);
}

void SpectralDetector::retune(const config::ParamSet& params) {
  maskBins_ = params.real(kSpeMask);
  threshold_ = params.isAutomatic(kSpeThreshold) ? 0.0 : params.real(kSpeThreshold);
  purity_ = params.real(kSpePurity);
  chatterRatio_ = params.real(kSpeChatter);
  judge_.setChatterRatio(chatterRatio_);
  for (SpectralChannel& c : channels_) c.onset.prepare({kSmallest * kSmallest, params.real(kSpeEvidence)});
}

double SpectralDetector::chosen(const config::ParamDecl& decl) const {
  return decl.key == kSpeWindow.key ? spectrum_.segment() / rate_ : config::kAutomatic;
}

void SpectralDetector::reset() {
  judge_.reset();
  leaveCut();
  restart();
}

void SpectralDetector::restart() {
  ring_.reset();
  for (SpectralChannel& c : channels_) c.line = {};
  sinceLook_ = 0;
  steadySeconds_ = 0.0;
}

void SpectralDetector::leaveCut() {
  for (SpectralChannel& c : channels_) c.onset.reset();
  highTurns_ = 0.0;
  leading_ = 0;
}

void SpectralDetector::look(SpectralChannel& c, int index) {
  spectrum_.transform(ring_.newest(index));
  spectrum_.powers(power_);
  const double norm = std::sqrt(power_[mask_.first()]);
  const double amplitude = norm > 0.0 ? spectrum_.amplitude(static_cast<int>(mask_.first())) / norm : 0.0;
  c.line = strongestOutside(power_, mask_, spectrum_.binWidth(), amplitude, c.eta, kernels_);
}

// Chatter that was there from the entry: no calm stretch was learned, so the fixed ratio decides, but only for one and
// the same line over many turns.
bool SpectralDetector::fromEntry(const LineOutside& line, double turns) {
  const double spindle = turns * rate_ / hop_;
  const bool high = line.severity >= chatterRatio_ && line.purity >= purity_;
  const bool same = std::abs(line.frequency.value - highLine_.value) < kSameLine * spindle;
  highTurns_ = high && same ? highTurns_ + turns : 0.0;
  highLine_ = line.frequency;
  return highTurns_ > std::max(kEntryTurns, kEntrySeconds * spindle);
}

void SpectralDetector::analyse(const ConditionedBlock& block) {
  const double step = hop_ / rate_;
  const double turns = block.spindle.value * step;
  steadySeconds_ = AlarmStateMachine::steady(block) ? steadySeconds_ + step : 0.0;
  if (judge_.outdated(block)) leaveCut();
  if (!(turns > 0.0) || !ring_.full()) return;
  mask_.update(block.spindle, block.spindleSd, maskBins_, Hertz(kUsableBand * rate_));
  const bool settled = steadySeconds_ * rate_ > static_cast<double>(ring_.window());
  bool begins = false;
  bool lasts = false;
  double severity = 0.0;
  leading_ = 0;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    SpectralChannel& c = channels_[i];
    const Hertz before = c.line.frequency;
    look(c, static_cast<int>(i));
    c.onset.setSpindle(block.spindle);
    if (settled) c.onset.update(c.line.part, turns, judge_.calm());
    const bool over = threshold_ > 0.0 ? c.line.amplitude > threshold_ : c.onset.alarm();
    const bool stands = std::abs(c.line.frequency.value - before.value) < kSameLine * block.spindle.value;
    begins = begins || (over && stands && c.line.purity >= purity_);
    lasts = lasts || ((over || c.line.severity >= 0.5 * chatterRatio_) && c.line.purity >= kLostPurity);
    severity = std::max(severity, c.line.severity);
    if (c.line.part > channels_[leading_].line.part) leading_ = i;
  }
  const LineOutside& line = channels_[leading_].line;
  const bool entry = threshold_ <= 0.0 && settled && fromEntry(line, turns);
  judge_.judge({begins || entry, lasts, severity}, block, Seconds(step));
  judge_.follow(line.frequency, Hertz(0.25 * spectrum_.binWidth()));
  tellOwn();
}

AutoValueTable SpectralDetector::autoValues() const {
  return kOwnValues;
}

void SpectralDetector::tellOwn() {
  const SpectralChannel& c = channels_[leading_];
  const bool known = c.onset.learned();
  own_.set(OwnFloor, known ? c.onset.floor() : config::kAutomatic, !known ? 0 : judge_.calm() ? 1 : 2);
  if (threshold_ > 0.0) {
    own_.set(OwnThreshold, threshold_, 1);
    return;
  }
  const double least = c.onset.leastGrowth();
  const bool heard = known && c.line.part > 0.0;  // a line's amplitude goes with the root of its part
  own_.set(OwnThreshold, heard ? c.line.amplitude * std::sqrt(least / c.line.part) : config::kAutomatic, known ? 2 : 0);
}

Verdict SpectralDetector::verdict(const ConditionedBlock& block) const {
  Verdict v = judge_.verdict(block);
  const SpectralChannel& c = channels_[leading_];
  v.indicators = {c.line.amplitude, c.line.frequency.value, c.line.part,
                  c.onset.floor(),  c.onset.evidence(),     c.line.purity};
  if (v.alarming()) {
    v.reason = {ReasonCode::LineOffHarmonics, {c.line.part, c.onset.floor(), v.frequency.value}};
  } else if (v.valid && block.phase == CutPhase::Steady && !c.onset.learned()) {
    v.reason = {ReasonCode::Learning,
                {static_cast<double>(ring_.window()) / rate_ + OnsetTest::kLearnTurns / block.spindle.value}};
  }
  return v;
}

Verdict SpectralDetector::process(const ConditionedBlock& block) {
  if (!block.valid || channels_.empty()) return judge_.verdict(block);
  if (block.afterGap) restart();
  for (int f = 0; f < block.frames;) {
    const int frames = static_cast<int>(std::min<long>(hop_ - sinceLook_, block.frames - f));
    ring_.push(block.samples + f, block.stride, static_cast<std::size_t>(frames));
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
