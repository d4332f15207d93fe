// Whether the machine does what was agreed: knobs, programme, overrides that are not taken, a spindle that does not
// follow.
#include "core/safety/machine_watch.h"

#include <gtest/gtest.h>

#include <random>

namespace stillcut::safety {
namespace {

class Watch : public testing::Test {
 protected:
  Watch() {
    limits_.takeTime = Seconds(1.0);
    limits_.followTime = Seconds(5.0);
    limits_.operatorPause = Seconds(2.0);
    limits_.speedTolerance = 0.02;
    watch_.prepare(limits_);
    machine_.valid = machine_.linkUp = machine_.atSpeed = true;
    machine_.programmedSpeed = Rpm(8000.0);
    machine_.actualSpeed = Rpm(8000.0);
    watch_.engage(machine_);
  }
  // The machine as it is when it obeys `ours`.
  void obey(const Factors& ours) {
    machine_.speedOverride = Ratio(machine_.operatorSpeed.value * ours.speed);
    machine_.feedOverride = Ratio(machine_.operatorFeed.value * ours.feed);
    machine_.actualSpeed = machine_.targetSpeed();
  }
  void look(double seconds, const Factors& ours, bool commanding = true) {
    for (int i = 0; i < static_cast<int>(seconds * 100.0 + 0.5); ++i) watch_.look(machine_, ours, commanding, 0.01);
  }
  GateLimits limits_;
  MachineWatch watch_;
  MachineState machine_;
};

constexpr Factors kSlower{0.85, 0.85};

TEST_F(Watch, AMachineThatObeysIsNoTrouble) {
  obey(kSlower);
  look(60.0, kSlower);
  EXPECT_EQ(watch_.trouble().code, ReasonCode::None);
  EXPECT_TRUE(watch_.atSpeed());
  EXPECT_FALSE(watch_.programChanged());
  EXPECT_FALSE(watch_.operatorOverrideMoving());
}

TEST_F(Watch, AnOverrideThatIsNotTakenIsToldAfterItsTime) {
  obey({});
  machine_.actualSpeed = Rpm(6800.0);
  look(0.9, kSlower);
  EXPECT_EQ(watch_.trouble().code, ReasonCode::None);
  look(0.3, kSlower);
  ASSERT_EQ(watch_.trouble().code, ReasonCode::GateOverrideNotTaken);
  EXPECT_NEAR(watch_.trouble().n[0], 100.0, 1e-9);  // read back
  EXPECT_NEAR(watch_.trouble().n[1], 85.0, 1e-9);   // expected
  obey(kSlower);
  look(0.01, kSlower);
  EXPECT_EQ(watch_.trouble().code, ReasonCode::None);
}

TEST_F(Watch, AnOverrideThatWasTakenAndStandsAtTheKnobsWasReset) {
  machine_.operatorSpeed = Ratio(0.9);
  obey(kSlower);
  look(1.0, kSlower);
  obey({});
  look(1.2, kSlower);
  ASSERT_EQ(watch_.trouble().code, ReasonCode::GateOverrideReset);
  EXPECT_NEAR(watch_.trouble().n[0], 90.0, 1e-9);
  EXPECT_NEAR(watch_.trouble().n[1], 76.5, 1e-9);
  // Somewhere else is no reset, and neither is what was never taken in this engagement.
  machine_.speedOverride = Ratio(0.6);
  look(0.01, kSlower);
  EXPECT_EQ(watch_.trouble().code, ReasonCode::GateOverrideNotTaken);
  watch_.engage(machine_);
  obey({});
  look(1.2, kSlower);
  EXPECT_EQ(watch_.trouble().code, ReasonCode::GateOverrideNotTaken);
}

TEST_F(Watch, TheFeedCountsAsTheSpeedDoesButForAFeedHold) {
  obey(kSlower);
  machine_.feedOverride = Ratio(0.0);
  machine_.feedHold = true;
  look(5.0, kSlower);
  EXPECT_EQ(watch_.trouble().code, ReasonCode::None);
  machine_.feedHold = false;
  look(1.2, kSlower);
  ASSERT_EQ(watch_.trouble().code, ReasonCode::GateOverrideNotTaken);
  EXPECT_NEAR(watch_.trouble().n[0], 0.0, 1e-9);
}

TEST_F(Watch, ASpindleThatDoesNotFollowIsToldLater) {
  obey(kSlower);
  machine_.actualSpeed = Rpm(8000.0);
  look(4.9, kSlower);
  EXPECT_EQ(watch_.trouble().code, ReasonCode::None);
  EXPECT_FALSE(watch_.atSpeed());
  look(0.3, kSlower);
  ASSERT_EQ(watch_.trouble().code, ReasonCode::GateNotFollowing);
  EXPECT_NEAR(watch_.trouble().n[0], 8000.0, 1e-9);
  EXPECT_NEAR(watch_.trouble().n[1], 6800.0, 1e-9);
}

TEST_F(Watch, AMachineThatMeasuresNoSpeedIsBelievedByItsWord) {
  obey(kSlower);
  machine_.actualSpeed = Rpm(0.0);
  look(30.0, kSlower);
  EXPECT_EQ(watch_.trouble().code, ReasonCode::None);
  EXPECT_TRUE(watch_.atSpeed());
  machine_.atSpeed = false;
  look(0.01, kSlower);
  EXPECT_FALSE(watch_.atSpeed());
}

TEST_F(Watch, WithoutACommandNothingIsOwed) {
  machine_.speedOverride = Ratio(0.3);
  machine_.actualSpeed = Rpm(100.0);
  look(30.0, kSlower, false);
  EXPECT_EQ(watch_.trouble().code, ReasonCode::None);
}

TEST_F(Watch, AnotherSpeedWordIsAnotherProgramme) {
  obey(kSlower);
  machine_.programmedSpeed = Rpm(8005.0);  // rounding of a word read back
  look(0.01, kSlower);
  EXPECT_FALSE(watch_.programChanged());
  machine_.programmedSpeed = Rpm(8100.0);
  look(0.01, kSlower);
  EXPECT_TRUE(watch_.programChanged());
  watch_.engage(machine_);
  EXPECT_EQ(watch_.programmed().value, 8100.0);
  look(0.01, kSlower);
  EXPECT_FALSE(watch_.programChanged());
}

TEST_F(Watch, AKnobThatIsTurnedCountsForItsTime) {
  obey(kSlower);
  look(1.0, kSlower);
  machine_.operatorFeed = Ratio(0.9);
  obey(kSlower);
  look(0.01, kSlower);
  EXPECT_TRUE(watch_.operatorOverrideJustMoved());
  look(0.01, kSlower);
  EXPECT_FALSE(watch_.operatorOverrideJustMoved());
  look(1.9, kSlower);
  EXPECT_TRUE(watch_.operatorOverrideMoving());
  look(0.2, kSlower);
  EXPECT_FALSE(watch_.operatorOverrideMoving());
}

TEST_F(Watch, RoundingOfTheReadBackIsNoHand) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> rounding(-0.0035, 0.0035);
  look(0.01, {});
  for (int i = 0; i < 2000; ++i) {
    machine_.operatorSpeed = Ratio(1.0 + rounding(random));
    watch_.look(machine_, {}, true, 0.01);
    ASSERT_FALSE(watch_.operatorOverrideMoving()) << i;
  }
}

// Slow turning, each click too small to count by itself, adds up to a turn.
TEST_F(Watch, ManySmallClicksAreATurn) {
  look(0.01, {});
  bool seen = false;
  for (int i = 1; i <= 20; ++i) {
    machine_.operatorSpeed = Ratio(1.0 - 0.002 * i);
    watch_.look(machine_, {}, true, 0.01);
    seen = seen || watch_.operatorOverrideJustMoved();
  }
  EXPECT_TRUE(seen);
}

TEST_F(Watch, TheBaseOfAbsoluteWishesMovesOnlyWhenAsked) {
  look(0.01, {});
  machine_.operatorSpeed = Ratio(0.8);
  look(1.0, {});
  EXPECT_EQ(watch_.baseOperatorSpeed().value, 1.0);
  watch_.rebase(machine_);
  EXPECT_EQ(watch_.baseOperatorSpeed().value, 0.8);
  EXPECT_EQ(watch_.baseOperatorFeed().value, 1.0);
}

}  // namespace
}  // namespace stillcut::safety
