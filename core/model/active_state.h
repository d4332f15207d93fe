// What a screen shows of the active work-holder: plain values that its loop publishes a few times a second, and the fit
// of each path's model, which is made aside when a path was identified. Thread: plain values; ActiveSnapshot is of
// fixed size, so that publishing it neither allocates nor locks.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut {

inline constexpr int kActiveAxes = 2;   // x, y
inline constexpr int kActiveLines = 8;  // an axis

// Of the door to one actuator (core/safety/actuator_gate.h).
enum class ActuatorState : std::uint8_t { Off, RampIn, On, RampOut };
enum class ActuatorRelease : std::uint8_t {
  None,
  Asked,
  LeaseOver,
  NotFinite,
  Diverging,
  Saturated,
  Worse,
  DeadSensor,
  DeviceFault
};
std::string_view actuatorReleaseText(ActuatorRelease why);  // "the loop diverged", for a report

// How much quieter a line is now than the controller's model says it would be without control.
struct LineAttenuation {
  Hertz frequency{};
  double gain_dB = 0.0;  // above 0: quieter; power within 5 Hz, over about the last second
  bool known = false;    // false: not yet, or no response there
};

struct ActiveAxis {
  ActuatorState state = ActuatorState::Off;
  ActuatorRelease release = ActuatorRelease::None;  // of the last letting go
  double strokePeak = 0.0;                          // fraction of the stroke, over the last second
  double strokeRms = 0.0;                           //
  double limitedFraction = 0.0;                     // of the last second's samples, cut off by amplitude or slew
  double errorRms = 0.0;                            // read now [SI of the sensor]
  double uncontrolledRms = 0.0;                     // by the model, without control
  int lineCount = 0;
  std::array<LineAttenuation, kActiveLines> lines{};
};

// The model of the path from an actuator to its sensor, and its margins.
struct ActivePath {
  bool known = false;
  Instant identified{};          // on the loop's clock
  Seconds delay{};               // from output to the first response to it: the loop's own delay
  double residual = 0.0;         // rms of what the model does not predict, over that of the reading
  double phaseMargin = 0.0;      // at its worst place on the lines to quieten, of the 90 degrees FXLMS can stand [rad]
  Seconds delayMargin{};         // how much later the loop may become before a line is driven the wrong way
  Hertz worstFrequency{};        // that place
  bool predictedStable = false;  // phaseMargin > 0
};

struct ActiveSnapshot {
  std::uint64_t number = 0;
  Instant time{};
  bool open = false;  // the device runs
  Hertz rate{};
  int blockFrames = 0;
  bool identifying = false;
  double identified = 0.0;  // 0 .. 1 of the record
  std::array<ActiveAxis, kActiveAxes> axes{};
  std::array<ActivePath, kActiveAxes> paths{};
  std::uint64_t blocks = 0;
  std::uint64_t underruns = 0;  // blocks that came late or were lost; the output was zero
  Seconds worstBlock{};         // longest time that the loop took for a block
};

// Measured against modelled, for a plot. Handed over outside the real-time path.
struct PathFit {
  std::vector<double> frequency;               // [Hz]
  std::vector<std::complex<double>> measured;  // [SI of the sensor per metre of stroke]
  std::vector<std::complex<double>> modelled;
  std::vector<double> coherence;  // 0 .. 1; below 0.8 the measurement says little
  ActivePath path;
};

}  // namespace stillcut
