// A stable cut, and the tone of an axis drive that rises and falls with every feed move: it follows no spindle, and it
// is no chatter.
// Thread: any; no state.
#pragma once

#include <cstdint>

#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

struct AxisDrive {
  double amplitude = 0.2;  // m/s^2, of the tone; the tooth passing line has 0.69
  double highest = 812.0;  // Hz, at full feed
  double move = 2.0;       // s from feed move to feed move
  double speed = 7000.0;   // rev/min
  std::uint64_t seed = 1;
  double rate = 6400.0;                            // Hz
  double entry = 2.0, exit = 12.0, length = 14.0;  // s
};

FieldCase axisDrive(const AxisDrive& s);

}  // namespace stillcut::field
