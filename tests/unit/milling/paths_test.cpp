// Overrides on their way to the drives, the drive itself, and values along time: over random commands and loads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/milling/simulation/override_path.h"
#include "core/milling/simulation/schedule.h"
#include "core/milling/simulation/spindle_drive.h"

namespace stillcut::milling {
namespace {

Instant at(double seconds) {
  return Instant{} + toDuration(Seconds(seconds));
}

struct Command {
  double when = 0.0;
  double speed = 1.0;
};

// What is in force is always what was commanded between the longest and the shortest delay ago, and never older than
// what was in force before.
TEST(OverridePath, WhatIsInForceWasCommandedWithinTheDelays) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> factor(0.55, 1.15), pause(0.001, 0.05);
    OverrideSettings settings;
    settings.resolution = Ratio(0.0);
    OverridePath path(settings, seed);
    std::vector<Command> given{{-1.0, 1.0}};
    std::size_t inForce = 0;
    double now = 0.0;
    for (int i = 0; i < 1000; ++i) {
      now += pause(random);
      if (random() % 2 == 0) {
        given.push_back({now, factor(random)});
        path.command(Ratio(given.back().speed), Ratio(0.5), at(now));
      }
      path.advance(at(now));
      const double speed = path.speed().value;
      std::size_t found = inForce;
      while (found < given.size() && std::abs(given[found].speed - speed) > 1e-12) ++found;
      ASSERT_LT(found, given.size()) << "nobody commanded " << speed;
      inForce = found;
      if (inForce > 0) {
        ASSERT_LE(given[inForce].when, now - settings.shortestDelay.value + 1e-6);
      }
      // The next one is not overdue.
      if (inForce + 1 < given.size()) {
        ASSERT_GE(given[inForce + 1].when, now - settings.longestDelay.value - 1e-6) << seed << " " << i;
      }
    }
  }
}

TEST(OverridePath, WhateverIsCommandedStaysInRangeAndOnSteps) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> wild(-2.0, 4.0);
  OverrideSettings settings;
  settings.resolution = Ratio(0.05);
  OverridePath path(settings, 9);
  for (int i = 0; i < 3000; ++i) {
    path.command(Ratio(wild(random)), Ratio(wild(random)), at(0.1 * i));
    path.advance(at(0.1 * i + 0.09));
    EXPECT_GE(path.speed(), settings.lowestSpeed);
    EXPECT_LE(path.speed(), settings.highestSpeed);
    EXPECT_GE(path.feed(), settings.lowestFeed);
    EXPECT_LE(path.feed(), settings.highestFeed);
    EXPECT_NEAR(std::remainder(path.speed().value, 0.05), 0.0, 1e-9);
    EXPECT_NEAR(std::remainder(path.feed().value, 0.05), 0.0, 1e-9);
  }
}

// Newton: what the motor gives, less friction and cutting, is what turns the spindle faster.
TEST(SpindleDrive, SpeedIsTheIntegralOfItsTorques) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> load(0.0, 8.0), target(3000.0, 9000.0);
  DriveSettings settings;
  settings.acceleration = 20000.0;
  SpindleDrive drive(settings, Rpm(6000.0));
  double torque = 2.0;
  for (int i = 0; i < 20000; ++i) {
    if (i % 500 == 0) {
      drive.setTarget(Rpm(target(random)));
      torque = load(random);
    }
    const double before = drive.radPerSecond();
    drive.advance(Seconds(1e-4), torque);
    ASSERT_LE(std::abs(drive.torque()), settings.torqueLimit + 1e-12);
    const double gained = (drive.torque() - settings.frictionTorque - torque) / settings.inertia * 1e-4;
    ASSERT_NEAR(drive.radPerSecond(), before + gained, 1e-9) << i;
    ASSERT_NEAR(drive.current(), drive.torque() / settings.torquePerAmpere, 1e-12);
  }
}

TEST(SpindleDrive, ALargerInertiaIsNoFaster) {
  double slowest = 0.0;
  for (double inertia : {0.002, 0.004, 0.008, 0.016}) {
    DriveSettings settings;
    settings.inertia = inertia;
    SpindleDrive drive(settings, Rpm(3000.0));
    drive.setTarget(Rpm(9000.0));
    double seconds = 0.0;
    while (std::abs(drive.speed().value - 9000.0) > 90.0 && seconds < 20.0) {
      drive.advance(Seconds(1e-3), 1.0);
      seconds += 1e-3;
    }
    EXPECT_GE(seconds, slowest) << inertia;
    slowest = seconds;
  }
  EXPECT_LT(slowest, 5.0);
}

// The value of a profile drawn with a ruler: the last segment that has begun, at its end at the latest.
double drawn(const Schedule& profile, double s) {
  double value = profile.segments.front().fromValue;
  for (const ScheduleSegment& g : profile.segments) {
    if (s < g.from) return value;
    const double u = std::min(1.0, (s - g.from) / (g.to - g.from));
    const double share = g.shape == RampShape::Linear ? u : 3.0 * u * u - 2.0 * u * u * u;
    value = g.fromValue + share * (g.toValue - g.fromValue);
  }
  return value;
}

TEST(Profiles, AgreeWithTheDrawingAndStayWithinTheirExtremes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> length(0.1, 2.0), value(-3.0, 3.0);
  for (int trial = 0; trial < 300; ++trial) {
    Schedule profile;
    profile.along = trial % 2 == 0 ? Along::Time : Along::Path;
    double s = length(random);
    for (auto n = 1 + random() % 6; n > 0; --n) {
      const double end = s + length(random);
      profile.segments.push_back(
          {s, end, value(random), value(random), random() % 2 == 0 ? RampShape::Linear : RampShape::Smoothstep});
      s = end + (random() % 2 == 0 ? length(random) : 0.0);
    }
    ASSERT_TRUE(check(profile, -3.0, 3.0, "p").ok());
    ASSERT_FALSE(check(profile, profile.lowest(0.0) + 1e-6, 3.0, "p").ok());
    for (int k = -5; k < 120; ++k) {
      const double where = 0.1 * k + 0.0123;
      const double got = profile.along == Along::Time ? profile.at(where, 1e9, 0.0) : profile.at(1e9, where, 0.0);
      ASSERT_NEAR(got, drawn(profile, where), 1e-12) << trial << " " << where;
      ASSERT_GE(got, profile.lowest(0.0) - 1e-12);
      ASSERT_LE(got, profile.highest(0.0) + 1e-12);
    }
  }
}

}  // namespace
}  // namespace stillcut::milling
