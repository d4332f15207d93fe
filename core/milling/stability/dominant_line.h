// The chatter frequency of a motion exp(i theta t/tau) p(t), p periodic with the tooth period tau: its largest Fourier
// line. Pure: any thread; set-up, not real-time.
#pragma once

#include <complex>
#include <span>

#include "core/base/units.h"
#include "core/milling/stability/work_meter.h"

namespace stillcut::milling {

// `motion` holds x and y, interleaved, at equal times over one period [s]; lines -lines..lines are compared. 0 when
// stopped.
Hertz dominantLine(std::span<const std::complex<double>> motion, double angle, double period, int lines,
                   WorkMeter& meter);

}  // namespace stillcut::milling
