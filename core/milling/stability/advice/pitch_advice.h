// Which pitch of the teeth suits a wanted speed: alternating and rising pitches are tried from even ones to where a
// tooth would have little room for its chips, and the one with the largest limit within 2 % of the speed is given.
// What pitch a tool has is decided when it is bought or ground, so it must hold where the speed is a little off.
// Thread: any; a second or two. Allocates.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/cut_model.h"

namespace stillcut::milling {

struct PitchChoice {
  std::vector<double> pitch;  // [rad]; as many as the tool has teeth
  Metres limit{};             // least within 2 % of the speed; as deep as was searched where nothing limits it
};

struct PitchAdvice {
  PitchChoice best, even;
  Metres searched{};  // three times the depth
};

// The tool's own pitch does not count; a helix for each tooth is refused. Needs two teeth or more.
Result<PitchAdvice> advisePitch(const CutModel& model, Rpm speed, Metres depth, const std::string& where,
                                const std::stop_token& stop = {});

}  // namespace stillcut::milling
