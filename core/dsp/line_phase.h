// The frequency of a line that is roughly known, by how far its phase advances: two windows of two revolutions, some
// more apart, are rotated back by the rough frequency; the rotation left between them is its error. Hann windows of
// two revolutions have zeros at every whole spindle order beside the line, which is where its sidebands are.
// Thread: pure function; real-time.
#pragma once

#include <span>

#include "core/base/units.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

inline constexpr double kLinePhaseTurns = 3.0;  // that must be known

// newest: the signal, oldest first, at least kLinePhaseTurns of it. rough: within half a spindle order. 0 where no line
// stands there: the two looks do not agree, or it holds too little of the signal.
Hertz linePhaseFrequency(std::span<const double> newest, Hertz rough, Hertz spindle, Hertz rate,
                         const dsp::kernels::Kernels& kernels) noexcept;

}  // namespace stillcut::detect
