// The frequency that chatter has at a time. It moves while the chatter grows and while the cut deepens, by up to 0.8 %
// on the simulated cuts: teeth that begin to leave the material soften the cut. A verdict is held to its own time.
// Thread: one; not the sample path.
#pragma once

#include "core/base/units.h"
#include "tests/bench/detection/known_cut.h"

namespace stillcut::bench {

// Around `time`, over eight turns of the spindle and 50 ms at least, from the signal before noise: the strongest line
// within 2 % of cut.chatterHz of what does not repeat from turn to turn. cut.chatterHz where there is no such signal,
// where the spindle does not keep its speed, where it lies on a spindle order, and where the line is not most of what
// does not repeat.
Hertz frequencyAt(const KnownCut& cut, Seconds time);

}  // namespace stillcut::bench
