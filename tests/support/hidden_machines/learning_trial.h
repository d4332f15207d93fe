// How the learner does on one hidden machine: what it calls 90 % against what is so, its limit against the true one,
// and what a shop gains.
#pragma once

#include <cstdint>
#include <vector>

#include "core/learn/lobe_posterior.h"
#include "core/learn/stability_map.h"
#include "tests/support/hidden_machines/hidden_machine.h"

namespace stillcut::test {

struct LimitScore {
  double error = 0.0;    // median of |ln(learned median / true)| over the speeds where there is a limit
  int called = 0;        // depths called stable with 90 %, one at each speed
  int stable = 0;        // that are
  double removal = 0.0;  // of the advised cut at a risk of 10 %, over the largest that would be stable; 0: it chatters
};

// A guided series of `count` cuts. Gives the number that chattered.
int chooseCuts(learn::LobePosterior& posterior, const HiddenMachine& machine, int count, std::uint64_t seed);

// What a shop removes that stays with the best of its quiet cuts, over the largest that would be stable.
double ownRemoval(const HiddenMachine& machine, const std::vector<learn::CutEvidence>& cuts);

learn::MapRequest workOf(const HiddenMachine& machine);
learn::LearnRange rangeFor(const HiddenMachine& machine);

// Against the machine as it is after `cuts` cuts.
LimitScore scoreOf(learn::LobePosterior& posterior, const HiddenMachine& machine, int cuts, int speeds = 24);

}  // namespace stillcut::test
