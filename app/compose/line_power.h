// Power of a line in a record, for the dB that simulations report.
#pragma once

#include <span>

#include "core/base/units.h"

namespace stillcut::app {

// Within 5 Hz of the line over the last second; 0: the record is shorter.
double linePower(std::span<const double> x, double frequency, Hertz rate);

}  // namespace stillcut::app
