// The force law F = a_p (K h^x + K_e) as the straight line that touches it at a chip thickness: what lobes and the
// growth of small disturbances see of a material whose exponent is not 1. It holds for chips near that one. Thread:
// pure functions.
#pragma once

#include "core/milling/cut_model.h"

namespace stillcut::milling {

// Mean chip thickness over the angles in the cut, f_z (cos start - cos exit)/(exit - start).
Metres meanChip(const Engagement& engagement, Metres feedPerTooth);
Metres meanChip(const CutModel& model, Metres feedPerTooth);  // of an edge that stands: f sin(kappa)
// x K h^(x-1) for K and exponent 1, without edge forces; `chip` above 0. An exponent of 1 is left as it is.
Material linearisedAt(Material material, Metres chip);
// What lobes can work with: a power law taken as straight at the mean chip of this feed, or at the material's usual
// chip where the feed is 0. A serrated tool is told the feed. Gives the chip back; 0: nothing was done, the law is
// straight or no chip is known.
Metres lineariseForLobes(CutModel& model, Metres feedPerTooth);

}  // namespace stillcut::milling
