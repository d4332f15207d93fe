// The strongest line of a spectrum outside the harmonics of the spindle and the tooth passing (Liao 1996, section 3).
// Thread: worker, real-time.
#pragma once

#include <cstddef>
#include <span>

#include "core/base/units.h"
#include "core/dsp/harmonic_mask.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

// What one spectrum says.
struct LineOutside {
  std::size_t bin = 0;
  Hertz frequency{};
  double amplitude = 0.0;  // of the line
  double part = 0.0;       // its power over that of the whole signal
  double purity = 0.0;     // its power over that of all free bins
  double severity = 0.0;  // energy ratio of the line to line and harmonics, by (2 pi f)^(2 eta) as Caliskan 2018 eq. 28
};

// power: |X|^2 of every bin; amplitude: of a line per root of its |X|^2.
LineOutside strongestOutside(std::span<const double> power, const HarmonicMask& mask, double binWidth, double amplitude,
                             int eta, const dsp::kernels::Kernels& kernels) noexcept;

}  // namespace stillcut::detect
