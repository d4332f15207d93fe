// The chain's promises: a detector that fails hands over to its second, a strategy that fails lets go, a number that is
// none never reaches the gate.

#include "core/pipeline/chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "tests/support/scripted_parts.h"

namespace stillcut::pipeline {
namespace {

StepInput stepInput(int number) {
  StepInput in;
  in.block.allocate(1, test::kFrames);
  test::ScriptedSource source(number + 1);
  for (int i = 0; i <= number; ++i) EXPECT_TRUE(source.read(in));
  return in;
}

ChainParts twoDetectors(test::ScriptedDetector::Script first) {
  ChainParts parts = test::scriptedChain(std::move(first));
  parts.detectors.push_back(
      std::make_unique<test::ScriptedDetector>([](const auto&) { return test::stableVerdict(); }));
  parts.fallback = 1;
  return parts;
}

TEST(Chain, DetectorThatThrowsHandsOverToItsSecond) {
  Chain chain(twoDetectors([](const auto&) -> Verdict { throw std::runtime_error("broken"); }));
  chain.prepare(test::setup(), {}, {});
  const Chain::Step& step = chain.process(stepInput(0));
  EXPECT_TRUE(step.detectorFailed);
  EXPECT_EQ(step.output.inCharge, 1);
  EXPECT_FALSE(step.output.verdicts[0].valid);
  EXPECT_EQ(step.output.verdicts[0].reason.code, ReasonCode::DetectorFault);
  EXPECT_TRUE(step.output.verdicts[1].valid);
}

// The gate gives nothing away, and the advice is there all the same.
TEST(Chain, WithoutAMachineTheAdviceIsMadeOfWhatWasSetUp) {
  ChainParts parts = test::scriptedChain([](const auto&) {
    Verdict v = test::stableVerdict();
    v.state = CutState::Chatter;
    v.frequency = Hertz(1250.0);
    v.severity = Ratio(0.6);
    return v;
  });
  parts.strategy = std::make_unique<control::StablePocket>();
  Chain chain(std::move(parts));
  CutSetup setup = test::setup();
  setup.teeth = 4;
  setup.nominalSpeed = Rpm(8500.0);
  chain.prepare(setup, {}, {});
  SpeedAdvice advice;
  for (int k = 0; k < 200; ++k) {
    StepInput in = stepInput(k);
    in.machine = {};
    const Chain::Step& step = chain.process(in);
    advice = step.advice;
    EXPECT_FALSE(step.output.hasCommand);
    for (int e = 0; e < step.output.eventCount; ++e) {
      EXPECT_NE(step.output.events[static_cast<std::size_t>(e)].reason.code, ReasonCode::LinkLost) << "there is none";
    }
  }
  ASSERT_EQ(advice.kind, SpeedAdvice::Kind::Speed);
  EXPECT_NEAR(advice.speed.value, 60.0 * 1250.0 / (2 * 4), 100.0) << "60 f / (p Z), van Dijk 2010 eq. 30";
}

TEST(Chain, VerdictWithANumberThatIsNoneIsAFault) {
  Chain chain(twoDetectors([](const auto&) {
    Verdict v = test::stableVerdict();
    v.frequency = Hertz(std::numeric_limits<double>::quiet_NaN());
    return v;
  }));
  chain.prepare(test::setup(), {}, {});
  EXPECT_EQ(chain.process(stepInput(0)).output.inCharge, 1);
}

TEST(Chain, WithoutASecondAFaultMeansNoVerdictRatherThanStable) {
  Chain chain(test::scriptedChain([](const auto&) -> Verdict { throw 1; }));
  chain.prepare(test::setup(), {}, {});
  const Chain::Step& step = chain.process(stepInput(0));
  EXPECT_EQ(step.output.inCharge, 0);
  EXPECT_FALSE(step.output.verdicts[0].valid);
}

// Whatever call of a method throws: the run goes on, with its second or with a verdict that says so.
TEST(Chain, AMethodMayThrowInAnyOfItsCalls) {
  static constexpr config::ParamDecl kKnob =
      config::realParam("test.knob", "Knob", "1", 1.0, 0.0, 10.0, "A number that changes while it runs");
  for (const char* const where : {"process", "retune", "reset", "strategy.retune", "relinquish", "decide"}) {
    SCOPED_TRACE(where);
    const std::string broken = where;
    const auto breakIn = [&broken](const char* call) {
      if (broken == call) throw std::bad_alloc();
    };
    ChainParts parts = test::scriptedChain({}, {});
    auto first = std::make_unique<test::ScriptedDetector>([&](const auto&) {
      if (broken == "process" || broken == "reset") throw std::bad_alloc();
      return test::stableVerdict();
    });
    first->onRetune = [&] { breakIn("retune"); };
    first->onReset = [&] { breakIn("reset"); };
    auto strategy = std::make_unique<test::ScriptedStrategy>([&](const control::StrategyInput&) {
      breakIn("decide");
      return OverrideRequest{};
    });
    strategy->onRetune = [&] { breakIn("strategy.retune"); };
    strategy->onRelinquish = [&] { breakIn("relinquish"); };
    parts.detectors.clear();
    parts.detectors.push_back(std::move(first));
    parts.detectors.push_back(
        std::make_unique<test::ScriptedDetector>([](const auto&) { return test::stableVerdict(); }));
    parts.fallback = 1;
    parts.strategy = std::move(strategy);
    parts.tunable = {&kKnob};
    Chain chain(std::move(parts));
    chain.prepare(test::setup(), {}, {});
    bool strategyFailed = false;
    for (int k = 0; k < 5; ++k) {
      StepInput in = stepInput(k);
      in.inputs[0] = {OperatorAction::SetParameter, Authority::Off, 0, config::parameterId(kKnob.key), 2.0 + k};
      in.inputs[1] = {OperatorAction::BackToProgrammed, Authority::Off};
      in.inputCount = 2;
      const Chain::Step& step = chain.process(in);
      strategyFailed = step.strategyFailed;
      EXPECT_TRUE(step.output.verdicts[static_cast<std::size_t>(step.output.inCharge)].valid);
    }
    const bool ofTheDetector = broken == "process" || broken == "retune" || broken == "reset";
    EXPECT_EQ(chain.inCharge(), ofTheDetector ? 1 : 0);
    EXPECT_EQ(strategyFailed, !ofTheDetector);
  }
}

TEST(Chain, AStrategyThatThrowsIsNeverAskedAgain) {
  int asked = 0;
  Chain chain(test::scriptedChain([](const auto&) { return test::stableVerdict(); },
                                  [&](const auto&) -> OverrideRequest {
                                    ++asked;
                                    throw std::runtime_error("broken");
                                  }));
  chain.prepare(test::setup(), {}, {});
  int told = 0;
  for (int i = 0; i < 5; ++i) {
    const Chain::Step& step = chain.process(stepInput(i));
    EXPECT_TRUE(step.strategyFailed);
    EXPECT_EQ(step.output.request.kind, RequestKind::None);
    EXPECT_EQ(step.output.request.reason.code, ReasonCode::MonitoringAt);
    told += step.output.eventCount;
  }
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(told, 1);
  safety::FlightRecording flight;
  ASSERT_TRUE(chain.flights().take(flight));
  EXPECT_EQ(flight.cause.code, ReasonCode::StrategyFault);
  EXPECT_FALSE(chain.flights().take(flight));
  chain.prepare(test::setup(), {}, {});
  chain.process(stepInput(0));
  EXPECT_EQ(asked, 2);
}

// Counts how often it was told that the machine has another author.
class Owned final : public control::Strategy {
 public:
  explicit Owned(int& told) : told_(told) {}
  control::StrategyInfo describe() const override { return {"owned", "Owned", "test"}; }
  void prepare(const CutSetup& /*setup*/, const config::ParamSet& /*params*/) override {}
  OverrideRequest decide(const control::StrategyInput& /*input*/) override { return {}; }
  void reset() noexcept override {}
  void relinquish() noexcept override { ++told_; }

