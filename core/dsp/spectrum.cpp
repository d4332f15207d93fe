#include "core/dsp/spectrum.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::dsp {

void Spectrum::prepare(int segment, Hertz rate, WindowKind window, int padded) {
  kernels_ = kernels::bestKernels();
  window_.assign(static_cast<std::size_t>(std::max(segment, 2)), 0.0);
  sums_ = fillWindow(window, window_);
  fft_.prepare(goodFftSize(std::max(padded, segment)));
  rate_ = rate.value;
  binWidth_ = rate_ / fft_.size();
  values_ = fft_.forward();
}

void Spectrum::transform(std::span<const double> samples) noexcept {
  transform(samples.first(window_.size()), {});
}

void Spectrum::transform(std::span<const double> older, std::span<const double> newer) noexcept {
  double* in = fft_.input().data();
  kernels_.multiply(older.data(), window_.data(), in, older.size());
  kernels_.multiply(newer.data(), window_.data() + older.size(), in + older.size(), newer.size());
  values_ = fft_.forward();
}

void Spectrum::powers(std::span<double> out) const noexcept {
  kernels_.squares(reinterpret_cast<const double*>(values_.data()), out.data(), values_.size());
}

double Spectrum::density(int bin) const noexcept {
  const bool single = bin == 0 || 2 * bin == fft_.size();  // no mirror image to fold in
  return (single ? 1.0 : 2.0) * std::norm(values_[static_cast<std::size_t>(bin)]) / (rate_ * sums_.squares);
}

double Spectrum::amplitude(int bin) const noexcept {
  const bool single = bin == 0 || 2 * bin == fft_.size();
  return (single ? 1.0 : 2.0) * std::abs(values_[static_cast<std::size_t>(bin)]) / sums_.sum;
}

}  // namespace stillcut::dsp
