// A machine, an operator and a detector that mean ill: mostly plausible, so that the gate gets somewhere, and every so
// often anything at all. Deterministic in its seed.
#pragma once

#include <array>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/support/gate_books.h"

namespace stillcut::safety::testing {

class HostileWorld {
 public:
  explicit HostileWorld(std::uint64_t seed) : random_(seed) { calm(); }

  bool chance(double p) { return uniform(0.0, 1.0) < p; }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  double nonsense() {
    constexpr std::array<double, 10> kValues{std::numeric_limits<double>::quiet_NaN(),
                                             std::numeric_limits<double>::infinity(),
                                             -std::numeric_limits<double>::infinity(),
                                             0.0,
                                             -0.0,
                                             -1.0,
                                             1e308,
                                             -1e308,
                                             std::numeric_limits<double>::denorm_min(),
                                             1e9};
    return kValues[static_cast<std::size_t>(below(static_cast<int>(kValues.size())))];
  }

  GateLimits limits() {
    GateLimits l;
    l.autoAllowed = chance(0.8);
    l.overrides.lowestSpeed = Ratio(uniform(0.3, 0.95));
    l.overrides.highestSpeed = Ratio(uniform(1.0, 1.5));
    l.overrides.lowestFeed = Ratio(uniform(0.0, 0.95));
    l.overrides.highestFeed = Ratio(uniform(1.0, 1.5));
    l.overrides.feedPerTooth = chance(0.5) ? 1.0 : uniform(1.0, 1.5);
    if (chance(0.5)) l.overrides.lowestFeedPerTooth = uniform(0.0, 0.9);
    if (chance(0.3)) l.overrides.slowestFeed = fromMmPerMin(uniform(10.0, 1500.0));
    if (chance(0.3)) l.overrides.fastestFeed = l.overrides.slowestFeed + fromMmPerMin(uniform(10.0, 2000.0));
    if (chance(0.3)) l.overrides.slowest = Rpm(uniform(100.0, 8000.0));
    l.overrides.fastest = anotherCutter();
    failed_ = false;
    l.speedStep = uniform(0.001, 0.2);
    l.speedSlew = uniform(0.01, 5.0);
    l.feedStep = uniform(0.001, 0.5);
    l.feedSlew = uniform(0.01, 10.0);
    l.filter = Seconds(chance(0.5) ? 0.0 : uniform(0.0, 0.5));
    l.changesPerMinute = 1 + below(chance(0.5) ? 6 : 120);
    l.coolDown = Seconds(uniform(1.0, 5.0));
    l.holdTime = Seconds(uniform(0.0, 1.0));
    l.reengageDelay = Seconds(uniform(0.0, 0.3));
    l.operatorPause = Seconds(uniform(0.0, 1.0));
    l.takeTime = Seconds(uniform(0.1, chance(0.5) ? 1.0 : 10.0));
    l.followTime = Seconds(uniform(0.2, chance(0.5) ? 1.0 : 60.0));
    return l;
  }

