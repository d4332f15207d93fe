// OverrideRequest: what a strategy asks for, in absolute values, with its reason. Not a command: only the gate can
// make a command of it. Plain values: any thread.
#pragma once

#include <cstdint>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/model/reason.h"

namespace stillcut {

enum class RequestKind : std::uint8_t {
  None,     // nothing to change: keep what is in force
  Set,      // go to `speed` and `feed`
  Hold,     // stay exactly where we are
  Release,  // go back to the programmed values
};

struct OverrideRequest {
  Instant time{};
  RequestKind kind = RequestKind::None;
  bool claimsSpeed = false;  // which overrides this strategy drives
  bool claimsFeed = false;
  Rpm speed{};             // wanted spindle speed, when Set and claimsSpeed
  MetresPerSecond feed{};  // wanted feed, when Set and claimsFeed
  Reason reason;
};

}  // namespace stillcut
