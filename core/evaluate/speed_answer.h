// SpeedAnswer: what to do about chatter that was found: which speeds, which depth, or why neither can be said.
// Thread: any; not the sample path.
#pragma once

#include "core/control/speed_choices.h"

namespace stillcut::evaluate {

struct SpeedRequest {
  control::SpeedQuestion question;
  Metres depthLimit{};  // of the present speed, by the lobes; 0: not known
};

// A reach without an upper end means that none was given: half to twice the present speed then.
SpeedAnswer answerSpeed(const SpeedRequest& request);

}  // namespace stillcut::evaluate
