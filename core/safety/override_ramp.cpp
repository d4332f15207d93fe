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
  accept({s, limits_.overrides.perTooth(feed.clamp(now_.feed), s)});
}

void OverrideRamp::advance(const RampInput& in) STILLCUT_RT {
  const config::OverrideLimits& o = limits_.overrides;
  const double share = in.dt > 0.0 ? in.dt / (in.dt + limits_.filter.value) : 0.0;
  filtered_.speed = lowPassed(filtered_.speed, in.wanted.speed, share);
  filtered_.feed = lowPassed(filtered_.feed, in.wanted.feed, share);
  const double speedGoal = in.speed.clamp(filtered_.speed);
  const double feedGoal = in.feed.clamp(o.perTooth(filtered_.feed, speedGoal));

  const auto most = [&](double from, double to, double step, double slew) {
    const double rate = in.recovering && toward100(from, to) ? limits_.recoveryFraction : 1.0;
    return rate * std::min(step, slew * in.dt);
  };
  double speed = approach(now_.speed, speedGoal, most(now_.speed, speedGoal, limits_.speedStep, limits_.speedSlew));
  double feed = approach(now_.feed, feedGoal, most(now_.feed, feedGoal, limits_.feedStep, limits_.feedSlew));
  speed = orderedSpeed(in, speed);
  feed = orderedFeed(in, feed);
  speed = in.speed.clamp(speed);
  accept({speed, o.perTooth(in.feed.clamp(feed), speed)});
}

// Feed falls first: speed goes only as low as the feed that has been sent, and is in force, allows; and only as high as
// leaves each tooth enough.
double OverrideRamp::orderedSpeed(const RampInput& in, double speed) const STILLCUT_RT {
  const config::OverrideLimits& o = limits_.overrides;
  if (speed < now_.speed) {
    // What is read back is rounded.
    const double inForce = in.feedInForce - limits_.speedTolerance - kReadbackRounding;
    return std::max(speed, std::min(now_.speed, std::max(now_.feed, inForce) / o.feedPerTooth));
  }
  if (speed > now_.speed && o.lowestFeedPerTooth > 0.0) {
    return std::min(speed, std::max(now_.speed, now_.feed / o.lowestFeedPerTooth));
  }
  return speed;
}

// Speed rises first: feed goes only as high as the speed sent, and reached, allows; and only as low as leaves each
// tooth enough.
double OverrideRamp::orderedFeed(const RampInput& in, double feed) const STILLCUT_RT {
  const config::OverrideLimits& o = limits_.overrides;
  if (feed > now_.feed) {
    const double reached = in.actualSpeed > 0.0 ? in.actualSpeed * (1.0 + limits_.speedTolerance) : now_.speed;
    return std::max(now_.feed, std::min(feed, o.feedPerTooth * std::min(now_.speed, reached)));
  }
  if (feed < now_.feed) return std::max(feed, std::min(now_.feed, o.lowestFeedPerTooth * now_.speed));
  return feed;
}

}  // namespace stillcut::safety
