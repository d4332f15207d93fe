// Which speeds are advised against chatter: n = 60 f / (z p), as properties over chatter, teeth and speed.
#include "core/control/speed_choices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/control/target_speed.h"

namespace stillcut::control {
namespace {

SpeedQuestion asked(double chatter, int teeth, double speed) {
  return {Hertz(chatter), teeth, Rpm(speed), {Rpm(0.5 * speed), Rpm(2.0 * speed)}, nullptr};
}

// 1502 Hz between two teeth at 9500 rev/min are 4.74 waves: five of them lie below, four and a half above.
TEST(SpeedChoices, AreTheWholeWavesOnEitherSideAndTheHalfWaveAbove) {
  const auto choices = speedChoices(asked(1502.0, 2, 9500.0));
  ASSERT_EQ(choices.size(), 3U);
  EXPECT_NEAR(choices[0].speed.value, 60.0 * 1502.0 / (2 * 5.0), 1e-6);
  EXPECT_EQ(choices[0].basis, SpeedBasis::WholeWaves);
  EXPECT_NEAR(choices[1].speed.value, 60.0 * 1502.0 / (2 * 4.5), 1e-6);
  EXPECT_EQ(choices[1].basis, SpeedBasis::HalfWave);
  EXPECT_NEAR(choices[2].speed.value, 60.0 * 1502.0 / (2 * 4.0), 1e-6);
}

TEST(SpeedChoices, FitTheirWavesLieInReachAndComeNearestFirst) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> hertz(150.0, 4000.0), rpm(1500.0, 20000.0);
  int found = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const SpeedQuestion q = asked(hertz(random), 1 + static_cast<int>(random() % 8), rpm(random));
    double before = 0.0;
    for (const SpeedChoice& c : speedChoices(q)) {
      ++found;
      EXPECT_NEAR(q.chatter / toothPassing(c.speed, q.teeth), c.waves, 1e-9 * c.waves);
      EXPECT_TRUE(q.reach.contains(c.speed));
      const double part = c.waves - std::floor(c.waves);
      EXPECT_TRUE(part == 0.0 || part == 0.5) << c.waves;
      if (part == 0.5) {
        EXPECT_GT(c.speed, q.present);
      }
      const double away = std::abs((c.speed - q.present).value);
      EXPECT_GT(away, 0.0);
      EXPECT_GE(away, before);
      before = away;
    }
  }
  EXPECT_GT(found, 5000);
}

TEST(SpeedChoices, OfASpeedThatAlreadyHasWholeWavesAreItsNeighbours) {
  const auto choices = speedChoices(asked(1500.0, 2, 9000.0));
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_EQ(choices[0].waves, 6.0);
  EXPECT_EQ(choices[1].waves, 4.0);
}

TEST(SpeedChoices, AreNoneWhereSomethingIsNotKnown) {
  EXPECT_TRUE(speedChoices(asked(0.0, 2, 9500.0)).empty());
  EXPECT_TRUE(speedChoices(asked(1502.0, 0, 9500.0)).empty());
  EXPECT_TRUE(speedChoices(asked(1502.0, 2, 0.0)).empty());
  EXPECT_TRUE(speedChoices(asked(std::nan(""), 2, 9500.0)).empty());
}

// The lobes decide where they are known; a range in which the cut was heard to chatter is refuted.
TEST(SpeedChoices, OfTheLobesAreTheirRangesButTheOneThatChattered) {
  StableSpeeds known;
  known.ranges = {{Rpm(7000.0), Rpm(7400.0), Rpm(7200.0)},
                  {Rpm(9400.0), Rpm(9600.0), Rpm(9500.0)},
                  {Rpm(11000.0), Rpm(30000.0), Rpm(25000.0)}};
  SpeedQuestion question = asked(1502.0, 2, 9500.0);
  question.known = &known;
  const auto choices = speedChoices(question);
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_EQ(choices[0].speed, Rpm(7200.0));
  EXPECT_EQ(choices[0].basis, SpeedBasis::Lobes);
  EXPECT_EQ(choices[1].to, question.reach.high);
  EXPECT_EQ(choices[1].speed, question.reach.high);
  known.ranges.clear();
  EXPECT_TRUE(speedChoices(question).empty());
}

}  // namespace
}  // namespace stillcut::control
