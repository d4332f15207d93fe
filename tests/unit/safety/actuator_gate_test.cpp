// The actuator's door: limits, lease, ramps, and what makes it let go. Loops that really run away are in
// tests/unit/active/gated_loop_test.cpp.
#include "core/safety/actuator_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace stillcut::safety {
namespace {

constexpr double kRate = 5000.0;
constexpr double kPi = 3.14159265358979;
static_assert(!std::is_constructible_v<ActuatorCommand, double>, "only the gate makes commands");

ActuatorLimits usual() {
  ActuatorLimits limits;
  limits.amplitude = 3.0;
  limits.slew = 2e4;
  return limits;
}

double wave(int n, double frequency = 471.0) {
  return std::sin(2.0 * kPi * frequency * n / kRate);
}

class OpenGate : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(gate_.prepare(usual(), Hertz(kRate)).ok());
    gate_.engage();
    for (int n = 0; n < 1000; ++n) step(0.5 * wave(n), wave(n));
    ASSERT_EQ(gate_.state(), ActuatorState::On);
  }
  double step(double wanted, double error) {
    gate_.renew();
    return gate_.pass(wanted, error).value();
  }
  // Samples until the gate lets go for `why`, then until the output is zero.
  void expectRampsOut(ActuatorRelease why) {
    EXPECT_EQ(gate_.state(), ActuatorState::RampOut);
    EXPECT_EQ(gate_.why(), why);
    for (int n = 0; n < 25; ++n) step(1.0, wave(n));  // 5 ms
    EXPECT_EQ(gate_.state(), ActuatorState::Off);
    EXPECT_EQ(step(1.0, 0.1), 0.0);
    EXPECT_EQ(gate_.why(), why);
    EXPECT_FALSE(actuatorReleaseText(why).empty());
  }
  ActuatorGate gate_;
};

TEST(ActuatorGate, IsShutUntilItIsEngaged) {
  ActuatorGate gate;
  ASSERT_TRUE(gate.prepare(usual(), Hertz(kRate)).ok());
  for (int n = 0; n < 100; ++n) EXPECT_EQ(gate.pass(1.0, wave(n)).value(), 0.0);
}

TEST(ActuatorGate, StartsWithARamp) {
  ActuatorGate gate;
  ASSERT_TRUE(gate.prepare(usual(), Hertz(kRate)).ok());
  gate.engage();
  double before = 0.0;
  for (int n = 0; n < 500; ++n) {
    gate.renew();
    const double y = gate.pass(1.0, wave(n)).value();
    EXPECT_GE(y, before);
    EXPECT_LE(y - before, 1.0 / 500.0 + 1e-12);
    before = y;
  }
  EXPECT_NEAR(before, 1.0, 1e-9);
  EXPECT_EQ(gate.state(), ActuatorState::On);
}

TEST_F(OpenGate, AmplitudeAndSlewAreNeverExceeded) {
  double before = step(0.0, 0.1);
  for (int n = 0; n < 400; ++n) {
    const double y = step((n % 7 < 3 ? 1.0 : -1.0) * 100.0, 0.01 * wave(n));
    EXPECT_LE(std::abs(y), 3.0);
    EXPECT_LE(std::abs(y - before), 2e4 / kRate + 1e-12);
    EXPECT_TRUE(gate_.limited());
    before = y;
  }
  EXPECT_GE(gate_.limitedSamples(), 400U);
  EXPECT_NEAR(gate_.strokeUsed(), 1.0, 1e-12);
}

TEST_F(OpenGate, LetsGoByARampWhenAsked) {
  gate_.release();
  const double first = std::abs(step(0.5, 0.2));
  EXPECT_LE(first, 0.5);
  expectRampsOut(ActuatorRelease::Asked);
}

TEST_F(OpenGate, LetsGoWhenTheLeaseIsNotRenewed) {
  int n = 0;
  while (gate_.state() == ActuatorState::On && n < 1000) {
    gate_.pass(0.5 * wave(n), wave(n));
    ++n;
  }
  EXPECT_LE(n, 501);  // 100 ms
  EXPECT_GE(n, 499);
  expectRampsOut(ActuatorRelease::LeaseOver);
}

