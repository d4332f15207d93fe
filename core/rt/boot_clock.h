// BootClock: goes on while the computer sleeps, as the steady clock does not. The difference tells that it has slept.
// Any thread. Real-time safe.
#pragma once

#include <ctime>

#include "core/base/time.h"

namespace stillcut::rt {

class BootClock final : public Clock {
 public:
  Instant now() const noexcept override {
    timespec t{};
    if (clock_gettime(CLOCK_BOOTTIME, &t) != 0) return SteadyClock().now();
    constexpr std::int64_t kSecond_ns = 1'000'000'000;
    return instantFromNs(t.tv_sec * kSecond_ns + t.tv_nsec);
  }
};

}  // namespace stillcut::rt
