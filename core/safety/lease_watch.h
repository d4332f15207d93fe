// LeaseWatch: the link thread's own judge of whether a command may be obeyed and for how long. It trusts nothing but
// the link thread's clock and the moment a command arrived there, so it works when the worker stalls or dies, and when
// the link thread itself stood still. Whatever it cannot judge ends in Release: it does not fail open. Thread: link
// thread only. Real-time safe, no allocation.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/realtime.h"
#include "core/model/override_command.h"

namespace stillcut::safety {

enum class LinkAction {
  Nothing,  // what is in force stays
  Apply,    // send the newest command to the machine
  Release,  // bring the programmed values back, now
};

class LeaseWatch {
 public:
  // Each cycle of the link thread, with the newest command in the mailbox (null: none yet) and its own clock.
  LinkAction poll(const OverrideCommand* newest, Instant now) STILLCUT_RT {
    const bool first = !polled_;
    // The clock went back, or nobody polled for longer than the command's own lease: it may have run out unseen.
    const Duration gap = now - lastPoll_;
    const auto tooLong = [&](const Duration& lease) { return first || gap < Duration::zero() || gap > lease; };
    polled_ = true;
    lastPoll_ = now;

    const bool expired = inForce_ && (tooLong(lease_) || now - renewedAt_ >= lease_);
    if (expired) expire();
    const bool fresh = newest != nullptr && newest->sequence() > lastSequence_;
    if (fresh) lastSequence_ = newest->sequence();
    if (expired) return LinkAction::Release;
    if (!fresh) return LinkAction::Nothing;
    if (newest->kind() != CommandKind::Set) {
      inForce_ = false;
      return LinkAction::Release;
    }
    return tooLong(newest->lease()) ? LinkAction::Nothing : grant(*newest, now);
  }

  bool inForce() const STILLCUT_RT { return inForce_; }
  // The newest engagement that was let go of against the gate's will, for MachineState::endedEngagement; 0: none.
  std::uint64_t endedEngagement() const STILLCUT_RT { return endedEngagement_; }
  // Leases that ran out since the start.
  std::uint64_t expiries() const STILLCUT_RT { return expiries_; }

 private:
  static constexpr Duration kLongestLease = std::chrono::seconds(2);

  LinkAction grant(const OverrideCommand& command, Instant now) STILLCUT_RT {
    const bool sane = command.lease() > Duration::zero() && command.lease() <= kLongestLease &&
                      isFinite(command.speed()) && isFinite(command.feed());
    // A worker that slept through its lease may not jump back to where it was: that engagement is over.
    const bool over = command.engagement() <= endedEngagement_;
    if (!sane || over) {
      const bool had = inForce_;
      inForce_ = false;
      if (had) endedEngagement_ = std::max(endedEngagement_, engagement_);
      return had ? LinkAction::Release : LinkAction::Nothing;
    }
    inForce_ = true;
    renewedAt_ = now;
    lease_ = command.lease();
    engagement_ = command.engagement();
    return LinkAction::Apply;
  }
  void expire() STILLCUT_RT {
    inForce_ = false;
    endedEngagement_ = std::max(endedEngagement_, engagement_);
    ++expiries_;
  }

  bool polled_ = false;
  bool inForce_ = false;
  Instant lastPoll_{};
  Instant renewedAt_{};
  Duration lease_{};
  std::uint64_t lastSequence_ = 0;
  std::uint64_t engagement_ = 0;
  std::uint64_t endedEngagement_ = 0;  // a Set of this number or below is never obeyed again
  std::uint64_t expiries_ = 0;
};

}  // namespace stillcut::safety
