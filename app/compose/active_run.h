// The loop of the active work-holder on a simulated machine, block by block as its own thread would run it: identify
// the path from each actuator to its accelerometer in air, then cut with and without control. Thread: one; not the
// sample path, but the step of the loop itself is (tests count).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/active/active_engine.h"
#include "core/active/active_params.h"
#include "core/base/result.h"
#include "core/milling/simulation/simulated_cut.h"
#include "core/safety/actuator_gate.h"

namespace stillcut::app {

struct ActiveOptions {
  std::uint64_t seed = 0;
  config::ParamSet params;  // active.*
  // Every frame of the controlled cut, samples in device units.
  std::function<void(const SampleBlock&, const milling::SimulatedCut&)> observe;
  std::function<void(const active::PathRecorder&)> recorded;  // what the paths are identified from
};

struct AxisResult {
  std::string axis;
  active::IdentifiedPath path;  // without a report under force feedback: it is of one line
  ActivePath margin;
  ActuatorRelease released = ActuatorRelease::None;
  double releasedAt = 0.0;  // [s]
  double strokeUsed = 0.0;  // largest fraction of the amplitude limit
  double limitedFraction = 0.0;
};

struct Attenuation {
  std::string axis;
  double frequency = 0.0;  // [Hz]
  double db = 0.0;         // power within 5 Hz of it over the last second, without control over with control
  double alone = 0.0;      // that power without control, any unit
};

struct ActiveResult {
  std::vector<AxisResult> axes;
  std::vector<Attenuation> attenuation;
  bool chatterAlone = false;       // true chatter in the last second
  bool chatterControlled = false;  // it grows, is as loud as chatter left alone, or louder than a stable cut
  std::optional<double> growth;    // of the vibration under control, over the last two seconds [1/s]
  double finalRatio = 0.0;         // rms of the tip's acceleration, with over without, last second
  double chatterHz = 0.0;          // of the cut left alone
};

// Refuses a scenario without a work-holder or without an accelerometer on each axis, a path that cannot be identified,
// and one without phase margin. With active.feedback = force: force_run.h.
Result<ActiveResult> runActive(const milling::Scenario& scenario, const ActiveOptions& options);

}  // namespace stillcut::app