TEST_F(OpenGate, LetsGoOfWhatIsNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (const bool inError : {false, true}) {
      SetUp();
      const double y = inError ? step(0.5, bad) : step(bad, 0.5);
      EXPECT_TRUE(std::isfinite(y));
      EXPECT_LE(std::abs(y), 0.5);
      expectRampsOut(ActuatorRelease::NotFinite);
    }
  }
}

TEST_F(OpenGate, LetsGoWhenErrorAndOutputGrowTogether) {
  int n = 0;
  double size = 1.0;
  int sinceDouble = 0;
  while (gate_.state() == ActuatorState::On && n < 2000) {
    size *= std::exp(100.0 / kRate);  // a growth rate of 100 1/s
    step(0.1 * size * wave(n), size * wave(n + 3));
    if (size > 2.0) ++sinceDouble;
    ++n;
  }
  EXPECT_LE(sinceDouble, 100);  // 20 ms after the error left everything known behind
  expectRampsOut(ActuatorRelease::Diverging);
}

TEST_F(OpenGate, LetsGoWhenItIsAtItsEndAndTheVibrationGrows) {
  int n = 0;
  while (gate_.state() == ActuatorState::On && n < 1000) {
    step(50.0 * wave(n), 5.0 * wave(n + 3));
    ++n;
  }
  EXPECT_LE(n, 100);  // 20 ms
  expectRampsOut(ActuatorRelease::Saturated);
}

TEST_F(OpenGate, LetsGoWhenTheModelSaysItWouldBeQuieterWithout) {
  int n = 0;
  while (gate_.state() == ActuatorState::On && n < 1000) {
    gate_.renew();
    gate_.pass(0.5 * wave(n), 1.2 * wave(n), 0.5 * wave(n));
    ++n;
  }
  EXPECT_LE(n, 660);  // 132 ms
  expectRampsOut(ActuatorRelease::Worse);
}

// A touch that follows another at once is not lost.
TEST_F(OpenGate, AStartWhileItRampsOutWaitsForTheEnd) {
  gate_.release();
  step(0.5, 0.1);
  ASSERT_EQ(gate_.state(), ActuatorState::RampOut);
  gate_.engage();
  step(0.5, 0.2);
  EXPECT_EQ(gate_.state(), ActuatorState::RampOut);
  for (int n = 0; n < 30; ++n) step(0.5, 0.1 * wave(n));
  EXPECT_EQ(gate_.state(), ActuatorState::RampIn);
  gate_.engage();
  gate_.release();  // the later touch counts
  step(0.5, 0.1);
  EXPECT_EQ(gate_.state(), ActuatorState::RampOut);
  for (int n = 0; n < 60; ++n) step(0.5, 0.1 * wave(n));
  EXPECT_EQ(gate_.state(), ActuatorState::Off);
}

TEST_F(OpenGate, LetsGoOfADeadSensor) {
  int n = 0;
  while (gate_.state() == ActuatorState::On && n < 1000) {
    step(0.5 * wave(n) + 0.01, 0.0);
    ++n;
  }
  EXPECT_LE(n, 27);  // 5 ms
  expectRampsOut(ActuatorRelease::DeadSensor);
}

// What comes from outside is no divergence: the tool entering the cut, a beat at the tooth-passing frequency, slow
// chatter that the output holds down.
TEST_F(OpenGate, StaysWhenTheVibrationComesFromOutside) {
  for (int n = 0; n < 5000; ++n) {
    const double entry = n > 1000 ? 20.0 : 1.0;
    const double beat = 1.0 + 0.8 * std::sin(2.0 * kPi * 63.6 * n / kRate);
    step(0.5 * wave(n), entry * beat * wave(n + 1));
    ASSERT_EQ(gate_.state(), ActuatorState::On) << n;
  }
}

TEST_F(OpenGate, OffStaysOffUntilEngagedAnew) {
  gate_.release();
  for (int n = 0; n < 200; ++n) step(1.0, wave(n));
  EXPECT_EQ(step(1.0, 0.1), 0.0);
  gate_.engage();
  for (int n = 0; n < 600; ++n) step(1.0, wave(n));
  EXPECT_EQ(gate_.state(), ActuatorState::On);
  EXPECT_EQ(gate_.why(), ActuatorRelease::None);
}

