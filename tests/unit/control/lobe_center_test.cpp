// lobe-center against van Dijk 2010, section 4.1.
#include "core/control/lobe_center.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/control/monitor.h"
#include "core/control/registry.h"

namespace stillcut::control {
namespace {

config::ParamSet withRange(double lowSpeed, double highSpeed, double lowFeed, double highFeed) {
  config::ParamSet params;
  EXPECT_TRUE(params.set(config::kLowestSpeedOverride, lowSpeed, "test"));
  EXPECT_TRUE(params.set(config::kHighestSpeedOverride, highSpeed, "test"));
  EXPECT_TRUE(params.set(config::kLowestFeedOverride, lowFeed, "test"));
  EXPECT_TRUE(params.set(config::kHighestFeedOverride, highFeed, "test"));
  return params;
}

// van Dijk's cut: 35 000 rpm, two teeth, 0.2 mm per tooth, overrides 50..120 % and 0..100 %.
class LobeCenterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    setup_.teeth = 2;
    in_.dt = Seconds(0.01);
    in_.machine.valid = true;
    in_.machine.programmedSpeed = in_.machine.actualSpeed = Rpm(35000.0);
    in_.machine.programmedFeed = fromMmPerMin(14000.0);
    in_.verdict.valid = true;
    in_.verdict.state = CutState::Chatter;
    in_.verdict.frequency = Hertz(2200.0);
    strategy_.prepare(setup_, withRange(50, 120, 0, 100));
  }
  OverrideRequest decide() {
    in_.now += toDuration(in_.dt);
    return strategy_.decide(in_);
  }

  CutSetup setup_;
  StrategyInput in_;
  LobeCenter strategy_;
};

TEST_F(LobeCenterTest, GoldenNumber) {
  EXPECT_EQ(wavesBetweenTeeth(Hertz(2200.0), 2, Rpm(35000.0)), 2);
  const OverrideRequest r = decide();
  EXPECT_EQ(r.kind, RequestKind::Set);
  EXPECT_TRUE(r.claimsSpeed && r.claimsFeed);
  EXPECT_NEAR(r.speed.value, 33000.0, 1e-6);
  EXPECT_EQ(r.reason.code, ReasonCode::CentreOfNextPocket);
  EXPECT_NEAR(r.reason.n[1], 2.0, 0.0);
  EXPECT_EQ(r.time, in_.now);
}

TEST_F(LobeCenterTest, FeedPerToothStays) {
  const OverrideRequest r = decide();
  EXPECT_NEAR(toMmPerMin(r.feed) / r.speed.value, 14000.0 / 35000.0, 1e-9);
}

TEST_F(LobeCenterTest, AtLeastOneWave) {
  in_.verdict.frequency = Hertz(500.0);  // 0.43 waves
  EXPECT_EQ(wavesBetweenTeeth(in_.verdict.frequency, 2, Rpm(35000.0)), 1);
  // 15 000 rpm is below 50 % and there is no pocket above p = 1: explained, not asked.
  const OverrideRequest r = decide();
  EXPECT_EQ(r.kind, RequestKind::None);
  EXPECT_EQ(r.reason.code, ReasonCode::TargetOutOfRange);
  EXPECT_NEAR(r.reason.n[0], 15000.0, 1e-6);
}

TEST_F(LobeCenterTest, TakesTheNeighbouringPocketInReach) {
  strategy_.prepare(setup_, withRange(90, 101, 80, 120));  // 33 000 stays in reach
  EXPECT_NEAR(decide().speed.value, 33000.0, 1e-6);
  // 5000 Hz: p = round(4.286) = 4, 37 500 rpm, above 101 %; p = 5 gives 30 000, below 90 %: nothing.
  in_.verdict.frequency = Hertz(5000.0);
  strategy_.reset();
  EXPECT_EQ(decide().reason.code, ReasonCode::TargetOutOfRange);
  strategy_.prepare(setup_, withRange(80, 101, 80, 120));
  const OverrideRequest r = decide();
  EXPECT_NEAR(r.speed.value, 30000.0, 1e-6);
  EXPECT_EQ(r.reason.code, ReasonCode::NextPocketInRange);
}

TEST_F(LobeCenterTest, FamilyMembersAreTakenAsGiven) {
  // 2200 Hz and 2200 - f_tp belong to one family; each has its own target, and the dominant one decides.
  const double ftp = 2 * 35000.0 / 60.0;
  in_.verdict.frequency = Hertz(2200.0 - ftp);
  const OverrideRequest r = decide();
  EXPECT_NEAR(r.speed.value, 60.0 * (2200.0 - ftp) / 2.0, 1e-6);
  // Both lie on the same side of the present speed: the fraction of a wave is the same.
  EXPECT_LT(r.speed.value, 35000.0);
}

