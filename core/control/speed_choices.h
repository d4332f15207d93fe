// Speed choices: which spindle speeds are worth trying against chatter of a known frequency, for whoever advises a
// person after the cut. The same rule as the strategies follow (target_speed.h): a pocket lies where whole waves of the
// chatter fit between two teeth, n = 60 f_c / (p Z) (van Dijk 2010 eq. 29, 30). By the work that the regeneration does
// in one wave (Liao 1996 eq. 3, 8) a cut gains from p - 1/2 to p waves and loses from p to p + 1/2: a speed with a
// wave fraction above one half may go down to p or up to p - 1/2. Where lobes are known they decide.
// Thread: any; allocates, not for the sample path.
#pragma once

#include <vector>

#include "core/config/override_limits.h"
#include "core/model/cut_setup.h"
#include "core/model/recording_answer.h"

namespace stillcut::control {

struct SpeedQuestion {
  Hertz chatter{};
  int teeth = 0;
  Rpm present{};                        // at which it chatters
  config::SpeedRange reach;             // that the machine and the tool allow
  const StableSpeeds* known = nullptr;  // by the lobes, at the depth of the cut; null: not known
};

// Nearest to the present speed first, none that is the present one, at most four. Empty where chatter, teeth or speed
// are not known, where nothing is in reach, and where the lobes know of no stable speed.
std::vector<SpeedChoice> speedChoices(const SpeedQuestion& question);

}  // namespace stillcut::control
