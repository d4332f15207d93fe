// What teeth do to each other and to stability: shared chips, past teeth, helix, pitch, process damping.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/milling/regenerative_cut.h"
#include "core/milling/simulation/growth_probe.h"

namespace stillcut::milling {
namespace {

constexpr AngularWindow kSlot{0.0, std::numbers::pi};

CutModel stiffModel(int teeth) {
  CutModel m;
  Mode x;
  x.frequency = Hertz(900.0);
  x.damping = 0.02;
  x.stiffness = 1e13;
  m.modes = {x};
  m.tool.teeth = teeth;
  return m;
}

// Whichever teeth reach the material, a revolution takes one revolution's feed: across the feed the chips of all teeth
// add up to it, with up to two past teeth having left the surface that is met.
TEST(Teeth, ChipsOfARevolutionAddUpToItsFeed) {
  const double perRevolution = 3e-4, depth = 1e-3;
  for (const std::vector<double>& runout :
       {std::vector<double>{0.0, 0.0, 0.0}, {5e-5, -2e-5, -3e-5}, {1.5e-4, 1.2e-4, -4e-4}, {5e-4, -5e-4, -5e-4}}) {
    CutModel m = stiffModel(3);
    for (double r : runout) m.tool.runout.emplace_back(r);
    CutNumerics n;
    n.stepsPerRevolution = 2400;
    RegenerativeCut cut(m, n);
    cut.setSpeed(50.0 * kTwoPi);
    cut.setFeed(perRevolution * 50.0);
    // A sliver around the direction of the feed: one tooth at a time.
    const AngularWindow sliver{0.5 * std::numbers::pi - 1e-2, 0.5 * std::numbers::pi + 1e-2};
    cut.setWindows({&sliver, 1});
    cut.setAxialDepth(depth);
    cut.advance(5 * 2400);
    double chips = 0.0;
    for (int tooth = 0; tooth < 3; ++tooth) {
      double most = 0.0;
      for (int i = 0; i < 800; ++i) {
        cut.advance(1);
        most = std::max(most, cut.force()[1]);  // F_t of the one tooth in the sliver
      }
      chips += most / (depth * m.material.tangential);
    }
    EXPECT_NEAR(chips, perRevolution, 0.01 * perRevolution) << runout[0];
  }
}

struct Cut {
  CutModel model;
  double rpm = 6000.0, depth = 1e-3;
  AngularWindow window = kSlot;
  int slices = 1;
};

double growthOf(const Cut& c) {
  CutNumerics n;
  n.stepsPerRevolution = 2048;
  n.slices = c.slices;
  n.deepest = Metres(c.depth);
  GrowthProbe probe(c.model, n, 8, Metres(1e-4));
  probe.cut().setSpeed(c.rpm * kTwoPi / 60.0);
  probe.cut().setWindows({&c.window, 1});
  probe.cut().setAxialDepth(c.depth);
  double sum = 0.0;
  for (int i = 0; i < 256 * 300; ++i) {
    probe.advance();
    if (i >= 256 * 200) sum += probe.growth() / (256 * 100);
  }
  return sum;
}

CutModel flexible(int teeth) {
  CutModel m;
  for (int i = 0; i < 2; ++i) {
    Mode mode;
    mode.frequency = Hertz(900.0 + 60.0 * i);
    mode.damping = 0.02;
    mode.stiffness = 8e6;
    mode.direction = {i == 0 ? 1.0 : 0.0, i == 0 ? 0.0 : 1.0};
    m.modes.push_back(mode);
  }
  m.tool.teeth = teeth;
  m.tool.diameter = Metres(0.012);
  return m;
}

// Four teeth in a slot: the two in the cut stand at right angles and their directional matrices add up to a constant,
// at every height, so a helix changes nothing.
TEST(Teeth, HelixChangesNothingWhereTheForceIsConstant) {
  Cut four{flexible(4), 6000.0, 1.5e-3};
  const double straight = growthOf(four);
  four.model.tool.helix = 0.6;
  four.slices = 12;
  EXPECT_NEAR(growthOf(four), straight, 0.01 * std::abs(straight) + 0.5);
}

// An uneven pitch spreads the delays: the speed at which a regular tool is worst is no longer bad.
TEST(Teeth, VariablePitchStabilisesWhereARegularToolChatters) {
  Cut cut{flexible(4), 0.0, 1.0e-3};
  double worst = -1e9;
  for (int i = 0; i <= 8; ++i) {
    cut.rpm = 3600.0 + 100.0 * i;
    worst = std::max(worst, growthOf(cut));
  }
  ASSERT_GT(worst, 0.0);
  // The difference of 8 degrees is half a wave of 920 Hz at 4000 rev/min: 4000 * 360 / 60 / 920 / 2 = 13 degrees for a
  // pair of delays, shared between neighbours.
  for (double difference : {6.5, 13.0}) {
    const double d = difference / 360.0 * kTwoPi;
    cut.model.tool.pitch = {0.25 * kTwoPi - d, 0.25 * kTwoPi + d, 0.25 * kTwoPi - d, 0.25 * kTwoPi + d};
    double uneven = -1e9;
    for (int i = 0; i <= 4; ++i) {
      cut.rpm = 3600.0 + 200.0 * i;
      uneven = std::max(uneven, growthOf(cut));
    }
    EXPECT_LT(uneven, worst) << difference;
  }
}

// Indentation acts by slope: depth times coefficient times speed of vibration over cutting speed, against the motion.
TEST(Teeth, ProcessDampingIsTheSlopeOfThePath) {
  const double depth = 0.3e-3, coefficient = 2e4, velocity = 0.01;
  for (double rpm : {1500.0, 6000.0}) {
    std::array<double, 2> force{};
    for (std::size_t i = 0; i < 2; ++i) {
      CutModel m = stiffModel(1);
      m.material.processDamping = i == 0 ? 0.0 : coefficient;
      RegenerativeCut cut(m, {});
      cut.setSpeed(rpm * kTwoPi / 60.0);
      cut.setFeed(1e-4 * rpm / 60.0);
      cut.setWindows({&kSlot, 1});
      cut.setAxialDepth(depth);
      cut.advance(2048 + 511);
      cut.disturb(0, 0.0, velocity);
      cut.advance(1);  // the tooth stands at a right angle to the feed: what is radial is along x
      force[i] = cut.force()[0];
    }
    const double cuttingSpeed = rpm * kTwoPi / 60.0 * 0.005;
    EXPECT_NEAR(force[1] - force[0], -depth * coefficient * velocity / cuttingSpeed, 0.02 * 0.06 / cuttingSpeed);
  }
}

}  // namespace
}  // namespace stillcut::milling
