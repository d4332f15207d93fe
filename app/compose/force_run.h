// Force feedback (Ford 2013, figure 8, table 4): the error is the dynamic cutting force at the work-holder, its static
// part taken off by a high-pass, and what is to fall is the line at the spindle's frequency. The reference is a tone
// that rotates with the spindle; each axis has a controller of its own (feedforward form, core/active/fxlms.h).
//
// In air a table that moves cuts nothing, and its force sensor measures its own inertia. So the path is identified
// in the cut, by a tone for each axis a tenth below and above the spindle's line, where the cut has no line of its own.
// It is a model of that line alone. A face mill answers a motion along x by force along y as well: each force is given
// to the actuator that moves it more (the relative gain, Bristol 1966), on Ford's cut the other axis' one. Thread: one;
// not the sample path.
#pragma once

#include "app/compose/active_run.h"

namespace stillcut::app {

// Refuses a scenario without a work-holder or without a force sensor on each axis.
Result<ActiveResult> runForce(const milling::Scenario& scenario, const ActiveOptions& options);

}  // namespace stillcut::app
