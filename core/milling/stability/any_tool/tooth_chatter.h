// The chatter frequency that belongs to a multiplier exp(i angle) of a tooth period: the motion is exp(i angle t/tau)
// times a periodic function, and its largest Fourier line is what a sensor measures.
// Thread: one, with its WorkMeter; not real-time.
#pragma once

#include "core/base/units.h"
#include "core/milling/stability/transition_matrix.h"

namespace stillcut::milling {

Hertz toothChatter(const RegenerativeSystem& system, const TransitionMatrix& transition, double angle, double depth,
                   WorkMeter& meter);  // 0 when stopped

}  // namespace stillcut::milling
