// What must hold for whatever the gate lets out, written down without the gate's code: limits, rates, order, authority,
// lease, holding on bad input. breach() is empty or says what was broken.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "core/safety/gate_io.h"
#include "core/safety/gate_limits.h"

namespace stillcut::safety::testing {

class GateOracle {
 public:
  void prepared(const GateLimits& limits) {
    limits_ = limits;
    granted_ = Authority::Off;
    lived_ = false;
  }

  std::string breach(const GateInput& in, const GateOutput& out) {
    const double elapsed = static_cast<double>(toNs(in.now) - lastNow_) * 1e-9;
    const bool lapsed = !lived_ || elapsed <= 0.0 || elapsed > limits_.lease.value;
    lastNow_ = toNs(in.now);
    lived_ = true;
    for (const OperatorInput& i : in.inputs) {
      if (i.action == OperatorAction::SetAuthority) granted_ = i.authority;
      if (i.action == OperatorAction::GrantBySimulation) granted_ = Authority::Auto;
      if (i.action == OperatorAction::BackToProgrammed) granted_ = Authority::Off;
    }
    untrusted_ = trusted(in.machine, in.now) ? 0.0 : untrusted_ + (elapsed > 0.0 && elapsed < 1.0 ? elapsed : 0.0);

    std::string what = judge(in, out, elapsed, lapsed);
    const bool set = out.command && out.command->kind() == CommandKind::Set;
    if (out.command) sequence_ = out.command->sequence();
    inForce_ = set;
    if (set) {
      if (out.command->engagement() != engagement_) programmed_ = in.machine.programmedSpeed.value;
      speed_ = out.command->speed().value;
      feed_ = out.command->feed().value;
      engagement_ = out.command->engagement();
      ++sets;
    }
    return what;
  }
  long sets = 0;

 private:
  static bool in(double v, double low, double high) { return v >= low - 1e-9 && v <= high + 1e-9; }
  static bool between(double v, double low, double high) { return number(v) && v >= low && v <= high; }
  static bool number(double v) { return std::isfinite(v); }

  bool trusted(const MachineState& m, Instant now) const {
    const double age = std::abs(static_cast<double>(toNs(now)) - static_cast<double>(toNs(m.time))) * 1e-9;
    return m.valid && m.linkUp && m.overridesEnabled && m.controlOurs && m.programRunning &&
           age <= limits_.machineAge.value && number(m.programmedSpeed.value) && m.programmedSpeed.value > 0.0 &&
           m.programmedSpeed.value <= 3e5 && between(m.programmedFeed.value, 0.0, 10.0) &&
           between(m.operatorSpeed.value, 0.01, 4.0) && between(m.operatorFeed.value, 0.0, 4.0) &&
           between(m.actualSpeed.value, 0.0, 3e5) && between(m.actualFeed.value, 0.0, 10.0) &&
           between(m.speedOverride.value, 0.0, 4.0) && between(m.feedOverride.value, 0.0, 4.0);
  }

  // Range of our factor such that factor and product stay inside, never pushing out what the operator did himself.
  static config::FactorRange allowed(double low, double high, double knob) {
    if (knob <= 0.0) return {low, high};
    return {std::min(1.0, std::max(low, low / knob)), std::max(1.0, std::min(high, high / knob))};
  }

  std::string judge(const GateInput& g, const GateOutput& out, double elapsed, bool lapsed) const {
    std::ostringstream s;
    if (out.authority == Authority::Auto && !limits_.autoAllowed) return "Auto without leave";
    if (!out.command) return inForce_ && !lapsed ? "a Set in force was neither renewed nor released" : "";
    const CommandRecord& c = out.command->record();
    if (c.sequence <= sequence_) return "sequence did not grow";
    if (c.kind == CommandKind::Release) return out.commanding ? "released and still commanding" : "";
    if (lapsed) return "Set on a dead lease";
    if (granted_ == Authority::Off || out.authority == Authority::Off) return "Set without authority";
    if (c.lease != toDuration(limits_.lease)) return "wrong lease";
    if (!number(c.speed.value) || !number(c.feed.value)) return "not finite";
    const bool same = inForce_ && c.engagement == engagement_;
    if (inForce_ && !same) return "changed its engagement without a release";
    if (!trusted(g.machine, g.now)) return whenUntrusted(c);
    if (same && std::abs(g.machine.programmedSpeed.value - programmed_) > 2e-3 * programmed_) {
      return "went on after the program changed its speed";
    }
    return whenTrusted(g, c, elapsed, same);
  }

  std::string whenUntrusted(const CommandRecord& c) const {
    if (!inForce_) return "took the overrides of a machine that cannot be trusted";
    if (c.speed.value != speed_ || c.feed.value != feed_) return "moved on bad machine state";
    return untrusted_ > limits_.holdTime.value + 0.2 ? "held on bad machine state for too long" : "";
  }

