// Settings of the gate: what is refused, with which key, and what the ranges come to with the operator's knob.
#include "core/safety/gate_limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <utility>

namespace stillcut::safety {
namespace {

using ::testing::HasSubstr;

void expectRefused(const config::ParamSet& params, const CutSetup& setup, const char* key) {
  const auto limits = gateLimits(params, setup, "mill.toml");
  ASSERT_FALSE(limits.ok());
  EXPECT_THAT(limits.error().line(), HasSubstr(key));
  EXPECT_THAT(limits.error().line(), HasSubstr("mill.toml"));
}

const config::ParamDecl* declared(std::string_view key) {
  for (const config::ParamDecl* decl : gateParams()) {
    if (decl->key == key) return decl;
  }
  return nullptr;
}

MachineState machineAt(double programmed, double speedKnob = 1.0, double feedKnob = 1.0) {
  MachineState m;
  m.programmedSpeed = Rpm(programmed);
  m.programmedFeed = fromMmPerMin(1000.0);
  m.operatorSpeed = Ratio(speedKnob);
  m.operatorFeed = Ratio(feedKnob);
  return m;
}

TEST(GateLimits, DefaultsAreAccepted) {
  const auto limits = gateLimits({}, {}, "test");
  ASSERT_TRUE(limits.ok());
  EXPECT_FALSE(limits->autoAllowed);
  EXPECT_EQ(limits->overrides.lowestSpeed.value, 0.5);
  EXPECT_EQ(limits->overrides.highestSpeed.value, 1.2);
  EXPECT_EQ(limits->lease.value, 0.2);
  EXPECT_LE(limits->recoveryFraction, 0.2);
  // The struct's own defaults are the declared ones.
  const GateLimits plain;
  EXPECT_EQ(limits->speedSlew, plain.speedSlew);
  EXPECT_EQ(limits->feedSlew, plain.feedSlew);
  EXPECT_EQ(limits->holdTime.value, plain.holdTime.value);
  EXPECT_EQ(limits->reengageDelay.value, plain.reengageDelay.value);
  EXPECT_EQ(limits->changesPerMinute, plain.changesPerMinute);
  EXPECT_EQ(limits->coolDown.value, plain.coolDown.value);
  EXPECT_EQ(limits->takeTime.value, plain.takeTime.value);
  EXPECT_EQ(limits->verdictAge.value, plain.verdictAge.value);
}

TEST(GateLimits, EveryKeyIsDeclaredOnceAndItsDefaultIsInRange) {
  std::set<std::string_view> keys;
  for (const config::ParamDecl* decl : gateParams()) {
    EXPECT_TRUE(keys.insert(decl->key).second) << decl->key;
    EXPECT_EQ(decl->key.substr(0, 5), "gate.");
    EXPECT_FALSE(decl->meaning.empty());
    if (decl->mayBeAutomatic) continue;
    EXPECT_GE(decl->fallback, decl->lowest) << decl->key;
    EXPECT_LE(decl->fallback, decl->highest) << decl->key;
  }
}

TEST(GateLimits, ARangeOfOneHundredPercentAloneIsAnOverrideThatIsNotDriven) {
  config::ParamSet params;
  ASSERT_TRUE(params.set(config::kLowestSpeedOverride, 100, "t"));
  ASSERT_TRUE(params.set(config::kHighestSpeedOverride, 100, "t"));
  const auto limits = gateLimits(params, {}, "test");
  ASSERT_TRUE(limits.ok());
  const auto range = config::speedFactors(limits->overrides, machineAt(8000.0));
  EXPECT_EQ(range.low, 1.0);
  EXPECT_EQ(range.high, 1.0);
}

TEST(GateLimits, EmptyAndCrossedRangesAreRefused) {
  config::ParamSet params;
  ASSERT_TRUE(params.set(config::kLowestSpeed, 12000, "t"));
  ASSERT_TRUE(params.set(config::kHighestSpeed, 10000, "t"));
  expectRefused(params, {}, "gate.lowest-speed");
  EXPECT_FALSE(params.set(config::kLowestSpeedOverride, 130, "t"));  // 100 % is always inside
}

TEST(GateLimits, CuttingSpeedNeedsTheDiameterAndLimitsTheSpindle) {
  config::ParamSet params;
  ASSERT_TRUE(params.set(config::kHighestCuttingSpeed, 600, "t"));
  expectRefused(params, {}, "gate.highest-cutting-speed");
  CutSetup setup;
  setup.toolDiameter = Metres(0.010);
  const auto limits = gateLimits(params, setup, "test");
  ASSERT_TRUE(limits.ok());
  EXPECT_NEAR(limits->overrides.fastest.value, 600.0 / (std::numbers::pi * 0.010), 1e-6);
}

TEST(GateLimits, ALeaseShorterThanTwoBlocksIsRefused) {
  CutSetup setup;
  setup.rate = Hertz(1000.0);
  setup.blockFrames = 128;
  expectRefused({}, setup, "gate.lease");
}

// What is stale is a matter of how often the link reads.
TEST(GateLimits, AStateIsStaleAfterThreeOfTheLinksPeriods) {
  CutSetup setup;
  setup.rate = Hertz(10000.0);
  setup.blockFrames = 100;
  for (const double period : {0.005, 0.05, 0.1, 0.2, 0.5}) {
    const auto limits = gateLimits({}, setup, "test", Seconds(period));
    ASSERT_TRUE(limits.ok());
    EXPECT_NEAR(limits->machineAge.value, std::max(0.1, 3.0 * period) + 0.01, 1e-12);
  }
}

TEST(GateLimits, AnAgeThatTheLinkCannotKeepIsRefused) {
  config::ParamSet params;
  ASSERT_TRUE(params.set(*declared("gate.machine-age"), 100.0, "t"));
  const auto tooFine = gateLimits(params, {}, "mill.toml", Seconds(0.1));
  ASSERT_FALSE(tooFine.ok());
  EXPECT_THAT(tooFine.error().line(), HasSubstr("mill.toml: gate.machine-age"));
  EXPECT_THAT(tooFine.error().line(), HasSubstr("every 100 ms"));
  const auto good = gateLimits(params, {}, "mill.toml", Seconds(0.05));
  ASSERT_TRUE(good.ok());
  EXPECT_NEAR(good->machineAge.value, 0.1, 1e-12);  // as told
  config::ParamSet hasty;
  ASSERT_TRUE(hasty.set(*declared("gate.take-time"), 0.1, "t"));
  const auto tooSoon = gateLimits(hasty, {}, "mill.toml", Seconds(0.1));
  ASSERT_FALSE(tooSoon.ok());
  EXPECT_THAT(tooSoon.error().line(), HasSubstr("mill.toml: gate.take-time"));
}

// One value from both ends is no range, and no range at all is none either.
TEST(GateLimits, AMachineWithoutRoomIsRefusedUnlessItHasNoOverrideAtAll) {
  const auto narrowed = [](double low, double high) {
    config::ParamSet params;
    return config::narrowToMachine(params, {Ratio(low), Ratio(high), Ratio(1.0), Ratio(1.0)}, "Mill 3");
  };
  EXPECT_TRUE(narrowed(1.0, 1.0).ok());
  for (const auto& [low, high] : {std::pair{0.8, 0.8}, {1.2, 1.2}, {0.0, 0.0}, {1.2, 0.5}, {1.1, 0.9}}) {
    const Status status = narrowed(low, high);
    ASSERT_FALSE(status.ok()) << low << " " << high;
    EXPECT_THAT(status.error().line(), HasSubstr("gate."));
    EXPECT_THAT(status.error().line(), HasSubstr("Mill 3"));
  }
}

TEST(GateLimits, TheMachinesOwnOverrideNarrows) {
  config::ParamSet params;
  ASSERT_TRUE(config::narrowToMachine(params, {Ratio(0.8), Ratio(1.1), Ratio(0.0), Ratio(1.0)}, "Mill 3"));
  const auto limits = gateLimits(params, {}, "test");
  ASSERT_TRUE(limits.ok());
  EXPECT_NEAR(limits->overrides.lowestSpeed.value, 0.8, 1e-12);
  EXPECT_NEAR(limits->overrides.highestFeed.value, 1.0, 1e-12);
  EXPECT_NEAR(limits->overrides.lowestFeed.value, 0.5, 1e-12);
  EXPECT_TRUE(config::narrowToMachine(params, {Ratio(1.0), Ratio(1.0), Ratio(0.0), Ratio(1.0)}, "Mill 3").ok());
  EXPECT_EQ(gateLimits(params, {}, "test")->overrides.lowestSpeed.value, 1.0);  // a machine without that override
  EXPECT_FALSE(config::narrowToMachine(params, {Ratio(0.5), Ratio(0.9), Ratio(0.0), Ratio(1.0)}, "Mill 3").ok());
}

TEST(OverrideRanges, OneHundredPercentIsAlwaysInside) {
  config::OverrideLimits limits;
  limits.slowest = Rpm(5000.0);
  limits.fastest = Rpm(11000.0);
  limits.slowestFeed = fromMmPerMin(800.0);
  limits.fastestFeed = fromMmPerMin(1100.0);
  limits.lowestFeedPerTooth = 0.8;
  for (const double programmed : {100.0, 5000.0, 10000.0, 11000.0, 50000.0}) {
    for (const double knob : {0.0, 0.1, 0.5, 1.0, 1.2, 2.0}) {
      const config::FactorRange s = speedFactors(limits, machineAt(programmed, knob, knob));
      EXPECT_TRUE(s.contains(1.0));
      EXPECT_TRUE(feedFactors(limits, machineAt(programmed, knob, knob)).contains(1.0));
      EXPECT_GE(s.low * limits.feedPerTooth, feedFactors(limits, machineAt(programmed, knob, knob)).low - 1e-12);
      EXPECT_LE(s.high * limits.lowestFeedPerTooth,
                feedFactors(limits, machineAt(programmed, knob, knob)).high + 1e-12);
    }
  }
  // Where the operator alone is inside, so is the product at both edges.
  limits.slowestFeed = MetresPerSecond(0.0);
  limits.lowestFeedPerTooth = 0.0;
  const config::FactorRange s = speedFactors(limits, machineAt(10000.0, 0.9));
  EXPECT_NEAR(s.low * 0.9, 0.5, 1e-12);
  EXPECT_NEAR(s.high * 9000.0, 10800.0, 1e-9);  // 120 % of the knob's base is below 11 000
}

TEST(OverrideRanges, ReachableSpeedsAreTheProduct) {
  const config::SpeedRange range = config::reachableSpeeds({}, machineAt(35000.0));
  EXPECT_NEAR(range.low.value, 17500.0, 1e-9);
  EXPECT_NEAR(range.high.value, 42000.0, 1e-9);
}

}  // namespace
}  // namespace stillcut::safety
