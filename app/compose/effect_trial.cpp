#include "app/compose/effect_trial.h"

#include <cmath>
#include <optional>

#include "core/pipeline/link_runner.h"
#include "core/rt/wakeup.h"
#include "core/safety/override_gate.h"

namespace stillcut::app {
namespace {

constexpr double kShare = 0.95;
constexpr int kMoves = 6;
constexpr Seconds kTick{0.005};
constexpr Duration kLongestMove = std::chrono::seconds(6);
constexpr Duration kStay = std::chrono::milliseconds(500);
constexpr double kNear = 0.006;  // overrides are whole per cents

// The gate, the lease and the link as in a run; in the place of detector and strategy the request to move.
class Mover {
 public:
  Mover(cnc::CncLink& link, const Clock& clock) : clock_(clock), runner_(link, commands_, states_) {
    safety::GateLimits limits;
    limits.autoAllowed = true;
    limits.filter = Seconds(0.0);
    limits.interventions.most = kMoves + 1;  // no cut is here, nor an alarm that a move could end
    limits.machineAge = safety::staleAfter(link.describe().period, kTick);
    gate_.prepare(limits);
    last_ = clock.now();
  }

  void turn(double share) {
    never_.waitFor(kTick);  // only its time-out is used
    const Instant now = clock_.now();
    runner_.tick(now);
    if (const auto state = states_.latest()) machine_ = *state;
    safety::GateInput in;
    in.now = now;
    in.dt = secondsBetween(last_, now);
    last_ = now;
    in.machine = machine_;
    in.verdict.time = in.request.time = now;
    in.verdict.valid = true;
    in.verdict.state = CutState::Chatter;  // what a gate moves for
    in.verdict.phase = CutPhase::Steady;
    in.request.kind = RequestKind::Set;
    in.request.claimsSpeed = in.request.claimsFeed = true;
    in.request.speed = machine_.programmedSpeed * machine_.operatorSpeed.value * share;
    in.request.feed = machine_.programmedFeed * machine_.operatorFeed.value * share;
    const OperatorInput take{OperatorAction::SetAuthority, Authority::Auto};
    if (gate_.authority() != Authority::Auto) in.inputs = {&take, 1};
    const safety::GateOutput out = gate_.step(in);
    reason_ = out.reason;
    if (out.command) commands_.post(*out.command);
  }
  bool shows(double share) const {
    const MachineState& m = machine_;
    return m.valid && std::abs(m.speedOverride / m.operatorSpeed - share) < kNear &&
           std::abs(m.feedOverride / m.operatorFeed - share) < kNear;
  }
  void end() { runner_.finish(); }
  Seconds effect() const { return machine_.link.effect; }
  std::string why() const { return sentence(reason_); }

 private:
  const Clock& clock_;
  rt::Mailbox<OverrideCommand> commands_;
  rt::Mailbox<MachineState> states_;
  pipeline::LinkRunner runner_;
  safety::OverrideGate gate_;
  rt::Wakeup never_;
  MachineState machine_;
  Reason reason_;
  Instant last_{};
};

}  // namespace

EffectTrial measureEffect(cnc::CncLink& link, const Clock& clock, const std::function<bool()>& toEnd) {
  EffectTrial trial;
  Mover mover(link, clock);
  for (; trial.moves < kMoves && !toEnd(); ++trial.moves) {
    const double share = trial.moves % 2 == 0 ? kShare : 1.0;
    const Instant began = clock.now();
    while (!mover.shows(share) && clock.now() - began < kLongestMove && !toEnd()) mover.turn(share);
    if (!mover.shows(share)) {
      trial.problem = mover.why();
      break;
    }
    for (const Instant there = clock.now(); clock.now() - there < kStay && !toEnd();) mover.turn(share);
  }
  if (toEnd()) trial.problem = "interrupted";
  trial.effect = mover.effect();
  mover.end();
  return trial;
}

}  // namespace stillcut::app
