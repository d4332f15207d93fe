// MachineState: the machine as read back, by value. The only thing that flows against the samples. Any thread.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut {

// What the link knows of itself: when each part was last received, and the delays it measured. Times are stream time,
// 0: never. A machine that takes its overrides unseen (analog) leaves `overrides` at never.
struct LinkTimes {
  Instant commanded{};     // the newest order that differs from the one before
  Instant acknowledged{};  // the newest order that was
  Instant overrides{};     // read back: what is in force
  Instant speed{};         // actual speed, at speed; never where nothing measures it
  Instant feed{};
  Instant program{};    // running, hold, S and F words
  Seconds roundTrip{};  // from a request to its answer; a median, 0: not measured
  Seconds effect{};     // from an order to overrides that show it; a median, 0: none was seen yet

  // Onto another stream's time; never stays never.
  void shift(Duration by) {
    for (Instant* t : {&commanded, &acknowledged, &overrides, &speed, &feed, &program}) {
      if (*t != Instant{}) *t += by;
    }
  }
};

// What keeps orders from acting on a machine that answers, as far as its link can tell. The gate goes by the flags of
// MachineState; this is their cause, for a person.
enum class OverrideInhibit : std::uint8_t {
  None,             // nothing, or the link cannot tell
  MachineOff,       // switched off, or in emergency stop
  MachineAlarm,     //
  NoProgram,        // the machine is on and waits
  OverridesLocked,  // by the program: M49
  SpeedLocked,      // M51 P0; or M49, while only the speed was moved
  FeedLocked,       // M50 P0; or M49, while only the feed was moved
  AdaptiveLocked,   // M52 P0: the feed goes by motion.adaptive-feed, and the program does not follow it
  OtherClient,      // another one has the overrides
  ControlRefused,   // asked for, and not given: the password
  ComponentSilent,  // stillcut-hal does not answer
  ComponentDown,    // stillcut-hal has not seen the machine's watchdog act
  ComponentOut,     // the machine's watchdog or the operator's switch has taken stillcut-hal out
  Starting,         // its port was opened, and a board that starts anew then is deaf for seconds
};
inline constexpr int kOverrideInhibits = 14;
std::string_view name(OverrideInhibit block);

struct MachineState {
  Instant time{};      // when it was read, stream time
  bool valid = false;  // false: nothing was ever read, or what was read made no sense
  bool linkUp = false;
  bool programRunning = false;
  bool feedHold = false;
  bool atSpeed = false;          // the spindle has reached what is commanded
  bool overridesEnabled = true;  // false under M49 and its like
  bool controlOurs = true;       // false when another client took the overrides
  OverrideInhibit block = OverrideInhibit::None;
  Rpm programmedSpeed{};             // S word; 0: spindle stopped
  MetresPerSecond programmedFeed{};  // F word
  Ratio operatorSpeed{1.0};          // the operator's own knobs
  Ratio operatorFeed{1.0};
  Ratio speedOverride{1.0};  // in force: knob times ours
  Ratio feedOverride{1.0};
  Rpm actualSpeed{};  // measured where the machine measures it
  MetresPerSecond actualFeed{};
  // CommandRecord::engagement: the link has let go of this one and all before it, and obeys none of them again. 0:
  // none.
  std::uint64_t endedEngagement = 0;
  LinkTimes link;

  Rpm targetSpeed() const { return programmedSpeed * speedOverride.value; }
};

}  // namespace stillcut