  // The next step. The request is the caller's.
  void advance() {
    now_ += static_cast<std::int64_t>(uniform(1e6, 20e6));
    if (chance(0.001)) now_ += static_cast<std::int64_t>(uniform(-1e9, 1e9));
    if (chance(0.001)) now_ -= 10'000'000;
    if (chance(0.01)) calm();
    if (chance(0.004)) turnKnobs();
    if (chance(0.0005)) hang();
    if (chance(0.001)) program();
    if (chance(0.02)) verdict_.state = static_cast<CutState>(below(4));
    follow();
    inputs_ = 0;
    if (chance(0.01)) press();

    in = {};
    in.now = instantFromNs(now_);
    in.dt = Seconds(chance(0.002) ? nonsense() : uniform(0.001, 0.02));
    in.machine = machine_;
    in.machine.time = stamp(1.0);
    in.verdict = verdict_;
    in.verdict.time = stamp(1.0);
    if (chance(0.02)) vibration_ = uniform(0.1, 10.0);
    in.vibration = chance(0.01) ? nonsense() : vibration_;
    in.strategyFailed = failed_ = failed_ || chance(0.00005);
    if (chance(0.02)) bend(in.machine);
    if (chance(0.01)) bend(in.verdict);
    in.inputs = {list_.data(), static_cast<std::size_t>(inputs_)};
  }
  Instant stamp(double worst) {
    const double late = chance(0.01) ? uniform(-worst, worst) : uniform(0.0, 0.05);
    return instantFromNs(now_ - static_cast<std::int64_t>(late * 1e9));
  }
  void answered(const GateOutput& out) {
    const bool set = out.command && out.command->kind() == CommandKind::Set;
    advice_ = out.adviceNumber;
    if (!set && !out.command) return;
    if (chance(0.0002)) machine_.endedEngagement = out.command->engagement();
    ours_ = set ? std::array{out.command->speed().value, out.command->feed().value} : std::array{1.0, 1.0};
  }
  OverrideRequest wildRequest() {
    if (chance(0.02)) wish_ = {uniform(0.3, 1.8), uniform(0.1, 1.8)};
    if (chance(0.01)) wishKind_ = chance(0.8) ? RequestKind::Set : static_cast<RequestKind>(below(4));
    OverrideRequest r;
    r.time = stamp(1.0);
    r.kind = wishKind_;
    r.claimsSpeed = !chance(0.05);
    r.claimsFeed = !chance(0.05);
    r.speed = machine_.programmedSpeed * wish_[0];
    r.feed = machine_.programmedFeed * wish_[1];
    if (chance(0.005)) r.speed = Rpm(nonsense());
    if (chance(0.005)) r.feed = MetresPerSecond(nonsense());
    return r;
  }

  GateInput in;
  CutterLimits cutter;  // of the newest limits()

