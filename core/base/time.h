// Stream time: nanoseconds on the clock of the sample source. Sources stamp it, nobody restamps it, and everything from
// the conditioner to the gate measures time with it, so that a replay at any pace decides the same.
// Thread: values, no state. Real-time safe.
#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "core/base/units.h"

namespace stillcut {

struct StreamClock {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = std::chrono::nanoseconds;
  using time_point = std::chrono::time_point<StreamClock, duration>;
  static constexpr bool is_steady = true;
};

using Instant = StreamClock::time_point;
using Duration = StreamClock::duration;

constexpr Instant instantFromNs(std::int64_t ns) {
  return Instant(Duration(ns));
}
constexpr std::int64_t toNs(Instant t) {
  return t.time_since_epoch().count();
}
inline Duration toDuration(Seconds s) {
  return Duration(std::llround(s.value * 1e9));
}
constexpr Seconds toSeconds(Duration d) {
  return Seconds(static_cast<double>(d.count()) * 1e-9);
}
constexpr Seconds secondsBetween(Instant from, Instant to) {
  return toSeconds(to - from);
}
constexpr Seconds sinceEpoch(Instant t) {
  return toSeconds(t.time_since_epoch());
}

// Where a thread that must know the time of day of the stream gets it: the steady clock when live, a counter in tests.
class Clock {
 public:
  virtual ~Clock() = default;
  // Any thread. Never goes back.
  virtual Instant now() const noexcept = 0;
};

class SteadyClock final : public Clock {
 public:
  Instant now() const noexcept override {
    return Instant(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
  }
};

// Time that is set: of a deterministic run, which sets it to the end of each block, and of tests.
class ManualClock final : public Clock {
 public:
  Instant now() const noexcept override { return instantFromNs(ns_.load(std::memory_order_acquire)); }
  void set(Instant t) noexcept { ns_.store(toNs(t), std::memory_order_release); }

 private:
  std::atomic<std::int64_t> ns_{0};
};

}  // namespace stillcut
