// ReleaseBudget: the time a link may take on its ways home, bounded in all: release(), close() and the destructor share
// it, so that a peer that hangs holds the program's end once and not three times. Commands and good answers give it
// anew. Thread: link thread. Real-time safe but for what the rounds do.
#pragma once

#include <algorithm>

#include "core/base/time.h"

namespace stillcut::cnc {

class ReleaseBudget {
 public:
  ReleaseBudget(const Clock& clock, Duration whole) : clock_(clock), whole_(whole), left_(whole) {}

  void anew() noexcept { left_ = whole_; }
  // Nobody answers: nothing more is tried.
  void giveUp() noexcept { left_ = Duration::zero(); }
  // Rounds until `done()` or the time is over. Timed and counted, a `step` each at least: neither a slow round nor a
  // clock that stands still may hold the program's end.
  template <class Done, class Round>
  void run(Instant now, Duration step, Done&& done, Round&& round) noexcept {
    while (left_ > Duration::zero() && !done()) {
      const Instant began = clock_.now();
      round(now);
      left_ -= std::max(step, Duration(clock_.now() - began));
      now = std::max(now, clock_.now());
    }
  }

 private:
  const Clock& clock_;
  Duration whole_, left_;
};

}  // namespace stillcut::cnc
