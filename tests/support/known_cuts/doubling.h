// Period doubling by its own definition, from a simulated cut before noise.
// Thread: one; not the sample path.
#pragma once

#include <optional>

#include "tests/support/known_cuts/known_cut.h"

namespace stillcut::bench {

struct Doubling {                      // times: NaN where the limit is passed, and nothing comes of it
  double at1 = kNever, at20 = kNever;  // s
  double lastAbove = kNever;           // s, 20 %; middle of the window
  double hertz = 0.0;
};

// Even teeth at constant speed. What changes its sign from tooth to tooth lies on spindle harmonics, where a difference
// over whole turns does not see it, and runout makes some of it in the stable cut: a mode that comes near its limit
// amplifies that by 1 / (1 - depth / limit). All that is forced vibration. Beyond the limit of the exact lobes it goes
// on to grow by itself: chatter is what it has added, as a vector, to what it was where the cut passed that limit for
// the last time before, both over the tooth passings, which grow with the depth. The ratio is that over all that is
// forced, what alternated already included. Where it never reaches an energy ratio of 20 %, runout drives
// what alternates: such a cut has one motion, whatever its noise, a small disturbance of which dies at any time, and
// goes smoothly past the limit. None: the cut never comes to that limit from below, and this says nothing.
std::optional<Doubling> doublingOf(const KnownCut& cut, const SimulationOrder& order);

}  // namespace stillcut::bench