// While a path is identified the output is ramped noise and the reading follows it: no loop, and nothing that diverges.
TEST(ActuatorGate, AnOutputThatDoesNotComeFromTheErrorMayGrowWithIt) {
  ActuatorGate judged, driven;
  for (ActuatorGate* gate : {&judged, &driven}) {
    ASSERT_TRUE(gate->prepare(usual(), Hertz(kRate)).ok());
    gate->engage();
  }
  for (int n = 0; n < 3000; ++n) {
    const double grown = std::min(1.0, 1e-3 * std::exp(0.01 * n));
    judged.renew();
    driven.renew();
    judged.pass(grown * wave(n), 1e-6 + grown * wave(n + 3));
    driven.drive(grown * wave(n), 1e-6 + grown * wave(n + 3));
  }
  EXPECT_EQ(judged.why(), ActuatorRelease::Diverging);
  EXPECT_EQ(driven.state(), ActuatorState::On);
  EXPECT_EQ(driven.why(), ActuatorRelease::None);
}

TEST_F(OpenGate, ADrivenOutputIsLimitedAndLetGoLikeAnyOther) {
  double before = gate_.pass(0.0, 0.1).value();
  for (int n = 0; n < 2000; ++n) {
    gate_.renew();
    const double now = gate_.drive(100.0 * wave(n), wave(n)).value();
    EXPECT_LE(std::abs(now), 3.0);
    EXPECT_LE(std::abs(now - before), 2e4 / kRate + 1e-12);
    before = now;
  }
  int n = 0;
  for (; gate_.state() == ActuatorState::On && n < 1000; ++n) {
    gate_.renew();
    gate_.drive(0.5 * wave(n) + 0.01, 0.0);
  }
  EXPECT_LE(n, 27);
  expectRampsOut(ActuatorRelease::DeadSensor);
}

// The device's output fell to zero: a ramp from where it was would be a jump back to it.
TEST_F(OpenGate, ALostBlockShutsItAtOnce) {
  gate_.cut();
  EXPECT_EQ(gate_.state(), ActuatorState::Off);
  EXPECT_EQ(gate_.why(), ActuatorRelease::DeviceFault);
  EXPECT_FALSE(actuatorReleaseText(ActuatorRelease::DeviceFault).empty());
  for (int n = 0; n < 100; ++n) EXPECT_EQ(step(1.0, wave(n)), 0.0);
  gate_.cut();  // shut already: what shut it stays told
  gate_.engage();
  EXPECT_LT(std::abs(step(1.0, wave(0))), 0.01);  // from zero, by the ramp
  EXPECT_EQ(gate_.why(), ActuatorRelease::None);
}

// Once a block is enough, as long as a block is shorter than the lease.
TEST_F(OpenGate, TheLeaseIsRenewedBlockByBlock) {
  for (int n = 0; n < 5000; ++n) {
    if (n % 480 == 0) gate_.renew();
    gate_.pass(0.5 * wave(n), wave(n));
    ASSERT_EQ(gate_.state(), ActuatorState::On) << n;
  }
}

TEST(ActuatorGate, RefusesLimitsThatAreNone) {
  const auto refused = [](auto&& change) {
    ActuatorLimits limits = usual();
    change(limits);
    ActuatorGate gate;
    return !gate.prepare(limits, Hertz(kRate)).ok();
  };
  EXPECT_TRUE(refused([](ActuatorLimits& l) { l.amplitude = 0.0; }));
  EXPECT_TRUE(refused([](ActuatorLimits& l) { l.amplitude = std::nan(""); }));
  EXPECT_TRUE(refused([](ActuatorLimits& l) { l.slew = -1.0; }));
  EXPECT_TRUE(refused([](ActuatorLimits& l) { l.lease = Seconds(5.0); }));
  EXPECT_TRUE(refused([](ActuatorLimits& l) { l.rampOut = Seconds(0.0); }));
}

}  // namespace
}  // namespace stillcut::safety
