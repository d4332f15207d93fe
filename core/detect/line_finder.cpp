#include "core/detect/line_finder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr int kPadding = 4;  // zero-padding: the parabola then errs by less than a thousandth of a bin width
// Half width of what counts as the line: twice a Hann lobe, since a line that grows fast is broad.
constexpr int kLobe = 4 * kPadding;  // padded bins

// Four sums side by side: one alone waits for every addition.
double sum(std::span<const double> x) noexcept {
  std::array<double, 4> parts{};
  std::size_t i = 0;
  for (; i + 4 <= x.size(); i += 4) {
    for (std::size_t k = 0; k < 4; ++k) parts[k] += x[i + k];
  }
  for (; i < x.size(); ++i) parts[0] += x[i];
  return (parts[0] + parts[1]) + (parts[2] + parts[3]);
}

}  // namespace

void LineFinder::prepare(int channels, int window, Hertz rate) {
  channels_ = channels;
  window_ = static_cast<std::size_t>(window);
  spectrum_.prepare(window, rate, dsp::WindowKind::Recent, kPadding * window);
  ring_.assign(static_cast<std::size_t>(channels) * window_, 0.0);
  unrolled_.assign(window_, 0.0);
  for (auto* v : {&power_, &now_}) v->assign(static_cast<std::size_t>(spectrum_.bins()), 0.0);
  reset();
}

void LineFinder::reset() noexcept {
  std::fill(ring_.begin(), ring_.end(), 0.0);
  head_ = seen_ = 0;
}

void LineFinder::push(const double* rest) noexcept {
  for (int c = 0; c < channels_; ++c) ring_[static_cast<std::size_t>(c) * window_ + head_] = rest[c];
  head_ = head_ + 1 == window_ ? 0 : head_ + 1;
  if (seen_ < window_) ++seen_;
}

FoundLine LineFinder::find(Hertz low, Hertz high) noexcept {
  FoundLine found;
  if (2 * seen_ < window_) return found;
  std::fill(power_.begin(), power_.end(), 0.0);
  const double width = spectrum_.binWidth();
  const auto first = static_cast<std::size_t>(std::max(1.0, std::ceil(low.value / width)));
  const auto last = std::min(static_cast<std::size_t>(high.value / width), power_.size() - 2);
  if (first >= last) return found;
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
    const auto begin = ring_.begin() + static_cast<std::ptrdiff_t>(c * window_);
    const auto middle = begin + static_cast<std::ptrdiff_t>(head_);
    const auto end = begin + static_cast<std::ptrdiff_t>(window_);
    std::copy(begin, middle, std::copy(middle, end, unrolled_.begin()));
    spectrum_.transform(unrolled_);
    spectrum_.powers(now_);
    const double total = sum(std::span(now_).subspan(first, last + 1 - first));
    if (!(total > 0.0)) continue;
    const double share = 1.0 / total;
    for (std::size_t b = first - 1; b <= last + 1; ++b) power_[b] += share * now_[b];
  }
  const auto from = power_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto to = power_.begin() + static_cast<std::ptrdiff_t>(last + 1);
  const auto peak = static_cast<std::size_t>(std::max_element(from, to) - power_.begin());
  const std::span<const double> all(power_);
  const double whole = sum(all.subspan(first, last + 1 - first));
  if (!(whole > 0.0)) return found;
  const std::size_t left = std::max(first, peak - std::min<std::size_t>(peak, kLobe));
  const std::size_t right = std::min<std::size_t>(last, peak + kLobe);
  found.frequency = refined(peak);
  found.purity = sum(all.subspan(left, right + 1 - left)) / whole;
  return found;
}

// The top of the parabola through the logarithms of the peak and its neighbours.
Hertz LineFinder::refined(std::size_t peak) const noexcept {
  const double left = std::log(power_[peak - 1] + 1e-300);
  const double mid = std::log(power_[peak] + 1e-300);
  const double right = std::log(power_[peak + 1] + 1e-300);
  const double curve = left - 2.0 * mid + right;
  const double shift = curve < 0.0 ? std::clamp(0.5 * (left - right) / curve, -0.5, 0.5) : 0.0;
  return Hertz((static_cast<double>(peak) + shift) * spectrum_.binWidth());
}

LineFinder::Peak LineFinder::near(Hertz middle, Hertz reach) const noexcept {
  const double width = spectrum_.binWidth();
  const double low = std::max(1.0, std::ceil((middle.value - reach.value) / width));
  const double high = std::min((middle.value + reach.value) / width, static_cast<double>(power_.size()) - 2.0);
  if (!(low < high)) return {};
  const auto first = static_cast<std::size_t>(low);
  const auto last = static_cast<std::size_t>(high);
  std::size_t peak = first;
  for (std::size_t b = first; b <= last; ++b) {
    if (power_[b] > power_[peak]) peak = b;
  }
  if (power_[peak] < power_[peak - 1] || power_[peak] < power_[peak + 1]) return {};
  return {refined(peak), power_[peak]};
}

}  // namespace stillcut::detect
