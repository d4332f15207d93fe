#include "core/detect/coherence_ratio.h"

#include <algorithm>
#include <cmath>

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

double sharpen(double gamma, SharpenForm form) noexcept {
  if (gamma > kKnee) return std::exp(-(1.0 - gamma) / kAbove);
  const double printed = std::exp(-(1.0 - gamma) / kBelow);
  if (form == SharpenForm::Printed) return printed;
  return printed * std::exp((1.0 - kKnee) * (1.0 / kBelow - 1.0 / kAbove));
}

double CoherenceBand::weight(Hertz f) const noexcept {
  if (!(low.value > 0.0)) return 1.0;
  const double flank = kFlank * low.value;
  const double rise = (f.value - low.value) / flank;
  const double fall = (high.value - f.value) / flank;
  return kOutside + (1.0 - kOutside) * std::clamp(std::min(rise, fall), 0.0, 1.0);
}

void CoherenceRatio::prepare(int bins, const Settings& settings) {
  settings_ = settings;
  for (auto* v : {&gx_, &gy_, &raw_, &ratio_}) v->assign(static_cast<std::size_t>(bins), 0.0);
  gxy_.assign(static_cast<std::size_t>(bins), {});
  reset();
}

void CoherenceRatio::reset() noexcept {
  segments_ = 0;
  for (auto* v : {&gx_, &gy_, &raw_, &ratio_}) std::fill(v->begin(), v->end(), 0.0);
  std::fill(gxy_.begin(), gxy_.end(), std::complex<double>{});
}

void CoherenceRatio::update(std::span<const std::complex<double>> x, std::span<const std::complex<double>> y) noexcept {
  const bool welch = settings_.form == CoherenceForm::Welch;
  segments_ = std::min(segments_ + 1, settings_.averages);
  const double part = welch ? 1.0 / segments_ : 1.0;
  for (std::size_t b = 0; b < gx_.size(); ++b) {
    gx_[b] += part * (std::norm(x[b]) - gx_[b]);
    gy_[b] += part * (std::norm(y[b]) - gy_[b]);
    gxy_[b] += part * (std::conj(x[b]) * y[b] - gxy_[b]);
    const double both = gx_[b] * gy_[b];
    const double cross = welch ? std::norm(gxy_[b]) : gxy_[b].real() * gxy_[b].real();
    raw_[b] = both > 0.0 ? std::min(cross / both, 1.0) : 0.0;
  }
}

CoherencePeak CoherenceRatio::peak(const HarmonicMask& mask, double binWidth) noexcept {
  CoherencePeak found;
  std::size_t line = 0;
  double height = 0.0;
  double free = 0.0;
  for (std::size_t b = std::max(mask.first(), kSmooth); b <= mask.last() && b + kSmooth < raw_.size(); ++b) {
    double sum = 0.0;
    for (std::size_t i = b - kSmooth; i <= b + kSmooth; ++i) sum += raw_[i];
    const double smooth = sum / (2.0 * kSmooth + 1.0);
    ratio_[b] = sharpen(smooth, settings_.sharpening) * settings_.band.weight(Hertz(static_cast<double>(b) * binWidth));
    if (!mask.free(b)) continue;
    found.gammaMax = std::max(found.gammaMax, ratio_[b]);
    const double cross = std::abs(gxy_[b]);
    free += cross;
    if (cross * ratio_[b] > height) {
      height = cross * ratio_[b];
      line = b;
    }
  }
  if (line == 0 || line + kLobe >= gxy_.size()) return found;
  double lobe = 0.0;
  for (std::size_t b = line - std::min(line, kLobe); b <= line + kLobe; ++b) {
    if (mask.free(b)) lobe += std::abs(gxy_[b]);
  }
  const double shift = peakShift(std::abs(gxy_[line - 1]), std::abs(gxy_[line]), std::abs(gxy_[line + 1]));
  found.frequency = Hertz((static_cast<double>(line) + shift) * binWidth);
  found.purity = free > 0.0 ? lobe / free : 0.0;
  return found;
}

}  // namespace stillcut::detect
