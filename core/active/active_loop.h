// ActiveLoop: both axes of the active work-holder, each a controller behind its gate, and what they earn. One frame in,
// one frame out; the way from error to stroke is the same for a device, a simulated one and a test.
// Thread: step(), begin(), cut() and tell() on the loop's thread, real-time; engage(), release() and state() on any.
#pragma once

#include <array>
#include <vector>

#include "core/active/axis_tally.h"
#include "core/active/fxlms.h"
#include "core/active/line_meter.h"
#include "core/active/model_renewal.h"
#include "core/active/online_identifier.h"
#include "core/active/path_filter.h"
#include "core/base/result.h"
#include "core/safety/actuator_gate.h"

namespace stillcut::active {

struct AxisOptions {
  FxlmsOptions controller;
  PathModel path;
  safety::ActuatorLimits limits;
  std::vector<Hertz> lines;  // whose attenuation is reported
  OnlineOptions online;      // off unless its rms is above 0
};

using AxisPair = std::array<double, kActiveAxes>;
using CommandPair = std::array<safety::ActuatorCommand, kActiveAxes>;

class ActiveLoop {
 public:
  // Refuses a path that cannot be used and limits that are none, naming the axis.
  Status prepare(const std::array<AxisOptions, kActiveAxes>& axes, Hertz rate);

  void engage() noexcept;
  void release() noexcept;
  bool off() const noexcept;  // both gates

  // Before the frames of a block whose owner is alive: the leases.
  void begin() STILLCUT_RT;
  // Errors [SI of the sensor] to strokes [converter's unit].
  CommandPair step(const AxisPair& errors) STILLCUT_RT;
  // The device lost a block; its output is zero.
  void cut() STILLCUT_RT;
  void setStep(double step) noexcept;
  void setLeak(double leak) noexcept;
  // Beside the loop, on one thread, a few times a second: takes what was identified on-line, and gives the loop another
  // model where it is to have one. Allocates.
  void renewModels();
  // How many models were taken over since prepare().
  int renewals(std::size_t axis) const { return axes_[axis].renewals; }
  void tell(std::array<ActiveAxis, kActiveAxes>& axes) const STILLCUT_RT;

  const safety::ActuatorGate& gate(std::size_t axis) const { return axes_[axis].gate; }
  const FxlmsController& controller(std::size_t axis) const { return axes_[axis].controller; }

 private:
  struct Axis {
    FxlmsController controller;
    safety::ActuatorGate gate;
    LineMeter meter;
    AxisTally tally;
    ActuatorState before = ActuatorState::Off;
    OnlineIdentifier online;
    PathFilter added;                     // what is added for it, as the model says it arrives
    ModelRenewal renewal;                 // beside the loop
    int renewals = 0;                     // beside the loop
    rt::TripleBuffer<PathModel> renewed;  // to the loop
  };
  static safety::ActuatorCommand step(Axis& axis, double error) STILLCUT_RT;

  std::array<Axis, kActiveAxes> axes_;
};

}  // namespace stillcut::active
