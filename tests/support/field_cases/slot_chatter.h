// A slot in aluminium with two flutes, by microphone: the harmonic series of the spindle, and chatter at f_c + k f_tp
// with sidebands at the distance of the spindle frequency, 13 dB lower. The spindle turns exactly at its nominal speed,
// and chatter is 18 dB above every harmonic of the series, often close beside one: whoever estimates the speed from the
// signal must not take the chatter for the series.
// Thread: any; no state.
#pragma once

#include <cstdint>

#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

enum class ChatterBegin {
  Entry,  // with the tool's entry: no stable cut before
  Late,   // after 3 s of stable cut
  Never,
};

struct SlotChatter {
  double speed = 10100.0;  // rev/min
  double order = 7.9;      // chatter frequency over spindle frequency
  ChatterBegin begin = ChatterBegin::Late;
  std::uint64_t seed = 1;
  double rate = 44100.0;  // Hz
  double entry = 3.5;     // s
  double stable = 3.0;    // s of stable cut, Late
  double exit = 13.5;     // s
  double length = 15.0;   // s
};

FieldCase slotChatter(const SlotChatter& s);

}  // namespace stillcut::field
