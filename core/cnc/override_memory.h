// OverrideMemory: what we have sent to a machine and what its operator had before, kept where it outlives this program.
// A program that is killed leaves its overrides standing; the next one would take them for the operator's own.
// Plain values: any thread. The calls' threads: see each.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>

namespace stillcut::cnc {

// Of one override, in percent of the programmed value.
struct SentOverride {
  int base = 100;  // the operator's own
  int sent = 100;  // base times ours
  bool operator==(const SentOverride&) const = default;
};
struct SentOverrides {
  SentOverride speed, feed;
  bool operator==(const SentOverrides&) const = default;
};

// One of them, or none, handed from thread to thread without a lock. Any thread.
class SentOverridesCell {
 public:
  void set(const std::optional<SentOverrides>& s) noexcept {
    cell_.store(s ? packed(*s) : 0, std::memory_order_release);
  }
  std::optional<SentOverrides> get() const noexcept {
    const std::uint64_t all = cell_.load(std::memory_order_acquire);
    const auto part = [all](unsigned shift) { return static_cast<int>(all >> shift & 0xFFFFU) - 1; };
    if (all == 0) return std::nullopt;
    return SentOverrides{{part(48), part(32)}, {part(16), part(0)}};
  }

 private:
  // Each part is one more than its percentage, so that all together are never 0.
  static std::uint64_t packed(const SentOverrides& s) noexcept {
    constexpr int kMost = 1000;
    std::uint64_t all = 0;
    for (const int percent : {s.speed.base, s.speed.sent, s.feed.base, s.feed.sent}) {
      all = all << 16U | static_cast<std::uint64_t>(std::clamp(percent, 0, kMost) + 1);
    }
    return all;
  }
  std::atomic<std::uint64_t> cell_{0};
};

class OverrideMemory {
 public:
  virtual ~OverrideMemory() = default;
  // Set-up thread, before the link is used: what an earlier program has left on record.
  virtual std::optional<SentOverrides> left() const = 0;
  // Whether that was sent this very moment: an override that goes there step by step may not have arrived.
  virtual bool fresh() const noexcept { return false; }
  // Link thread, real-time: to be on record within 0.1 s, by another thread than this one.
  virtual void keep(const SentOverrides& sent) noexcept = 0;
  // The same: nothing of ours stands in the machine any more.
  virtual void forget() noexcept = 0;
};

}  // namespace stillcut::cnc
