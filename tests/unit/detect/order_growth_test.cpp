// Chatter on spindle harmonics: period doubling with even teeth, and a line beside a whole order.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

RunOptions told(const CutSignal& s) {
  RunOptions o;
  o.teeth = s.teeth;
  o.rpm = 60.0 * s.spindle * 1.01;
  return o;
}

CutSignal withTeeth(int teeth, unsigned seed) {
  CutSignal s;
  s.rate = 12800.0;
  s.teeth = teeth;
  s.seed = seed;
  s.noise = 0.05;
  return s;
}

// Three seconds of vibration(t [s]) in noise raise no alarm, whatever the noise.
template <class Vibration>
void expectSilence(int teeth, double spindle, std::array<unsigned, 3> seeds, const Vibration& vibration) {
  for (const unsigned seed : seeds) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    Recording r;
    r.rate = 12800.0;
    r.channels.assign(1, {});
    for (int k = 0; k < static_cast<int>(3.0 * r.rate); ++k)
      r.channels[0].push_back(static_cast<float>(0.02 * normal(engine) + vibration(k / r.rate)));
    RunOptions o;
    o.teeth = teeth;
    o.rpm = 60.0 * spindle;
    EXPECT_LT(run(r, o).firstAlarm, 0.0) << "seed " << seed;
  }
}

TEST(Doubling, OnSpindleHarmonicsIsSeenAndNamed) {
  for (const int teeth : {2, 4}) {
    for (const unsigned seed : {11U, 12U, 13U}) {
      CutSignal s = withTeeth(teeth, seed);
      s.chatterOrder = 2.5 * teeth;
      s.growthStart = 2.5;
      s.growthConstant = 0.03;
      s.cap = 2.0;
      s.seconds = 3.2;
      const RunResult r = run(makeCut(s), told(s));
      ASSERT_GT(r.firstAlarm, s.growthStart) << teeth << " teeth, seed " << seed;
      // Before it is as large as the main tooth harmonic, although runout holds a tenth of that on every order.
      EXPECT_LT(r.firstAlarm, s.growthStart + s.growthConstant * std::log(1.0 / s.startAmplitude) + 2.0 / s.spindle);
      const Verdict& v = r.at(r.firstAlarm + 0.05);
      EXPECT_NEAR(v.frequency.value, s.chatterOrder * s.spindle, 0.005 * s.chatterOrder * s.spindle);
      EXPECT_EQ(v.kind, ChatterKind::Flip);
      // It stands still from turn to turn once it is full, and is chatter all the same.
      EXPECT_EQ(r.verdicts.back().state, CutState::Chatter);
      EXPECT_EQ(r.verdicts.back().kind, ChatterKind::Flip);
    }
  }
}

TEST(Doubling, RunoutOfAlternateTeethIsNoAlarm) {
  for (const int teeth : {2, 4}) {
    for (const unsigned seed : {21U, 22U}) {
      CutSignal s = withTeeth(teeth, seed);
      s.seconds = 15.0;
      EXPECT_LT(run(makeCut(s), told(s)).firstAlarm, 0.0) << teeth << " teeth, seed " << seed;
    }
  }
}

// The tool comes to the end of the material: runout weighs more in what is left of the arc, and nothing grows.
TEST(Doubling, ALoadThatLeapsIsNoAlarm) {
  for (const int teeth : {2, 3, 4}) {
    for (const unsigned seed : {31U, 32U, 33U}) {
      CutSignal s = withTeeth(teeth, seed);
      s.newLoad = 2.5;
      s.seconds = 4.0;
      EXPECT_LT(run(makeCut(s), told(s)).firstAlarm, 0.0) << teeth << " teeth, seed " << seed;
    }
  }
}

// The cut goes on with the new load, and chatter in it is seen.
TEST(Doubling, ChatterAfterALeapOfTheLoadIsSeen) {
  CutSignal s = withTeeth(4, 34);
  s.newLoad = 1.5;
  s.growthStart = 2.2;
  s.growthConstant = 0.02;
  s.seconds = 2.8;
  const RunResult r = run(makeCut(s), told(s));
  EXPECT_GT(r.firstAlarm, s.growthStart);
  EXPECT_LT(r.firstAlarm, s.growthStart + 4.4 * s.growthConstant);
}

