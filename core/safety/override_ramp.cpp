#include "core/safety/override_ramp.h"

#include <algorithm>
#include <cmath>

namespace stillcut::safety {
namespace {

constexpr double kArrived = 1e-5;  // closer than this the filter's tail is cut off

double approach(double from, double to, double most) noexcept {
  return from + std::clamp(to - from, -most, most);
}

double lowPassed(double state, double wanted, double share) noexcept {
  const double next = state + share * (wanted - state);
  return std::abs(wanted - next) < kArrived ? wanted : next;
}

bool toward100(double from, double to) noexcept {
  return (from - 1.0) * (to - from) < 0.0;
}

}  // namespace

void OverrideRamp::prepare(const GateLimits& limits) {
  limits_ = limits;
  restart();
}

void OverrideRamp::restart() STILLCUT_RT {
  now_ = {};
  filtered_ = {};
}

void OverrideRamp::halt() STILLCUT_RT {
  filtered_ = now_;
}

bool OverrideRamp::at(const Factors& f) const STILLCUT_RT {
  return std::abs(now_.speed - f.speed) < kArrived && std::abs(now_.feed - f.feed) < kArrived;
}

void OverrideRamp::accept(const Factors& next) STILLCUT_RT {
  if (std::isfinite(next.speed) && std::isfinite(next.feed)) now_ = next;
}

void OverrideRamp::keepInside(const config::FactorRange& speed, const config::FactorRange& feed) STILLCUT_RT {
  const double s = speed.clamp(now_.speed);
  accept({s, std::min(feed.clamp(now_.feed), limits_.overrides.feedPerTooth * s)});
}

void OverrideRamp::advance(const RampInput& in) STILLCUT_RT {
  const double perTooth = limits_.overrides.feedPerTooth;
  const double share = in.dt > 0.0 ? in.dt / (in.dt + limits_.filter.value) : 0.0;
  filtered_.speed = lowPassed(filtered_.speed, in.wanted.speed, share);
  filtered_.feed = lowPassed(filtered_.feed, in.wanted.feed, share);
  const double speedGoal = in.speed.clamp(filtered_.speed);
  const double feedGoal = in.feed.clamp(std::min(filtered_.feed, perTooth * speedGoal));

  const auto most = [&](double from, double to, double step, double slew) {
    const double rate = in.recovering && toward100(from, to) ? limits_.recoveryShare : 1.0;
    return rate * std::min(step, slew * in.dt);
  };
  double speed = approach(now_.speed, speedGoal, most(now_.speed, speedGoal, limits_.speedStep, limits_.speedSlew));
  double feed = approach(now_.feed, feedGoal, most(now_.feed, feedGoal, limits_.feedStep, limits_.feedSlew));

  // Feed falls first: speed goes only as low as the feed that has already been sent allows.
  if (speed < now_.speed) speed = std::max(speed, std::min(now_.speed, now_.feed / perTooth));
  // Speed rises first: feed goes only as high as the speed sent, and reached, allows.
  if (feed > now_.feed) {
    const double reached = in.actualSpeed > 0.0 ? in.actualSpeed * (1.0 + limits_.speedTolerance) : now_.speed;
    feed = std::max(now_.feed, std::min(feed, perTooth * std::min(now_.speed, reached)));
  }
  speed = in.speed.clamp(speed);
  accept({speed, std::min(in.feed.clamp(feed), perTooth * speed)});
}

}  // namespace stillcut::safety
