#include "core/daq/clock_aligner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace stillcut::daq {
namespace {

constexpr double kHalf = 8.0;            // taps on either side, of the slower rate
constexpr double kCut = 0.9;             // of its Nyquist frequency
constexpr std::size_t kAnchors = 64;     // stamps kept
constexpr double kResidualMemory = 5.0;  // s
constexpr std::size_t kSteps = 4096;     // of the kernel's table, for its one side

// sinc and window from the middle (0) to the end (kSteps), of unit cut-off distance kHalf.
const std::array<float, kSteps + 2>& kernel() {
  static const auto kTable = [] {
    std::array<float, kSteps + 2> table{};
    for (std::size_t i = 0; i <= kSteps; ++i) {
      const double u = static_cast<double>(i) / kSteps;
      const double x = std::numbers::pi * kCut * kHalf * u;
      const double window = 0.42 + 0.5 * std::cos(std::numbers::pi * u) + 0.08 * std::cos(2.0 * std::numbers::pi * u);
      table[i] = static_cast<float>(kCut * (i == 0 ? 1.0 : std::sin(x) / x) * window);
    }
    return table;
  }();
  return kTable;
}

}  // namespace

void ClockAligner::prepare(Hertz from, Hertz to, int channels, int history) {
  nominal_ = 1.0 / from.value;
  cut_ = std::min(1.0, to.value / from.value);
  width_ = kHalf / cut_;
  channels_ = channels;
  history_ = std::max<std::int64_t>(history, static_cast<std::int64_t>(4.0 * width_));
  samples_.assign(static_cast<std::size_t>(channels) * static_cast<std::size_t>(history_), 0.0F);
  anchors_.assign(kAnchors, {});
  (void)kernel();
  started_ = false;
  period_ = nominal_;
  residual_ = 0.0;
  anchorCount_ = 0;
  begin_ = end_ = 0;
}

void ClockAligner::push(const SampleBlock& block) noexcept {
  if (!started_) origin_ = block.firstSample;
  if (!started_ || block.has(kBlockGap)) {
    begin_ = end_;
    anchorCount_ = 0;
  }
  started_ = true;
  const double time = secondsBetween(origin_, block.firstSample).value;
  if (anchorCount_ > 0) {
    const Anchor& before = anchors_[newestAnchor_];
    const double frames = static_cast<double>(end_ - before.frame);
    const double off = time - (before.time + frames * period_);
    const double part = std::min(1.0, frames * nominal_ / kResidualMemory);
    residual_ += part * (off * off - residual_);
    period_ += part * ((time - before.time) / frames - period_);
  }
  newestAnchor_ = (newestAnchor_ + 1) % kAnchors;
  anchors_[newestAnchor_] = {end_, time};
  anchorCount_ = std::min(anchorCount_ + 1, kAnchors);
  for (int c = 0; c < channels_; ++c) {
    const std::span<const float> from = block.channel(c);
    float* to = samples_.data() + static_cast<std::int64_t>(c) * history_;
    for (std::size_t f = 0; f < from.size(); ++f) to[(end_ + static_cast<std::int64_t>(f)) % history_] = from[f];
  }
  end_ += block.frames;
  begin_ = std::max(begin_, end_ - history_);
}

// Of the stretch that `seconds` lies in; beyond the newest stamp, on with the rate.
double ClockAligner::frameAt(double seconds) const noexcept {
  std::size_t later = newestAnchor_;
  if (seconds >= anchors_[later].time || anchorCount_ < 2) {
    return static_cast<double>(anchors_[later].frame) + (seconds - anchors_[later].time) / period_;
  }
  std::size_t earlier = later;
  for (std::size_t i = 1; i < anchorCount_; ++i) {
    later = earlier;
    earlier = (earlier + kAnchors - 1) % kAnchors;
    if (seconds >= anchors_[earlier].time) break;
  }
  const Anchor& a = anchors_[earlier];
  const Anchor& b = anchors_[later];
  return static_cast<double>(a.frame) + (seconds - a.time) * static_cast<double>(b.frame - a.frame) / (b.time - a.time);
}

Instant ClockAligner::first() const noexcept {
  // Stamps that are still held; what lies before the oldest of them has no time.
  const Anchor& oldest = anchors_[(newestAnchor_ + kAnchors - (anchorCount_ - 1)) % kAnchors];
  const double frames = static_cast<double>(std::max(begin_, oldest.frame) - oldest.frame) + width_ + 1.0;
  return origin_ + toDuration(Seconds(oldest.time + frames * period_));
}

Instant ClockAligner::last() const noexcept {
  const Anchor& newest = anchors_[newestAnchor_];
  const double frames = static_cast<double>(end_ - newest.frame) - width_ - 1.0;
  return origin_ + toDuration(Seconds(newest.time + frames * period_));
}

float ClockAligner::value(int c, Instant time) const noexcept {
  const double at = frameAt(secondsBetween(origin_, time).value);
  const auto from = static_cast<std::int64_t>(std::ceil(at - width_));
  const auto to = static_cast<std::int64_t>(std::floor(at + width_));
  const float* samples = samples_.data() + static_cast<std::int64_t>(c) * history_;
  const auto& table = kernel();
  double sum = 0.0;
  double taps = 0.0;
  for (std::int64_t k = std::max(from, begin_); k <= std::min(to, end_ - 1); ++k) {
    const double u = std::abs(at - static_cast<double>(k)) / width_ * kSteps;
    const auto i = static_cast<std::size_t>(u);
    const double part = u - static_cast<double>(i);
    const double tap = (1.0 - part) * static_cast<double>(table[i]) + part * static_cast<double>(table[i + 1]);
    sum += tap * static_cast<double>(samples[k % history_]);
    taps += tap;
  }
  // Over their own sum: what stands still comes out as it is, bit by bit, and is seen to be dead.
  return static_cast<float>(taps > 0.0 ? sum / taps : 0.0);
}

Seconds ClockAligner::residual() const noexcept {
  return Seconds(std::sqrt(residual_));
}

}  // namespace stillcut::daq
