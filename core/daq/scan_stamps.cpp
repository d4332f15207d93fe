#include "core/daq/scan_stamps.h"

#include <algorithm>
#include <cmath>

namespace stillcut::daq {
namespace {

constexpr int kMostScore = 64;
constexpr int kIrregular = 8;                     // what a step that is no period takes off
constexpr double kApart = 2e-4;                   // so much two crystals part
constexpr double kMissing = 1.5;                  // periods
constexpr std::int64_t kSetAnew = 1'000'000'000;  // ns: no transport takes so long; that clock was set

}  // namespace

void ScanStamps::prepare(Hertz rate) noexcept {
  *this = ScanStamps();
  period_ = 1e9 / rate.value;
}

int ScanStamps::run(std::span<const std::int64_t> stamps) noexcept {
  int count = 0;
  for (const std::int64_t stamp : stamps) {
    const double step = static_cast<double>(stamp - last_) / period_;
    if (any_) {
      if (believed() && step > kMissing) {
        if (count == 0) any_ = false;
        return count;
      }
      score_ = std::abs(step - 1.0) < 0.5 ? std::min(score_ + 1, kMostScore) : std::max(score_ - kIrregular, 0);
    }
    any_ = true;
    last_ = stamp;
    ++count;
  }
  return count;
}

void ScanStamps::arrived(std::int64_t newest, Instant seen) noexcept {
  const std::int64_t delay = toNs(seen) - newest;
  const auto grown = static_cast<std::int64_t>(kApart * static_cast<double>(newest - tiedAt_));
  if (delay - delay_ > kSetAnew) tied_ = false;
  delay_ = tied_ ? std::min(delay_ + std::max<std::int64_t>(grown, 0), delay) : delay;
  tiedAt_ = newest;
  tied_ = true;
}

}  // namespace stillcut::daq
