// A spindle that turns and does not cut: its first three orders, one of them perhaps the tooth passing, a bearing's
// tone with its second harmonic, a fan, and noise. Nothing quieter precedes it, and nothing may be called a cut or
// chatter. Thread: any; no state.
#pragma once

#include <cstdint>

#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

struct IdleSpindle {
  double speed = 7970.0;  // rev/min
  int teeth = 3;
  double bearing = 3.57;  // orders
  double fan = 812.3;     // Hz
  std::uint64_t seed = 1;
  double rate = 25600.0;  // Hz
  double length = 8.0;    // s
};

FieldCase idleSpindle(const IdleSpindle& s);

}  // namespace stillcut::field
