// Spindle drive, override path, profiles: limits, delay, order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "core/milling/simulation/override_path.h"
#include "core/milling/simulation/schedule.h"
#include "core/milling/simulation/spindle_drive.h"

namespace stillcut::milling {
namespace {

Instant at(double seconds) {
  return Instant{} + toDuration(Seconds(seconds));
}

TEST(SpindleDrive, ReachesItsTargetWithoutOvershootBeyondTwoPercent) {
  DriveSettings s;
  s.acceleration = 5000.0;
  SpindleDrive drive(s, Rpm(6000.0));
  drive.setTarget(Rpm(5000.0));
  double lowest = 6000.0;
  for (int i = 0; i < 10000; ++i) {
    drive.advance(Seconds(1e-4), 0.0);
    lowest = std::min(lowest, drive.speed().value);
  }
  EXPECT_NEAR(drive.speed().value, 5000.0, 1.0);
  EXPECT_GT(lowest, 4980.0);
}

TEST(SpindleDrive, TorqueLimitBoundsTheAcceleration) {
  DriveSettings s;
  s.acceleration = 1e9;
  SpindleDrive drive(s, Rpm(1000.0));
  drive.setTarget(Rpm(50000.0));
  double before = drive.radPerSecond();
  for (int i = 0; i < 200; ++i) {
    drive.advance(Seconds(1e-3), 0.0);
    EXPECT_LE(drive.radPerSecond() - before, s.torqueLimit / s.inertia * 1e-3 + 1e-9);
    before = drive.radPerSecond();
  }
  EXPECT_LE(drive.torque(), s.torqueLimit);
  EXPECT_LT(drive.speed().value, 49000.0);
}

TEST(SpindleDrive, LoadDrawsCurrentAndSpeedRecovers) {
  DriveSettings s;
  SpindleDrive drive(s, Rpm(3000.0));
  double lowest = 3000.0;
  for (int i = 0; i < 20000; ++i) {
    drive.advance(Seconds(1e-4), 4.0);
    lowest = std::min(lowest, drive.speed().value);
  }
  EXPECT_LT(lowest, 2990.0);
  EXPECT_NEAR(drive.speed().value, 3000.0, 0.5);
  EXPECT_NEAR(drive.current(), (4.0 + s.frictionTorque) / s.torquePerAmpere, 0.01);
}

// Amplitudes that a cutting torque of 1 N m at `hz` leaves in speed and current.
struct Answer {
  double speed = 0.0;    // [rad/s]
  double current = 0.0;  // [A]
};

Answer answerTo(const DriveSettings& s, double hz) {
  constexpr double kStep = 1e-5;
  SpindleDrive drive(s, Rpm(9000.0));
  std::complex<double> speed, current;
  const int settle = 40000, count = 40000;  // whole periods
  for (int i = 0; i < settle + count; ++i) {
    const double angle = kTwoPi * hz * kStep * i;
    drive.advance(Seconds(kStep), 2.0 + std::sin(angle));
    if (i < settle) continue;
    const std::complex<double> turn = std::polar(2.0 / count, -angle);
    speed += turn * drive.radPerSecond();
    current += turn * drive.current();
  }
  return {std::abs(speed), std::abs(current)};
}

// The equations of spindle_drive.h, below, at and far above the loops' bandwidths.
TEST(SpindleDrive, SpeedAndCurrentAnswerTheCuttingTorqueAsTheirEquationsSay) {
  DriveSettings s;
  s.bandwidth = Hertz(100.0);
  s.torqueLoop = Hertz(800.0);
  for (const double hz : {20.0, 100.0, 500.0, 1000.0, 2500.0}) {
    const std::complex<double> p(0.0, kTwoPi * hz);
    const double w = kTwoPi * s.bandwidth.value;
    const std::complex<double> loop =
        (2.0 * w * s.inertia + w * w * s.inertia / p) / (1.0 + p / (kTwoPi * s.torqueLoop.value));
    const std::complex<double> speed = -1.0 / (s.inertia * p + loop);
    const Answer heard = answerTo(s, hz);
    EXPECT_NEAR(heard.speed / std::abs(speed), 1.0, 0.02) << hz << " Hz";
    EXPECT_NEAR(heard.current / (std::abs(speed * loop) / s.torquePerAmpere), 1.0, 0.03) << hz << " Hz";
  }
}

// Above the loops' bandwidths both are integrators of the torque (Caliskan 2018 section 4): why their signals weigh as
// a velocity does. A torque loop that is slower takes the current further down, the speed not at all.
TEST(SpindleDrive, SpeedAndCurrentFallWithTheFrequencyAboveTheLoops) {
  DriveSettings s;
  const Answer low = answerTo(s, 400.0), high = answerTo(s, 1600.0);
  EXPECT_NEAR(low.speed / high.speed, 4.0, 0.05);
  EXPECT_NEAR(low.current / high.current, 4.0, 0.05);
  s.torqueLoop = Hertz(400.0);
  const Answer lagged = answerTo(s, 1600.0);
  EXPECT_NEAR(lagged.speed / high.speed, 1.0, 0.02);
  EXPECT_NEAR(high.current / lagged.current, std::hypot(1.0, 4.0), 0.15);
}

TEST(SpindleDrive, OverloadStallsButStaysFinite) {
  SpindleDrive drive(DriveSettings{}, Rpm(3000.0));
  for (int i = 0; i < 20000; ++i) drive.advance(Seconds(1e-4), 1000.0);
  EXPECT_GT(drive.radPerSecond(), 0.0);
  EXPECT_LT(drive.speed().value, 100.0);
}

TEST(OverridePath, ActsAfterItsDelayWithinItsRangeAndInOrder) {
  OverridePath path(OverrideSettings{}, 3);
  path.command(Ratio(2.0), Ratio(-1.0), at(1.0));
  path.advance(at(1.0399));
  EXPECT_EQ(path.speed().value, 1.0);
  path.advance(at(1.0701));
  EXPECT_EQ(path.speed().value, 1.2);
  EXPECT_EQ(path.feed().value, 0.0);
  // Many commands within one delay: the last is in force in the end, at most 70 ms after it was given.
  for (int i = 0; i < 200; ++i) path.command(Ratio(0.6 + 0.001 * i), Ratio(0.5), at(2.0 + 1e-3 * i));
  path.advance(at(2.199 + 0.0701));
  EXPECT_NEAR(path.speed().value, 0.799, 1e-12);
}

TEST(OverridePath, DelaysVaryBetweenTheirBounds) {
  OverridePath path(OverrideSettings{}, 11);
  double shortest = 1.0, longest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double given = 1.0 + i;
    const Ratio wanted(i % 2 == 0 ? 0.9 : 0.8);
    path.command(wanted, Ratio(1.0), at(given));
    double t = given;
    while (path.speed() != wanted && t < given + 1.0) path.advance(at(t += 1e-3));
    shortest = std::min(shortest, t - given);
    longest = std::max(longest, t - given);
  }
  EXPECT_GE(shortest, 0.0399);
  EXPECT_LE(longest, 0.0711);
  EXPECT_GT(longest - shortest, 0.02);
}

TEST(OverridePath, IgnoresWhatIsNoNumberAndRoundsToItsResolution) {
  OverrideSettings s;
  s.resolution = Ratio(0.01);
  OverridePath path(s, 1);
  path.command(Ratio(std::numeric_limits<double>::quiet_NaN()), Ratio(0.5), at(0.0));
  path.advance(at(1.0));
  EXPECT_EQ(path.feed().value, 1.0);
  path.command(Ratio(0.8349), Ratio(0.5), at(1.0));
  path.advance(at(2.0));
  EXPECT_NEAR(path.speed().value, 0.83, 1e-12);
}

TEST(Schedule, RampsHoldsAndRefusesDisorder) {
  Schedule p;
  p.segments = {{0.0, 1.0, 2.0, 2.0, RampShape::Linear},
                {2.0, 4.0, 2.0, 6.0, RampShape::Linear},
                {4.0, 6.0, 6.0, 0.0, RampShape::Smoothstep}};
  EXPECT_EQ(p.at(-1.0, 0.0, 9.0), 2.0);
  EXPECT_EQ(p.at(1.5, 0.0, 9.0), 2.0);
  EXPECT_NEAR(p.at(3.0, 0.0, 9.0), 4.0, 1e-12);
  EXPECT_NEAR(p.at(4.5, 0.0, 9.0), 6.0 * (1.0 - 0.15625), 1e-12);
  EXPECT_EQ(p.at(99.0, 0.0, 9.0), 0.0);
  EXPECT_EQ(Schedule{}.at(0.0, 0.0, 9.0), 9.0);
  EXPECT_TRUE(check(p, 0.0, 10.0, "p").ok());
  std::swap(p.segments[0], p.segments[1]);
  EXPECT_FALSE(check(p, 0.0, 10.0, "p").ok());
}

}  // namespace
}  // namespace stillcut::milling
