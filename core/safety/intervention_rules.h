// InterventionRules: what is asked of a move that was made for an alarm, and why so much. Plain values: any thread.
#pragma once

#include "core/base/units.h"

namespace stillcut::safety {

struct InterventionRules {
  // After arriving no alarm is heard any more. Chatter dies in some ten turns, a detector needs as many to say so, and
  // a strategy waits half a second before it listens: together 1.5 s at 1000 rpm.
  Seconds helpsWithin{2.0};
  // Then it stays away: the beat of two chatter frequencies is shorter.
  Seconds staysAway{1.0};
  // Longer than the gate waits for a spindle, and than the slowest law creeps from one end of its range to the other.
  Seconds arrivesWithin{12.0};
  // Of the programmed values: further the same way by so little is one move that goes on. Laws that feel their way go
  // by such steps; those that know where to go make one of it.
  double creeps = 0.03;
  // Times the rms before the move, when the alarm has had its time to end and goes on: 6 dB. Chatter at another speed
  // in reach is about as loud (53 of 54 moves without help in simulated cuts), a cut that was stable and now chatters
  // is ten times so.
  double louder = 2.0;
  // At the new speed. Given up sooner it was not listened to, and the next is the same move: laws that feel their way
  // stand at none of their steps, those that know where to go wait so long.
  Seconds listens{0.5};
  // Moves in a row that did not help, until Auto becomes Advise: one may be bad luck.
  int most = 2;
  // Quiet for so long proves the move, and what failed before it is forgiven. Shorter pauses are how a source of false
  // alarms swings a machine.
  Seconds proven{10.0};
};

}  // namespace stillcut::safety
