// The books of the gate's oracle: what was in force, who had authority, how long input was bad, how often the machine
// was moved. Made from the gate's inputs and outputs alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>

#include "core/safety/gate_io.h"
#include "core/safety/gate_limits.h"

namespace stillcut::safety::testing {

// What the makers of machine, tool and holder allow, and what the edge does.
struct CutterLimits {
  Rpm machine{std::numeric_limits<double>::infinity()};
  Rpm tool{std::numeric_limits<double>::infinity()};
  Rpm holder{std::numeric_limits<double>::infinity()};
  MetresPerSecond edge{std::numeric_limits<double>::infinity()};
  Metres diameter{0.01};
};

class Books {
 public:
  void prepared(const GateLimits& limits) {
    const bool wasInForce = inForce;
    const std::uint64_t engagement = engagement_;
    *this = Books();
    limits_ = limits;
    inForce = wasInForce;  // to be released by the next step
    engagement_ = engagement;
    lapsed = true;
    sinceRelease = sinceKnob = 1e9;
    fresh_ = true;
  }

  void before(const GateInput& in) {
    elapsed = static_cast<double>(toNs(in.now) - lastNow_) * 1e-9;
    lapsed = fresh_ || elapsed <= 0.0 || elapsed > limits_.lease.value;
    if (lapsed) elapsed = 0.0;
    lastNow_ = toNs(in.now);
    listen(in);
    watchMachine(in);
    const bool clock = std::isfinite(in.dt.value) && in.dt.value > 0.0;
    const bool machine = trusted(in);
    const bool notObeyed = notTaken > limits_.takeTime.value || notFollowing > limits_.followTime.value;
    bad = in.strategyFailed || lapsed || !clock || !machine || notObeyed || !usable(in.verdict, in.now) ||
          !usable(in, in.request);
    unusual = !lapsed && (machine || (in.machine.programRunning && in.machine.programmedSpeed.value != 0.0));
    badClock = clock ? 0.0 : badClock + elapsed;
    bucket_ = std::max(0.0, bucket_ + (bad ? elapsed : -elapsed));
    const bool changed = inForce && machine && programChanged(in.machine, 1e-3);
    blind = inForce && (blind || notFollowing > limits_.followTime.value);
    const bool longBad = bucket_ >= limits_.holdTime.value - 1e-9;
    mayLeave = inForce && (mayLeave || given == Authority::Off || in.strategyFailed || changed || (bad && longBad));
    mustLeave =
        inForce && (mustLeave || given == Authority::Off || in.strategyFailed ||
                    (changed && programChanged(in.machine, 2e-3)) || (bad && badSince > limits_.holdTime.value + 0.1));
  }

  void after(const GateInput& in, const GateOutput& out) {
    failed = failed || in.strategyFailed;
    badSince = bad ? badSince + elapsed : 0.0;
    goodFor = bad ? 0.0 : goodFor + elapsed;
    shown = given = out.authority;
    adviceOpen_ = out.adviceOpen;
    adviceNumber_ = out.adviceNumber;
    sinceRelease += elapsed;
    const bool set = out.command && out.command->kind() == CommandKind::Set;
    if (out.command && !set && !fresh_) sinceRelease = 0.0;
    fresh_ = false;
    const bool moved = set && (out.command->speed().value != speed_ || out.command->feed().value != feed_);
    stuck = moved || !mustLeave ? 0.0 : stuck + elapsed;  // what may leave need not hurry
    if (!set && inForce) mayLeave = mustLeave = licence = false;
    if (set && out.command->engagement() != engagement_) {
      programmed_ = in.machine.programmedSpeed.value;
      engagement_ = out.command->engagement();
      notTaken = notFollowing = still_ = 0.0;
    }
    endLicence(in, moved, set);
    inForce = set;
    speed_ = set ? out.command->speed().value : 1.0;
    feed_ = set ? out.command->feed().value : 1.0;
  }

  // Its moves did not help, the gate says: what is in force goes home.
  void giveUp() {
    if (!mustLeave) stuck = 0.0;
    mayLeave = mustLeave = inForce;
  }

