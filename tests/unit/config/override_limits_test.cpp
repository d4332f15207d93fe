// How far the overrides may go: every key narrows, contradictions are refused, and whatever the knobs show there is
// always a way back to the programmed values.
#include "core/config/override_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stillcut::config {
namespace {

CutSetup setupWith(Metres diameter) {
  CutSetup setup;
  setup.toolDiameter = diameter;
  return setup;
}

ParamSet with(const ParamDecl& decl, double value) {
  ParamSet params;
  EXPECT_TRUE(params.set(decl, value, "test").ok());
  return params;
}

std::string refusal(const ParamSet& params, const CutSetup& setup = {}) {
  const auto limits = checkOverrideLimits(params, setup, "mill.toml");
  EXPECT_FALSE(limits.ok());
  return limits.ok() ? "" : limits.error().line();
}

MachineState machineAt(double rpm, double feed, double speedKnob, double feedKnob) {
  MachineState m;
  m.programmedSpeed = Rpm(rpm);
  m.programmedFeed = MetresPerSecond(feed);
  m.operatorSpeed = Ratio(speedKnob);
  m.operatorFeed = Ratio(feedKnob);
  return m;
}

TEST(OverrideLimits, DefaultsAreTheDeclaredOnes) {
  const auto limits = checkOverrideLimits({}, {}, "test");
  ASSERT_TRUE(limits.ok());
  EXPECT_DOUBLE_EQ(limits->lowestSpeed.value, kLowestSpeedOverride.fallback / 100.0);
  EXPECT_DOUBLE_EQ(limits->highestSpeed.value, kHighestSpeedOverride.fallback / 100.0);
  EXPECT_DOUBLE_EQ(limits->lowestFeed.value, kLowestFeedOverride.fallback / 100.0);
  EXPECT_DOUBLE_EQ(limits->highestFeed.value, kHighestFeedOverride.fallback / 100.0);
  EXPECT_EQ(limits->slowest.value, 0.0);
  EXPECT_TRUE(std::isinf(limits->fastest.value));
}

TEST(OverrideLimits, TheLowestOfMachineToolAndHolderCounts) {
  ParamSet params;
  ASSERT_TRUE(params.set(kHighestSpeed, 12000.0, "test").ok());
  ASSERT_TRUE(params.set(kToolSpeed, 9000.0, "test").ok());
  ASSERT_TRUE(params.set(kHolderSpeed, 15000.0, "test").ok());
  EXPECT_EQ(checkOverrideLimits(params, {}, "test")->fastest.value, 9000.0);
  // 200 m/min at 10 mm: v / (pi d).
  ASSERT_TRUE(params.set(kHighestCuttingSpeed, 200.0, "test").ok());
  const auto limits = checkOverrideLimits(params, setupWith(Metres(0.010)), "test");
  ASSERT_TRUE(limits.ok());
  EXPECT_NEAR(limits->fastest.value, 200.0 / (kTwoPi / 2.0 * 0.010), 1e-9);
}

TEST(OverrideLimitsErrors, NameTheKey) {
  EXPECT_NE(refusal(with(kHighestCuttingSpeed, 200.0)).find("gate.highest-cutting-speed"), std::string::npos);
  ParamSet crossed = with(kLowestSpeed, 9000.0);
  ASSERT_TRUE(crossed.set(kHighestSpeed, 9000.0, "test").ok());
  EXPECT_NE(refusal(crossed).find("gate.lowest-speed"), std::string::npos);
  ParamSet feeds = with(kLowestFeed, 500.0);
  ASSERT_TRUE(feeds.set(kHighestFeed, 400.0, "test").ok());
  EXPECT_NE(refusal(feeds).find("gate.lowest-feed"), std::string::npos);
}

TEST(OverrideLimits, AMachineWithoutAnOverrideIsNoMistake) {
  ParamSet params = with(kLowestFeedOverride, 100.0);
  ASSERT_TRUE(params.set(kHighestFeedOverride, 100.0, "test").ok());
  const auto limits = checkOverrideLimits(params, {}, "test");
  ASSERT_TRUE(limits.ok());
  EXPECT_EQ(limits->lowestFeed, limits->highestFeed);
}

TEST(NarrowToMachine, OnlyEverNarrows) {
  std::mt19937 random(2);
  const auto percent = [&](int from, int to) { return from + static_cast<double>(random() % unsigned(to - from + 1)); };
  for (int trial = 0; trial < 500; ++trial) {
    ParamSet params;
    ASSERT_TRUE(params.set(kLowestSpeedOverride, percent(20, 90), "test").ok());
    ASSERT_TRUE(params.set(kHighestSpeedOverride, percent(110, 180), "test").ok());
    const double low = params.real(kLowestSpeedOverride), high = params.real(kHighestSpeedOverride);
    MachineOverrides machine;
    machine.lowestSpeed = Ratio(percent(10, 99) / 100.0);
    machine.highestSpeed = Ratio(percent(101, 200) / 100.0);
    machine.lowestFeed = Ratio(0.0);
    machine.highestFeed = Ratio(2.0);
    ASSERT_TRUE(narrowToMachine(params, machine, "test").ok());
    EXPECT_DOUBLE_EQ(params.real(kLowestSpeedOverride), std::max(low, 100.0 * machine.lowestSpeed.value));
    EXPECT_DOUBLE_EQ(params.real(kHighestSpeedOverride), std::min(high, 100.0 * machine.highestSpeed.value));
    EXPECT_DOUBLE_EQ(params.real(kLowestFeedOverride), kLowestFeedOverride.fallback);
    EXPECT_DOUBLE_EQ(params.real(kHighestFeedOverride), kHighestFeedOverride.fallback);
  }
}

TEST(NarrowToMachine, RefusesAMachineThatCannotReachTheRange) {
  ParamSet params;
  MachineOverrides machine;
  machine.lowestSpeed = Ratio(0.3);
  machine.highestSpeed = Ratio(0.4);  // a machine that can only go slower than is allowed
  const Status status = narrowToMachine(params, machine, "link");
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().line().find("gate.lowest-speed-override"), std::string::npos);
}

