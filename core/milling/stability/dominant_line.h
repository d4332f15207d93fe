// The chatter frequency of a motion exp(i theta t/tau) p(t), p periodic with the tooth period tau: its largest Fourier
// line.
#pragma once

#include <complex>
#include <span>

#include "core/base/units.h"

namespace stillcut::milling {

// `motion` holds x and y, interleaved, at equal times over one period [s]; lines -lines..lines are compared.
Hertz dominantLine(std::span<const std::complex<double>> motion, double angle, double period, int lines);

}  // namespace stillcut::milling
