// A gate on virtual time with an obedient machine behind it: what the gate commands is read back a few steps later, and
// the spindle follows. Tests bend any of it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

#include "core/safety/override_gate.h"

namespace stillcut::safety::testing {

// Moves are not judged by what came of them: most tests let it chatter wherever the machine goes.
inline GateLimits promptLimits() {
  GateLimits limits;
  limits.autoAllowed = true;
  limits.filter = Seconds(0.0);
  limits.reengageDelay = Seconds(0.1);
  limits.interventions.helpsWithin = limits.interventions.arrivesWithin = Seconds(1e9);
  limits.interventions.most = 1 << 20;
  return limits;
}
// They are.
inline GateLimits judgingLimits() {
  GateLimits limits = promptLimits();
  limits.interventions = {};
  return limits;
}

class GateHarness {
 public:
  static constexpr double kDt = 0.01;

  explicit GateHarness(const GateLimits& limits = promptLimits()) {
    gate.prepare(limits);
    machine.valid = machine.linkUp = machine.programRunning = machine.atSpeed = true;
    machine.programmedSpeed = Rpm(10000.0);
    machine.programmedFeed = fromMmPerMin(1000.0);
    machine.actualSpeed = Rpm(10000.0);
    verdict.valid = true;
    verdict.state = CutState::Stable;
    verdict.phase = CutPhase::Steady;
    verdict.frequency = Hertz(700.0);
    step();
  }

  // One block. Stamps what is fresh, lets the machine follow unless told otherwise.
  GateOutput step(std::initializer_list<OperatorInput> inputs = {}) {
    now += toDuration(Seconds(kDt));
    if (machineFollows) follow();
    GateInput in;
    in.now = now;
    in.dt = dt;
    if (freshMachine) machine.time = now;
    if (freshVerdict) verdict.time = now;
    if (freshRequest) request.time = now;
    in.machine = machine;
    in.verdict = verdict;
    in.request = request;
    in.vibration = vibration;
    in.strategyFailed = strategyFailed;
    const std::vector<OperatorInput> list(inputs);
    in.inputs = list;
    last = gate.step(in);
    if (last.command) commands.push_back(last.command->record());
    for (int i = 0; i < last.eventCount; ++i) events.push_back(last.events[static_cast<std::size_t>(i)]);
    flights += last.flight ? 1 : 0;
    if (last.flight) causes.push_back(last.flightCause.code);
    return last;
  }
  void run(double seconds) {
    for (int i = 0; i < std::lround(seconds / kDt); ++i) step();
  }
  GateOutput authority(Authority a) { return step({{OperatorAction::SetAuthority, a}}); }
  // An acceptance is of the advice that the last step showed.
  GateOutput act(OperatorAction a) { return step({{a, Authority::Off, last.adviceNumber}}); }

  void ask(double speed, double feedMmPerMin) {
    request.kind = RequestKind::Set;
    request.claimsSpeed = request.claimsFeed = true;
    request.speed = Rpm(speed);
    request.feed = fromMmPerMin(feedMmPerMin);
  }
  // Chatter, Auto, and a wish that has been reached.
  void settleAt(double speed, double feedMmPerMin) {
    verdict.state = CutState::Chatter;
    authority(Authority::Auto);
    ask(speed, feedMmPerMin);
    run(2.0);
  }
  bool said(ReasonCode code) const {
    for (const Event& e : events) {
      if (e.reason.code == code) return true;
    }
    return false;
  }
  bool released() const {
    for (const CommandRecord& c : commands) {
      if (c.kind == CommandKind::Release) return true;
    }
    return false;
  }
  // From command `first` on: away from where it stood by the rates, feed and speed in their order, and only then the
  // Release. With promptLimits() and an allowed feed per tooth of 1.
  void expectHomeByRamp(std::size_t first) const {
    const GateLimits l = promptLimits();
    std::size_t i = first + 1;
    for (; i < commands.size() && commands[i].kind == CommandKind::Set; ++i) {
      const CommandRecord &a = commands[i - 1], &b = commands[i];
      EXPECT_LE(std::abs(b.speed.value - a.speed.value), std::min(l.speedStep, l.speedSlew * kDt) + 1e-9) << i;
      EXPECT_LE(std::abs(b.feed.value - a.feed.value), std::min(l.feedStep, l.feedSlew * kDt) + 1e-9) << i;
      EXPECT_LE(std::abs(b.speed.value - 1.0), std::abs(a.speed.value - 1.0) + 1e-9) << i;
      EXPECT_LE(b.feed.value, std::min(a.speed.value, b.speed.value) + 1e-9) << "the feed never goes ahead, " << i;
    }
    ASSERT_LT(i, commands.size());
    EXPECT_GT(i, first + 2) << "at once";
    EXPECT_NEAR(commands[i - 1].speed.value, 1.0, 1e-4);
    EXPECT_NEAR(commands[i - 1].feed.value, 1.0, 1e-4);
    EXPECT_EQ(commands[i].kind, CommandKind::Release);
  }
  const CommandRecord& lastCommand() const { return commands.back(); }

  OverrideGate gate;
  MachineState machine;
  Verdict verdict;
  OverrideRequest request;
  Instant now{};
  Seconds dt{kDt};
  double vibration = -1.0;  // rms
  bool freshMachine = true, freshVerdict = true, freshRequest = true;
  bool strategyFailed = false;
  bool machineFollows = true;  // readback and spindle
  bool spindleStands = false;  // it does not, whatever is read back
  GateOutput last;
  std::vector<CommandRecord> commands;
  std::vector<Event> events;
  int flights = 0;
  std::vector<ReasonCode> causes;  // of the flights

 private:
  void follow() {
    constexpr std::size_t kDelay = 5;  // 50 ms, as van Dijk's machine
    const bool set = !commands.empty() && commands.back().kind == CommandKind::Set;
    delayed_.push_back(set ? Factors{commands.back().speed.value, commands.back().feed.value} : Factors{});
    if (delayed_.size() > kDelay) delayed_.pop_front();
    machine.speedOverride = Ratio(machine.operatorSpeed.value * delayed_.front().speed);
    machine.feedOverride = Ratio(machine.operatorFeed.value * delayed_.front().feed);
    if (!spindleStands) machine.actualSpeed += (machine.targetSpeed() - machine.actualSpeed) * 0.3;
  }
  std::deque<Factors> delayed_;
};

}  // namespace stillcut::safety::testing
