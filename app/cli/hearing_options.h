// What commands share that hear a sensor: from a recording of it, or from the device of a profile that is then set
// right.
#pragma once

#include <string>

#include "core/base/result.h"

namespace stillcut::app {

struct HearingOptions {
  std::string recording, profile;  // one of them
  double seconds = 5.0;
  bool save = false;  // in the profile
};

// `heard`: "tone"; `whose`: the machine of the profile.
inline Status checkHearing(const HearingOptions& o, const std::string& command, const std::string& heard,
                           const std::string& whose) {
  if (o.recording.empty() == o.profile.empty()) {
    return Error{command, o.recording.empty() ? "nothing to listen to" : "both a recording and a profile are named",
                 "name a RECORDING of the " + heard + ", or --profile of the machine " + whose};
  }
  if (o.save && o.profile.empty()) return Error{"--save", "needs --profile", "that is where it is saved"};
  if (!(o.seconds >= 2.0 && o.seconds <= 60.0)) return Error{"--seconds", "must be from 2 to 60", ""};
  return Done{};
}

}  // namespace stillcut::app