TEST_F(LobeCenterTest, FrequencyIsLowPassed) {
  decide();
  in_.verdict.frequency = Hertz(2260.0);
  const double first = decide().speed.value;
  EXPECT_GT(first, 33000.0);
  EXPECT_LT(first, 33900.0 - 500.0);
  for (int i = 0; i < 100; ++i) decide();
  EXPECT_NEAR(decide().speed.value, 33900.0, 1.0);
}

TEST_F(LobeCenterTest, AJumpToAnotherFamilyMemberIsNotAveraged) {
  decide();
  in_.verdict.frequency = Hertz(2200.0 + 2 * 35000.0 / 60.0);
  const double target = 60.0 * in_.verdict.frequency.value / (3 * 2);
  EXPECT_NEAR(decide().speed.value, target, 1e-6);
}

TEST_F(LobeCenterTest, KeepsTheLastSetpointOnceQuiet) {
  decide();
  in_.verdict.state = CutState::Stable;
  in_.verdict.frequency = {};
  in_.machine.actualSpeed = Rpm(34000.0);
  OverrideRequest r;
  for (int i = 0; i < 50; ++i) r = decide();
  EXPECT_EQ(r.kind, RequestKind::Set);
  EXPECT_NEAR(r.speed.value, 33000.0, 1e-6);
  EXPECT_EQ(r.reason.code, ReasonCode::KeepingSpeed);
}

TEST_F(LobeCenterTest, FreezesAtTheActualSpeedWhenAskedTo) {
  config::ParamCatalog catalog;
  catalog.add(lobeCenterParams());
  config::ParamSet params = withRange(50, 120, 0, 100);
  ASSERT_TRUE(params.set(catalog, "lobe-center.freeze", "true", "test"));
  strategy_.prepare(setup_, params);
  decide();
  in_.verdict.state = CutState::Stable;
  in_.machine.actualSpeed = Rpm(33900.0);
  decide();
  in_.machine.actualSpeed = Rpm(33700.0);
  EXPECT_NEAR(decide().speed.value, 33900.0, 1e-6);
}

TEST_F(LobeCenterTest, TheRuleIsRecomputedWhileChatterLasts) {
  decide();
  in_.machine.actualSpeed = Rpm(33500.0);
  in_.verdict.frequency = Hertz(2240.0);
  for (int i = 0; i < 100; ++i) decide();
  EXPECT_NEAR(decide().speed.value, 33600.0, 1.0);
}

TEST_F(LobeCenterTest, UnusableInputIsNeverASet) {
  in_.verdict.valid = false;
  EXPECT_EQ(decide().kind, RequestKind::None);
  in_.verdict.valid = true;
  decide();
  in_.machine.valid = false;
  EXPECT_EQ(decide().kind, RequestKind::Hold);
  in_.machine.valid = true;
  in_.verdict.frequency = Hertz(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(decide().kind, RequestKind::Hold);
  in_.verdict.frequency = Hertz(2200.0);
  EXPECT_EQ(decide().kind, RequestKind::Set);
  for (const double dt : {std::numeric_limits<double>::quiet_NaN(), 0.0, -0.01}) {
    in_.dt = Seconds(dt);
    EXPECT_EQ(decide().kind, RequestKind::Hold) << dt;
  }
}

TEST_F(LobeCenterTest, StableCutAsksForNothing) {
  in_.verdict.state = CutState::Stable;
  EXPECT_EQ(decide().kind, RequestKind::None);
}

TEST_F(LobeCenterTest, AnotherProgrammedSpeedForgets) {
  decide();
  in_.verdict.state = CutState::Stable;
  in_.machine.programmedSpeed = in_.machine.actualSpeed = Rpm(20000.0);
  EXPECT_EQ(decide().kind, RequestKind::None);
}

TEST_F(LobeCenterTest, WithoutTeethItSaysSo) {
  setup_.teeth = 0;
  strategy_.prepare(setup_, withRange(50, 120, 0, 100));
  const OverrideRequest r = decide();
  EXPECT_EQ(r.kind, RequestKind::None);
  EXPECT_EQ(r.reason.code, ReasonCode::TeethNotKnown);
}

TEST(Monitor, NeverAsksForAnOverride) {
  Monitor monitor;
  StrategyInput in;
  in.verdict.valid = true;
  in.verdict.state = CutState::Chatter;
  const OverrideRequest r = monitor.decide(in);
  EXPECT_NE(r.kind, RequestKind::Set);
  EXPECT_FALSE(r.claimsSpeed || r.claimsFeed);
}

TEST(StrategyTable, EveryIdMakesItsStrategyAndMisspellingsAreHelped) {
  for (const StrategyEntry& entry : strategyTable()) {
    const auto made = makeStrategy(entry.id);
    ASSERT_TRUE(made.ok());
    EXPECT_EQ((*made)->describe().id, entry.id);
  }
  EXPECT_TRUE(makeStrategy(kDefaultStrategy).ok());
  const auto wrong = makeStrategy("lobe-centre");
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(wrong.error().line().find("lobe-center"), std::string::npos);
}

}  // namespace
}  // namespace stillcut::control
