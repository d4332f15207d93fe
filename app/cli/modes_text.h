// Modes of a tap test as the command line prints and writes them.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/modal_measurement.h"

namespace stillcut::app {

// Band, misfits, a row for each mode, and what was remarked.
void printModes(const identify::AxisModes& axis);

// All axes in one MODES.toml.
Status saveAxes(const std::vector<identify::AxisModes>& axes, const std::string& source, const std::string& out);

}  // namespace stillcut::app
