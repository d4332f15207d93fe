// WAV files whose header does not say how much they hold: the recorder was killed, wrote into a pipe, or lost its
// power. All samples are there.
// Thread: any; no state.
#pragma once

#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

enum class WavHeader {
  Killed,    // 0x80000000 bytes announced, as arecord writes before it knows
  Largest,   // 0x7ffff000 bytes announced
  Zero,      // 0 bytes announced, filled in at the end that never came
  CutOff,    // 100 bytes more announced than there are
  Streamed,  // 0xffffffff: unknown, as ffmpeg writes into a pipe
};

// 16 bits; the signal must be within full scale.
FileCase wavFile(FieldCase cut, WavHeader header);

}  // namespace stillcut::field
