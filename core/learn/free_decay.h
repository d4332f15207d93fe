// The free response inside a stable cut: what is left of a vibration without the harmonics of the spindle
// is the answer of the cut to small blows, and its decay is what the cut has left until it chatters. Operational modal
// analysis: the autocovariance of the residual decays as the free response does (James and Carne 1995; Ahmadi 2019;
// JMMP 2025 9(10) 323); its poles by the eigensystem realization (Juang and Pappa 1985), its scatter by leaving out
// parts. Pure; allocates; any thread but the sample path.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/message.h"
#include "core/base/units.h"

namespace stillcut::learn {

struct FreeDecay {
  Hertz frequency{};
  Hertz frequencySd{};
  double rate = 0.0;    // of the decay [1/s]; 0 at the limit
  double rateSd = 0.0;  // [1/s]
};

struct DecayParams {
  Hertz lowest{300.0}, highest{3000.0};  // where modes are looked for
  int turnsAveraged = 16;                // of the spindle, for its harmonics
  int parts = 8;                         // of the recording, for the scatter
  double mostDoubt = 0.35;               // rateSd/rate above which nothing is said
  double shortest_s = 1.0;               // of the recording
};

struct DecayAnswer {
  std::optional<FreeDecay> decay;
  Message why;  // nothing is said
};

// `samples` of a steady stable cut at a constant speed.
DecayAnswer freeDecay(std::span<const double> samples, Hertz rate, Rpm spindle, const DecayParams& params = {});

// The slowest decay of all channels is what the cut has left; none: why of the first.
DecayAnswer slowestDecay(std::span<const std::vector<double>> channels, Hertz rate, Rpm spindle,
                         const DecayParams& params = {});

}  // namespace stillcut::learn
