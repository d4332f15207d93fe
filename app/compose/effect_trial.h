// EffectTrial: how long an order takes to act on a real machine. It moves both overrides to 95 % and back, as often as
// it takes, through a gate of its own and the lease of every command: only for somebody who has asked for it, with a
// program running in air. The programmed values are back when it returns. Thread: one that may wait, for half a minute
// at most, and no longer than until it is to end.
#pragma once

#include <functional>
#include <string>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/cnc/cnc_link.h"

namespace stillcut::app {

struct EffectTrial {
  Seconds effect{};     // median, from an order to overrides that show it; 0: none was seen
  int moves = 0;        // that were seen to arrive
  std::string problem;  // why there were no more; empty: all arrived
};

// The link has been tried and is closed or open. `clock`: as the link was made with. `toEnd`: asked in every tick.
EffectTrial measureEffect(cnc::CncLink& link, const Clock& clock, const std::function<bool()>& toEnd);

}  // namespace stillcut::app
