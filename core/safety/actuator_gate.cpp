#include "core/safety/actuator_gate.h"

#include <algorithm>
#include <cmath>

namespace stillcut::safety {

Status ActuatorGate::prepare(const ActuatorLimits& limits, Hertz rate) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0.0; };
  if (!positive(limits.amplitude)) return Error{message("actuator"), message("the amplitude limit must be above zero")};
  if (!positive(limits.slew)) return Error{message("actuator"), message("the slew limit must be above zero")};
  if (!positive(rate.value)) return Error{message("actuator"), message("the sample rate must be above zero")};
  if (!positive(limits.lease.value) || limits.lease.value > 1.0) {
    return Error{message("actuator"), message("the lease must be above zero and at most one second")};
  }
  for (const Seconds ramp : {limits.rampIn, limits.rampOut}) {
    if (!positive(ramp.value) || ramp.value > 10.0) {
      return Error{message("actuator"), message("ramps must be above zero and at most ten seconds")};
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
  const std::uint64_t renewals = renewals_.load(std::memory_order_relaxed);
  sinceRenewal_ = renewals != seenRenewals_ ? 0 : std::min(sinceRenewal_ + 1, leaseSamples_);
  seenRenewals_ = renewals;
  // Asked for once in a while, looked at each sample: an exchange costs as much as a fifth of the loop.
  const bool stop = releaseAsked_.load(std::memory_order_relaxed) && releaseAsked_.exchange(false);
  // Asked for while it ramps out, it waits for the end.
  const bool start = engageAsked_.load(std::memory_order_relaxed) && (stop || state_ != ActuatorState::RampOut) &&
                     engageAsked_.exchange(false);
  const bool open = state_ == ActuatorState::RampIn || state_ == ActuatorState::On;
  if (open && stop) relinquish(ActuatorRelease::Asked);
  if (open && !stop && sinceRenewal_ >= leaseSamples_) relinquish(ActuatorRelease::LeaseOver);
  if (!open && start && !stop && state_ == ActuatorState::Off) {
    watch_.reset();
    sinceRenewal_ = 0;
    ramp_ = 0.0;
    why_ = ActuatorRelease::None;
    state_ = ActuatorState::RampIn;
  }
}

void ActuatorGate::relinquish(ActuatorRelease why) STILLCUT_RT {
  held_ = last_;
  ramp_ = 1.0;
  why_ = why;
  state_ = ActuatorState::RampOut;
}

void ActuatorGate::cut() STILLCUT_RT {
  last_ = held_ = ramp_ = 0.0;
  if (state_ == ActuatorState::Off) return;
  why_ = ActuatorRelease::DeviceFault;
  state_ = ActuatorState::Off;
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

void ActuatorGate::heed(LoopHealth health) STILLCUT_RT {
  switch (health) {
    case LoopHealth::Fine:
      break;
    case LoopHealth::Diverging:
      relinquish(ActuatorRelease::Diverging);
      break;
    case LoopHealth::Saturated:
      relinquish(ActuatorRelease::Saturated);
      break;
    case LoopHealth::Worse:
      relinquish(ActuatorRelease::Worse);
      break;
    case LoopHealth::DeadSensor:
    case LoopHealth::Silenced:
      relinquish(ActuatorRelease::DeadSensor);
      break;
  }
}

ActuatorCommand ActuatorGate::pass(double wanted, double error, double without) STILLCUT_RT {
  return through(wanted, error, without, Health::Judged);
}

ActuatorCommand ActuatorGate::drive(double wanted, double error) STILLCUT_RT {
  return through(wanted, error, error, Health::DeadSensorOnly);
}

ActuatorCommand ActuatorGate::through(double wanted, double error, double without, Health health) STILLCUT_RT {
  listen();
  limited_ = false;
  double output = 0.0;
  const bool open = state_ == ActuatorState::RampIn || state_ == ActuatorState::On;
  if (open && (!std::isfinite(wanted) || !std::isfinite(error))) relinquish(ActuatorRelease::NotFinite);
  if (state_ == ActuatorState::RampIn || state_ == ActuatorState::On) {
    output = shaped(wanted);
    const LoopHealth found = watch_.watch(error, without, output, limited_);
    if (health == Health::Judged || found == LoopHealth::DeadSensor) heed(found);
  }
  if (state_ == ActuatorState::Off && std::isfinite(error)) watch_.listen(error);
  if (state_ == ActuatorState::RampOut) output = ramped();
  if (!std::isfinite(output)) output = 0.0;  // last, whatever happened above
  last_ = output;
  // This thread alone writes both.
  if (limited_) limitedSamples_.store(limitedSamples_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  const double used = std::abs(output) / limits_.amplitude;
  if (used > strokeUsed_.load(std::memory_order_relaxed)) strokeUsed_.store(used, std::memory_order_relaxed);
  return ActuatorCommand(output);
}

}  // namespace stillcut::safety
