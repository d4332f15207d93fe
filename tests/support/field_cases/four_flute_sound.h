// The cut that the cases about channels, overload and file headers share: four flutes by microphone, stable from 2 s
// on, with chatter from 5 s to the end.
// Thread: any; no state.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

struct FourFluteSound {
  double speed = 8000.0;    // rev/min
  double chatter = 1171.3;  // Hz
  std::uint64_t seed = 1;
  double rate = 25600.0;                           // Hz
  double entry = 2.0, begin = 5.0, length = 12.0;  // s
};

// One channel, before a sound card stores it.
std::vector<double> fourFluteSamples(const FourFluteSound& s);

// With these channels instead of its own one.
FieldCase fourFluteCase(const FourFluteSound& s, const std::vector<std::vector<double>>& channels);

FieldCase fourFluteSound(const FourFluteSound& s);

}  // namespace stillcut::field
