#include "core/rt/deadline_stats.h"

#include <algorithm>
#include <cmath>

namespace stillcut::rt {

void DeadlineStats::record(Seconds taken) noexcept {
  const double decades = std::log10(std::max(taken.value, 1e-7) / 1e-7);
  const int bucket = std::clamp(static_cast<int>(decades * kPerDecade), 0, kBuckets - 1);
  buckets_[static_cast<std::size_t>(bucket)].fetch_add(1, std::memory_order_relaxed);
  count_.fetch_add(1, std::memory_order_relaxed);
  if (taken.value > worst_.load(std::memory_order_relaxed)) worst_.store(taken.value, std::memory_order_relaxed);
}

Seconds DeadlineStats::quantile(double share) const noexcept {
  const std::uint64_t total = count();
  if (total == 0) return Seconds();
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(total)));
  std::uint64_t sum = 0;
  for (int i = 0; i < kBuckets; ++i) {
    sum += buckets_[static_cast<std::size_t>(i)].load(std::memory_order_relaxed);
    if (sum >= wanted) return Seconds(1e-7 * std::pow(10.0, (i + 1.0) / kPerDecade));
  }
  return worst();
}

}  // namespace stillcut::rt