 private:
  void calm() {
    const Rpm speed = machine_.programmedSpeed.value > 0.0 ? machine_.programmedSpeed : Rpm(10000.0);
    machine_ = {};
    machine_.valid = machine_.linkUp = machine_.programRunning = machine_.atSpeed = true;
    machine_.programmedSpeed = speed;
    machine_.programmedFeed = fromMmPerMin(1000.0);
    machine_.actualSpeed = speed;
    verdict_ = {};
    verdict_.valid = true;
    verdict_.state = CutState::Chatter;
    verdict_.phase = CutPhase::Steady;
    verdict_.frequency = Hertz(uniform(100.0, 3000.0));
  }
  void program() {
    machine_.programmedSpeed = Rpm(uniform(1000.0, 30000.0));
    machine_.programmedFeed = fromMmPerMin(chance(0.1) ? 0.0 : uniform(10.0, 5000.0));
  }
  void turnKnobs() {
    machine_.operatorSpeed = Ratio(uniform(0.5, 1.3));
    machine_.operatorFeed = Ratio(chance(0.1) ? 0.0 : uniform(0.0, 1.5));
  }
  // For a while the machine does not do as it is told: the override is ignored or put back, or the spindle stands.
  void hang() {
    hangs_ = 50 + below(400);
    hung_ = below(3);
  }
  void follow() {
    const bool hangs = hangs_ > 0;
    hangs_ -= hangs ? 1 : 0;
    if (!hangs || hung_ != 0) {
      machine_.speedOverride = machine_.operatorSpeed * (hangs && hung_ == 1 ? 1.0 : ours_[0]);
      machine_.feedOverride = machine_.operatorFeed * (hangs && hung_ == 1 ? 1.0 : ours_[1]);
    }
    if (!hangs || hung_ != 2) machine_.actualSpeed += (machine_.targetSpeed() - machine_.actualSpeed) * 0.4;
  }
  void press() {
    using enum OperatorAction;
    constexpr std::array kRest{Refuse, BackToProgrammed, Hold, EndHold, EndHold, TrueAlarm, GrantBySimulation};
    inputs_ = 1 + below(4);
    for (int i = 0; i < inputs_; ++i) {
      OperatorInput& input = list_[static_cast<std::size_t>(i)];
      const double which = uniform(0.0, 1.0);
      input.action = which < 0.4 ? SetAuthority : which < 0.7 ? Accept : kRest[static_cast<std::size_t>(below(7))];
      input.advice = chance(0.8) ? advice_ : static_cast<std::uint32_t>(below(50));
      input.authority = chance(0.6) ? Authority::Auto : chance(0.7) ? Authority::Advise : Authority::Off;
    }
  }
  // What the makers allow, by the settings that a profile has.
  Rpm anotherCutter() {
    cutter = {};
    CutSetup setup;
    config::ParamSet params;
    const auto limit = [&](const config::ParamDecl& key, double low, double high) {
      const double value = uniform(low, high);
      if (!params.set(key, value, "world")) throw std::runtime_error("the world breaks its own rules");
      return value;
    };
    if (chance(0.3)) cutter.machine = Rpm(limit(config::kHighestSpeed, 8500.0, 25000.0));
    if (chance(0.3)) cutter.tool = Rpm(limit(config::kToolSpeed, 8500.0, 25000.0));
    if (chance(0.3)) cutter.holder = Rpm(limit(config::kHolderSpeed, 8500.0, 25000.0));
    if (chance(0.3)) {
      cutter.diameter = setup.toolDiameter = Metres(uniform(0.004, 0.02));
      const double slowest = 8500.0 / 60.0 * 3.1416 * cutter.diameter.value;  // m/s
      cutter.edge = MetresPerSecond(limit(config::kHighestCuttingSpeed, 60.0 * slowest, 200.0 * slowest) / 60.0);
    }
    return config::checkOverrideLimits(params, setup, "world").value().fastest;
  }
  void bend(MachineState& m) {
    switch (below(14)) {
      case 0:
        m.valid = false;
        break;
      case 1:
        m.linkUp = false;
        break;
      case 2:
        m.programRunning = false;
        break;
      case 3:
        m.feedHold = true;
        break;
      case 4:
        m.overridesEnabled = false;
        break;
      case 5:
        m.controlOurs = false;
        break;
      case 6:
        m.programmedSpeed = Rpm(nonsense());
        break;
      case 7:
        m.programmedFeed = MetresPerSecond(nonsense());
        break;
      case 8:
        m.operatorSpeed = Ratio(nonsense());
        break;
      case 9:
        m.operatorFeed = Ratio(nonsense());
        break;
      case 10:
        m.actualSpeed = Rpm(nonsense());
        break;
      case 11:
        m.speedOverride = Ratio(nonsense());
        break;
      case 12:
        m.atSpeed = false;
        break;
      default:
        m.time = chance(0.5) ? Instant::min() : Instant::max();
        break;
    }
  }
  void bend(Verdict& v) {
    switch (below(4)) {
      case 0:
        v.valid = false;
        break;
      case 1:
        v.frequency = Hertz(nonsense());
        break;
      case 2:
        v.severity = Ratio(nonsense());
        break;
      default:
        v.time = Instant::min();
        break;
    }
  }

  std::mt19937_64 random_;
  std::int64_t now_ = 1'000'000'000'000;
  MachineState machine_;
  Verdict verdict_;
  std::array<double, 2> ours_{1.0, 1.0};
  std::array<double, 2> wish_{0.9, 0.9};
  double vibration_ = 1.0;
  std::array<OperatorInput, 4> list_{};
  int inputs_ = 0;
  RequestKind wishKind_ = RequestKind::Set;
  std::uint32_t advice_ = 0;
  int hangs_ = 0, hung_ = 0;
  bool failed_ = false;
};

}  // namespace stillcut::safety::testing