// So near to an order that the comb follows it; its side lines are a tooth passing apart.
TEST(BesideAnOrder, ChatterIsSeenAndNamed) {
  struct Case {
    int teeth;
    double order;
  };
  for (const Case c : {Case{3, 7.04}, Case{4, 6.96}, Case{4, 15.03}, Case{6, 8.04}}) {
    for (const unsigned seed : {41U, 42U}) {
      CutSignal s = withTeeth(c.teeth, seed);
      s.chatterHertz = c.order * s.spindle;
      s.speedSd = 1e-4;
      s.growthStart = 2.5;
      s.growthConstant = 0.03;
      s.seconds = 3.4;
      const RunResult r = run(makeCut(s), told(s));
      ASSERT_GT(r.firstAlarm, s.growthStart) << c.order << " seed " << seed;
      EXPECT_LT(r.firstAlarm, s.growthStart + s.growthConstant * std::log(s.cap / s.startAmplitude) + 4.0 / s.spindle)
          << c.order << " seed " << seed;
      const Verdict& v = r.at(r.firstAlarm + 0.1);
      EXPECT_NEAR(v.frequency.value, s.chatterHertz, 0.005 * s.chatterHertz) << c.order << " seed " << seed;
      EXPECT_EQ(v.kind, ChatterKind::Hopf) << c.order << " seed " << seed;
      EXPECT_EQ(r.verdicts.back().state, CutState::Chatter) << c.order << " seed " << seed;
    }
  }
}

// Chatter with an e-fold in forty turns is taken for a mode that settles, and so is what has grown as large as it gets.
// That holds it back for some time and not for good.
TEST(BesideAnOrder, ChatterThatHardlyGrowsIsKnownOnceItIsFull) {
  for (const unsigned seed : {61U, 62U}) {
    CutSignal s = withTeeth(4, seed);
    s.chatterHertz = 7.03 * s.spindle;
    s.speedSd = 1e-4;
    s.growthStart = 2.5;
    s.growthConstant = 0.4;
    s.cap = 2.0;
    s.seconds = 6.5;
    const RunResult r = run(makeCut(s), told(s));
    const double full = s.growthStart + s.growthConstant * std::log(s.cap / s.startAmplitude);
    EXPECT_GT(r.firstAlarm, s.growthStart) << "seed " << seed;
    EXPECT_LT(r.firstAlarm, full + 48.0 / s.spindle) << "seed " << seed;
    EXPECT_EQ(r.verdicts.back().state, CutState::Chatter) << "seed " << seed;
  }
}

// A mode near the limit amplifies an order of runout to half the main harmonic: it stands still against the spindle.
TEST(BesideAnOrder, RunoutThatAModeAmplifiesIsNone) {
  for (const double order : {7.0, 15.0}) {
    CutSignal s = withTeeth(4, 43);
    s.chatterOrder = order;
    s.growthStart = 2.5;
    s.growthConstant = 0.15;
    s.cap = 0.5;
    s.seconds = 5.0;
    EXPECT_LT(run(makeCut(s), told(s)).firstAlarm, 0.0) << order;
  }
}

// ... but not to four times the main harmonic, and then it is chatter although it stands still, and grows no faster
// than a load may.
TEST(BesideAnOrder, WhatDwarfsAllElseIsChatter) {
  for (const unsigned seed : {57U, 58U, 59U}) {
    CutSignal s = withTeeth(4, seed);
    s.chatterOrder = 7.0;
    s.growthStart = 2.5;
    s.growthConstant = 0.3;
    s.cap = 8.0;
    s.seconds = 4.5;
    const RunResult r = run(makeCut(s), told(s));
    const auto reaches = [&](double size) {
      return s.growthStart + s.growthConstant * std::log(size / s.startAmplitude);
    };
    EXPECT_GT(r.firstAlarm, reaches(2.0)) << "seed " << seed;
    EXPECT_LT(r.firstAlarm, reaches(5.0)) << "seed " << seed;
  }
}

