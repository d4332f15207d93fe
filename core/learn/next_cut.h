// The next most useful cut: which speed and depth, within what the user allows, would raise the removal rate most once
// its outcome is known (value of information: Karandikar and Schmitz, 2014), and what it would tell.
// Thread: one; some 100 ms. Allocates.
#pragma once

#include <vector>

#include "core/learn/lobe_posterior.h"
#include "core/learn/stability_map.h"

namespace stillcut::learn {

// What the user allows and wants.
struct TrialLimits {
  milling::Engagement engagement;
  int teeth = 2;
  Rpm lowest{}, highest{};
  Metres deepest{};
  double risk = 0.1;         // of chatter that the advice may carry
  double mostChatter = 0.6;  // probability of chatter that a trial cut may have
  int cutsLeft = 1;          // of a series, this one included: a longer one explores more
};

struct NextCut {
  Rpm speed{};
  Metres depth{};
  double probabilityStable = 0.0;
  double bits = 0.0;             // expected information of verdict and frequency
  double removalNow = 0.0;       // of the best cut at the risk, as of now [m rev/min]
  double removalExpected = 0.0;  // of the best cut once the outcome is known, in the mean
  LearnedAdvice now;             // the best cut as of now
  LearnedAdvice ifStable;        // and with either outcome
  LearnedAdvice ifChatter;       // over the chatter frequencies that may be met: the most probable one
};

// Error: limits that are none.
Result<NextCut> nextCut(LobePosterior& posterior, const TrialLimits& limits);

}  // namespace stillcut::learn
