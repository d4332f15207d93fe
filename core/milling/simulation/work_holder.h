// The two-axis piezo work-holder of Ford 2013 (figure 3): a table on flexures that two actuators move by up to +-3 um
// along x and y. Its flexure is one more mode of the relative motion of tool and workpiece in each axis: the cutting
// force bends it, and the actuator pushes it with stiffness times free stroke. Between converter and stroke:
// reconstruction filter of 4th order, amplifier with a bandwidth, a slew limit (its current into the actuator's
// capacity) and the stroke's ends. The paper's: 6 um of stroke in all, filters at 4 kHz (acceleration feedback) or 2
// kHz (force). Ours: flexure, damping, stiffness, the amplifier. Thread: one; step() is real-time.
#pragma once

#include "core/base/realtime.h"
#include "core/milling/cut_model.h"
#include "core/milling/simulation/low_pass.h"

namespace stillcut::milling {

struct WorkHolderSettings {
  Hertz flexure{1500.0};         // with the workpiece on it
  double damping = 0.05;         //
  double stiffness = 1.5e9;      // [N/m]
  Metres stroke{3e-6};           // either way
  Hertz reconstruction{4000.0};  // -3 dB of the filter behind the converter
  Hertz amplifier{3000.0};       // -3 dB of the amplifier, small signals
  double slew = 0.05;            // largest speed of the free stroke [m/s]
  std::vector<Hertz> quieten;    // lines its control is to care about most
  bool operator==(const WorkHolderSettings&) const = default;
};

Status check(const WorkHolderSettings& settings, const std::string& where);
// The flexure as two modes, along x and y.
std::array<Mode, 2> workHolderModes(const WorkHolderSettings& settings);

class WorkHolderAxis {
 public:
  WorkHolderAxis(const WorkHolderSettings& settings, Hertz rate);
  // One step of 1/rate with what the converter holds [m of free stroke]; gives the force on the flexure [N].
  double step(double command) STILLCUT_RT;
  bool saturated() const { return saturated_; }  // at the stroke's end or at the slew limit
  double stroke() const { return stroke_; }      // free stroke now [m]

 private:
  WorkHolderSettings settings_;
  LowPass4 filter_;
  double follow_, most_;
  double stroke_ = 0.0;
  bool saturated_ = false;
};

}  // namespace stillcut::milling
