// The model against mechanics: free decay, mean force, leaving the cut, variable pitch, helix, process damping.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/milling/engagement_windows.h"
#include "core/milling/regenerative_cut.h"

namespace stillcut::milling {
namespace {

constexpr AngularWindow kSlot{0.0, std::numbers::pi};

CutModel stiffModel() {
  CutModel m;
  Mode x;
  x.frequency = Hertz(900.0);
  x.damping = 0.02;
  x.stiffness = 1e12;  // gives way by nanometres
  Mode y = x;
  y.direction = {0.0, 1.0};
  m.modes = {x, y};
  return m;
}

TEST(RegenerativeCut, FreeDecayEqualsTheDamping) {
  CutModel m = stiffModel();
  m.modes.resize(1);
  m.modes[0].stiffness = 1e6;
  RegenerativeCut cut(m, {});
  cut.setSpeed(100.0 * kTwoPi);
  cut.disturb(0, 1e-5, 0.0);
  const double w = kTwoPi * 900.0, mass = m.modes[0].mass();
  const auto energy = [&] {
    return 0.5 * 1e6 * std::pow(cut.displacement(0), 2) + 0.5 * mass * std::pow(cut.velocity(0), 2);
  };
  const double before = energy();
  // A whole number of damped periods (to within a step of 5 us), so that the energy is compared at one phase.
  const double period = kTwoPi / (w * std::sqrt(1.0 - 0.02 * 0.02));
  cut.advance(static_cast<int>(std::lround(20.0 * period / cut.stepTime())));
  EXPECT_NEAR(std::log(before / energy()), 2.0 * 0.02 * w * cut.time(), 0.01);
}

TEST(RegenerativeCut, StaticForceGivesStaticDeflection) {
  CutModel m = stiffModel();
  m.modes[0].stiffness = m.modes[1].stiffness = 2e6;
  m.modes[0].damping = m.modes[1].damping = 0.3;
  RegenerativeCut cut(m, {});
  cut.setSpeed(100.0 * kTwoPi);
  cut.setExternalForce(10.0, -4.0);
  cut.advance(2048 * 20);
  EXPECT_NEAR(cut.tip()[0], 10.0 / 2e6, 1e-12);
  EXPECT_NEAR(cut.tip()[1], -4.0 / 2e6, 1e-12);
}

// Mean slotting force of Z teeth (Altintas, Manufacturing Automation, eq. 2.30): Fx = -Z a/4 K_r c - Z a/pi K_re,
// Fy = +Z a/4 K_t c + Z a/pi K_te.
TEST(RegenerativeCut, MeanForceGrowsWithTheFeedPerTooth) {
  CutModel m = stiffModel();
  m.tool.teeth = 3;
  m.material = {7e8, 2.5e8, 1.2e4, 0.9e4, 1.0, 0.0};
  const double depth = 2e-3, speed = 50.0 * kTwoPi;
  for (double perTooth : {0.5e-4, 1e-4, 2e-4}) {
    CutNumerics n;
    n.stepsPerRevolution = 2016;
    RegenerativeCut cut(m, n);
    cut.setSpeed(speed);
    cut.setFeed(perTooth * 3 * 50.0);
    cut.setWindows({&kSlot, 1});
    cut.setAxialDepth(depth);
    cut.advance(2016);
    double fx = 0.0, fy = 0.0;
    for (int i = 0; i < 2016; ++i) {
      cut.advance(1);
      fx += cut.force()[0] / 2016.0;
      fy += cut.force()[1] / 2016.0;
    }
    const double expectedX = -3.0 * depth * (2.5e8 * perTooth / 4.0 + 0.9e4 / std::numbers::pi);
    const double expectedY = 3.0 * depth * (7e8 * perTooth / 4.0 + 1.2e4 / std::numbers::pi);
    EXPECT_NEAR(fx, expectedX, 2e-3 * std::abs(expectedX)) << perTooth;
    EXPECT_NEAR(fy, expectedY, 2e-3 * std::abs(expectedY)) << perTooth;
    // Torque: mean tangential force of all teeth times the radius.
    const double meanTangential = 3.0 * depth * (7e8 * perTooth / std::numbers::pi + 1.2e4 / 2.0);
    EXPECT_NEAR(cut.takeMeanTorque(), meanTangential * 0.005, 5e-3 * meanTangential * 0.005);
  }
}

TEST(RegenerativeCut, PowerLawOfTheChip) {
  CutModel m = stiffModel();
  m.tool.teeth = 1;
  m.material.exponent = 0.7;
  CutNumerics n;
  RegenerativeCut cut(m, n);
  cut.setSpeed(50.0 * kTwoPi);
  cut.setFeed(1e-4 * 50.0);
  cut.setWindows({&kSlot, 1});
  cut.setAxialDepth(1e-3);
  cut.advance(2048 + 512);  // the tooth stands at a right angle to the feed: h is the feed per tooth
  const double h = 1e-4;
  EXPECT_NEAR(cut.force()[1], 1e-3 * 6e8 * std::pow(h, 0.7), 1e-3 * 1e-3 * 6e8 * std::pow(h, 0.7));
}

// One tooth stands out by more than a feed: it does all the work, at twice the feed, and its fellow cuts nothing.
TEST(RegenerativeCut, ToothBehindItsFellowLeavesTheCut) {
  CutModel m = stiffModel();
  m.tool.runout = {Metres(3e-4), Metres(-3e-4)};
  RegenerativeCut cut(m, {});
  cut.setSpeed(50.0 * kTwoPi);
  cut.setFeed(1e-4 * 2 * 50.0);
  cut.setWindows({&kSlot, 1});
  cut.setAxialDepth(1e-3);
  cut.advance(4 * 2048);
  std::array<double, 2> most{};
  for (int half = 0; half < 2; ++half) {
    for (int i = 0; i < 1024; ++i) {
      cut.advance(1);
      most[static_cast<std::size_t>(half)] = std::max(most[static_cast<std::size_t>(half)], cut.force()[1]);
    }
  }
  const double full = 1e-3 * 6e8 * 2e-4;
  // (f_y also holds the radial part, so compare where the tooth stands across: its largest is a little above.)
  EXPECT_GT(most[0], full);
  EXPECT_LT(most[0], 1.06 * full);
  EXPECT_EQ(most[1], 0.0);
}

// Chips divide as the pitch does, and a pitch that falls between steps changes nothing beyond the step's size.
TEST(RegenerativeCut, VariablePitchSharesTheFeed) {
  CutModel m = stiffModel();
  const double first = 170.37 / 360.0 * kTwoPi;
  m.tool.pitch = {first, kTwoPi - first};
  RegenerativeCut cut(m, {});
  cut.setSpeed(50.0 * kTwoPi);
  const double perRevolution = 2e-4;
  cut.setFeed(perRevolution * 50.0);
  cut.setWindows({&kSlot, 1});
  cut.setAxialDepth(1e-3);
  cut.advance(3 * 2048 + 512);  // tooth 0 across the feed; tooth 1 leads it by the first pitch
  EXPECT_NEAR(cut.force()[1], 1e-3 * 6e8 * perRevolution * first / kTwoPi, 2e-4 * 120.0);
}

TEST(RegenerativeCut, HelixSmoothsTheForceAndKeepsItsMean) {
  std::array<double, 2> mean{}, most{};
  for (std::size_t i = 0; i < 2; ++i) {
    CutModel m = stiffModel();
    m.tool.helix = i == 0 ? 0.0 : 0.6;
    CutNumerics n;
    n.slices = 24;
    n.deepest = Metres(6e-3);
    RegenerativeCut cut(m, n);
    cut.setSpeed(50.0 * kTwoPi);
    cut.setFeed(1e-4 * 2 * 50.0);
    cut.setWindows({&kSlot, 1});
    cut.setAxialDepth(6e-3);
    cut.advance(2 * 2048);
    for (int s = 0; s < 2048; ++s) {
      cut.advance(1);
      mean[i] += cut.force()[1] / 2048.0;
      most[i] = std::max(most[i], cut.force()[1]);
    }
  }
  EXPECT_NEAR(mean[1], mean[0], 2e-3 * mean[0]);
  EXPECT_LT(most[1], 0.95 * most[0]);
}

TEST(RegenerativeCut, ProcessDampingTakesEnergy) {
  const auto growth = [](double damping) {
    CutModel m;
    Mode x;
    x.frequency = Hertz(200.0);
    x.damping = 0.02;
    x.stiffness = 2e7;
    m.modes = {x};
    m.material.processDamping = damping;
    CutNumerics n;
    n.mayLeaveCut = false;
    RegenerativeCut cut(m, n);
    cut.setSpeed(10.0 * kTwoPi);
    cut.setWindows({&kSlot, 1});
    cut.setAxialDepth(2e-3);
    cut.disturb(0, 1e-6, 0.0);
    cut.advance(2048);
    return std::hypot(cut.displacement(0), cut.velocity(0) / (kTwoPi * 200.0));
  };
  EXPECT_LT(growth(5e5), 0.9 * growth(0.0));
}

TEST(EngagedAngles, InAndOut) {
  const AngularWindow half{0.0, std::numbers::pi / 2.0};
  EXPECT_EQ(engagedAngles(half, 0.0, 1.0).count, 0);
  const EngagedAngles in = engagedAngles(half, 0.5, 1.0);
  ASSERT_EQ(in.count, 1);
  EXPECT_NEAR(in.windows[0].from, std::asin(0.5), 1e-12);
  EXPECT_NEAR(in.windows[0].to, std::numbers::pi / 2.0, 1e-12);
  const EngagedAngles out = engagedAngles(half, 1.0, 0.5);
  ASSERT_EQ(out.count, 1);
  EXPECT_NEAR(out.windows[0].to, std::asin(0.5), 1e-12);
  EXPECT_EQ(engagedAngles(kSlot, 1.0, 0.5).count, 2);  // a slot leaves by its middle
  EXPECT_EQ(engagedAngles(half, 1.0, 0.0).count, 0);
}

}  // namespace
}  // namespace stillcut::milling