// Over random limits, knobs and programmes.
class FactorRanges : public testing::Test {
 protected:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  OverrideLimits limits() {
    OverrideLimits l;
    l.lowestSpeed = Ratio(between(0.2, 1.0));
    l.highestSpeed = Ratio(between(1.0, 1.8));
    l.lowestFeed = Ratio(between(0.0, 1.0));
    l.highestFeed = Ratio(between(1.0, 1.8));
    if (random_() % 2 == 0) l.slowest = Rpm(between(0.0, 6000.0));
    if (random_() % 2 == 0) l.fastest = Rpm(between(6001.0, 20000.0));
    if (random_() % 2 == 0) l.slowestFeed = MetresPerSecond(between(0.0, 0.02));
    if (random_() % 2 == 0) l.fastestFeed = MetresPerSecond(between(0.021, 0.1));
    l.feedPerTooth = between(1.0, 1.4);
    l.lowestFeedPerTooth = between(0.0, 0.9);
    return l;
  }
  MachineState machine() {
    const double knob = random_() % 8 == 0 ? 0.0 : between(0.3, 1.6);
    return machineAt(between(0.0, 15000.0), between(0.0, 0.08), between(0.4, 1.5), knob);
  }
  std::mt19937 random_{7};
};

TEST_F(FactorRanges, AlwaysHoldTheWayBack) {
  for (int trial = 0; trial < 20000; ++trial) {
    const OverrideLimits l = limits();
    const MachineState m = machine();
    const FactorRange speed = speedFactors(l, m);
    const FactorRange feed = feedFactors(l, m);
    ASSERT_TRUE(speed.contains(1.0)) << speed.low << " " << speed.high;
    ASSERT_TRUE(feed.contains(1.0)) << feed.low << " " << feed.high;
    ASSERT_GE(speed.low, 0.0);
    ASSERT_TRUE(std::isfinite(speed.high) && std::isfinite(feed.high));
  }
}

// Whatever factor is taken inside: neither it nor its product with the knob goes further out than the limits allow, or
// than programme and operator went by themselves.
TEST_F(FactorRanges, NeverDriveFurtherOutThanTheLimits) {
  for (int trial = 0; trial < 20000; ++trial) {
    const OverrideLimits l = limits();
    const MachineState m = machine();
    const FactorRange range = speedFactors(l, m);
    const double knob = m.operatorSpeed.value;
    const Rpm base = m.programmedSpeed * knob;
    for (double share : {0.0, 0.3, 1.0}) {
      const double factor = range.low + share * (range.high - range.low);
      EXPECT_GE(factor, std::min(1.0, l.lowestSpeed.value) - 1e-12);
      EXPECT_LE(factor, std::max(1.0, l.highestSpeed.value) + 1e-12);
      EXPECT_GE(factor * knob, std::min(knob, l.lowestSpeed.value) - 1e-12);
      EXPECT_LE(factor * knob, std::max(knob, l.highestSpeed.value) + 1e-12);
      EXPECT_GE((base * factor).value, std::min(base, l.slowest).value - 1e-9);
      EXPECT_LE((base * factor).value, std::max(base, l.fastest).value + 1e-9);
    }
  }
}

TEST_F(FactorRanges, EverySpeedHasAFeedThatKeepsTheChipInside) {
  for (int trial = 0; trial < 20000; ++trial) {
    const OverrideLimits l = limits();
    const MachineState m = machine();
    const FactorRange speed = speedFactors(l, m);
    const FactorRange feed = feedFactors(l, m);
    for (double share : {0.0, 0.5, 1.0}) {
      const double factor = speed.low + share * (speed.high - speed.low);
      const double thickest = l.feedPerTooth * factor;
      const double thinnest = l.lowestFeedPerTooth * factor;
      EXPECT_LE(feed.low, std::max(thickest, 1.0 * factor) + 1e-12);
      EXPECT_TRUE(factor > 1.0 || feed.high >= thinnest - 1e-12);
      EXPECT_GE(l.perTooth(1.0, factor), thinnest - 1e-12);
      EXPECT_LE(l.perTooth(1.0, factor), thickest + 1e-12);
    }
  }
}

TEST_F(FactorRanges, ReachableSpeedsAreTheFactorsTimesBase) {
  for (int trial = 0; trial < 2000; ++trial) {
    const OverrideLimits l = limits();
    const MachineState m = machine();
    const SpeedRange reach = reachableSpeeds(l, m);
    const Rpm base = m.programmedSpeed * m.operatorSpeed.value;
    EXPECT_NEAR(reach.low.value, (base * speedFactors(l, m).low).value, 1e-9);
    EXPECT_NEAR(reach.high.value, (base * speedFactors(l, m).high).value, 1e-9);
    EXPECT_TRUE(reach.contains(base));
    EXPECT_FALSE(reach.contains(reach.high + Rpm(1.0)));
  }
}

}  // namespace
}  // namespace stillcut::config
