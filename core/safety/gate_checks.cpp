#include "core/safety/gate_checks.h"

#include <algorithm>
#include <cmath>

namespace stillcut::safety {
namespace {

// Beyond these no milling machine exists: a value outside is a fault of the sender.
constexpr double kFastestSpindle = 300000.0;  // rev/min
constexpr double kFastestFeed = 10.0;         // m/s
constexpr double kHighestKnob = 4.0;          // 400 %
// A request this far from the programmed value is a fault, not a wish that limits could trim.
constexpr double kWildest = 4.0;

bool within(double v, double low, double high) noexcept {
  return std::isfinite(v) && v >= low && v <= high;
}

// In doubles: hostile stamps at the ends of the range must not overflow.
double ageOf(Instant stamp, Instant now) noexcept {
  return (static_cast<double>(toNs(now)) - static_cast<double>(toNs(stamp))) * 1e-9;
}

// Stale, or stamped further in the future than it may be old: both mean that the stamp cannot be believed.
bool fresh(Instant stamp, Instant now, Seconds maxAge) noexcept {
  return std::abs(ageOf(stamp, now)) <= maxAge.value;
}

// What is stamped later than now is new, not older than nothing.
Reason ageReason(ReasonCode code, Instant stamp, Instant now) noexcept {
  return {code, {std::max(0.0, ageOf(stamp, now))}};
}

// A machine is read while the block that is judged still waits in a sound card's buffer: stamped a little later than
// the block, its state is as fresh as can be. Further ahead no clock of ours is.
constexpr double kAhead = 1.0;  // [s]

}  // namespace

bool plausible(const MachineState& m) STILLCUT_RT {
  return within(m.programmedSpeed.value, 0.0, kFastestSpindle) && within(m.programmedFeed.value, 0.0, kFastestFeed) &&
         within(m.operatorSpeed.value, 0.01, kHighestKnob) && within(m.operatorFeed.value, 0.0, kHighestKnob) &&
         within(m.speedOverride.value, 0.0, kHighestKnob) && within(m.feedOverride.value, 0.0, kHighestKnob) &&
         within(m.actualSpeed.value, 0.0, kFastestSpindle) && within(m.actualFeed.value, 0.0, kFastestFeed);
}

Reason checkMachine(const MachineState& m, Instant now, Seconds maxAge) STILLCUT_RT {
  // A machine that was never read has not answered for any time: there may be none.
  if (!m.linkUp && m.time == Instant{} && !m.valid) return {ReasonCode::MachineNeverRead, {}};
  if (!m.linkUp) return ageReason(ReasonCode::LinkLost, m.time, now);
  if (!m.valid || !plausible(m)) return {ReasonCode::GateMachineInvalid, {}};
  const bool ahead = m.time > now && fresh(m.time, now, Seconds(std::max(kAhead, maxAge.value)));
  if (!ahead && !fresh(m.time, now, maxAge)) return ageReason(ReasonCode::GateStaleMachine, m.time, now);
  if (!m.overridesEnabled) return {ReasonCode::GateMachineLocked, {}};
  if (!m.controlOurs) return {ReasonCode::GateControlLost, {}};
  if (!m.programRunning || m.programmedSpeed.value <= 0.0) return {ReasonCode::GateMachineNotReady, {}};
  return {};
}

Reason checkVerdict(const Verdict& v, Instant now, Seconds maxAge) STILLCUT_RT {
  const bool finite = isFinite(v.frequency) && isFinite(v.severity) && isFinite(v.spindle);
  if (!v.valid || !finite || v.frequency.value < 0.0) return {ReasonCode::GateVerdictInvalid, {}};
  if (!fresh(v.time, now, maxAge)) return ageReason(ReasonCode::GateStaleVerdict, v.time, now);
  return {};
}

bool inCut(const Verdict& v) STILLCUT_RT {
  return v.state != CutState::AirCutting && v.phase != CutPhase::RunUp;
}

Seconds sampleAge(const Verdict& v, const MachineState& m, Instant now) STILLCUT_RT {
  return Seconds(ageOf(v.time, std::max(now, m.time)));
}

Reason checkRequest(const OverrideRequest& r, const MachineState& m, Instant now, Seconds maxAge) STILLCUT_RT {
  if (r.kind != RequestKind::Set) {
    const bool known = r.kind == RequestKind::None || r.kind == RequestKind::Hold || r.kind == RequestKind::Release;
    return known ? Reason{} : Reason{ReasonCode::GateNotFinite, {}};
  }
  if (!fresh(r.time, now, maxAge)) return ageReason(ReasonCode::GateStaleRequest, r.time, now);
  const Rpm speed = m.programmedSpeed * m.operatorSpeed.value;
  if (r.claimsSpeed && !within(r.speed.value, speed.value / kWildest, speed.value * kWildest)) {
    return {ReasonCode::GateNotFinite, {}};
  }
  const MetresPerSecond feed = m.programmedFeed * m.operatorFeed.value;
  if (r.claimsFeed && !within(r.feed.value, 0.0, feed.value > 0.0 ? feed.value * kWildest : kFastestFeed)) {
    return {ReasonCode::GateNotFinite, {}};
  }
  return {};
}

}  // namespace stillcut::safety
