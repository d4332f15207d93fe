// Windows, with the sums a calibrated spectrum needs.
#pragma once

#include <span>

namespace stillcut::dsp {

enum class WindowKind {
  Rectangular,
  Hann,
  FlatTop,
  Recent,  // rises as a Hann window over nine tenths of its length, falls over the last tenth: sees what just began
};

struct WindowSums {
  double sum = 0.0;      // of w: calibrates the amplitude of a line
  double squares = 0.0;  // of w^2: calibrates the density of noise
};

// Fills w with the periodic (DFT-even) window. Not real-time only because of its cosines.
WindowSums fillWindow(WindowKind kind, std::span<double> w);

}  // namespace stillcut::dsp
