// The Floquet multiplier of largest modulus of a cut at one speed and depth, by itself: what the lobes, the advice and
// the simulated cuts are held to. The circle |mu| = r is widened or narrowed until the argument principle finds the
// outermost multiplier just outside it, then Newton on the transition matrix (core/milling/stability).
#pragma once

#include <complex>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::test {

// |mu| > 1 is unstable; a multiplier below 0.01 is given as that. An error where the speed or the depth (0 .. 1 m) is
// none, or the cut is too unstable for double precision.
Result<std::complex<double>> dominantMultiplier(const milling::ExactLobes& lobes, Rpm speed, Metres depth);

}  // namespace stillcut::test
