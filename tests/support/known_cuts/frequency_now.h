// The frequency that chatter has at a time. It moves while the chatter grows and while the cut deepens, by up to 0.8 %
// on the simulated cuts: teeth that begin to leave the material soften the cut. A verdict is held to its own time.
// Thread: one; not the sample path.
#pragma once

#include "core/base/units.h"
#include "tests/support/known_cuts/known_cut.h"

namespace stillcut::bench {

// Around `time`, over eight turns of the spindle and 50 ms at least, from the signal before noise: the strongest line
// within 2 % of cut.chatterHz, of the vibration where that line is most of it and was not there before the chatter, or
// else of what does not repeat from turn to turn. The spindle's order where it lies on one; cut.chatterHz where there
// is no such signal, near an order, and where the line is not most of what does not repeat.
Hertz frequencyAt(const KnownCut& cut, Seconds time);

// How far a verdict of that time is off, as a ratio, by what these channels (empty: all) heard. Chatter comes as a
// family of lines, whole spindle orders apart and mirrored at 0: the force of a tooth that is in and out of the
// material holds them all, and each sensor hears most of those beside its own axis' mode. The truth's line is the one
// that the tip, in x and y together, shakes most at. Another one is as right for a sensor that hears it at least half
// as loud, in power, as any of the family: nothing in its signal says that it is not the one.
double frequencyOffBy(const KnownCut& cut, Seconds time, Hertz told, const std::vector<int>& channels);

}  // namespace stillcut::bench
