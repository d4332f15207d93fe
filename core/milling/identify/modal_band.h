// Which part of a compliance measurement to fit when nobody says. Pure: any thread; set-up, not real-time.
#pragma once

#include "core/base/result.h"
#include "core/milling/identify/frf.h"

namespace stillcut::identify {

struct Band {
  double from = 0.0;  // [Hz]
  double to = 0.0;
};

// From 0.55 times the lowest to 1.2 times the highest resonance that stands out of noise and reaches a tenth of the
// highest in mobility (which favours neither the drift of an integrated accelerometer at low frequency nor its noise at
// high frequency). The factors leave room on both sides for the skirts that fix the residuals.
Result<Band> resonantBand(const Frf& compliance);

}  // namespace stillcut::identify
