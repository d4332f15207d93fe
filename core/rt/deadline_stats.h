// DeadlineStats: how long something took, as a histogram with buckets 12 % apart from 0.1 us to 10 s.
// Thread: record() on one thread, real-time; the others on any, at any time (numbers may be one record apart).
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "core/base/units.h"

namespace stillcut::rt {

class DeadlineStats {
 public:
  void record(Seconds taken) noexcept;

  std::uint64_t count() const noexcept { return count_.load(std::memory_order_relaxed); }
  Seconds worst() const noexcept { return Seconds(worst_.load(std::memory_order_relaxed)); }
  // Upper edge of the bucket below which `share` (0..1) of all records lie; 0 without records.
  Seconds quantile(double share) const noexcept;

 private:
  static constexpr int kPerDecade = 20;
  static constexpr int kBuckets = 8 * kPerDecade;  // 1e-7 s .. 10 s

  std::array<std::atomic<std::uint64_t>, kBuckets> buckets_{};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<double> worst_{0.0};
};

}  // namespace stillcut::rt
