// LinkRunner: hop 6, everything the link thread does in one tick: take the newest command, check its lease, send it,
// read the machine back, and measure how long orders take to act. The lease is measured on the link thread's own clock,
// so that a worker that stalls or dies cannot keep an override in force. Thread: link thread only (or the one thread of
// a deterministic run).
#pragma once

#include <atomic>
#include <cstdint>

#include "core/base/time.h"
#include "core/cnc/cnc_link.h"
#include "core/cnc/effect_gauge.h"
#include "core/model/machine_state.h"
#include "core/model/override_command.h"
#include "core/rt/mailbox.h"
#include "core/safety/lease_watch.h"
#include "core/safety/release_watch.h"

namespace stillcut::pipeline {

// Of the link thread itself, for the screen: a machine that is silent and a thread of ours that stands still look the
// same from the worker.
struct LinkTally {
  std::uint64_t leasesExpired = 0;
  std::uint64_t stalls = 0;  // ticks that came more than 0.5 s late, and sleeps of the computer
  Instant lastTick{};        // 0: none yet
  bool notYetBack = false;   // released, and not read back yet
};

class LinkRunner {
 public:
  // `effect`: how long an order took to act when it was measured before; 0: never. `boot`: a clock that goes on while
  // the computer sleeps, for leases to run out then as well; null: the clock of tick() is all there is.
  LinkRunner(cnc::CncLink& link, rt::Mailbox<OverrideCommand>& commands, rt::Mailbox<MachineState>& states,
             Seconds effect = {}, const Clock* boot = nullptr)
      : link_(link), commands_(commands), states_(states), boot_(boot), effect_(effect) {}
  // Whatever ends the run, the programmed values come back.
  ~LinkRunner() { finish(); }
  LinkRunner(const LinkRunner&) = delete;
  LinkRunner& operator=(const LinkRunner&) = delete;

  void tick(Instant now) noexcept;
  // Releases if anything is in force, at once and in one step: whoever ends the run has no gate any more that could
  // ramp, and the machine's own acceleration is the ramp. Links keep the order of feed and speed (cnc/move_order.h).
  // Later ticks only read.
  void finish() noexcept;

  // Any thread.
  std::uint64_t leasesExpired() const { return leasesExpired_.load(std::memory_order_relaxed); }
  LinkTally tally() const {
    return {leasesExpired(), stalls_.load(std::memory_order_relaxed),
            instantFromNs(lastTick_ns_.load(std::memory_order_relaxed)), notYetBack_.load(std::memory_order_relaxed)};
  }

 private:
  void watchTime(Instant now) noexcept;
  void measure(MachineState& state) noexcept;

  cnc::CncLink& link_;
  rt::Mailbox<OverrideCommand>& commands_;
  rt::Mailbox<MachineState>& states_;
  const Clock* boot_;
  safety::LeaseWatch lease_;
  safety::ReleaseWatch released_;
  cnc::EffectGauge effect_;
  Instant lastTick_{};
  bool ticked_ = false;
  Duration ahead_{};   // the boot clock, of ours
  Duration asleep_{};  // so long in all
  bool finished_ = false;
  std::atomic<std::uint64_t> stalls_{0};
  std::atomic<std::int64_t> lastTick_ns_{0};
  std::atomic<std::uint64_t> leasesExpired_{0};
  std::atomic<bool> notYetBack_{false};
};

}  // namespace stillcut::pipeline
