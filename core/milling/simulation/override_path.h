// OverridePath: what lies between an override command and the drives: range, resolution and a delay drawn anew for each
// command (van Dijk 2010 section 5.2: 50..120 % speed, 0..100 % feed, 40..70 ms).
// Thread: one. Real-time safe.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/milling/simulation/noise.h"

namespace stillcut::milling {

struct OverrideSettings {
  Ratio lowestSpeed{0.5}, highestSpeed{1.2};
  Ratio lowestFeed{0.0}, highestFeed{1.0};
  Ratio resolution{0.001};  // steps of both; 0: continuous
  Seconds shortestDelay{0.040}, longestDelay{0.070};
  bool operator==(const OverrideSettings&) const = default;
};

class OverridePath {
 public:
  OverridePath(const OverrideSettings& settings, std::uint64_t seed) noexcept;

  // A command given at stream time `when`; not finite: ignored. Commands take effect in the order given. When 64 wait
  // already, it takes the place of the last of them.
  void command(Ratio speed, Ratio feed, Instant when) noexcept;
  // What is in force at `now`; time does not go back.
  void advance(Instant now) noexcept;
  Ratio speed() const { return speed_; }
  Ratio feed() const { return feed_; }

 private:
  struct Pending {
    Instant due{};
    Ratio speed{1.0}, feed{1.0};
  };
  static constexpr std::size_t kDepth = 64;

  OverrideSettings settings_;
  NoiseSource noise_;
  std::array<Pending, kDepth> queue_{};
  std::size_t first_ = 0, count_ = 0;
  Instant lastDue_{};
  Ratio speed_{1.0}, feed_{1.0};
};

}  // namespace stillcut::milling
