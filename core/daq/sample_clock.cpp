#include "core/daq/sample_clock.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stillcut::daq {
namespace {

constexpr double kBandwidth = 0.1;  // Hz: a crystal drifts slower, a transport jitters faster
constexpr double kFastBandwidth = 1.0;
constexpr double kFastFor = 3.0;        // s
constexpr double kWindow = 0.5;         // s of arrivals
constexpr double kWindowBlocks = 16.0;  // blocks of arrivals at least, so that one of them is on time
constexpr double kLatest = 0.03;        // s of lateness that is no jitter, once it stays
constexpr double kLateBlocks = 3.0;     // blocks of lateness at least, to be no jitter
constexpr double kMostPull = 0.01;      // s: one late block must not bend the loop
constexpr double kRateRange = 0.02;     // a device's crystal is not further off the rate given or found
constexpr double kFar = 0.005;          // of the rate: what the loop should have followed
constexpr std::size_t kFewest = 2;      // windows that tell a rate
constexpr double kSlowest = 20.0;       // times the nominal period; beyond, a device stands still

}  // namespace

void SampleClock::prepare(Hertz nominal, int blockFrames, bool countsLosses, std::uint64_t lossUnit) noexcept {
  *this = SampleClock();
  nominal_ = nominal.value;
  countsLosses_ = countsLosses;
  lossUnit_ = lossUnit;
  block_ = blockFrames / nominal.value;
  latest_ = std::max(kLatest, kLateBlocks * block_);
  base_ = period_ = 1.0 / nominal.value;
}

// The device is believed as far as the time since the block before has room for what it tells.
void SampleClock::take(int frames, double at) noexcept {
  const double told = static_cast<double>(told_) * period_;
  if (cut_) {
    any_ = follows_ = false;
    jumped_ = true;
    since_ = 0.0;
    next_ = at - frames * period_;
  } else if (told_ > 0 && told <= at - at_ + std::max(0.0, late_) + latest_) {
    next_ += told;
    counted_ += static_cast<double>(told_);
    lost_ += told_;
  } else if (doubtful_ || told_ > 0) {
    jumped_ = true;
    const double late = at - (next_ + frames * period_);
    if (late > latest_) lose(late);
  }
  told_ = 0;
  cut_ = doubtful_ = false;
}

// So much time has gone by without samples.
void SampleClock::lose(double seconds) noexcept {
  const double unit = static_cast<double>(lossUnit_);
  const double frames = countsLosses_ ? 0.0 : unit * std::round(seconds / (period_ * unit));
  jumped_ = true;
  next_ += seconds;
  counted_ += frames;
  lost_ += static_cast<std::uint64_t>(frames);
  if (countsLosses_) any_ = follows_ = false;  // what came before tells nothing of the rate now
}

double SampleClock::arrivalPeriod() const noexcept {
  std::array<double, kWindows> sorted = periods_;
  const std::size_t n = std::min(windows_, kWindows);
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(n));
  const double low = sorted[(n - 1) / 2];
  const double high = sorted[n / 2];
  return std::abs(low - period_) < std::abs(high - period_) ? low : high;
}

// A window has ended.
void SampleClock::judge() noexcept {
  if (!any_) return;
  if (follows_ && first_.frames > before_.frames) {
    periods_[windows_++ % kWindows] = (first_.at - before_.at) / (first_.frames - before_.frames);
  }
  const double lateBefore = std::exchange(leastBefore_, least_);
  before_ = first_;
  follows_ = true;
  if (windows_ >= kFewest) {
    settled_ = true;
    const double arrives = std::min(arrivalPeriod(), kSlowest / nominal_);
    const double off = arrives / period_ - 1.0;
    const double far = latest_ / 3.0;
    if ((off > kFar && least_ > far) || (off < -kFar && least_ < -far)) {
      base_ = period_ = arrives;
      next_ = first_.at + (counted_ - first_.frames) * period_;
      leastBefore_ = 0.0;
      jumped_ = true;
      return;
    }
  }
  if (least_ > latest_ && lateBefore > latest_ && std::abs(least_ - lateBefore) <= latest_ / 2.0) {
    const double counted = counted_;
    lose(least_);
    before_.frames += counted_ - counted;
    leastBefore_ = 0.0;
  }
}

void SampleClock::note(double at, double late) noexcept {
  const double lateOfBase = at - counted_ * base_;
  if (!any_) windowBegin_ = at;
  if (!any_ || lateOfBase < firstLate_) {
    firstLate_ = lateOfBase;
    first_ = {at, counted_};
  }
  least_ = any_ ? std::min(least_, late) : late;
  any_ = true;
}

Instant SampleClock::stamp(int frames, Instant seen) noexcept {
  lost_ = 0;
  jumped_ = false;
  if (!started_) {
    started_ = true;
    origin_ = seen;
    next_ = -frames * period_;
    told_ = 0;
    cut_ = doubtful_ = false;
  }
  const double at = secondsBetween(origin_, seen).value;
  take(frames, at);
  if (any_ && at - windowBegin_ >= std::max(kWindow, kWindowBlocks * block_)) {
    judge();
    any_ = false;
  }
  const double length = frames * period_;
  next_ = std::min(next_, at - length + latest_);  // no sample is seen before it was taken
  const double late = at - (next_ + length);
  counted_ += frames;
  note(at, late);
  const double begin = next_;
  const double bandwidth = since_ < kFastFor ? kFastBandwidth : kBandwidth;
  const double omega = 2.0 * std::numbers::pi * bandwidth * length;
  const double most = std::max(kMostPull, 0.5 * block_);
  const double pull = late > latest_ ? 0.0 : std::clamp(late, -most, most);
  next_ += length + std::min(1.0, std::numbers::sqrt2 * omega) * pull;
  if (frames > 0) period_ += omega * omega * pull / frames;
  period_ = std::clamp(period_, (1.0 - kRateRange) * base_, (1.0 + kRateRange) * base_);
  since_ += length;
  at_ = at;
  late_ = late;
  last_ = std::max(origin_ + toDuration(Seconds(begin)), last_);
  return last_;
}

}  // namespace stillcut::daq
