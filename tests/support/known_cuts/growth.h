// The growth experiment: a made signal of 32 spindle harmonics whose speed and amplitudes wander, noise 20 dB below the
// main tooth harmonic, told speed 1 % wrong; a line between the harmonics grows from 2 % of the main tooth harmonic to
// three times it.
// Thread: one; not the sample path.
#pragma once

#include "tests/support/known_cuts/known_cut.h"

namespace stillcut::bench {

// The alarm is due 4.4 growth constants after the start: when an ideally evaluated fixed rule of 20 % would come.
// Spindle speed, teeth, rate and the line's place (0.1 to 0.5 orders from a harmonic) are scattered by seed.
KnownCut growingCut(double constant, unsigned seed);
KnownCut minuteWithoutGrowth(unsigned seed);

}  // namespace stillcut::bench
