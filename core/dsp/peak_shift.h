// Where a line stands between the bins of its spectrum. Thread: any; pure.
#pragma once

namespace stillcut::detect {

// Place of a peak between bins, from a parabola through the logarithms of three powers: -0.5 .. 0.5.
double peakShift(double left, double middle, double right) noexcept;
// The same towards `beside`, from the peak and one neighbour, for a line under a Hann window: amplitudes in the ratio
// a stand (2 a - 1) / (1 + a) apart (Grandke 1983).
double hannShift(double peak, double beside) noexcept;

}  // namespace stillcut::detect
