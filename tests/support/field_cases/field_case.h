// A recording as users bring it, made and not measured, and what an alarm has to do on it. The numbers of the cases are
// those that were measured in real recordings.
// Thread: any; values.
#pragma once

#include <string>
#include <vector>

#include "core/model/channel.h"

namespace stillcut::field {

struct Signal {
  double rate = 0.0;  // Hz
  SensorQuantity quantity = SensorQuantity::Acceleration;
  std::vector<std::vector<float>> channels;  // in SI units, or in full scale for sound
};

// Chatter begins at `begin` and is fully developed from `from` to `to`, in s from the first sample.
struct AlarmTruth {
  bool chatter = false;  // false: nothing may alarm from end to end
  double begin = 0.0, from = 0.0, to = 0.0;
  int mostAlarms = 0;  // 0: any number
};

struct FieldCase {
  Signal signal;
  int teeth = 0;
  double speed = 0.0;  // rev/min, nominal and true
  AlarmTruth truth;
};

// The same as a file. `cut.signal` is what has to be read from it, apart from offsets and scale.
struct FileCase {
  FieldCase cut;
  std::string suffix;  // ".csv"
  std::string content;
};

}  // namespace stillcut::field
