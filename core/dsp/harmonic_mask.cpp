#include "core/dsp/harmonic_mask.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {

void HarmonicMask::prepare(int bins, double binWidth) {
  const auto size = static_cast<std::size_t>(bins);
  kernels_ = dsp::kernels::bestKernels();
  bins_ = size;
  free_.assign(dsp::kernels::wholeLanes(size), 0.0);
  binWidth_ = binWidth;
  first_ = 1;
  last_ = 0;
  for (auto& weights : weights_) weights.assign(size, 1.0);
  for (std::size_t b = 1; b < size; ++b) {
    const double f = static_cast<double>(b) * binWidth;
    weights_[0][b] = 1.0 / (f * f);
    weights_[2][b] = f * f;
  }
}

void HarmonicMask::update(Hertz spindle, Hertz doubt, double halfWidth, Hertz high) noexcept {
  const double spacing = spindle.value / binWidth_;
  const double spread = doubt.value / binWidth_;
  first_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(0.5 * spacing)));
  last_ = std::min(static_cast<std::size_t>(high.value / binWidth_), bins_ - 2);
  kernels_.maskHarmonics({spacing, spread, halfWidth, first_, last_, free_.size(), free_.data()});
}

}  // namespace stillcut::detect
