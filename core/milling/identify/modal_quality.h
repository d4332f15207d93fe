// How far a fit can be trusted: what its modes alone make of the measurement, what they leave out, and the coherence
// they were measured with. Pure: any thread; set-up, not real-time.
#pragma once

#include <vector>

#include "core/milling/identify/modal_band.h"
#include "core/milling/identify/modal_fit.h"

namespace stillcut::identify {

// Mean over the mode's bandwidth; 0 where it was not measured.
double coherenceAt(const Frf& frf, const milling::Mode& mode);

// Sets written misfit and both depths of a fit whose modes and lines are there, and remarks on a depth that is far off.
// The measured depth is the deepest of the band and of the `resonances` beside it.
void judgeWritten(ModalFit& fit, const std::vector<Resonance>& resonances, double addedDecay);

// Remarks on resonances that no mode stands for, with their size, and on those that are noisy or lie above `usableTo`,
// where the hammer has no force left [Hz].
void nameLeftOut(ModalFit& fit, const std::vector<Resonance>& resonances, double usableTo);

}  // namespace stillcut::identify
