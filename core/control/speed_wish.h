// The wishes that every rule of speeds puts together alike: a speed with the feed that follows it, and what it asks for
// where nothing can be decided. Thread: worker; pure and real-time.
#pragma once

#include "core/control/plain_reasons.h"
#include "core/control/strategy.h"
#include "core/control/target_speed.h"

namespace stillcut::control {

// Nothing can be decided now. `target`: what is asked for already, and stays in force; 0: nothing.
inline OverrideRequest keepOrNothing(const StrategyInput& input, Rpm target) noexcept {
  OverrideRequest keep;
  keep.time = input.now;
  keep.kind = target.value > 0.0 ? RequestKind::Hold : RequestKind::None;
  keep.reason = nothingUsable(target, input.machine);
  return keep;
}

// `target` 0: nothing is asked for, and only the reason is said.
inline OverrideRequest speedWish(const StrategyInput& input, Rpm target, const Reason& reason) noexcept {
  OverrideRequest wish;
  wish.time = input.now;
  wish.claimsSpeed = true;
  wish.claimsFeed = true;
  wish.reason = reason.code == ReasonCode::NothingToDoAt ? nothingToDoAt(input) : finite(reason);
  if (target.value <= 0.0) return wish;
  wish.kind = RequestKind::Set;
  wish.speed = target;
  wish.feed = feedFollowing(target, input.machine);
  return wish;
}

}  // namespace stillcut::control
