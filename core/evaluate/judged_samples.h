// What samples are judged at all, and in which steps: the same for recordings and for what another program hands over.
// Plain values: any thread.
#pragma once

#include "core/base/units.h"

namespace stillcut::evaluate {

inline constexpr Seconds kJudgedBlock{0.005};                           // how fine verdicts are in time
inline constexpr Hertz kSlowestSampling{100.0}, kFastestSampling{1e6};  // nothing beyond can be judged

}  // namespace stillcut::evaluate
