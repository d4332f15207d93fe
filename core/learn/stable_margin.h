// How far a stable cut is from chatter: every guessed machine foretells how fast the free vibration decays at this
// speed and depth; those that foretell what was measured say where the limit lies. Silent where they do not agree.
// Thread: one; some 10 ms. Allocates.
#pragma once

#include <optional>

#include "core/learn/free_decay.h"
#include "core/learn/lobe_posterior.h"

namespace stillcut::learn {

struct StableCut {
  milling::Engagement engagement;
  int teeth = 2;
  Rpm speed{};
  Metres depth{};
};

struct StableMargin {
  Metres rise{};         // by which the depth could grow, median
  Metres low{}, high{};  // 10 and 90 %
};

struct MarginAnswer {
  std::optional<StableMargin> margin;
  Message why;  // nothing is said
};

// The free vibration of a guessed machine in a cut that is stable for it, of the pair of multipliers that would leave
// first (zeroth order). Rate 0: it cannot be followed from the limit down to this depth.
FreeDecay foretoldDecay(const Dynamics& machine, const ForceShape& shape, int teeth, Rpm speed, Metres depth,
                        const LimitPoint& limit);

MarginAnswer stableMargin(LobePosterior& posterior, const StableCut& cut, const FreeDecay& measured);

}  // namespace stillcut::learn
