// ActuatorGate: the only door to the actuator of one axis. Only it can make an ActuatorCommand, and nothing can switch
// it off. Whatever it is asked for is limited in amplitude, then in slew, ramped in, and checked to be finite last. It
// lets go, by a ramp to zero, when the lease is not renewed, the error or the wish is not finite, the loop runs away,
// is at its end or has a dead sensor (divergence_watch.h), or when it is told to; then it says why and stays off until
// engaged anew. Thread: pass() on the loop's thread, real-time; renew(),
// release() and state() from any; engage() before the loop runs or from any thread.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/base/realtime.h"
#include "core/base/result.h"
#include "core/base/units.h"
#include "core/model/active_state.h"
#include "core/safety/divergence_watch.h"

namespace stillcut::safety {

struct ActuatorLimits {
  double amplitude = 0.0;  // largest output, either sign, in the converter's unit; > 0
  double slew = 0.0;       // largest change per second; > 0
  Seconds lease{0.1};      // without renewal
  Seconds rampIn{0.1};
  Seconds rampOut{0.005};
};

class ActuatorCommand {
 public:
  ActuatorCommand() = default;  // rest
  double value() const { return value_; }

 private:
  friend class ActuatorGate;
  explicit ActuatorCommand(double value) : value_(value) {}
  double value_ = 0.0;
};

class ActuatorGate {
 public:
  // Refuses limits that are not positive and finite, a lease above one second, ramps above ten.
  Status prepare(const ActuatorLimits& limits, Hertz rate);

  void engage() noexcept { engageAsked_.store(true); }
  void release() noexcept { releaseAsked_.store(true); }
  void renew() noexcept { renewals_.fetch_add(1); }  // once a block will do

  // Once a sample: what the controller wants, the error it was made from, and what the error would be without control
  // by the controller's model (left out: nobody knows).
  ActuatorCommand pass(double wanted, double error) STILLCUT_RT { return pass(wanted, error, error); }
  ActuatorCommand pass(double wanted, double error, double without) STILLCUT_RT;
  // The same for an output that does not come from the error, as while a path is identified: whatever grows, it is no
  // loop that runs away. A dead sensor counts.
  ActuatorCommand drive(double wanted, double error) STILLCUT_RT;

  // The device's output fell to zero by itself: off at once, without a ramp from where it no longer is.
  void cut() STILLCUT_RT;

  ActuatorState state() const noexcept { return state_.load(); }
  ActuatorRelease why() const noexcept { return why_.load(); }  // of the last letting go
  // The last wish was cut off by amplitude or slew; how many were since the start; largest share of the stroke used.
  bool limited() const noexcept { return limited_; }
  std::uint64_t limitedSamples() const noexcept { return limitedSamples_.load(); }
  double strokeUsed() const noexcept { return strokeUsed_.load(); }

 private:
  enum class Health { Judged, DeadSensorOnly };
  ActuatorCommand through(double wanted, double error, double without, Health health) STILLCUT_RT;
  void heed(LoopHealth health) STILLCUT_RT;
  void listen() STILLCUT_RT;
  void relinquish(ActuatorRelease why) STILLCUT_RT;
  double ramped() STILLCUT_RT;
  double shaped(double wanted) STILLCUT_RT;

  ActuatorLimits limits_;
  DivergenceWatch watch_;
  double perSample_ = 0.0;  // slew
  double inStep_ = 0.0, outStep_ = 0.0;
  std::int64_t leaseSamples_ = 0, sinceRenewal_ = 0;
  std::uint64_t seenRenewals_ = 0;
  double ramp_ = 0.0;  // 0 .. 1
  double last_ = 0.0;  // written
  double held_ = 0.0;  // written when it let go
  bool limited_ = false;
  std::atomic<bool> engageAsked_{false}, releaseAsked_{false};
  std::atomic<std::uint64_t> renewals_{0};
  std::atomic<ActuatorState> state_{ActuatorState::Off};
  std::atomic<ActuatorRelease> why_{ActuatorRelease::None};
  std::atomic<std::uint64_t> limitedSamples_{0};
  std::atomic<double> strokeUsed_{0.0};
};

}  // namespace stillcut::safety
