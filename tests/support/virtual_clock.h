// VirtualClock: a clock that moves when the test says so. Tests run on it and never sleep.
// Thread: any; now() may be read while another thread advances.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/base/time.h"

namespace stillcut::test {

class VirtualClock final : public Clock {
 public:
  explicit VirtualClock(Instant start = Instant{}) : ns_(toNs(start)) {}
  Instant now() const noexcept override { return instantFromNs(ns_.load(std::memory_order_acquire)); }
  void advance(Seconds by) { ns_.fetch_add(toDuration(by).count(), std::memory_order_acq_rel); }

 private:
  std::atomic<std::int64_t> ns_;
};

}  // namespace stillcut::test
