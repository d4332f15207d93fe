// A channel whose energy ratio is high in the calm cut: from where on it is more than usual.
#include "core/detect/caliskan/usual_ratio.h"

#include <gtest/gtest.h>

#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

constexpr double kChatter = 0.2;

UsualRatio usedTo(double ratio, int turns) {
  UsualRatio usual;
  for (int i = 0; i < turns; ++i) usual.learn(ratio, 1.0);
  return usual;
}

TEST(UsualRatio, IsTheChatterRatioUntilMuchIsHeard) {
  EXPECT_DOUBLE_EQ(UsualRatio().limit(kChatter, 1.0), kChatter);
  EXPECT_DOUBLE_EQ(usedTo(0.4, 15).limit(kChatter, 0.5), 0.5 * kChatter);
}

// Four times what does not repeat over what does; half of that rise where full chatter is to stay.
TEST(UsualRatio, AsksOfANoisyChannelForMoreThanItsNoise) {
  const UsualRatio usual = usedTo(0.4, 100);
  const auto odds = [](double ratio) { return ratio / (1.0 - ratio); };
  EXPECT_NEAR(odds(usual.limit(kChatter, 1.0)), 4.0 * odds(0.4), 1e-9);
  EXPECT_NEAR(odds(usual.limit(kChatter, 0.5)), 2.0 * odds(0.4), 1e-9);
  EXPECT_LT(usedTo(0.99, 100).limit(kChatter, 1.0), 1.0);
}

TEST(UsualRatio, AsksOfAQuietChannelForTheChatterRatio) {
  EXPECT_DOUBLE_EQ(usedTo(0.02, 100).limit(kChatter, 1.0), kChatter);
}

TEST(UsualRatio, DoesNotTakeWhatGrowsUnheardForUsual) {
  UsualRatio usual = usedTo(0.1, 20);
  for (int i = 0; i < 200; ++i) usual.learn(0.1 + 0.004 * i, 1.0);
  EXPECT_LT(usual.limit(kChatter, 1.0), 0.32);
}

// Two axes: one hears the cut, the other little but noise and a line of the machine. Chatter comes, is alarmed, and
// goes.
TEST(UsualRatio, OfANoisyAxisHoldsNoAlarm) {
  constexpr double kRate = 12800.0;
  constexpr double kSpindle = 105.0;
  std::mt19937 engine(5);
  std::normal_distribution<double> noise;
  Recording r;
  r.rate = kRate;
  r.channels.assign(2, {});
  for (int k = 0; k < static_cast<int>(4.0 * kRate); ++k) {
    const double t = k / kRate;
    const double turn = kTwoPi * kSpindle * t;
    const double grown = t < 2.0 ? 0.0 : std::min(2.0, 0.01 * std::exp((t - 2.0) / 0.03));
    const double chatter = grown * std::min(1.0, std::exp((2.4 - t) / 0.1));
    const double cut = t < 0.5 ? 0.0 : steadyCutAt(turn, 3) + chatter * std::sin(7.4 * turn);
    r.channels[0].push_back(static_cast<float>(cut + 0.02 * noise(engine)));
    r.channels[1].push_back(
        static_cast<float>(0.02 * cut + (t < 0.5 ? 0.0 : 0.015 * std::sin(3.35 * turn)) + 0.003 * noise(engine)));
  }
  RunOptions o;
  o.teeth = 3;
  o.rpm = 60.0 * kSpindle;
  const RunResult result = run(r, o);
  EXPECT_GT(result.at(1.9).severity.value, kChatter);
  EXPECT_GT(result.firstAlarm, 2.0);
  EXPECT_LT(result.firstAlarm, 2.2);
  EXPECT_EQ(result.at(2.35).state, CutState::Chatter);
  EXPECT_EQ(result.alarmTimeIn(3.0, 4.0), 0.0);
}

}  // namespace
}  // namespace stillcut::detect::testing
