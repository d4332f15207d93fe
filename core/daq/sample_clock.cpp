#include "core/daq/sample_clock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::daq {
namespace {

constexpr double kBandwidth = 0.1;  // Hz: a crystal drifts slower, a transport jitters faster
constexpr double kFastBandwidth = 1.0;
constexpr double kFastFor = 3.0;     // s
constexpr double kWindow = 0.5;      // s
constexpr double kLatest = 0.03;     // s of lateness that is a loss and no jitter, once it stays
constexpr double kLateBlocks = 3.0;  // ... and so many blocks
constexpr double kMostPull = 0.5;    // of a block: one late block must not bend the loop
constexpr double kRateRange = 0.02;  // a device's crystal is not further off
constexpr double kWrongRateRange = 0.25;

}  // namespace

void SampleClock::prepare(Hertz nominal, int blockFrames, bool countsLosses) noexcept {
  countsLosses_ = countsLosses;
  nominal_ = nominal.value;
  block_ = blockFrames / nominal.value;
  reset();
}

void SampleClock::reset() noexcept {
  started_ = any_ = false;
  period_ = nominal_ > 0.0 ? 1.0 / nominal_ : 0.0;
  since_ = window_ = least_ = 0.0;
  lost_ = 0;
}

void SampleClock::skip(std::uint64_t frames) noexcept {
  next_ += static_cast<double>(frames) * period_;
}

Instant SampleClock::stamp(int frames, Instant seen) noexcept {
  lost_ = 0;
  const double length = frames * period_;
  if (!started_) {
    started_ = true;
    origin_ = seen;
    next_ = -length;
  }
  const double at = secondsBetween(origin_, seen).value;
  double late = at - (next_ + length);
  least_ = any_ ? std::min(least_, late) : late;
  any_ = true;
  window_ += length;
  if (window_ >= kWindow) {
    if (least_ > std::max(kLatest, kLateBlocks * block_)) {
      if (!countsLosses_) lost_ = static_cast<std::uint64_t>(std::llround(least_ / period_));
      next_ += least_;
      late -= least_;
    }
    window_ = 0.0;
    any_ = false;
  }
  const double begin = next_;
  const double bandwidth = since_ < kFastFor ? kFastBandwidth : kBandwidth;
  const double omega = 2.0 * std::numbers::pi * bandwidth * length;
  const double pull = std::clamp(late, -block_, kMostPull * block_);
  next_ += length + std::min(1.0, std::numbers::sqrt2 * omega) * pull;
  if (frames > 0) period_ += omega * omega * pull / frames;
  const double range = countsLosses_ ? kWrongRateRange : kRateRange;
  period_ = std::clamp(period_, (1.0 - range) / nominal_, (1.0 + range) / nominal_);
  since_ += length;
  const Instant first = origin_ + toDuration(Seconds(begin));
  last_ = std::max(first, last_);
  return last_;
}

}  // namespace stillcut::daq