  bool mayShow(Authority a) const { return a == given || (given == Authority::Auto && a == Authority::Advise); }

  // Commands reach the machine and act on it.
  bool steerable(const GateInput& in) const {
    return readable(in) && in.machine.overridesEnabled && in.machine.controlOurs;
  }

  // Ranges of our factors such that factor and product with the knob stay inside; what program and operator chose
  // themselves is never corrected, so 1 is always inside.
  config::FactorRange feeds(const MachineState& m) const {
    const config::OverrideLimits& o = limits_.overrides;
    config::FactorRange r = withKnob(o.lowestFeed.value, o.highestFeed.value, m.operatorFeed.value);
    const double base = m.programmedFeed.value * m.operatorFeed.value;
    if (base > 0.0) {
      r.low = std::min(1.0, std::max(r.low, o.slowestFeed.value / base));
      r.high = std::max(1.0, std::min(r.high, o.fastestFeed.value / base));
    }
    return r;
  }
  config::FactorRange ownSpeeds(const MachineState& m) const {
    return withKnob(limits_.overrides.lowestSpeed.value, limits_.overrides.highestSpeed.value, m.operatorSpeed.value);
  }
  // Also such that some feed in its own range gives each tooth what it may have.
  config::FactorRange speeds(const MachineState& m) const {
    const config::OverrideLimits& o = limits_.overrides;
    config::FactorRange r = ownSpeeds(m);
    const config::FactorRange f = feeds(m);
    if (o.lowestFeedPerTooth > 0.0) r.high = std::min(r.high, std::max(1.0, f.high / o.lowestFeedPerTooth));
    r.low = std::max(r.low, std::min(1.0, f.low / o.feedPerTooth));
    const double base = m.programmedSpeed.value * m.operatorSpeed.value;
    if (base > 0.0) {
      r.high = std::max(1.0, std::min(r.high, o.fastest.value / base));
      r.low = std::min(1.0, std::max(r.low, o.slowest.value / base));
    }
    return r;
  }

  bool inForce = false;
  bool lapsed = true;    // time stood still, went back or passed the lease
  double elapsed = 0.0;  // [s] of this step
  Authority given = Authority::Off, shown = Authority::Off;
  bool licence = false;  // an advice was accepted, and nothing has ended that since
  bool touched = false;  // authority, in this step
  bool held = false, failed = false;
  bool bad = false, unusual = false;          // input of this step; worth an event
  double badSince = 0.0, goodFor = 0.0;       // [s] before this step
  double badClock = 0.0, stuck = 0.0;         // [s]
  double notTaken = 0.0, notFollowing = 0.0;  // [s]
  bool blind = false;                         // the spindle has not followed for too long: it is not waited for
  double sinceRelease = 1e9, sinceKnob = 1e9;
  bool mayLeave = false, mustLeave = false;  // for 100 %, at full rate

 private:
  static bool within(double v, double low, double high) { return std::isfinite(v) && v >= low && v <= high; }
  static double age(Instant of, Instant now) {
    return std::abs(static_cast<double>(toNs(now)) - static_cast<double>(toNs(of))) * 1e-9;
  }
  static config::FactorRange withKnob(double low, double high, double knob) {
    if (knob <= 0.0) return {low, high};
    return {std::min(1.0, std::max(low, low / knob)), std::max(1.0, std::min(high, high / knob))};
  }

  // An acceptance is good for one move: until it has come to rest with nothing in its way, or has not begun in time.
  // Edges that move away give the rest of it free.
  void endLicence(const GateInput& in, bool moved, bool set) {
    const config::FactorRange s = speeds(in.machine), f = feeds(in.machine);
    const bool edge = s.low != speeds_.low || s.high != speeds_.high || f.low != feeds_.low || f.high != feeds_.high;
    speeds_ = s;
    feeds_ = f;
    if (shown != Authority::Advise) licence = false;
    // What is in force is, by its acceptance or because it was in force when Advise was chosen.
    if (edge && set) licence = true;
    const bool waits = bad || held || in.machine.feedHold || sinceKnob < limits_.operatorPause.value || !settled_;
    if (moved || edge || !licence || (set && waits)) still_ = 0.0;
    still_ += elapsed;
    if (still_ > (set ? 1.0 : 6.0)) licence = false;
  }

