// ComediOutput: an AnalogOutput on a Comedi device (NI and many other cards). The last voltage stays when the program
// ends. Thread: as AnalogOutput says.
#pragma once

#include <memory>

#include "core/cnc/analog/analog_link.h"

namespace stillcut::app {

// Null in a build without Comedi.
std::unique_ptr<cnc::AnalogOutput> makeComediOutput();
// The same for a trial: it is looked at and not written.
std::unique_ptr<cnc::AnalogOutput> makeSilentOutput();

}  // namespace stillcut::app
