#include "core/control/stable_pocket.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/control/speed_request.h"

namespace stillcut::control {
namespace {

using config::ParamDecl;

constexpr ParamDecl kConfirm = config::realParam("stable-pocket.confirm", "Confirmation", "ms", 50.0, 0.0, 2000.0,
                                                 "How long an alarm stands at one frequency before the first move");
constexpr ParamDecl kConfirmAgain =
    config::realParam("stable-pocket.confirm-again", "Confirmation after a move", "ms", 250.0, 20.0, 5000.0,
                      "How long chatter stands at the new speed before that speed is given up");
constexpr ParamDecl kSettle = config::realParam("stable-pocket.settle", "Settling", "ms", 400.0, 0.0, 10000.0,
                                                "After the spindle has reached a new speed it is judged no sooner");
constexpr ParamDecl kMoves = config::integerParam("stable-pocket.moves", "Speeds to try", 3, 1, 6,
                                                  "After so many speeds without quiet it goes back and advises only");
constexpr ParamDecl kForget = config::realParam("stable-pocket.forget", "Memory of tried speeds", "s", 10.0, 1.0, 600.0,
                                                "After so long without an alarm the tried speeds are forgotten");
constexpr ParamDecl kPause = config::realParam("stable-pocket.pause", "Pause after giving up", "s", 60.0, 5.0, 3600.0,
                                               "So long nothing is tried again after no speed was quiet");
constexpr const ParamDecl* kParams[] = {&kConfirm, &kConfirmAgain, &kSettle, &kMoves, &kForget, &kPause};

constexpr double kAtTarget = 0.01;  // the spindle is there
// Chatter's torque moves the measured speed about by a few percent: more is a move. The mean of so long [s] counts.
constexpr double kShaken = 0.05, kEvenTime = 0.2;
constexpr double kSettleTurns = 15.0;  // on slow machines the decay takes revolutions, not milliseconds
constexpr double kNotMoved = 0.003;    // the spindle has not begun to move
constexpr double kAskAnew = 1.0;       // [s] a request that nobody carries out is made anew
constexpr double kStood = 1.0;         // [s] a spindle that has been this long at one speed is not on its way

bool near(Rpm a, Rpm b, double share) {
  return std::abs((a - b).value) <= share * b.value;
}

}  // namespace

config::ParamTable stablePocketParams() {
  return kParams;
}

StrategyInfo StablePocket::describe() const {
  return {"stable-pocket", "Next stable pocket, checked", "van Dijk 2010, eq. 29 and 30; stability lobes"};
}

void StablePocket::prepare(const CutSetup& setup, const config::ParamSet& params) {
  const auto limits = config::checkOverrideLimits(params, setup, describe().id);
  if (!limits) throw std::runtime_error(limits.error().line());
  limits_ = *limits;
  teeth_ = setup.teeth;
  retune(params);
  confirmation_.forget();
  search_.prepare(setup);
  reset();
}

void StablePocket::retune(const config::ParamSet& params) {
  mostMoves_ = params.integer(kMoves);
  settle_ = Seconds(params.real(kSettle) / 1000.0);
  forget_ = Seconds(params.real(kForget));
  pause_ = Seconds(params.real(kPause));
  confirmation_.configure({Seconds(params.real(kConfirm) / 1000.0), Seconds(params.real(kConfirmAgain) / 1000.0)});
}

void StablePocket::reset() {
  confirmation_.forgetLevels();
  programmed_ = {};
  relinquish();
}

void StablePocket::relinquish() {
  confirmation_.forget();
  search_.forget();
  phase_ = Phase::Watch;
  target_ = from_ = even_ = {};
  movedFor_ = {};
  arrived_ = false;
  heardThere_ = {};
  moves_ = 0;
  inPhase_ = waiting_ = standing_ = quiet_ = 0.0;
  path_ = {};
  reason_ = {ReasonCode::NothingToDoAt, {}};
}

OverrideRequest StablePocket::decide(const StrategyInput& input) {
  const MachineState& m = input.machine;
  const Verdict& v = input.verdict;
  if (target_.value > 0.0 && usable(m)) watchLetGo(v, m, actualOrCommandedSpeed(m));
  if (!usable(m) || !v.valid || !isFinite(v.frequency) || !positive(input.dt.value)) {
    // Chatter that drives the sensor to its limit now and then has not ended each time.
    if (v.valid || v.reason.code != ReasonCode::InputClipped) confirmation_.forget();
    return keepOrNothing(input, target_);
  }
  if (programmedSpeedChanged(m, programmed_)) {
    reset();
    programmed_ = m.programmedSpeed;
  }
  if (teeth_ <= 0) {
    reason_ = teethNotKnown(input);
    return answer(input);
  }
  const bool nothingYet = phase_ == Phase::Watch && moves_ == 0 && !v.alarming();
  if (nothingYet) {
    path_ = {};
  } else if (positive(m.actualFeed.value)) {
    path_ += Metres(m.actualFeed.value * input.dt.value);
  }
  const Rpm present = actualOrCommandedSpeed(m);
  const double dt = input.dt.value;
  even_ = near(even_, present, kShaken) ? even_ + (dt / (dt + kEvenTime)) * (present - even_) : present;
  if (phase_ == Phase::Settle) {
    settle(input, even_);
  } else {
    listen(input);
  }
  return answer(input);
}

// Programmed values in force that nobody here asked for: the gate has released, and would take the same request again.
void StablePocket::watchLetGo(const Verdict& verdict, const MachineState& machine, Rpm present) {
  if (near(present, target_, kAtTarget)) {
    arrived_ = true;
    if (verdict.valid) heardThere_ = verdict.alarming() ? verdict.frequency : Hertz();
    return;
  }
  const Rpm programmed = machine.programmedSpeed * machine.operatorSpeed.value;
  const bool back = near(present, programmed, kAtTarget) && near(machine.targetSpeed(), programmed, kAtTarget);
  if (!arrived_ || !back || near(target_, programmed, 2.0 * kAtTarget) || heardThere_.value <= 0.0) return;
  search_.countAsTried(target_, heardThere_);
  giveUpTarget();
}

void StablePocket::giveUpTarget() {
  target_ = from_ = {};
  phase_ = Phase::Watch;
  confirmation_.forget();
  reason_ = {ReasonCode::NothingToDoAt, {}};
}

void StablePocket::listen(const StrategyInput& input) {
  const double dt = input.dt.value;
  confirmation_.update(input.verdict, input.dt, {toHertz(even_), teeth_, moves_ > 0}, input.vibration);
  quiet_ = input.verdict.alarming() ? 0.0 : quiet_ + dt;
  if (phase_ == Phase::Resigned) {
    inPhase_ += dt;
    if (inPhase_ > pause_.value || quiet_ > forget_.value) {
      const Rpm programmed = programmed_;
      const Metres path = path_;
      reset();
      programmed_ = programmed;
      path_ = path;
    }
    return;
  }
  if (quiet_ > forget_.value) {
    moves_ = 0;
    search_.forget();
  }
  if (confirmation_.confirmed()) {
    choose(input.machine, even_);
  } else if (target_.value > 0.0 && arrived_) {  // asked for is not yet kept: the reason to ask stays
    reason_ = {ReasonCode::KeepingSpeed, {target_.value, movedFor_.value}};
  }
}

// The machine shows the order in force and the spindle no longer moves: what is left is slip, and stays.
bool StablePocket::standsAsOrdered(const StrategyInput& input, Rpm present) {
  const bool ordered = near(input.machine.targetSpeed(), target_, kAtTarget) && !near(present, from_, kNotMoved);
  const bool stands = ordered && near(present, stands_, kAtTarget);
  standing_ = stands ? standing_ + input.dt.value : 0.0;
  if (!stands) stands_ = present;
  return standing_ >= kStood;
}

// The target stands; nothing is judged until the spindle is there and has been for a while. Chatter that shakes the
// spindle off its speed again is no other move.
void StablePocket::settle(const StrategyInput& input, Rpm present) {
  const config::SpeedRange reach = reachableSpeeds(limits_, input.machine);
  if (target_ < reach.low * (1.0 - kAtTarget) || target_ > reach.high * (1.0 + kAtTarget)) {
    giveUpTarget();
    return;
  }
  arrived_ = arrived_ || standsAsOrdered(input, present);
  if (arrived_) {
    inPhase_ += input.dt.value;
    if (inPhase_ < std::max(settle_.value, kSettleTurns / toHertz(present).value)) return;
    phase_ = Phase::Watch;
    quiet_ = 0.0;
    confirmation_.forget();
    reason_ = {ReasonCode::KeepingSpeed, {target_.value, movedFor_.value}};
    return;
  }
  // Nobody carries it out (advice that waits for its answer, a pause of the gate): it is no move yet, and the chatter
  // may have changed meanwhile.
  waiting_ = near(present, from_, kNotMoved) ? waiting_ + input.dt.value : 0.0;
  if (waiting_ < kAskAnew) return;
  waiting_ = 0.0;
  --moves_;
  phase_ = Phase::Watch;
  confirmation_.forget();
}

void StablePocket::choose(const MachineState& m, Rpm present) {
  const config::SpeedRange reach = reachableSpeeds(limits_, m);
  const Hertz chatter = confirmation_.frequency();
  if (moves_ >= mostMoves_) {
    resign(nothingQuiet(chatter));
    return;
  }
  const NextSpeed next = search_.next({chatter, present, reach});
  if (!positive(next.speed.value)) {
    // That one speed is out of reach, or has been tried, is not the whole of it any more.
    resign(moves_ > 0 && next.reason.code != ReasonCode::NoStableSpeed ? nothingQuiet(chatter) : next.reason);
    return;
  }
  ++moves_;
  target_ = next.speed;
  from_ = present;
  movedFor_ = chatter;
  arrived_ = false;
  heardThere_ = {};
  reason_ = next.reason;
  phase_ = Phase::Settle;
  inPhase_ = waiting_ = standing_ = 0.0;
  confirmation_.forget();
}

void StablePocket::resign(const Reason& why) {
  phase_ = Phase::Resigned;
  inPhase_ = 0.0;
  target_ = {};
  reason_ = why;
}

Reason StablePocket::nothingQuiet(Hertz chatter) const {
  return {ReasonCode::NoStableSpeedTried, {static_cast<double>(moves_), chatter.value, 1e3 * path_.value}};
}

OverrideRequest StablePocket::answer(const StrategyInput& input) const {
  OverrideRequest request = speedRequest(input, target_, reason_);
  if (phase_ == Phase::Resigned) request.kind = RequestKind::Release;
  return request;
}

}  // namespace stillcut::control