  void listen(const GateInput& in) {
    touched = false;
    for (const OperatorInput& i : in.inputs) {
      const Authority asked = i.action == OperatorAction::GrantBySimulation ? Authority::Auto : i.authority;
      const bool gives = i.action == OperatorAction::SetAuthority || i.action == OperatorAction::GrantBySimulation;
      if (gives && (asked != Authority::Auto || limits_.autoAllowed)) take(asked);
      if (i.action == OperatorAction::BackToProgrammed) take(Authority::Off);
      if (i.action == OperatorAction::BackToProgrammed || i.action == OperatorAction::EndHold) held = false;
      if (i.action == OperatorAction::Hold) held = true;
      if (i.action == OperatorAction::Accept && given == Authority::Advise && adviceOpen_ &&
          i.advice == adviceNumber_) {
        licence = true;
        still_ = 0.0;
      }
    }
  }
  void take(Authority a) {
    if (a != given) {
      licence = adviceOpen_ = false;
      touched = true;
    }
    given = a;
    if (a == Authority::Off && inForce) mayLeave = mustLeave = true;
  }

  bool readable(const GateInput& in) const {
    const MachineState& m = in.machine;
    const double oldest = m.time > in.now ? std::max(1.0, limits_.machineAge.value) : limits_.machineAge.value;
    return m.valid && m.linkUp && age(m.time, in.now) <= oldest && within(m.programmedSpeed.value, 0.0, 3e5) &&
           within(m.programmedFeed.value, 0.0, 10.0) && within(m.operatorSpeed.value, 0.01, 4.0) &&
           within(m.operatorFeed.value, 0.0, 4.0) && within(m.actualSpeed.value, 0.0, 3e5) &&
           within(m.actualFeed.value, 0.0, 10.0) && within(m.speedOverride.value, 0.0, 4.0) &&
           within(m.feedOverride.value, 0.0, 4.0);
  }
  bool trusted(const GateInput& in) const {
    return steerable(in) && in.machine.programRunning && in.machine.programmedSpeed.value > 0.0;
  }
  bool usable(const Verdict& v, Instant now) const {
    return v.valid && age(v.time, now) <= limits_.verdictAge.value && isFinite(v.severity) && isFinite(v.spindle) &&
           isFinite(v.frequency) && v.frequency.value >= 0.0;
  }
  bool usable(const GateInput& in, const OverrideRequest& r) const {
    if (r.kind != RequestKind::Set) return true;
    const double speed = in.machine.programmedSpeed.value * in.machine.operatorSpeed.value;
    const double feed = in.machine.programmedFeed.value * in.machine.operatorFeed.value;
    return age(r.time, in.now) <= limits_.verdictAge.value &&
           (!r.claimsSpeed || within(r.speed.value, speed / 4.0, speed * 4.0)) &&
           (!r.claimsFeed || within(r.feed.value, 0.0, feed > 0.0 ? feed * 4.0 : 10.0));
  }
  bool programChanged(const MachineState& m, double share) const {
    return m.programmedSpeed.value > 0.0 && std::abs(m.programmedSpeed.value - programmed_) > share * programmed_;
  }

