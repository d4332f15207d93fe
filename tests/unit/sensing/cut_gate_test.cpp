// The gate sees levels only: what it says must not depend on how long the blocks are that bring them.
#include "core/sensing/cut_gate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stillcut::detect {
namespace {

constexpr double kOpen = 4.0;
constexpr double kTurn = 0.02;  // 3000 rev/min

struct Gate {
  Gate() {
    CutSetup setup;
    setup.channels.resize(1);
    gate.prepare(setup);
    gate.setOpenRatio(kOpen);
    gate.setSpeedKnown(true);
  }
  // `seconds` at this mean square; the phases on the way.
  std::vector<CutPhase> run(double meanSquare, double seconds, double block) {
    std::vector<CutPhase> seen;
    for (long i = std::lround(seconds / block); i > 0; --i) {
      gate.advance({&meanSquare, 1}, Seconds(block), Seconds(kTurn));
      seen.push_back(gate.phase());
    }
    return seen;
  }
  CutGate gate;
};

class CutGateBlocks : public ::testing::TestWithParam<double> {};

TEST_P(CutGateBlocks, AirEntrySteadyAndAirAgain) {
  Gate g;
  g.run(1.0, 2.0, GetParam());
  EXPECT_EQ(g.gate.phase(), CutPhase::AirCutting);
  const auto in = g.run(100.0, 2.0, GetParam());
  EXPECT_NE(std::find(in.begin(), in.end(), CutPhase::Entry), in.end());
  EXPECT_EQ(g.gate.phase(), CutPhase::Steady);
  EXPECT_LE(g.gate.airFloor(0), 1.0 + 1e-9);
  EXPECT_GT(g.gate.airFloor(0), 0.7);  // 1.5 dB: the first blocks weigh more
  g.run(1.0, 2.0, GetParam());
  EXPECT_EQ(g.gate.phase(), CutPhase::AirCutting);
}

TEST_P(CutGateBlocks, DigitalSilenceIsNoFloorThatAnythingExceeds) {
  Gate g;
  g.run(0.0, 1.0, GetParam());
  g.run(1.0, 2.0, GetParam());
  EXPECT_EQ(g.gate.phase(), CutPhase::AirCutting);
  g.run(100.0, 2.0, GetParam());
  EXPECT_EQ(g.gate.phase(), CutPhase::Steady);
}

// Noise in a narrow band dips by more than an exit's 3 dB; what then grows past all that was there has not left.
TEST_P(CutGateBlocks, WhatGrowsAfterADipIsInTheCut) {
  Gate g;
  g.run(1.0, 2.0, GetParam());
  g.run(100.0, 2.0, GetParam());
  ASSERT_EQ(g.gate.phase(), CutPhase::Steady);
  const auto dip = g.run(5.0, 0.1, GetParam());
  ASSERT_EQ(dip.back(), CutPhase::Exit);
  double steady = 0.0;
  for (int i = 0; i * GetParam() < 0.5; ++i) {  // to five hundred times as much
    const double level = 200.0 * std::exp(i * GetParam() / 0.08);
    if (g.run(level, GetParam(), GetParam()).back() == CutPhase::Steady) steady += GetParam();
  }
  EXPECT_GT(steady, 0.2);
}

// A corner is over, and the cut goes on with a tenth of what it was: no exit lasts twenty turns. Near air it does.
TEST_P(CutGateBlocks, ACutThatGoesOnWithLessIsNoExit) {
  for (const double less : {10.0, 4.5}) {
    Gate g;
    g.run(1.0, 2.0, GetParam());
    g.run(100.0, 2.0, GetParam());
    ASSERT_EQ(g.run(less, 0.2, GetParam()).back(), CutPhase::Exit);
    g.run(less, 1.0, GetParam());
    EXPECT_EQ(g.gate.phase(), less > 2.0 * kOpen ? CutPhase::Steady : CutPhase::Exit) << less;
  }
}

// A recording begins with the tool in the material, shaken by its first bite. Chatter that comes and is cured later is
// louder than the cut as well; what is left then is the cut and no air.
TEST_P(CutGateBlocks, ACutThatNoAirWasHeardBeforeIsNotAirOnceItsChatterIsCured) {
  const double step = std::min(GetParam(), 0.01);  // chatter that is there from one step to the next has no growth
  Gate g;
  g.gate.setForced(true);
  g.run(3000.0, 0.1, step);
  g.run(100.0, 2.0, step);
  ASSERT_TRUE(g.gate.inCut());
  g.run(1000.0, 0.5, step);
  const auto cured = g.run(90.0, 2.0, step);
  EXPECT_EQ(std::find(cured.begin(), cured.end(), CutPhase::AirCutting), cured.end());
  EXPECT_EQ(g.gate.phase(), CutPhase::Steady);
}

// A spindle's own sound lies on the tooth passing of a tool of two: no air was told from a cut, and the tool comes.
TEST(CutGate, WhereASpindleSoundedLikeTeethALeapIsTheEntry) {
  Gate g;
  g.gate.setForced(true);
  g.run(1.0, 2.0, 0.001);
  ASSERT_EQ(g.gate.phase(), CutPhase::Steady);
  const auto in = g.run(100.0, 2.0, 0.001);
  EXPECT_NE(std::find(in.begin(), in.begin() + 20, CutPhase::Entry), in.begin() + 20);
  EXPECT_EQ(g.gate.phase(), CutPhase::Steady);
}

INSTANTIATE_TEST_SUITE_P(Lengths, CutGateBlocks, ::testing::Values(0.001, 0.01, 0.05, 0.1));

}  // namespace
}  // namespace stillcut::detect
