// What LinuxCNC said, as values: the replies of linuxcncrsh and halrmt taken apart. Each value carries when it was last
// said; a reply that makes no sense changes nothing.
// Thread: link thread. Real-time safe.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut::cnc {

template <class T>
struct TimedValue {
  T value{};
  Instant when{};
  bool ever = false;

  void set(T v, Instant now) noexcept {
    value = v;
    when = now;
    ever = true;
  }
};

enum class EmcProgram : std::uint8_t { Idle, Running, Paused };

struct EmcStatus {
  // linuxcncrsh
  TimedValue<int> feedOverride, spindleOverride;  // %
  bool decimals = false;                          // the spindle's was said with some, as newer servers do
  TimedValue<EmcProgram> program;
  TimedValue<Rpm> speedWord;             // S
  TimedValue<MetresPerSecond> feedWord;  // F, by G20 or G21
  TimedValue<bool> machineOn, inControl;
  // halrmt
  TimedValue<Rpm> actualSpeed;     // spindle.0.speed-in
  TimedValue<Rpm> commandedSpeed;  // spindle.0.speed-out: S times the override in force, within the spindle's range
  TimedValue<bool> atSpeed, feedHold;
  TimedValue<double> adaptiveFeed;          // 1: no change
  TimedValue<MetresPerSecond> currentFeed;  // motion.current-vel
  double machineUnit = 1e-3;                // [m], of [TRAJ] LINEAR_UNITS, whatever the program's G20 and G21 say

  // One reply line; false: it is none of these.
  bool take(std::string_view line, Instant now) noexcept;

 private:
  bool takeCodes(std::string_view words, Instant now) noexcept;
  bool takePin(std::string_view words, Instant now) noexcept;
};

}  // namespace stillcut::cnc
