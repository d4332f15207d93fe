#include "core/spindle/line_list.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/peak_shift.h"

namespace stillcut::detect {
namespace {

// 11 dB. Of white noise one bin in e^12 is so high: one in ten looks at a spectrum of 16,000 bins.
constexpr double kAboveNoise = 12.0;
// Noise of a cut changes slowly with the frequency, and the lobes of the lines must fill less than half of a stretch.
constexpr Hertz kStretch{100.0};
constexpr std::size_t kFewestBins = 9;
constexpr double kMedianOfMean = 0.6931;  // of an exponential distribution

}  // namespace

void LineList::prepare(int bins, Hertz binWidth) {
  binWidth_ = binWidth.value;
  stretch_ = std::max(kFewestBins, static_cast<std::size_t>(kStretch / binWidth));
  const auto count = static_cast<std::size_t>(bins);
  noise_.assign(count / stretch_ + 1, 0.0);
  sorted_.assign(stretch_, 0.0);
  candidates_.reserve(count / 2 + 1);
  count_ = stretches_ = 0;
}

void LineList::measureNoise(std::span<const double> powers, std::size_t last) noexcept {
  stretches_ = 0;
  for (std::size_t from = 0; from + stretch_ <= last + 1 && stretches_ < noise_.size(); from += stretch_) {
    std::copy_n(powers.begin() + static_cast<std::ptrdiff_t>(from), stretch_, sorted_.begin());
    const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(stretch_ / 2);
    std::nth_element(sorted_.begin(), middle, sorted_.end());
    noise_[stretches_++] = *middle / kMedianOfMean;
  }
}

// Between the middles of two stretches as far as it is from each.
double LineList::noiseAt(std::size_t bin) const noexcept {
  if (stretches_ == 0) return 0.0;
  const double place = (static_cast<double>(bin) + 0.5) / static_cast<double>(stretch_) - 0.5;
  if (place <= 0.0) return noise_[0];
  const auto left = std::min(static_cast<std::size_t>(place), stretches_ - 1);
  const auto right = std::min(left + 1, stretches_ - 1);
  const double part = std::min(place - static_cast<double>(left), 1.0);
  return (1.0 - part) * noise_[left] + part * noise_[right];
}

void LineList::find(std::span<const double> powers, Hertz low, Hertz high) noexcept {
  candidates_.clear();
  count_ = 0;
  if (powers.size() < 3) return;
  const auto last = std::min(powers.size() - 2, static_cast<std::size_t>(std::max(0.0, high.value) / binWidth_));
  const auto first = std::max<std::size_t>(1, static_cast<std::size_t>(std::max(0.0, low.value) / binWidth_));
  measureNoise(powers, last);
  for (std::size_t b = first; b <= last; ++b) {
    const bool peak = powers[b] > powers[b - 1] && powers[b] >= powers[b + 1];
    if (!peak || !(powers[b] > kAboveNoise * noiseAt(b))) continue;
    const double shift = peakShift(powers[b - 1], powers[b], powers[b + 1]);
    candidates_.push_back({Hertz((static_cast<double>(b) + shift) * binWidth_), powers[b], b, false});
  }
  count_ = std::min<std::size_t>(candidates_.size(), kMost);
  const auto end = candidates_.begin() + static_cast<std::ptrdiff_t>(count_);
  std::partial_sort(candidates_.begin(), end, candidates_.end(),
                    [](const SpectralLine& a, const SpectralLine& b) { return a.power > b.power; });
  std::copy(candidates_.begin(), end, lines_.begin());
}

}  // namespace stillcut::detect
