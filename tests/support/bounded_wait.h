// Waiting for a real peer: looks every few milliseconds, and no longer than told.
#pragma once

#include <poll.h>

#include "core/base/time.h"

namespace stillcut::cnc::testing {

// True as soon as `done()` is; false after `atMost`.
template <class Done>
bool within(Seconds atMost, Done&& done) {
  static const SteadyClock clock;
  const Instant end = clock.now() + toDuration(atMost);
  while (!done()) {
    if (clock.now() >= end) return false;
    ::poll(nullptr, 0, 2);
  }
  return true;
}

}  // namespace stillcut::cnc::testing
