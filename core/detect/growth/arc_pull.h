// What an arc of engagement that moves does to the speed that is tracked.
//
// The spindle's speed is told from the phases of the tooth passings, and those move with the arc: while it widens or
// narrows they turn against the spindle, all alike, and the tracked speed takes that turn for its own. It is off by a
// tenth of a per cent in a corner, by a third where a slot is entered, as long as the arc moves and some turns more.
// What is forced on an order n then seems to turn by n times as much the other way: of a drift between nothing and
// that, nobody knows that it is a line's. A speed that stays where it is for seconds is the spindle's, whatever the
// pattern of the tooth passings does meanwhile. Not in Caliskan 2018. Thread: worker; real-time.
#pragma once

#include "core/base/units.h"

namespace stillcut::detect {

class ArcPull {
 public:
  void reset() { *this = {}; }
  // One turn, at the speed that is tracked; moving: the engagement is changing (order_stretches.h).
  void endTurn(Hertz spindle, bool moving);
  // Of a drift [turns per turn] of an order: what the pull cannot be the cause of.
  double beyond(int order, double drift) const;

 private:
  double before_ = 0.0;              // Hz, while the engagement stood
  double least_ = 0.0, most_ = 0.0;  // of the tracked speed over that, relative, within the memory of order_turns.h
};

}  // namespace stillcut::detect
