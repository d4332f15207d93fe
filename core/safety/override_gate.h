// OverrideGate: the one door to the machine (house rule 3). It alone can construct an OverrideCommand, and there is no
// way to switch it off: a wish that it does not understand, or that it gets from a machine state it cannot trust, is
// held, and then the programmed values come back.
//
// Its one state and what may follow what: gate_state.h, the first page to read; step() in the source is the second.
//
// Each step: time, operator, checks of everything that came in; then either hold-then-release, or the wish trimmed to
// the limits, counted as a change, low-passed, rate-limited, ordered (speed rises before feed, feed falls before
// speed), and checked for being finite last. While a Set is in force it is issued anew each step: that is what renews
// its lease.
//
// Letting go: while machine and link are well the factors travel back to 100 % by the same rates and in the same order,
// whoever or whatever ended them, and the Release comes last. It comes at once only where nothing can be steered any
// more (link gone, state stale, overrides locked, reset or not taken, time that jumped, a lease that has run out).
//
// Moves that were made for an alarm are judged by what came of them (intervention_judge.h): a louder cut is taken back,
// and after two moves in a row that did not help Auto becomes Advise and the programmed values come back.
//
// Every fault, refusal and change of authority leaves an event and a flight, also with nothing in force, unless
// authority is Off: then only what concerns the link.
// Thread: prepare() at set-up, step() on the worker, once per block, real-time.
#pragma once

#include "core/safety/gate_io.h"
#include "core/safety/gate_limits.h"
#include "core/safety/gate_state.h"
#include "core/safety/intervention_judge.h"
#include "core/safety/machine_watch.h"
#include "core/safety/override_ramp.h"
#include "core/safety/override_setpoint.h"
#include "core/safety/pending_advice.h"
#include "core/safety/said_once.h"
#include "core/safety/step_clock.h"

namespace stillcut::safety {

class OverrideGate {
 public:
  // Authority is Off afterwards. What was in force is released by the next step. May allocate nothing and never throws:
  // limits come checked from gateLimits().
  void prepare(const GateLimits& limits);

  GateOutput step(const GateInput& in) STILLCUT_RT;

  // As step() said last.
  Authority authority() const STILLCUT_RT { return authority_; }
  bool commanding() const STILLCUT_RT { return commands(state_); }

 private:
  struct TrimmedRequest {
    Factors factors;
    Reason limited;  // GateLimited when it had to be trimmed, else None
  };
  enum class Freeze { No, Operator, FeedHold, Knob, OldSamples };

  void enter(GateCause cause) STILLCUT_RT { state_ = after(state_, cause); }
  // By somebody's wish, and not on the way home.
  bool steering() const STILLCUT_RT { return state_ == GateState::Engaged || state_ == GateState::Returning; }
  void passTime(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void endWhatCannotGoOn(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void obeyOperator(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void setAuthority(Authority wanted, Instant now, GateOutput& out) STILLCUT_RT;
  void stay() STILLCUT_RT;
  void releaseWhatWasLeft() STILLCUT_RT;
  void acceptAdvice(std::uint32_t number, Instant now, GateOutput& out) STILLCUT_RT;
  void refuseAdvice(Instant now, GateOutput& out) STILLCUT_RT;
  void watchLink(const GateInput& in, GateOutput& out) STILLCUT_RT;
  Reason findTrouble(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void reportFault(const Reason& trouble, const GateInput& in, GateOutput& out) STILLCUT_RT;
  void holdThenRelease(const Reason& trouble, const GateInput& in, GateOutput& out) STILLCUT_RT;

  void act(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void endOldAcceptance(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void tryToTake(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void steer(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void retarget(const GateInput& in, GateOutput& out) STILLCUT_RT;
  bool follow(const Factors& wanted, bool accepted, const GateInput& in, GateOutput& out) STILLCUT_RT;
  void move(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void refuseChange(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void refuseBeyondLimits(const Reason& limited, const GateInput& in, GateOutput& out) STILLCUT_RT;
  RampInput rampInput(const MachineState& machine) const STILLCUT_RT;

  TrimmedRequest trimmed(const OverrideRequest& request, const MachineState& machine) const STILLCUT_RT;
  Reason notReady(const GateInput& in) const STILLCUT_RT;
  Freeze frozen(const GateInput& in) const STILLCUT_RT;
  Reason inForce(const MachineState& machine) const STILLCUT_RT;

  InterventionStep heard(const GateInput& in) const STILLCUT_RT;
  void judgeMove(const GateInput& in, GateOutput& out) STILLCUT_RT;
  void take(Outcome outcome, Instant now, GateOutput& out) STILLCUT_RT;
  void beginMove(const Factors& before, const GateInput& in, GateOutput& out) STILLCUT_RT;
  void undoMove() STILLCUT_RT;
  void countFault(Instant now, GateOutput& out) STILLCUT_RT;
  void withdrawAuto(Instant now, GateOutput& out) STILLCUT_RT;
  bool triedLouder(const Factors& wanted) const STILLCUT_RT;

  // By the ramp, over the next steps; at once where nothing is in force.
  void relinquish(const Reason& why, EventLevel level, Instant now, GateOutput& out) STILLCUT_RT;
  void goHome(const GateInput& in, GateOutput& out) STILLCUT_RT;
  // At once.
  void drop(const Reason& why, EventLevel level, Instant now, GateOutput& out) STILLCUT_RT;
  void forget() STILLCUT_RT;
  void issue(const GateInput& in, GateOutput& out) STILLCUT_RT;
  // Event and flight.
  void report(GateOutput& out, Instant now, EventLevel level, const Reason& reason) const STILLCUT_RT;
  static void keepFlight(GateOutput& out, const Reason& cause) STILLCUT_RT;
  void say(GateOutput& out, Instant now, EventLevel level, const Reason& reason) const STILLCUT_RT;

  GateLimits limits_;
  OverrideRamp ramp_;
  OverrideSetpoint setpoint_;
  MachineWatch watch_;
  PendingAdvice pendingAdvice_;
  InterventionJudge judge_;
  std::optional<Factors> louder_;  // that the cut was louder at: not asked for again under this authority
  Rpm judgedFor_{};                // what the move in hand is after

  GateState state_ = GateState::Idle;
  StepClock clock_;
  SaidOnce said_;

  Authority authority_ = Authority::Off;
  Instant authoritySince_{};
  bool operatorHold_ = false;
  bool strategyFailed_ = false;  // for good: there is nobody whose wishes to follow

  Reason dropReason_;  // why it gives up, or has let go
  std::uint64_t sequence_ = 0;
  std::uint64_t engagement_ = 0;

  double badTime_ = 0.0;   // [s] of bad input, running down again while it is good
  double restLeft_ = 0.0;  // [s] until the overrides may be taken again
  double stuck_ = 0.0;     // [s] letting go without getting any further
};

}  // namespace stillcut::safety
