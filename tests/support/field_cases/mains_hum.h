// Mains hum in an accelerometer's cable, from before the entry on, beside chatter that is stronger than it.
// Thread: any; no state.
#pragma once

#include <cstdint>

#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

struct MainsHum {
  double hum = 0.3;  // m/s^2 of the third harmonic of the mains; the chatter line has 0.69
  double mains = 50.0;
  double speed = 5000.0;   // rev/min
  double chatter = 684.7;  // Hz
  std::uint64_t seed = 1;
  double rate = 10000.0;                                      // Hz
  double entry = 3.0, begin = 4.0, exit = 6.0, length = 9.0;  // s
};

FieldCase mainsHum(const MainsHum& s);

}  // namespace stillcut::field
