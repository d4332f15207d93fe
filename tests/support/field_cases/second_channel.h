// A second channel that does not receive the cut beside one that does: the alarm must be the first one's.
// Thread: any; no state.
#pragma once

#include "tests/support/field_cases/four_flute_sound.h"

namespace stillcut::field {

enum class SecondChannel {
  Silent,  // digital zero: one microphone on a stereo input
  Dies,    // stops at a value 1 s after the entry
  Hums,    // mains hum only
};

FieldCase besideSecondChannel(const FourFluteSound& s, SecondChannel second);

}  // namespace stillcut::field
