#include "core/control/standing_advice.h"

#include <cmath>

#include "core/control/machine_readings.h"

namespace stillcut::control {
namespace {

constexpr double kAlike = 0.02;      // of the speed: the same place on the lobe, for the operator as for the eye
constexpr double kStableFor = 10.0;  // [s] of a cut that needs no other speed
constexpr double kThere = 0.01;      // the spindle has the advised speed

// Which of a reason's numbers is the chatter frequency; -1: none.
int chatterIndex(ReasonCode code) {
  switch (code) {
    case ReasonCode::KeepingSpeed:
    case ReasonCode::AlreadyThere:
    case ReasonCode::TowardLowerLevel:
    case ReasonCode::NoStableSpeedTried:
      return 1;
    case ReasonCode::CentreOfNextPocket:
    case ReasonCode::QuarterWave:
      return 2;
    case ReasonCode::TargetOutOfRange:
    case ReasonCode::NextPocketInRange:
    case ReasonCode::PocketByLobes:
    case ReasonCode::NoStableSpeed:
      return 3;
    default:
      return -1;
  }
}

Hertz chatterOf(const Reason& reason) {
  const int at = chatterIndex(reason.code);
  return at < 0 ? Hertz() : Hertz(reason.n[static_cast<std::size_t>(at)]);
}

SpeedAdvice adviceFrom(const OverrideRequest& asked, const MachineState& m) {
  SpeedAdvice advice;
  advice.base = m.programmedSpeed * m.operatorSpeed.value;
  advice.baseFeed = m.programmedFeed * m.operatorFeed.value;
  advice.reason = asked.reason;
  advice.chatter = chatterOf(asked.reason);
  const auto& n = asked.reason.n;
  if (asked.kind == RequestKind::Set && asked.claimsSpeed && positive(asked.speed.value)) {
    advice.kind = SpeedAdvice::Kind::Speed;
    advice.speed = asked.speed;
    advice.feed = asked.claimsFeed ? asked.feed : advice.baseFeed;
  } else if (asked.reason.code == ReasonCode::TargetOutOfRange && positive(n[0])) {
    advice.kind = SpeedAdvice::Kind::OutOfReach;
    advice.speed = Rpm(n[0]);
    if (advice.base.value > 0.0) advice.feed = advice.baseFeed * (advice.speed / advice.base);
  } else if (asked.reason.code == ReasonCode::NoStableSpeed) {
    advice.kind = SpeedAdvice::Kind::LessDepth;
    advice.depth = Metres(1e-3 * n[1]);
    advice.speed = Rpm(n[2]);
  } else if (asked.reason.code == ReasonCode::NoStableSpeedTried) {
    advice.kind = SpeedAdvice::Kind::LessDepth;
  }
  return advice;
}

bool alike(const SpeedAdvice& a, const SpeedAdvice& b) {
  return a.kind == b.kind && std::abs((a.speed - b.speed).value) <= kAlike * b.speed.value;
}

}  // namespace

MachineState machineAsSetUp(const CutSetup& setup, Hertz spindle, Instant now) {
  MachineState m;
  if (!positive(setup.nominalSpeed.value)) return m;
  m.time = now;
  m.valid = m.linkUp = m.programRunning = m.atSpeed = true;
  m.programmedSpeed = setup.nominalSpeed;
  m.programmedFeed = m.actualFeed = setup.nominalFeed;
  m.actualSpeed = positive(spindle.value) ? toRpm(spindle) : setup.nominalSpeed;
  m.speedOverride = Ratio(m.actualSpeed / m.programmedSpeed);
  return m;
}

bool neverRead(const MachineState& machine) {
  return !machine.valid && !machine.linkUp && machine.time == Instant{};
}

void StandingAdvice::prepare(const CutSetup& setup, const config::ParamSet& params, std::string_view strategy) {
  monitors_ = strategy == "monitor";
  if (monitors_) own_.prepare(setup, params);
  reset();
}

void StandingAdvice::retune(const config::ParamSet& params) {
  if (monitors_) own_.retune(params);
}

void StandingAdvice::reset() {
  if (monitors_) own_.reset();
  advice_ = {};
  programmed_ = {};
  stable_ = 0.0;
  expired_ = false;
}

const SpeedAdvice& StandingAdvice::look(const StrategyInput& input, const OverrideRequest& asked) {
  const MachineState& m = input.machine;
  if (!usable(m)) return advice_;
  if (programmedSpeedChanged(m, programmed_)) {
    advice_ = {};
    programmed_ = m.programmedSpeed;
  }
  watchCut(input);
  const SpeedAdvice next = adviceFrom(monitors_ ? own_.decide(input) : asked, m);
  if (next.kind != SpeedAdvice::Kind::None && !expired_) put(next);
  return advice_;
}

void StandingAdvice::watchCut(const StrategyInput& input) {
  const Verdict& v = input.verdict;
  if (v.alarming()) {
    stable_ = 0.0;
    expired_ = false;
    return;
  }
  const double off = std::abs((actualOrCommandedSpeed(input.machine) - advice_.speed).value);
  const bool there = advice_.kind == SpeedAdvice::Kind::Speed && off <= kThere * advice_.speed.value;
  if (!v.valid || v.state != CutState::Stable || v.phase != CutPhase::Steady || there) return;
  stable_ += input.dt.value;
  if (stable_ < kStableFor) return;
  advice_ = {};
  expired_ = true;
}

void StandingAdvice::put(const SpeedAdvice& next) {
  if (alike(next, advice_)) return;
  advice_ = next;
  stable_ = 0.0;
}

const SpeedAdvice& StandingAdvice::take(const OverrideRequest& pending, const MachineState& machine) {
  SpeedAdvice next = adviceFrom(pending, machine);
  if (pending.kind == RequestKind::Release) {
    next.kind = SpeedAdvice::Kind::ToProgrammed;
    next.speed = pending.speed;
    next.feed = pending.feed;
  }
  if (next.kind == SpeedAdvice::Kind::None) return advice_;
  advice_ = next;
  return advice_;
}

}  // namespace stillcut::control
