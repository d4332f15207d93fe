// The frequency of a line that is roughly known, by how far its phase advances: two windows of two turns, some turns
// apart, are turned back by the rough frequency; what they still turn against each other is its error. Hann windows of
// two turns have zeros at every whole spindle order beside the line, which is where its side lines are.
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