 private:
  int& told_;
};

// What is in force keeps its author when authority is asked for that is there already, or that the gate refuses.
TEST(Chain, AStrategyIsToldOfAnotherAuthorityOnlyWhereThereIsOne) {
  int told = 0;
  ChainParts parts = test::scriptedChain();
  parts.strategy = std::make_unique<Owned>(told);
  Chain chain(std::move(parts));
  auto ask = [&, number = 0](const OperatorInput& input) mutable {
    StepInput in = stepInput(number++);
    in.inputCount = 1;
    in.inputs[0] = input;
    chain.process(in);
    return told;
  };
  safety::GateLimits limits;
  chain.prepare(test::setup(), {}, limits);
  EXPECT_EQ(ask({OperatorAction::SetAuthority, Authority::Off}), 0);
  EXPECT_EQ(ask({OperatorAction::SetAuthority, Authority::Advise}), 1);
  EXPECT_EQ(ask({OperatorAction::SetAuthority, Authority::Advise}), 1);
  EXPECT_EQ(ask({OperatorAction::SetAuthority, Authority::Auto}), 1) << "nobody has allowed it";
  EXPECT_EQ(ask({OperatorAction::GrantBySimulation, Authority::Off}), 1) << "nor that";
  EXPECT_EQ(ask({OperatorAction::BackToProgrammed, Authority::Off}), 2);
}

TEST(Chain, AStrategyThatThrowsLosesTheMachineInThatBlock) {
  bool broken = false;
  Chain chain(test::scriptedChain(
      [](const auto&) {
        Verdict v = test::stableVerdict();
        v.state = CutState::Chatter;
        return v;
      },
      [&](const control::StrategyInput& in) {
        if (broken) throw std::runtime_error("broken");
        OverrideRequest r;
        r.time = in.now;
        r.kind = RequestKind::Set;
        r.claimsSpeed = true;
        r.speed = Rpm(5500.0);
        return r;
      }));
  safety::GateLimits limits;
  limits.autoAllowed = true;
  chain.prepare(test::setup(), {}, limits);
  auto step = [&, number = 0](bool grant) mutable -> const Chain::Step& {
    StepInput in = stepInput(number++);
    in.machine.time = in.block.end();
    in.machine.valid = in.machine.linkUp = in.machine.programRunning = in.machine.atSpeed = true;
    in.machine.programmedSpeed = in.machine.actualSpeed = Rpm(6000.0);
    in.inputCount = grant ? 1 : 0;
    in.inputs[0] = {OperatorAction::SetAuthority, Authority::Auto};
    return chain.process(in);
  };
  for (int i = 0; i < 20; ++i) step(i == 1);
  ASSERT_EQ(step(false).output.command.kind, CommandKind::Set);
  broken = true;
  // The way home, which no wish interrupts, and then nothing more.
  double speed = 0.0;
  for (int i = 0; i < 200; ++i) {
    const StepOutput& after = step(false).output;
    if (!after.hasCommand || after.command.kind == CommandKind::Release) break;
    EXPECT_GE(after.command.speed.value, speed);
    speed = after.command.speed.value;
  }
  EXPECT_NEAR(speed, 1.0, 1e-4);
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(step(false).output.hasCommand);
}

// A good machine, and what the operator does in this step.
class GivenFeed final : public MachineStateSource {
 public:
  void complete(StepInput& step) noexcept override {
    step.machine = MachineState{};
    step.machine.time = step.block.end();
    step.machine.valid = step.machine.linkUp = step.machine.programRunning = step.machine.atSpeed = true;
    step.machine.programmedSpeed = step.machine.actualSpeed = Rpm(6000.0);
    step.inputCount = count;
    step.inputs = inputs;
  }
  int count = 0;
  std::array<OperatorInput, kMaxInputsPerStep> inputs{};
};

class LastOutput final : public StepTap {
 public:
  bool push(const StepInput& /*input*/, const StepOutput& output) noexcept override {
    events.assign(output.events.begin(), output.events.begin() + output.eventCount);
    return true;
  }
  std::vector<Event> events;
};

TEST(StepLoop, LinesThatFoundNoRoomAreCountedInTheNextStep) {
  bool broken = false;
  Chain chain(test::scriptedChain([](const auto&) { return test::stableVerdict(); },
                                  [&](const auto&) -> OverrideRequest {
                                    if (broken) throw std::runtime_error("broken");
                                    return {};
                                  }));
  safety::GateLimits limits;
  limits.autoAllowed = true;
  chain.prepare(test::setup(), {}, limits);
  SteadyClock clock;
  rt::Mailbox<OverrideCommand> commands;
  GivenFeed feed;
  LastOutput tap;
  StepLoop loop({chain, feed, commands, nullptr, &tap, clock});
  auto step = [&, number = 0]() mutable {
    StepInput in = stepInput(number++);
    loop.step(in);
  };
  step();
  feed.count = 4;
  feed.inputs[0] = feed.inputs[2] = {OperatorAction::GrantBySimulation};
  feed.inputs[1] = feed.inputs[3] = {OperatorAction::BackToProgrammed};
  broken = true;  // a ninth line
  step();
  feed.count = 0;
  EXPECT_EQ(tap.events.size(), static_cast<std::size_t>(safety::kMaxGateEvents));
  EXPECT_EQ(tap.events.back().reason.code, ReasonCode::StrategyFault);
  step();
  ASSERT_EQ(tap.events.size(), 1U);
  EXPECT_EQ(tap.events[0].reason.code, ReasonCode::EventsLost);
  EXPECT_EQ(tap.events[0].reason.n[0], 1.0);
  step();
  EXPECT_TRUE(tap.events.empty());
}

TEST(Chain, ADetectorThatFailsIsSaidOnceAndKeepsAFlight) {
  Chain chain(twoDetectors([](const auto&) -> Verdict { throw std::runtime_error("broken"); }));
  chain.prepare(test::setup(), {}, {});
  int told = 0;
  for (int i = 0; i < 5; ++i) {
    const StepOutput& out = chain.process(stepInput(i)).output;
    told += out.eventCount;
    EXPECT_TRUE(out.eventCount == 0 || out.events[0].reason.code == ReasonCode::DetectorFault);
  }
  EXPECT_EQ(told, 1);
  safety::FlightRecording flight;
  ASSERT_TRUE(chain.flights().take(flight));
  EXPECT_EQ(flight.cause.code, ReasonCode::DetectorFault);
  EXPECT_FALSE(chain.flights().take(flight));
}

TEST(Chain, StrategySeesMeasuredTime) {
  std::vector<double> dts;
  Chain chain(test::scriptedChain([](const auto&) { return test::stableVerdict(); },
                                  [&](const control::StrategyInput& in) {
                                    dts.push_back(in.dt.value);
                                    return OverrideRequest{};
                                  }));
  chain.prepare(test::setup(), {}, {});
  chain.process(stepInput(0));
  chain.process(stepInput(3));  // two blocks were lost in between
  const double block = test::kFrames / test::kRate;
  ASSERT_EQ(dts.size(), 2U);
  EXPECT_NEAR(dts[0], block, 1e-9);
  EXPECT_NEAR(dts[1], 3.0 * block, 1e-9);
}

TEST(Chain, HandsOnTheIndicatorsThatStrategiesWeighFromWhicheverDetectorNamesThem) {
  static constexpr std::string_view kNames[] = {"floor", "gamma_max", "energy", "h"};
  control::StrategyInput seen;
  bool valid = true;
  ChainParts parts = test::scriptedChain([](const auto&) { return test::stableVerdict(); },
                                         [&](const control::StrategyInput& in) {
                                           seen = in;
                                           return OverrideRequest{};
                                         });
  parts.detectors.push_back(std::make_unique<test::ScriptedDetector>(
      [&](const auto&) {
        Verdict v = test::stableVerdict();
        v.valid = valid;
        v.indicators = {7.0, 0.9, 3.5, 12.0};
        return v;
      },
      kNames));
  Chain chain(std::move(parts));
  chain.prepare(test::setup(), {}, {});
  chain.process(stepInput(0));
  EXPECT_EQ(seen.coherence, 0.9);
  EXPECT_EQ(seen.energy, 3.5);
  EXPECT_EQ(seen.perturbation, 12.0);
  EXPECT_EQ(seen.verdict.indicators[0], 0.0) << "the verdict is that of the detector in charge";
  valid = false;
  chain.process(stepInput(1));
  EXPECT_LT(seen.coherence, 0.0);
  EXPECT_LT(seen.energy, 0.0);
  EXPECT_LT(seen.perturbation, 0.0);
}

// A target of before "Back to 100 %" may not come back with the next grant.
TEST(Chain, WhatAStrategyAskedForEndsWhenTheOperatorTakesTheMachineBack) {
  int told = 0;
  ChainParts parts = test::scriptedChain();
  parts.strategy = std::make_unique<Owned>(told);
  Chain chain(std::move(parts));
  chain.prepare(test::setup(), {}, {});
  StepInput in = stepInput(0);
  chain.process(in);
  EXPECT_EQ(told, 0);
  in = stepInput(1);
  in.inputCount = 2;
  in.inputs[0] = {OperatorAction::Hold};
  in.inputs[1] = {OperatorAction::BackToProgrammed};
  chain.process(in);
  EXPECT_EQ(told, 1);
  in = stepInput(2);
  in.inputCount = 1;
  in.inputs[0] = {OperatorAction::SetAuthority, Authority::Advise};
  chain.process(in);
  EXPECT_EQ(told, 2);
}

TEST(Chain, RefusesAnImpossibleLineUp) {
  EXPECT_THROW(Chain(ChainParts{}), std::runtime_error);
  ChainParts parts = test::scriptedChain();
  parts.inCharge = 1;
  EXPECT_THROW(Chain(std::move(parts)), std::runtime_error);
}

// 6000 rpm is 100 turns a second; the machine says so, except in one block.
TEST(Chain, OneImpossibleReadOfTheMachineDoesNotPoisonWhatFollows) {
  const double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {kInfinity, -1.0, 1e12, std::numeric_limits<double>::quiet_NaN()}) {
    double angle = 0.0, spindle = 0.0, feed = 0.0, told = 0.0;
    Chain chain(test::scriptedChain(
        [&](const detect::ConditionedBlock& block) {
          angle = block.angle[block.frames - 1];
          spindle = block.spindle.value;
          feed = block.feed.value;
          return test::stableVerdict();
        },
        [&](const control::StrategyInput& in) {
          told = in.machine.actualSpeed.value;
          return OverrideRequest{};
        }));
    chain.prepare(test::setup(), {}, {});
    for (int i = 0; i < 20; ++i) {
      StepInput in = stepInput(i);
      in.machine.time = in.block.end();
      in.machine.valid = in.machine.linkUp = in.machine.programRunning = true;
      in.machine.programmedSpeed = in.machine.actualSpeed = Rpm(6000.0);
      in.machine.actualFeed = MetresPerSecond(0.02);
      if (i == 10) {
        in.machine.actualSpeed = Rpm(bad);
        in.machine.actualFeed = MetresPerSecond(bad);
      }
      EXPECT_TRUE(chain.process(in).output.verdicts[0].valid);
      EXPECT_TRUE(std::isfinite(angle) && std::isfinite(spindle) && std::isfinite(feed)) << bad << " at " << i;
      EXPECT_EQ(told, i == 10 ? 0.0 : 6000.0);
    }
    EXPECT_NEAR(spindle, 100.0, 3.0);
    EXPECT_NEAR(feed, 0.02, 1e-12);
  }
}

TEST(Chain, AFlightIsNamedAfterItsCause) {
  Chain chain(test::scriptedChain());
  chain.prepare(test::setup(), {}, {});
  StepInput in = stepInput(0);
  in.inputCount = 1;
  in.inputs[0] = {OperatorAction::SetAuthority, Authority::Advise};
  chain.process(in);
  safety::FlightRecording flight;
  ASSERT_TRUE(chain.flights().take(flight));
  EXPECT_EQ(flight.cause.code, ReasonCode::AuthorityChanged);
}

}  // namespace
}  // namespace stillcut::pipeline
