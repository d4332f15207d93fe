// What a detector made of a known cut.
// Thread: one; not the sample path.
#pragma once

#include <string>
#include <vector>

#include "tests/support/known_cuts/known_cut.h"

namespace stillcut::bench {

struct Trial {
  std::string detector;
  std::vector<int> channels;  // empty: all
  double speedError = 0.0;    // of the told speed, as a ratio
};

struct Score {
  bool alarmed = false;
  double alarm = kNever;           // s
  double after1 = kNever;          // s after the 1 % time
  double after20 = kNever;         // s after the 20 % time
  double frequencyError = kNever;  // 50 ms after the alarm, as a ratio
  ChatterKind kind = ChatterKind::Unknown;
  double clearDelay = kNever;  // s, recovery
  bool before = false;         // in an unstable stretch before the truth's onset
  bool early = false, late = false, missed = false, falseAlarm = false, frequencyOff = false, kindWrong = false,
       clearLate = false;
  bool timely() const { return !(early || late || missed || falseAlarm); }
  bool good() const { return timely() && !frequencyOff && !clearLate; }
};

// Both axes, and each alone: the verdict is to be the same.
inline const std::vector<std::vector<int>> kAxes{{}, {0}, {1}};

// The detector in charge is held to the cut's rule; the others to 150 ms around the 20 % time.
Score score(const KnownCut& cut, const Trial& trial);

}  // namespace stillcut::bench
