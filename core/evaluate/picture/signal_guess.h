// SignalGuess: which spindle speed and how many teeth a recording says by itself, how sure that is, and what else fits
// nearly as well. For whoever is about to type these two numbers; no detector takes them from here.
//
// Speed: near the nominal one, or else near what the detector has found by itself, the lines of the spectrum, averaged
// over the louder half of the recording, are held against every speed by two_series.h, orders of the spindle and one
// series of chatter beside them. Where nobody has told a speed, others that fit nearly as well are its rivals: its
// parts always do, for a spindle with one tooth more or less may turn at them. Where the number that was told fits as
// revolutions a second, the speed is that. Teeth: where a speed was told, the largest number whose multiples carry most
// of what stands on the orders of the spindle. Thread: any; not the sample path.
#pragma once

#include <functional>
#include <vector>

#include "core/base/units.h"
#include "core/evaluate/picture/sample_store.h"

namespace stillcut::evaluate {

struct SignalGuess {
  Rpm speed{};  // 0: none stands out
  Rpm doubt{};  // one standard deviation
  std::vector<Rpm> speedRivals;
  int teeth = 0;  // 0: not known, or no speed was given
  std::vector<int> teethRivals;
};

struct GuessRequest {
  Hertz rate{};
  std::vector<int> channels;  // of the store, that are vibration
  Rpm told{};                 // 0: no speed was given
  Rpm heard{};                // by the detector; 0: nothing was found. Looked at where none was given
};

SignalGuess guessFromSignal(const SampleStore& samples, const GuessRequest& request,
                            const std::function<bool()>& goOn = {});

}  // namespace stillcut::evaluate
