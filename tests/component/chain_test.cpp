// The chain's promises: a detector that fails hands over to its second, a strategy that fails lets go, a number that is
// none never reaches the gate.

#include "core/pipeline/chain.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/component/scripted_parts.h"

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

TEST(Chain, StrategyThatThrowsAsksForRelease) {
  Chain chain(test::scriptedChain([](const auto&) { return test::stableVerdict(); },
                                  [](const auto&) -> OverrideRequest { throw std::runtime_error("broken"); }));
  chain.prepare(test::setup(), {}, {});
  const Chain::Step& step = chain.process(stepInput(0));
  EXPECT_TRUE(step.strategyFailed);
  EXPECT_EQ(step.output.request.kind, RequestKind::Release);
  EXPECT_FALSE(step.output.hasCommand && step.output.command.kind == CommandKind::Set);
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

TEST(Chain, RefusesAnImpossibleLineUp) {
  EXPECT_THROW(Chain(ChainParts{}), std::runtime_error);
  ChainParts parts = test::scriptedChain();
  parts.inCharge = 1;
  EXPECT_THROW(Chain(std::move(parts)), std::runtime_error);
}

}  // namespace
}  // namespace stillcut::pipeline