  // The knobs, and whether the machine does what it was told in the steps before.
  void watchMachine(const GateInput& in) {
    if (!trusted(in)) return;
    const MachineState& m = in.machine;
    const bool turned = knobSeen_ && (std::abs(m.operatorSpeed.value - knobSpeed_) > 0.004 ||
                                      std::abs(m.operatorFeed.value - knobFeed_) > 0.004);
    sinceKnob = turned ? 0.0 : sinceKnob + elapsed;
    if (turned || !knobSeen_) {
      knobSpeed_ = m.operatorSpeed.value;
      knobFeed_ = m.operatorFeed.value;
    }
    knobSeen_ = true;
    const double room = limits_.speedTolerance + kReadbackRounding;
    const bool taken = std::abs(m.speedOverride.value - m.operatorSpeed.value * speed_) <= room &&
                       (m.feedHold || std::abs(m.feedOverride.value - m.operatorFeed.value * feed_) <= room);
    const double speed = m.programmedSpeed.value * m.operatorSpeed.value * speed_;
    const bool follows = m.atSpeed && (m.actualSpeed.value <= 0.0 ||
                                       std::abs(m.actualSpeed.value - speed) <= limits_.speedTolerance * speed);
    settled_ = m.atSpeed && std::abs(m.speedOverride.value - m.operatorSpeed.value * speed_) < 1e-6 &&
               std::abs(m.feedOverride.value - m.operatorFeed.value * feed_) < 1e-6 &&
               std::abs(m.actualSpeed.value - speed) < 1e-4 * speed;
    notTaken = taken || !inForce ? 0.0 : notTaken + elapsed;
    notFollowing = follows || !inForce ? 0.0 : notFollowing + elapsed;
  }

  GateLimits limits_;
  bool fresh_ = true;
  std::int64_t lastNow_ = 0;
  std::uint64_t engagement_ = 0;
  double speed_ = 1.0, feed_ = 1.0, programmed_ = 0.0;
  double bucket_ = 0.0;
  bool adviceOpen_ = false;
  std::uint32_t adviceNumber_ = 0;
  bool settled_ = false;  // the machine is exactly where it was sent
  double still_ = 0.0;
  config::FactorRange speeds_, feeds_;
  bool knobSeen_ = false;
  double knobSpeed_ = 1.0, knobFeed_ = 1.0;
};

// Changes per minute under one grant of Auto. Counted are those that nobody can deny: taking the overrides, and a speed
// that turns round to go further away from 100 %. The gate may count more.
class ChangeCount {
 public:
  void prepared(const GateLimits& limits) {
    *this = ChangeCount();
    limits_ = limits;
  }
  std::string breach(const GateInput& in, const GateOutput& out, const Books& books) {
    clock_ += books.elapsed;
    if (out.authority != Authority::Auto || books.shown != Authority::Auto || books.touched) forget();
    const bool set = out.command && out.command->kind() == CommandKind::Set;
    const double speed = set ? out.command->speed().value : 1.0;
    const config::FactorRange range = books.speeds(in.machine);
    // Edges that move take the speed along: that is nobody's change.
    const bool edge = range.low != range_.low || range.high != range_.high;
    range_ = range;
    bool change = set && !books.inForce;
    if (!set || edge || books.mayLeave) {
      way_ = 0;
      turn_ = speed;
    } else {
      const int way = speed > speed_ ? 1 : speed < speed_ ? -1 : way_;
      if (way != way_) turn_ = speed_;
      const bool away = (speed - 1.0) * way > 0.0 && (turn_ - 1.0) * way >= 0.0;
      change = change || (way_ != 0 && way != way_ && away && !books.bad);
      way_ = way;
    }
    speed_ = speed;
    for (int i = 0; i < out.eventCount; ++i) {
      const bool usedUp = out.events[static_cast<std::size_t>(i)].reason.code == ReasonCode::GateChangesPerMinute;
      if (!usedUp) continue;
      coolUntil_ = clock_ + limits_.coolDown.value;
      inCoolDown_ = 0;
    }
    if (!change || out.authority != Authority::Auto) return "";
    // The speed turns after the gate has decided: one of them may have been decided before.
    if (clock_ < coolUntil_ && ++inCoolDown_ > 1) return "changed the speed in the cool-down";
    while (!times_.empty() && clock_ - times_.front() >= 60.0) times_.pop_front();
    times_.push_back(clock_);
    return static_cast<int>(times_.size()) > limits_.changesPerMinute + 1 ? "more changes in a minute than allowed"
                                                                          : "";
  }

 private:
  void forget() {
    times_.clear();
    coolUntil_ = -1.0;
  }
  GateLimits limits_;
  double clock_ = 0.0, coolUntil_ = -1.0;
  double speed_ = 1.0, turn_ = 1.0;
  int way_ = 0, inCoolDown_ = 0;
  config::FactorRange range_;
  std::deque<double> times_;
};

}  // namespace stillcut::safety::testing
