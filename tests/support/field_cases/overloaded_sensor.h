// Chatter that drives the sensor over its range: it clips. An overload must not end the alarm.
// Thread: any; no state.
#pragma once

#include "tests/support/field_cases/four_flute_sound.h"

namespace stillcut::field {

// `gain`: 4 clips 5 % of the samples in chatter, 6 clips 45 %.
FieldCase overloadedSensor(const FourFluteSound& s, double gain);

}  // namespace stillcut::field
