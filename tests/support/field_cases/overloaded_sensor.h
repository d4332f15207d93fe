// Chatter that drives the sensor over its range: it clips. An overload must not end the alarm.
// Thread: any; no state.
#pragma once

#include "tests/support/field_cases/four_flute_sound.h"

namespace stillcut::field {

// `gain`: 4 clips a tenth of the chatter's samples, 6 a half.
FieldCase overloadedSensor(const FourFluteSound& s, double gain);

}  // namespace stillcut::field
