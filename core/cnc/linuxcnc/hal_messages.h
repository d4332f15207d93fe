// The words between Stillcut and stillcut-hal, the program beside LinuxCNC that holds the override pins
// (app/hal, packaging/linuxcnc/stillcut.hal). One request a line, one report a line; every request renews the lease.
//   set 90 95 1.000 100 100    speed %, feed %, adaptive feed; the last two: where the knobs go when all this ends
//   set - 95 1.000 70 100      "-": this knob is the operator's, leave it alone
//   home 100 100               let go
//   HELD 90 95 1.000 104       standing, what the pins show, and the watchdog's measured time in ms
// Several may ask; whoever holds is told HELD, the others TAKEN, and what they send changes nothing then.
// Thread: any. Real-time safe.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace stillcut::cnc {

struct HalRequest {
  bool hold = false;               // set, or home
  std::optional<int> speed, feed;  // %, 0..1000; nothing: that knob is left alone
  double adaptiveFeed = 1.0;       // 0..1
  int restoreSpeed = 100, restoreFeed = 100;
};

enum class HalLeaseState : std::uint8_t {
  Unproven,  // the machine's watchdog was not seen to act: nothing is taken
  Home,      // nothing of ours
  Held,
  Taken,   // by another client, or not yet let go of by one that has fallen
  Fallen,  // the machine's watchdog, or the operator's switch, took us out: until we let go
};

struct HalReport {
  HalLeaseState standing = HalLeaseState::Unproven;
  int speed = 100, feed = 100;
  double adaptiveFeed = 1.0;
  int watchdogMs = 0;  // from the last heartbeat until the machine was seen to let go; 0: not seen
};

inline constexpr std::size_t kHalLine = 64;  // no line is longer

// One line without its end; nothing when it is none.
std::optional<HalRequest> readHalRequest(std::string_view line) noexcept;
std::optional<HalReport> readHalReport(std::string_view line) noexcept;
// The line with its end, as a part of `into`.
std::string_view writeHalRequest(const HalRequest& request, std::span<char, kHalLine> into) noexcept;
std::string_view writeHalReport(const HalReport& report, std::span<char, kHalLine> into) noexcept;

}  // namespace stillcut::cnc
