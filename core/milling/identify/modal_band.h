// Which part of a compliance measurement to fit when nobody says: the part that limits the depth of cut.
// Source: the stability limit is -1 / (2 K_s Re[G]) at the most negative real part of the compliance; S. A. Tobias and
// W. Fishwick 1958; Altintas and Budak 1995. A mode alone reaches 1 / (4 k z (1 + z)), half of its imaginary part at
// resonance. Pure: any thread; set-up, not real-time.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/frf.h"

namespace stillcut::identify {

struct Band {
  double from = 0.0;  // [Hz]
  double to = 0.0;
};

// How far a peak stands out of the scatter of the lines around it.
enum class PeakNoise {
  Clear,
  Noisy,   // surely a resonance, and fitted: the fit averages over its lines
  Buried,  // probably one; too noisy to be fitted
};

struct Resonance {
  double frequency = 0.0;  // [Hz]
  double depth = 0.0;      // of its negative real part, from the imaginary part at its peak [m/N]
  PeakNoise noise = PeakNoise::Clear;
  bool reached = true;  // by the hammer's spectrum

  bool fitted() const { return reached && noise != PeakNoise::Buried; }
};

// A resonance below this part of the deepest negative real part does not limit the cut where the deepest one does not.
inline constexpr double kLeastDepth = 0.05;
// A noisy one widens the band only where it may limit the cut: what is fitted badly makes the rest worse.
inline constexpr double kLeastNoisyDepth = 0.3;

// Peaks that stand out of the noise, and those that do so only in part or lie beyond the hammer's reach, each marked;
// rising in frequency.
std::vector<Resonance> findResonances(const Frf& compliance);

// From 0.55 times the lowest to 1.2 times the highest of the fitted `resonances` whose depth counts, within `allowed`
// (an end of 0 is free). The factors leave room on both sides for the skirts that fix the residuals. Error: there is
// none.
Result<Band> resonantBand(const Frf& compliance, const std::vector<Resonance>& resonances, const Band& allowed);

}  // namespace stillcut::identify
