// What every strategy says where it asks for nothing new: never without the numbers that it goes by.
// Thread: worker; pure and real-time.
#pragma once

#include <cmath>

#include "core/control/machine_readings.h"
#include "core/control/strategy.h"

namespace stillcut::control {

// What is not a number, or not known, is 0 in a sentence.
inline double shown(double v) {
  return std::isfinite(v) ? v : 0.0;
}

// The speed that is meant, which does not waver from verdict to verdict as the measured one does.
inline double commandedOrActualSpeed(const MachineState& m) {
  return shown(positive(m.targetSpeed().value) ? m.targetSpeed().value : m.actualSpeed.value);
}

// A machine that reports nonsense does not make nonsense of the sentence.
inline Reason finite(Reason reason) {
  for (double& n : reason.n) n = shown(n);
  return reason;
}

inline Reason monitoringAt(const StrategyInput& in) {
  return {ReasonCode::MonitoringAt, {commandedOrActualSpeed(in.machine), shown(in.verdict.severity.value)}};
}

inline Reason nothingToDoAt(const StrategyInput& in) {
  return {ReasonCode::NothingToDoAt, {commandedOrActualSpeed(in.machine), shown(in.verdict.severity.value)}};
}

// `target`: what is asked for; 0: nothing.
inline Reason nothingUsable(Rpm target, const MachineState& m) {
  return {ReasonCode::NothingUsable, {positive(target.value) ? target.value : commandedOrActualSpeed(m)}};
}

inline Reason teethNotKnown(const StrategyInput& in) {
  const double heard = in.verdict.alarming() ? in.verdict.frequency.value : 0.0;
  return {ReasonCode::TeethNotKnown, {shown(heard), commandedOrActualSpeed(in.machine)}};
}

}  // namespace stillcut::control
