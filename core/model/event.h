// Events (lines a machinist understands) and interventions (cards with before and after). Plain values: any thread.
#pragma once

#include <cstdint>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/model/reason.h"

namespace stillcut {

enum class EventLevel : std::uint8_t { Info, Warning, Fault };

struct Event {
  Instant time{};
  std::uint64_t number = 0;  // counts events of a run
  EventLevel level = EventLevel::Info;
  Reason reason;
};

// What came of our moves for an alarm, as the gate finds them: the alarm ended in time and stayed away; it goes on; it
// goes on and the cut is louder than before.
enum class MoveOutcome : std::uint8_t { None, Helped, NotHelped, Louder };

// One move of ours and what came of it.
struct Intervention {
  std::uint64_t number = 0;
  Instant began{};         // first alarm
  Instant commanded{};     // first command after it
  bool finished = false;   // quiet again, or given up
  bool quiet = false;      // quiet again
  Seconds timeToStable{};  // from the first alarm
  Hertz frequency{};       // chatter frequency at the alarm
  Rpm speedBefore{}, speedAfter{};
  MetresPerSecond feedBefore{}, feedAfter{};
  Ratio severityBefore{}, severityAfter{};  // energy ratio: highest before our command, newest after
  double vibrationBefore = 0.0;             // rms in the channel's SI unit
  double vibrationAfter = 0.0;
  MoveOutcome outcome = MoveOutcome::None;  // of the newest move
  double timesAsLoud = 0.0;                 // Louder: vibration over that before the move
  int withoutHelp = 0;                      // moves in a row that did not help, this one included
  bool endedAuto = false;                   // so many that Auto became Advise
  Metres marked{};                          // length of path cut in chatter
  // What it costs: time that a length of path takes after it, over the time that programme and knob give it. 1:
  // nothing, and where the feed is not known.
  Ratio cycleTime{1.0};
};

}  // namespace stillcut
