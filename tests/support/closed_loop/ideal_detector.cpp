#include "tests/support/closed_loop/ideal_detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "core/dsp/peak_shift.h"

namespace stillcut::test {
namespace {

constexpr std::array<std::string_view, 2> kIndicators{"gamma_max", "energy"};
constexpr double kFull = 0.5;     // amplitude, chatter to forced: an energy ratio of 20 %
constexpr double kTurns = 12.0;   // in one spectrum
constexpr double kLeast = 0.1;    // [s]
constexpr double kMasked = 1.6;   // bins around each harmonic
constexpr double kLowest = 40.0;  // [Hz]

}  // namespace

detect::DetectorInfo IdealDetector::describe() const {
  return {"ideal", "Ideal", "the simulation's truth", kIndicators};
}

void IdealDetector::prepare(const CutSetup& setup, const config::ParamSet& /*params*/) {
  const double seconds = std::max(kLeast, kTurns / toHertz(setup.nominalSpeed).value);
  const int length = std::max(64, static_cast<int>(seconds * setup.rate.value));
  spectrum_.prepare(length, setup.rate, dsp::WindowKind::Hann);
  past_.assign(static_cast<std::size_t>(length), 0.0);
}

Hertz IdealDetector::strongest(Hertz spindle) noexcept {
  spectrum_.transform(past_);
  const double width = spectrum_.binWidth();
  int best = 0;
  double most = -1.0;
  for (int bin = std::max(2, static_cast<int>(kLowest / width)); bin + 2 < spectrum_.bins(); ++bin) {
    const double hz = bin * width;
    const double order = hz / spindle.value;
    if (std::abs(order - std::round(order)) * spindle.value < kMasked * width) continue;
    const double velocity = spectrum_.amplitude(bin) / hz;
    if (velocity <= most) continue;
    most = velocity;
    best = bin;
  }
  if (best == 0) return Hertz(0.0);
  const auto power = [&](int bin) { return std::norm(spectrum_.values()[static_cast<std::size_t>(bin)]); };
  return Hertz((best + detect::peakShift(power(best - 1), power(best), power(best + 1))) * width);
}

Verdict IdealDetector::process(const detect::ConditionedBlock& block) noexcept {
  const std::span<const double> x = block.channel(0);
  const std::size_t fresh = std::min(x.size(), past_.size());
  std::move(past_.begin() + static_cast<std::ptrdiff_t>(fresh), past_.end(), past_.begin());
  std::copy(x.end() - static_cast<std::ptrdiff_t>(fresh), x.end(), past_.end() - static_cast<std::ptrdiff_t>(fresh));

  const milling::ChatterTruth& truth = plant_.truth();
  const double ratio = truth.chatterRatio();
  Verdict v;
  v.time = block.end();
  v.blockSequence = block.sequence;
  v.valid = true;
  v.spindle = toHertz(plant_.machineState().actualSpeed);
  v.phase = plant_.cutting() ? CutPhase::Steady : CutPhase::AirCutting;
  v.state = plant_.cutting() ? CutState::Stable : CutState::AirCutting;
  v.severity = Ratio(ratio * ratio / (1.0 + ratio * ratio));
  v.indicators[0] = ratio / (ratio + 0.25 * kFull);  // 0.8, Xu's reference, at full chatter
  v.indicators[1] = truth.vibration();
  if (!truth.chattering()) return v;
  v.state = ratio > kFull ? CutState::Chatter : CutState::Onset;
  v.frequency = strongest(v.spindle);
  v.kind = ChatterKind::Hopf;
  return v;
}

}  // namespace stillcut::test
