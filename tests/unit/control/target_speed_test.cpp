// Where lobe rules put the spindle (van Dijk 2010 eq. 29, 30), as properties over chatter, teeth, speed and reach.
#include "core/control/target_speed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace stillcut::control {
namespace {

class TargetSpeed : public testing::Test {
 protected:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  void draw() {
    chatter_ = Hertz(between(150.0, 4000.0));
    teeth_ = 1 + static_cast<int>(random_() % 8);
    present_ = Rpm(between(1500.0, 20000.0));
    reach_ = {present_ * between(0.4, 0.99), present_ * between(1.01, 1.6)};
  }
  std::mt19937 random_{17};
  Hertz chatter_{};
  int teeth_ = 0;
  Rpm present_{};
  config::SpeedRange reach_;
};

TEST_F(TargetSpeed, AWholeNumberOfWavesFitsBetweenTwoTeeth) {
  for (int trial = 0; trial < 5000; ++trial) {
    draw();
    const int p = wavesBetweenTeeth(chatter_, teeth_, present_);
    const Rpm speed = speedForWaves(chatter_, teeth_, p);
    EXPECT_NEAR(chatter_ / toothPassing(speed, teeth_), p, 1e-9);
    EXPECT_GE(p, 1);
  }
}

// No other whole number makes less of a wave's rest at the present speed.
TEST_F(TargetSpeed, TheWavesAreTheNearestWholeNumber) {
  for (int trial = 0; trial < 5000; ++trial) {
    draw();
    const double waves = chatter_ / toothPassing(present_, teeth_);
    const int p = wavesBetweenTeeth(chatter_, teeth_, present_);
    if (waves >= 1.0) {
      EXPECT_LE(std::abs(waves - p), 0.5 + 1e-12);
    } else {
      EXPECT_EQ(p, 1);
    }
  }
}

TEST_F(TargetSpeed, AStandingSpindleAndNoChatterAreOneWave) {
  EXPECT_EQ(wavesBetweenTeeth(Hertz(0.0), 4, Rpm(8000.0)), 1);
  EXPECT_EQ(wavesBetweenTeeth(Hertz(900.0), 4, Rpm(0.0)), 1);
  EXPECT_EQ(wavesBetweenTeeth(Hertz(std::numeric_limits<double>::quiet_NaN()), 4, Rpm(8000.0)), 1);
}

TEST_F(TargetSpeed, APocketIsInReachOrThereIsNone) {
  int none = 0, moved = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    draw();
    const LobeTarget pocket = pocketInReach(chatter_, teeth_, present_, reach_);
    const int p = wavesBetweenTeeth(chatter_, teeth_, present_);
    EXPECT_EQ(pocket.firstChoice, speedForWaves(chatter_, teeth_, p));
    if (pocket.waves == 0) {
      ++none;
      for (int q : {p - 1, p, p + 1}) {
        EXPECT_TRUE(q < 1 || !reach_.contains(speedForWaves(chatter_, teeth_, q)));
      }
      continue;
    }
    EXPECT_TRUE(reach_.contains(pocket.speed));
    EXPECT_EQ(pocket.speed, speedForWaves(chatter_, teeth_, pocket.waves));
    EXPECT_EQ(pocket.moved, pocket.waves != p);
    EXPECT_LE(std::abs(pocket.waves - p), 1);
    moved += pocket.moved ? 1 : 0;
    // The rule's own choice comes first; among its neighbours the nearer one.
    if (pocket.moved) {
      EXPECT_FALSE(reach_.contains(pocket.firstChoice));
      const int other = 2 * p - pocket.waves;
      if (other >= 1 && reach_.contains(speedForWaves(chatter_, teeth_, other))) {
        EXPECT_LE(std::abs((pocket.speed - present_).value),
                  std::abs((speedForWaves(chatter_, teeth_, other) - present_).value));
      }
    }
  }
  EXPECT_GT(none, 100);
  EXPECT_GT(moved, 100);
}

TEST_F(TargetSpeed, InAPocketsCentreTheRuleStays) {
  for (int trial = 0; trial < 2000; ++trial) {
    draw();
    const LobeTarget pocket = pocketInReach(chatter_, teeth_, present_, reach_);
    if (pocket.waves == 0) continue;
    const config::SpeedRange around{pocket.speed * 0.9, pocket.speed * 1.1};
    const LobeTarget again = pocketInReach(chatter_, teeth_, pocket.speed, around);
    EXPECT_EQ(again.waves, pocket.waves);
    EXPECT_FALSE(again.moved);
  }
}

TEST_F(TargetSpeed, TheFeedThatFollowsKeepsTheChip) {
  for (int trial = 0; trial < 2000; ++trial) {
    draw();
    MachineState machine;
    machine.programmedSpeed = present_;
    machine.programmedFeed = MetresPerSecond(between(0.001, 0.1));
    machine.operatorSpeed = Ratio(between(0.5, 1.2));
    machine.operatorFeed = Ratio(between(0.3, 1.5));
    const Rpm base = machine.programmedSpeed * machine.operatorSpeed.value;
    const MetresPerSecond before = machine.programmedFeed * machine.operatorFeed.value;
    const Rpm target(between(2000.0, 15000.0));
    const MetresPerSecond feed = feedFollowing(target, machine);
    EXPECT_NEAR(feed / (before * (target / base)), 1.0, 1e-12);
    EXPECT_NEAR(feedFollowing(base, machine) / before, 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace stillcut::control
