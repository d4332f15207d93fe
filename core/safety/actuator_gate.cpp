#include "core/safety/actuator_gate.h"

#include <algorithm>
#include <cmath>

namespace stillcut::safety {

std::string_view actuatorReleaseText(ActuatorRelease why) {
  switch (why) {
    case ActuatorRelease::None:
      return "";
    case ActuatorRelease::Asked:
      return "released";
    case ActuatorRelease::LeaseOver:
      return "nobody renewed the lease";
    case ActuatorRelease::NotFinite:
      return "a value was not finite";
    case ActuatorRelease::Diverging:
      return "the loop diverged";
    case ActuatorRelease::Saturated:
      return "the actuator was at its end and the vibration grew";
    case ActuatorRelease::Worse:
      return "control made the vibration worse";
    case ActuatorRelease::DeadSensor:
      return "the error sensor stands still";
  }
  return "";
}

Status ActuatorGate::prepare(const ActuatorLimits& limits, Hertz rate) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0.0; };
  if (!positive(limits.amplitude)) return Error{"actuator", "the amplitude limit must be above zero", ""};
  if (!positive(limits.slew)) return Error{"actuator", "the slew limit must be above zero", ""};
  if (!positive(rate.value)) return Error{"actuator", "the sample rate must be above zero", ""};
  if (!positive(limits.lease.value) || limits.lease.value > 1.0) {
    return Error{"actuator", "the lease must be above zero and at most one second", ""};
  }
  for (const Seconds ramp : {limits.rampIn, limits.rampOut}) {
    if (!positive(ramp.value) || ramp.value > 10.0) {
      return Error{"actuator", "ramps must be above zero and at most ten seconds", ""};
    }
  }
  limits_ = limits;
  watch_.prepare(rate, limits.amplitude);
  perSample_ = limits.slew / rate.value;
  inStep_ = 1.0 / std::max(1.0, limits.rampIn.value * rate.value);
  outStep_ = 1.0 / std::max(1.0, std::floor(limits.rampOut.value * rate.value));
  leaseSamples_ = std::llround(limits.lease.value * rate.value);
  sinceRenewal_ = 0;
  ramp_ = last_ = held_ = 0.0;
  limited_ = false;
  state_ = ActuatorState::Off;
  why_ = ActuatorRelease::None;
  limitedSamples_ = 0;
  strokeUsed_ = 0.0;
  return Done{};
}

// What other threads asked for, and the lease.
void ActuatorGate::listen() STILLCUT_RT {
  const std::uint64_t renewals = renewals_.load();
  sinceRenewal_ = renewals != seenRenewals_ ? 0 : std::min(sinceRenewal_ + 1, leaseSamples_);
  seenRenewals_ = renewals;
  const bool stop = releaseAsked_.exchange(false);
  const bool start = engageAsked_.exchange(false);
  const bool open = state_ == ActuatorState::RampIn || state_ == ActuatorState::On;
  if (open && stop) letGo(ActuatorRelease::Asked);
  if (open && !stop && sinceRenewal_ >= leaseSamples_) letGo(ActuatorRelease::LeaseOver);
  if (!open && start && !stop && state_ == ActuatorState::Off) {
    watch_.reset();
    sinceRenewal_ = 0;
    ramp_ = 0.0;
    why_ = ActuatorRelease::None;
    state_ = ActuatorState::RampIn;
  }
}

void ActuatorGate::letGo(ActuatorRelease why) STILLCUT_RT {
  held_ = last_;
  ramp_ = 1.0;
  why_ = why;
  state_ = ActuatorState::RampOut;
}

double ActuatorGate::shaped(double wanted) STILLCUT_RT {
  ramp_ = std::min(1.0, ramp_ + inStep_);
  if (ramp_ >= 1.0 && state_ == ActuatorState::RampIn) state_ = ActuatorState::On;
  const double inside = std::clamp(ramp_ * wanted, -limits_.amplitude, limits_.amplitude);
  const double output = std::clamp(inside, last_ - perSample_, last_ + perSample_);
  limited_ = output != ramp_ * wanted;
  return output;
}

double ActuatorGate::ramped() STILLCUT_RT {
  ramp_ = std::max(0.0, ramp_ - outStep_);
  if (ramp_ < 0.5 * outStep_) {
    ramp_ = 0.0;
    state_ = ActuatorState::Off;
  }
  return held_ * ramp_;
}

ActuatorCommand ActuatorGate::pass(double wanted, double error, double without) STILLCUT_RT {
  listen();
  limited_ = false;
  double output = 0.0;
  const bool open = state_ == ActuatorState::RampIn || state_ == ActuatorState::On;
  if (open && (!std::isfinite(wanted) || !std::isfinite(error))) letGo(ActuatorRelease::NotFinite);
  if (state_ == ActuatorState::RampIn || state_ == ActuatorState::On) {
    output = shaped(wanted);
    switch (watch_.watch(error, without, output, limited_)) {
      case LoopHealth::Fine:
        break;
      case LoopHealth::Diverging:
        letGo(ActuatorRelease::Diverging);
        break;
      case LoopHealth::Saturated:
        letGo(ActuatorRelease::Saturated);
        break;
      case LoopHealth::Worse:
        letGo(ActuatorRelease::Worse);
        break;
      case LoopHealth::DeadSensor:
        letGo(ActuatorRelease::DeadSensor);
        break;
    }
  }
  if (state_ == ActuatorState::RampOut) output = ramped();
  if (!std::isfinite(output)) output = 0.0;  // last, whatever happened above
  last_ = output;
  if (limited_) limitedSamples_.fetch_add(1);
  strokeUsed_ = std::max(strokeUsed_.load(), std::abs(output) / limits_.amplitude);
  return ActuatorCommand(output);
}

}  // namespace stillcut::safety
