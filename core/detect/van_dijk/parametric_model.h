// Roots and spectrum of the perturbation model D(q) = 1 - sum theta_n q^-n (van Dijk 2010, eq. 26, 27).
// Thread: values; real-time.
#pragma once

#include <complex>

#include "core/base/units.h"
#include "core/detect/van_dijk/parametric_recursions.h"

namespace stillcut::detect {

using ArRoots = std::array<std::complex<double>, kArOrder>;

// Roots of q^4 - theta_1 q^3 - .. - theta_4: all at once (Weierstrass), polished until they stand.
ArRoots rootsOf(const ArCoefficients& theta);
// The same from those of a theta near by, in a third of the time.
ArRoots rootsOf(const ArCoefficients& theta, const ArRoots& near);
// Is a root on or outside the unit circle? By the reflection coefficients (Schur, Cohn): no root is looked for.
bool unstable(const ArCoefficients& theta);
// The theta whose roots these are (conjugate pairs and real roots).
ArCoefficients thetaOf(const ArRoots& roots);
// Every root outside the unit circle is put at the radius 1 - delta, its angle kept.
// True when one was.
bool reflect(ArRoots& roots, double delta);
// The root of largest magnitude among those that oscillate (eq. 27 gives a real one no frequency); of all when none
// does. Its conjugate with positive angle.
std::complex<double> dominantRoot(const ArRoots& roots);
// eq. 27.
Hertz rootFrequency(std::complex<double> root, Hertz rate);
// eq. 26: |1 / D(f)|^2.
double modelDensity(const ArCoefficients& theta, Hertz frequency, Hertz rate);

}  // namespace stillcut::detect