// While the arc of engagement widens the tooth passings move with its middle, and the speed that is followed with them,
// 0.13 % too low: what runout leaves on order 8 turns against it. It becomes three times as strong, and for a dozen
// turns turns a little more, by a fifth of a turn in all.
TEST(BesideAnOrder, RunoutThatAChangingArcTurnsIsNone) {
  constexpr double kSpindle = 104.6;
  expectSilence(3, kSpindle, {54U, 55U, 56U}, [](double t) {
    const double moved = std::clamp(t - 1.2, 0.0, 1.0);
    const double runout = 0.38 + 1.65 * std::min(moved, 0.2) + 1.5 * std::clamp(moved - 0.7, 0.0, 0.25);
    const double turned = 6e-3 * kSpindle * std::clamp(moved - 0.75, 0.0, 0.12);
    double x = runout * std::cos(kTwoPi * (8 * kSpindle * t + turned));
    for (int j = 1; j <= 5; ++j) {
      const double arc = 3 * j * kTwoPi * 1.3e-3 * kSpindle * moved;
      x += std::cos(kTwoPi * 3 * j * kSpindle * t - arc + 0.7 * j * j) / j;
    }
    return x;
  });
}

// Near the limit a mode amplifies runout of alternate teeth, which holds a fifth of the amplitude already, to the size
// of the main harmonic: so far it follows the load, with an e-fold in 0.12 s, where chatter has one in 0.05 s at most.
TEST(Doubling, RunoutThatAModeAmplifiesIsNone) {
  for (const unsigned seed : {46U, 47U, 48U}) {
    CutSignal s = withTeeth(4, seed);
    s.chatterOrder = 10.0;
    s.growthStart = 2.5;
    s.growthConstant = 0.12;
    s.cap = 1.0;
    s.seconds = 4.0;
    EXPECT_LT(run(makeCut(s), told(s)).firstAlarm, 0.0) << "seed " << seed;
  }
}

// The arc of engagement changes within half a second, and the tooth passings against each other; on its way runout is
// left on order 6 as never before (an end mill whose cut widens from a tenth to two thirds of its diameter).
TEST(Doubling, RunoutThatAnImmersionRampUncoversIsNone) {
  constexpr double kSpindle = 131.3;
  expectSilence(4, kSpindle, {51U, 52U, 53U}, [](double t) {
    const double u = std::clamp((t - 1.5) / 0.5, 0.0, 1.0);
    double x = std::min(0.3, 0.008 * std::exp(12.0 * u)) * std::cos(kTwoPi * 6 * kSpindle * t);
    for (int j = 1; j <= 5; ++j) {
      const double tooth = (1.0 - u) / j + u / (j * j);
      x += tooth * std::cos(kTwoPi * 4 * j * kSpindle * t + 0.7 * j * j + u * j * j);
    }
    return x;
  });
}

// A tooth-passing harmonic on a mode shakes the cut more than anything else, and is named for what it is.
TEST(ForcedResonance, IsNamedAndIsNoAlarm) {
  CutSignal s = withTeeth(4, 44);
  const auto kindAt = [&](double resonance) {
    s.chatterOrder = 12.0;
    s.growthStart = resonance > 0.0 ? 0.0 : -1.0;
    s.startAmplitude = s.cap = resonance;
    const RunResult r = run(makeCut(s), told(s));
    EXPECT_LT(r.firstAlarm, 0.0) << resonance;
    EXPECT_EQ(r.verdicts.back().state, CutState::Stable) << resonance;
    return r.verdicts.back().kind;
  };
  EXPECT_EQ(kindAt(6.0), ChatterKind::Forced);
  EXPECT_EQ(kindAt(0.0), ChatterKind::Unknown);
}

}  // namespace
}  // namespace stillcut::detect::testing
