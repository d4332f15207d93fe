#include "core/detect/energy_separation.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr int kOrder = 4;
constexpr double kUsableBand = 0.45;  // of the rate
constexpr double kRetune = 1e-3;      // smaller speed changes move no edge worth mentioning

}  // namespace

void EnergySeparation::prepare(int channels, int bands, Hertz rate, Hertz lowestWidth) {
  channels_ = channels;
  bands_ = bands;
  rate_ = rate.value;
  const double longest = rate_ / (2.0 * lowestWidth.value);  // lag of band 1
  mask_ = std::bit_ceil(static_cast<std::size_t>(4.0 * longest) + 8) - 1;
  const std::size_t count = static_cast<std::size_t>(channels) * static_cast<std::size_t>(bands);
  lag_.assign(static_cast<std::size_t>(bands), 1);
  filters_.assign(count, {});
  ring_.assign(count * (mask_ + 1), 0.0);
  sums_.assign(count, {});
  estimates_.assign(count, {});
  width_ = 0.0;
  reset();
}

void EnergySeparation::tune(Hertz width, Hertz floor) noexcept {
  if (width_ > 0.0 && std::abs(width.value / width_ - 1.0) < kRetune) return;
  width_ = width.value;
  active_ = std::clamp(static_cast<int>(kUsableBand * rate_ / width_), 1, bands_);
  for (int m = 0; m < active_; ++m) {
    const double middle = (m + 0.5) * width_;
    lag_[static_cast<std::size_t>(m)] =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(rate_ / (4.0 * middle))), 1, mask_ / 4);
    for (int c = 0; c < channels_; ++c) {
      const Hertz low(m == 0 ? floor.value : m * width_);
      const Hertz high(std::min((m + 1) * width_, 0.49 * rate_));
      filters_[index(c, m)].bandPass(kOrder, low, high, Hertz(rate_));
    }
  }
}

void EnergySeparation::reset() noexcept {
  for (auto& filter : filters_) filter.reset();
  std::fill(ring_.begin(), ring_.end(), 0.0);
  std::fill(sums_.begin(), sums_.end(), Sums{});
  std::fill(estimates_.begin(), estimates_.end(), BandEstimate{});
  frames_ = 0;
}

void EnergySeparation::process(const double* rest) noexcept {
  for (int c = 0; c < channels_; ++c) {
    for (int m = 0; m < active_; ++m) {
      const std::size_t i = index(c, m);
      double* ring = ring_.data() + i * (mask_ + 1);
      const std::size_t d = lag_[static_cast<std::size_t>(m)];
      const double s0 = filters_[i].process(rest[c]);
      ring[head_] = s0;
      const double s1 = ring[(head_ - d) & mask_];
      const double s2 = ring[(head_ - 2 * d) & mask_];
      const double s3 = ring[(head_ - 3 * d) & mask_];
      const double s4 = ring[(head_ - 4 * d) & mask_];
      const double y0 = s0 - s1;
      const double y1 = s1 - s2;
      const double y2 = s2 - s3;
      const double y3 = s3 - s4;
      sums_[i].signal += s2 * s2 - s3 * s1;
      sums_[i].difference += (y1 * y1 - y2 * y0) + (y2 * y2 - y3 * y1);
    }
  }
  head_ = (head_ + 1) & mask_;
  ++frames_;
}

void EnergySeparation::estimate() noexcept {
  if (frames_ == 0) return;
  for (int c = 0; c < channels_; ++c) {
    for (int m = 0; m < bands_; ++m) {
      const std::size_t i = index(c, m);
      BandEstimate& e = estimates_[i];
      const Sums s = sums_[i];
      sums_[i] = {};
      if (m >= active_) {
        e = {};
        continue;
      }
      const double signal = s.signal / static_cast<double>(frames_);
      e.valid = false;
      if (!(signal > 0.0) || !std::isfinite(s.difference)) continue;
      const double cosine = 1.0 - s.difference / (4.0 * s.signal);
      const double sine2 = 1.0 - cosine * cosine;
      if (!(std::abs(cosine) <= 1.0) || sine2 < 1e-3) continue;
      const auto d = static_cast<double>(lag_[static_cast<std::size_t>(m)]);
      e.frequency = Hertz(std::acos(cosine) * rate_ / (kTwoPi * d));
      e.power = signal / sine2;
      e.valid = true;
    }
  }
  frames_ = 0;
}

}  // namespace stillcut::detect
