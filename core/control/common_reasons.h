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

// Where a number is not known, the sentence without it.
inline Reason monitoringAt(const StrategyInput& in) {
  if (!positive(commandedOrActualSpeed(in.machine))) return {ReasonCode::Monitoring, {}};
  return {ReasonCode::MonitoringAt, {commandedOrActualSpeed(in.machine), shown(in.verdict.severity.value)}};
}

inline Reason nothingToDoAt(const StrategyInput& in) {
  if (!positive(commandedOrActualSpeed(in.machine))) return {ReasonCode::NothingToDo, {}};
  return {ReasonCode::NothingToDoAt, {commandedOrActualSpeed(in.machine), shown(in.verdict.severity.value)}};
}

// `target`: what is asked for; 0: nothing.
inline Reason nothingUsable(Rpm target, const MachineState& m) {
  const double speed = positive(target.value) ? target.value : commandedOrActualSpeed(m);
  if (!positive(speed)) return {ReasonCode::VerdictNotUsable, {}};
  return {ReasonCode::NothingUsable, {speed}};
}

inline Reason teethNotKnown(const StrategyInput& in) {
  const double heard = in.verdict.alarming() ? in.verdict.frequency.value : 0.0;
  if (!positive(heard)) return nothingToDoAt(in);
  return {ReasonCode::TeethNotKnown, {shown(heard), commandedOrActualSpeed(in.machine)}};
}

}  // namespace stillcut::control
