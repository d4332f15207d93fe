// Cuts heard by one sensor each that is no accelerometer: microphone, force, spindle speed, motor current. The truth is
// that of the tip's acceleration.
// Thread: one; not the sample path.
#pragma once

#include <span>

#include "tests/support/known_cuts/cut_families.h"

namespace stillcut::bench {

std::span<const CutFamily> sensorKindFamilies();

}  // namespace stillcut::bench
