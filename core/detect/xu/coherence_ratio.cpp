#include "core/detect/xu/coherence_ratio.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/kernels/choose.h"
#include "core/dsp/peak_shift.h"

namespace stillcut::detect {
namespace {

constexpr std::size_t kSmooth = 2;  // bins to either side
constexpr double kKnee = 0.5;
constexpr double kAbove = 0.4;
constexpr double kBelow = 0.6;
constexpr double kOutside = 0.1;
constexpr double kFlank = 0.1;  // of the lower edge: 17 of 170 Hz
constexpr std::size_t kLobe = 2;

}  // namespace

dsp::kernels::SharpenRun sharpening(SharpenForm form) {
  dsp::kernels::SharpenRun run;
  run.knee = kKnee;
  run.above = kAbove;
  run.below = kBelow;
  if (form == SharpenForm::Monotone) run.factor = std::exp((1.0 - kKnee) * (1.0 / kBelow - 1.0 / kAbove));
  return run;
}

double CoherenceBand::weight(Hertz f) const {
  if (!(low.value > 0.0)) return 1.0;
  const double flank = kFlank * low.value;
  const double rise = (f.value - low.value) / flank;
  const double fall = (high.value - f.value) / flank;
  return kOutside + (1.0 - kOutside) * std::clamp(std::min(rise, fall), 0.0, 1.0);
}

void CoherenceRatio::prepare(int bins, double binWidth, const Settings& settings) {
  settings_ = settings;
  kernels_ = dsp::kernels::bestKernels();
  binWidth_ = binWidth;
  bins_ = static_cast<std::size_t>(bins);
  const std::size_t lanes = dsp::kernels::wholeLanes(bins_);
  for (auto* v : {&gx_, &gy_, &crossRe_, &crossIm_, &cross_, &raw_}) v->assign(lanes, 0.0);
  for (auto* v : {&weight_, &ratio_}) v->assign(bins_, 0.0);
  x_.fill(0.0);
  y_.fill(0.0);
  for (std::size_t b = 0; b < bins_; ++b) {
    weight_[b] = settings.band.weight(Hertz(static_cast<double>(b) * binWidth));
  }
  reset();
}

void CoherenceRatio::reset() {
  segments_ = 0;
  for (auto* v : {&gx_, &gy_, &crossRe_, &crossIm_, &cross_, &raw_, &ratio_}) std::fill(v->begin(), v->end(), 0.0);
}

void CoherenceRatio::update(std::span<const std::complex<double>> x, std::span<const std::complex<double>> y) {
  const bool welch = settings_.form == CoherenceForm::Welch;
  segments_ = std::min(segments_ + 1, settings_.averages);
  const auto* px = reinterpret_cast<const double*>(x.data());
  const auto* py = reinterpret_cast<const double*>(y.data());
  const auto run = [&](const double* a, const double* b, std::size_t from, std::size_t bins) {
    kernels_.coherence({a, b, bins, welch ? 1.0 / segments_ : 1.0, welch, gx_.data() + from, gy_.data() + from,
                        crossRe_.data() + from, crossIm_.data() + from, raw_.data() + from, cross_.data() + from});
  };
  const std::size_t whole = bins_ - bins_ % dsp::kernels::kLanes;
  run(px, py, 0, whole);
  if (whole == bins_) return;
  // The last bins go with silence behind them.
  std::copy(px + 2 * whole, px + 2 * bins_, x_.begin());
  std::copy(py + 2 * whole, py + 2 * bins_, y_.begin());
  run(x_.data(), y_.data(), whole, x_.size() / 2);
}

CoherencePeak CoherenceRatio::peak(const HarmonicMask& mask) {
  dsp::kernels::SharpenRun run = sharpening(settings_.sharpening);
  run.coherence = raw_.data();
  run.weight = weight_.data();
  run.bins = bins_;
  run.out = ratio_.data();
  kernels_.sharpen(run);
  CoherencePeak found;
  dsp::kernels::CrossScan scan{cross_.data(), ratio_.data(), mask.frees().data(), std::max(mask.first(), kSmooth),
                               std::min(mask.last(), bins_ - kSmooth - 1)};
  kernels_.scanCross(scan);
  found.gammaMax = scan.largestRatio;
  const std::size_t line = scan.place;
  if (line == 0 || line + kLobe >= bins_) return found;
  double lobe = 0.0;
  for (std::size_t b = line - std::min(line, kLobe); b <= line + kLobe; ++b) {
    if (mask.free(b)) lobe += cross_[b];
  }
  const double shift = peakShift(cross_[line - 1], cross_[line], cross_[line + 1]);
  found.frequency = Hertz((static_cast<double>(line) + shift) * binWidth_);
  found.purity = scan.freeSum > 0.0 ? lobe / scan.freeSum : 0.0;
  return found;
}

}  // namespace stillcut::detect
