// Does an order grow by itself, or with the load?
//
// The slow amplitude E of the vibration at a spindle order n, against the spindle's angle and in turns, obeys
//   E' = p E + f0 + f1 b,
// where b is the load, f0 + f1 b what runout drives that order with, linearised about now, and p the pole of the cut
// nearest to n, against n: its real part is what a small disturbance grows by in a turn, below 0 in a stable cut,
// however near its limit. Beside an order chatter and runout on a mode look alike for many turns: both turn slowly and
// grow, the one by itself, the other because a load that rises brings the mode nearer to its limit. A second difference
// over whole turns cannot tell them. p can, fitted to all turns of a window together, as the load is known from the
// tooth passings. But it moves with the load as well: by c s in a turn in which the load changes by the part s of
// itself, where c is 2 to 4 (a mode damped by the part z: 2 pi n z is what the load has taken from it when it comes to
// the limit, and less the later it acts). What that does to an order which grows by g a turn looks like a pole of up to
// c s / 2 g, less what f1 takes up of it; a third of what is asked for is what was left for four turns on end in cuts
// that came within a fiftieth of their limit, and so many turns are asked for, beyond the doubt of the fit
// (order_pole_test.cpp; "stable, slow spindle" in the table of detection).
//
// Whether an order settles is asked the other way round: with p taken as moving, E' = (p + c b) E + f0 + f1 b where b
// is the load's distance from that of now, p is the pole of now, and no allowance is needed. Four unknowns leave it in
// up to ten times the doubt, too much to begin an alarm by, but not to withhold one: in cuts that came to 0.95 of their
// limit p lay at -0.07 to 0.03 a turn where the other fit said 0.03 to 0.13, in chatter on an order, as far as it was
// known to a twentieth, at 0.06 to 1. Not in Caliskan 2018. Thread: worker; real-time.
#pragma once

#include <complex>
#include <cstddef>

#include "core/detect/growth/new_line.h"

namespace stillcut::detect {

struct OrderPole {
  static constexpr std::size_t kTurns = 16;  // of the window

  std::complex<double> pole;  // per turn
  double doubt = 0.0;         // standard deviation of its real part
  double growth = 0.0;        // of |E| in a turn, of the last two, logarithmic
  double load = 0.0;          // relative change of the load in a turn, of the last two

  struct Teeth {
    int count = 0;
    int harmonics = 0;  // of the spindle, as many as the rate can tell
  };
  // False where not so many turns are remembered, or nothing is there.
  bool fit(const NewLine& vibration, int channel, const Teeth& teeth, int order, Hertz spindle);
  bool growsByItself() const;
  // The pole of now and its doubt, of one that moves with the load; `growth` and `load` are left as they are.
  bool fitMoving(const NewLine& vibration, int channel, const Teeth& teeth, int order, Hertz spindle);
  // After that: it surely grows by itself by next to nothing, or falls. So does chatter that has grown as large as it
  // gets.
  bool settles(Hertz spindle) const;
  // Is the order's growth in the last two turns enough for that, whatever its pole? A fit costs twenty times as much.
  static bool mayGrow(const NewLine& vibration, int channel, int order, Hertz spindle);
};

}  // namespace stillcut::detect