  std::string whenTrusted(const GateInput& g, const CommandRecord& c, double elapsed, bool same) const {
    const MachineState& m = g.machine;
    const config::OverrideLimits& o = limits_.overrides;
    config::FactorRange feeds = allowed(o.lowestFeed.value, o.highestFeed.value, m.operatorFeed.value);
    config::FactorRange speeds = allowed(o.lowestSpeed.value, o.highestSpeed.value, m.operatorSpeed.value);
    if (!in(c.speed.value, speeds.low, speeds.high)) return "speed out of the override's range";
    const double base = m.programmedSpeed.value * m.operatorSpeed.value;
    const double n = base * c.speed.value;
    if (n > std::max(o.fastest.value, base) * (1 + 1e-9)) return "faster than the tool may turn";
    if (n < std::min(o.slowest.value, base) * (1 - 1e-9)) return "slower than the tool may turn";
    const double feedBase = m.programmedFeed.value * m.operatorFeed.value;
    if (feedBase > 0.0) {
      const double feed = feedBase * c.feed.value;
      if (feed > std::max(o.fastestFeed.value, feedBase) * (1 + 1e-9)) return "faster than the feed may be";
      if (feed < std::min(o.slowestFeed.value, feedBase) * (1 - 1e-9)) return "slower than the feed may be";
      feeds.low = std::min(1.0, std::max(feeds.low, o.slowestFeed.value / feedBase));
      feeds.high = std::max(1.0, std::min(feeds.high, o.fastestFeed.value / feedBase));
    }
    if (!in(c.feed.value, feeds.low, feeds.high)) return "feed out of the override's range";
    if (c.feed.value > o.feedPerTooth * c.speed.value + 1e-9) return "feed per tooth too high";
    if (c.feed.value < o.lowestFeedPerTooth * c.speed.value - 1e-9) return "feed per tooth too low";
    if (o.lowestFeedPerTooth > 0.0)
      speeds.high = std::min(speeds.high, std::max(1.0, feeds.high / o.lowestFeedPerTooth));
    speeds.high = std::max(1.0, std::min(speeds.high, o.fastest.value / base));
    speeds.low =
        std::min(1.0, std::max({speeds.low, o.slowest.value / base, std::min(1.0, feeds.low / o.feedPerTooth)}));
    return rates(g, c, elapsed, same ? speeds.clamp(speed_) : 1.0, same ? feeds.clamp(feed_) : 1.0);
  }

  // `speed`, `feed`: where we came from, taken along by edges that moved.
  std::string rates(const GateInput& g, const CommandRecord& c, double elapsed, double speed, double feed) const {
    const double perTooth = limits_.overrides.feedPerTooth;
    feed = std::max(std::min(feed, perTooth * speed), limits_.overrides.lowestFeedPerTooth * speed);
    const double dt = std::min(elapsed, g.dt.value > 0.0 ? g.dt.value : 0.0);
    const auto most = [&](double from, double to, double step, double slew) {
      const bool back = std::abs(to - 1.0) < std::abs(from - 1.0) && (to - 1.0) * (from - 1.0) >= 0.0;
      return (back && !g.verdict.alarming() ? 0.2 : 1.0) * std::min(step, slew * dt) + 1e-9;
    };
    const double ds = c.speed.value - speed;
    const double df = c.feed.value - feed;
    std::ostringstream s;
    if (std::abs(ds) > most(speed, c.speed.value, limits_.speedStep, limits_.speedSlew)) {
      s << "speed moved from " << speed << " (sent " << speed_ << ") by " << ds << " in " << dt << " s, allowed "
        << most(speed, c.speed.value, limits_.speedStep, limits_.speedSlew);
    } else if (std::abs(df) > most(feed, c.feed.value, limits_.feedStep, limits_.feedSlew)) {
      s << "feed moved from " << feed << " (sent " << feed_ << ") by " << df << " in " << dt << " s, allowed "
        << most(feed, c.feed.value, limits_.feedStep, limits_.feedSlew);
    } else if (ds < -1e-9 && c.speed.value < feed / perTooth - 1e-9) {
      s << "speed fell before feed";
    } else if (df > 1e-9 && c.feed.value > perTooth * speed + 1e-9) {
      s << "feed rose before speed";
    } else if (ds < -1e-9 && g.machine.operatorFeed.value > 0.0 &&
               c.speed.value < (g.machine.feedOverride.value / g.machine.operatorFeed.value - limits_.speedTolerance -
                                kReadbackRounding) /
                                       perTooth -
                                   1e-9) {
      s << "speed fell before the feed that is in force";
    }
    return s.str();
  }

  GateLimits limits_;
  Authority granted_ = Authority::Off;
  bool lived_ = false;
  std::int64_t lastNow_ = 0;
  std::uint64_t sequence_ = 0;
  std::uint64_t engagement_ = 0;
  bool inForce_ = false;
  double speed_ = 1.0, feed_ = 1.0;
  double programmed_ = 0.0;
  double untrusted_ = 0.0;
};

}  // namespace stillcut::safety::testing
