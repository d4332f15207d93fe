// What a law takes from the machine's state: whether there is anything to multiply, and the spindle speed.
// Thread: any; pure and real-time.
#pragma once

#include <cmath>

#include "core/model/machine_state.h"

namespace stillcut::control {

inline bool positive(double v) {
  return std::isfinite(v) && v > 0.0;
}

// Measured where the machine measures, else the commanded speed.
inline Rpm actualOrCommandedSpeed(const MachineState& m) {
  return m.actualSpeed.value > 0.0 ? m.actualSpeed : m.targetSpeed();
}

// False: hold, whatever the verdict.
inline bool usable(const MachineState& m) {
  return m.valid && positive(m.programmedSpeed.value) && positive(m.operatorSpeed.value) &&
         positive(actualOrCommandedSpeed(m).value);
}

// Another S word is another cut: what was found for the one before says nothing.
inline bool programmedSpeedChanged(const MachineState& m, Rpm before) {
  constexpr double kShare = 1e-3;
  return std::abs((m.programmedSpeed - before).value) > kShare * m.programmedSpeed.value;
}

}  // namespace stillcut::control
