// The requests that all rules of speeds put together alike: a speed with the feed that follows it, and what it asks for
// where nothing can be decided. Thread: worker; pure and real-time.
#pragma once

#include "core/control/common_reasons.h"
#include "core/control/strategy.h"
#include "core/control/target_speed.h"

namespace stillcut::control {

// Nothing can be decided now. `target`: what is asked for already, and stays in force; 0: nothing.
inline OverrideRequest keepOrNothing(const StrategyInput& input, Rpm target) {
  OverrideRequest keep;
  keep.time = input.now;
  keep.kind = target.value > 0.0 ? RequestKind::Hold : RequestKind::None;
  keep.reason = nothingUsable(target, input.machine);
  return keep;
}

// `target` 0: nothing is asked for, and only the reason is said.
inline OverrideRequest speedRequest(const StrategyInput& input, Rpm target, const Reason& reason) {
  OverrideRequest request;
  request.time = input.now;
  request.claimsSpeed = true;
  request.claimsFeed = true;
  request.reason = reason.code == ReasonCode::NothingToDoAt ? nothingToDoAt(input) : finite(reason);
  if (target.value <= 0.0) return request;
  request.kind = RequestKind::Set;
  request.speed = target;
  request.feed = feedFollowing(target, input.machine);
  return request;
}

}  // namespace stillcut::control
