#include "core/detect/speed_search.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr int kMostHarmonics = 40;
constexpr double kUsableBand = 0.45;  // of the rate; above it the filters before the converter bend the lines
constexpr double kOnComb = 0.15;      // orders
constexpr int kPadding = 2;
constexpr int kLobe = 2 * kPadding;  // half width of a Hann line in padded bins

}  // namespace

void SpeedSearch::prepare(int window, Hertz rate, int teeth) {
  spectrum_.prepare(window, rate, dsp::WindowKind::Hann, kPadding * window);
  finder_.prepare(spectrum_.bins(), Hertz(spectrum_.binWidth()), kLobe, teeth);
  rate_ = rate.value;
  teeth_ = teeth;
  for (auto* v : {&power_, &square_}) v->assign(static_cast<std::size_t>(spectrum_.bins()), 0.0);
  scratch_.assign(static_cast<std::size_t>(window), 0.0);
  trials_.assign(kMostTrials, 0.0);
}

void SpeedSearch::begin() noexcept {
  std::fill(power_.begin(), power_.end(), 0.0);
  std::fill(square_.begin(), square_.end(), 0.0);
  added_ = 0;
}

void SpeedSearch::addSpectrum(std::span<const double> samples, std::vector<double>& power) noexcept {
  spectrum_.transform(samples);
  const auto usable = static_cast<std::size_t>(kUsableBand * rate_ / spectrum_.binWidth());
  double total = 0.0;
  for (std::size_t b = kLobe; b < usable; ++b) total += std::norm(spectrum_.values()[b]);
  if (!(total > 0.0)) return;
  for (std::size_t b = kLobe; b < usable; ++b) power[b] += std::norm(spectrum_.values()[b]) / total;
}

void SpeedSearch::add(std::span<const double> samples) noexcept {
  addSpectrum(samples, power_);
  double mean = 0.0;
  for (const double x : samples) mean += x * x;
  mean /= static_cast<double>(samples.size());
  for (std::size_t n = 0; n < scratch_.size(); ++n) scratch_[n] = samples[n] * samples[n] - mean;
  addSpectrum(scratch_, square_);
  ++added_;
}

double SpeedSearch::at(const std::vector<double>& power, double position) noexcept {
  const auto b = static_cast<std::size_t>(position);
  if (b + 1 >= power.size()) return 0.0;
  const double part = position - static_cast<double>(b);
  return (1.0 - part) * power[b] + part * power[b + 1];
}

// Sums over the comb; a full Hann line holds 1.5 bins' worth of its peak, times the padding.
SpeedSearch::Parts SpeedSearch::parts(double spindle, int harmonics) const noexcept {
  Parts sum;
  for (int h = 1; h <= harmonics; ++h) {
    const double position = h * spindle / spectrum_.binWidth();
    sum.vibration += at(power_, position);
    sum.square += at(square_, position);
  }
  const double scale = 1.5 * kPadding / std::max(added_, 1);
  return {scale * sum.vibration, scale * sum.square};
}

double SpeedSearch::toothPart(double spindle) const noexcept {
  if (teeth_ < 1) return 0.0;
  double on = 0.0;
  for (int k = 1; k * teeth_ * spindle < kUsableBand * rate_; ++k) {
    const double position = k * teeth_ * spindle / spectrum_.binWidth();
    for (int d = -kLobe; d <= kLobe; ++d) on += at(power_, std::max(0.0, position + d));
  }
  return on / std::max(added_, 1);
}

SpeedSearch::Parts SpeedSearch::partsAt(Hertz spindle) const noexcept {
  if (!(spindle.value > 0.0)) return {};
  return parts(spindle.value, std::min(kMostHarmonics, static_cast<int>(kUsableBand * rate_ / spindle.value)));
}

SpeedCandidate SpeedSearch::search(Hertz low, Hertz high, Hertz notForced) noexcept {
  SpeedCandidate found;
  const int harmonics = std::min(kMostHarmonics, static_cast<int>(kUsableBand * rate_ / std::max(high.value, 1e-3)));
  if (harmonics < 1 || !(high > low) || !(low.value > 0.0) || added_ == 0) return found;
  const double finest = 0.2 * rate_ / window() / harmonics;
  const double step = std::max(finest, (high.value - low.value) / (kMostTrials - 2));
  std::size_t count = 0;
  std::size_t best = 0;
  for (double f = low.value; f <= high.value && count < trials_.size(); f += step, ++count) {
    const Parts p = parts(f, harmonics);
    const bool out = notForced.value > 0.0 && std::abs(dsp::orderOffset(notForced, Hertz(f))) < kOnComb;
    trials_[count] = out ? 0.0 : 0.5 * (p.vibration + p.square);
    if (trials_[count] > trials_[best]) best = count;
  }
  const double peak = trials_[best];
  const double left = best > 0 ? trials_[best - 1] : peak;
  const double right = best + 1 < count ? trials_[best + 1] : peak;
  const double curve = left - 2.0 * peak + right;
  const double shift = curve < 0.0 ? std::clamp(0.5 * (left - right) / curve, -0.5, 0.5) : 0.0;
  found.spindle = Hertz(low.value + (static_cast<double>(best) + shift) * step);
  found.sd = Hertz(step);
  found.part = std::min(peak, 1.0);
  found.atEdge = best == 0 || best + 1 == count;
  const auto middle = trials_.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(trials_.begin(), middle, trials_.begin() + static_cast<std::ptrdiff_t>(count));
  found.contrast = *middle > 0.0 ? peak / *middle : 0.0;
  found.toothPart = toothPart(found.spindle.value);
  return found;
}

SpeedSearch::Line SpeedSearch::strongest() const noexcept {
  const auto peak = static_cast<std::size_t>(std::max_element(power_.begin(), power_.end()) - power_.begin());
  double lobe = 0.0;
  for (std::size_t b = peak - std::min<std::size_t>(peak, kLobe); b <= std::min(peak + kLobe, power_.size() - 1); ++b) {
    lobe += power_[b];
  }
  double shift = 0.0;
  if (peak > 0 && peak + 1 < power_.size() && power_[peak - 1] > 0.0 && power_[peak + 1] > 0.0) {
    const double left = std::log(power_[peak - 1]);
    const double right = std::log(power_[peak + 1]);
    const double curve = left - 2.0 * std::log(power_[peak]) + right;
    if (curve < 0.0) shift = std::clamp(0.5 * (left - right) / curve, -0.5, 0.5);
  }
  return {Hertz((static_cast<double>(peak) + shift) * spectrum_.binWidth()), lobe / std::max(added_, 1)};
}

FoundSpeed SpeedSearch::find(Hertz low, Hertz high) noexcept {
  const auto usable = static_cast<std::size_t>(kUsableBand * rate_ / spectrum_.binWidth());
  return finder_.find(std::span<const double>(power_).first(std::min(usable, power_.size())), low, high);
}

}  // namespace stillcut::detect
