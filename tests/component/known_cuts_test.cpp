// Families of simulated cuts with known truth, other seeds than the detection table shows: what a new user's first cuts
// are like.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tests/support/known_cuts/cut_families.h"
#include "tests/support/known_cuts/score.h"
#include "tests/support/known_cuts/sensor_kinds.h"
#include "tests/support/known_cuts/tools.h"

namespace stillcut::bench {
namespace {

// Of a face mill at 800 rev/min the teeth are heard up to the hundredth order, where a speed found anew by a thousandth
// moves everything by a radian. Nothing grows.
TEST(KnownCuts, ASlowSpindleWhoseSpeedIsFoundAnewRaisesNoAlarm) {
  for (const SimulationOrder& order : slowStable(8)) {
    if (order.scenario.seed % 1000 <= 5) continue;
    const KnownCut cut = simulate(order);
    for (const int channel : {0, 1}) {
      const Score s = score(cut, {"energy-ratio", {channel}, 0.0});
      EXPECT_FALSE(s.falseAlarm) << cut.name << " channel " << channel << " at " << s.alarm << " s";
    }
  }
}

// A load that doubles within six turns has side lines as broad as chatter's beside every order, and runout on a mode
// turns its phase by as much.
TEST(KnownCuts, ALoadThatRisesWithinAFewTurnsRaisesNoAlarm) {
  int cuts = 0;
  for (const SimulationOrder& order : quickRise(12)) {
    const bool faceMill = order.scenario.programme.speed.value < 1000.0;
    if (!faceMill || order.scenario.seed % 100 <= 9) continue;
    const KnownCut cut = simulate(order);
    for (const int channel : {0, 1}) {
      const Score s = score(cut, {"energy-ratio", {channel}, 0.02});
      EXPECT_FALSE(s.falseAlarm) << cut.name << " channel " << channel << " at " << s.alarm << " s";
    }
    ++cuts;
  }
  EXPECT_GE(cuts, 4);
}

// ... and where it rises beyond the limit, it is chatter's alarm all the same, a few turns later.
TEST(KnownCuts, ChatterAfterAQuickRiseIsFound) {
  for (SimulationOrder& order : quickRise(2)) {
    if (order.name != "F4-2101" && order.name != "F4-2102") continue;
    for (auto& segment : order.scenario.programme.depth.segments) {
      if (segment.from >= 3.0) segment.toValue *= 1.3 / 0.9;
    }
    order.rule = AlarmRule::Slow;
    const KnownCut cut = simulate(order);
    ASSERT_GT(cut.at20, 3.0);
    for (const int channel : {0, 1}) {
      const Score s = score(cut, {"energy-ratio", {channel}, 0.0});
      EXPECT_TRUE(s.alarmed && !s.early) << cut.name;
      EXPECT_LT(s.after20, 3.0 * 60.0 / cut.rpm) << cut.name;
    }
  }
}

// An override of 6 % takes the fifth order across a mode of 1 % damping within a tenth of a second: it turns by 0.1 of
// an order, as chatter there would. The machine tells the speed.
TEST(KnownCuts, AnOrderThatAnOverrideTakesAcrossAModeRaisesNoAlarm) {
  int cuts = 0;
  for (const CutFamily& family : cutFamilies()) {
    if (family.name != "stable, speed changes") continue;
    for (const SimulationOrder& order : family.make(7)) {
      if (order.name != "Z2-607" || !order.machineTells) continue;
      const KnownCut cut = simulate(order);
      for (const double error : {-0.02, 0.0, 0.03}) {
        const Score s = score(cut, {"energy-ratio", {0}, error});
        EXPECT_FALSE(s.falseAlarm) << error << " at " << s.alarm << " s";
      }
      ++cuts;
    }
  }
  EXPECT_EQ(cuts, 1);
}

// In the speed and the current of the spindle the load of a tool that leaves the work ends in a step, which grows as
// fast as any chatter for half a turn.
TEST(KnownCuts, AToolThatLeavesIsNoGrowthToTheSpindle) {
  int cuts = 0;
  for (const CutFamily& family : sensorKindFamilies()) {
    if (family.name != "sensor: spindle speed" && family.name != "sensor: motor current") continue;
    for (const SimulationOrder& order : family.make(1)) {
      if (order.name != "Z4-1501-entry-exit") continue;
      const KnownCut cut = simulate(order);
      for (const double error : {0.0, 0.02, 0.03}) {
        const Score s = score(cut, {"energy-ratio", {}, error});
        EXPECT_FALSE(s.falseAlarm) << cut.family << ' ' << cut.name << ' ' << error << " at " << s.alarm << " s";
      }
      ++cuts;
    }
  }
  EXPECT_EQ(cuts, 2);
}

// Period doubling of two flutes that ends with the depth: the vibration falls by 12 dB, as if the tool left, and the
// order that it was on keeps its runout.
TEST(KnownCuts, DoublingThatEndsWithTheDepthIsOverInTime) {
  for (const CutFamily& family : cutFamilies()) {
    if (family.name != "recovery by depth") continue;
    for (const SimulationOrder& order : family.make(5)) {
      if (order.name != "Z2-703" && order.name != "Z2-705") continue;
      const KnownCut cut = simulate(order);
      ASSERT_EQ(cut.kind, ChatterKind::Flip);
      for (const std::vector<int>& channels : {std::vector<int>{}, {0}, {1}}) {
        const Score s = score(cut, {"energy-ratio", channels, 0.0});
        EXPECT_TRUE(s.alarmed && !s.late && !s.early) << cut.name;
        EXPECT_FALSE(s.clearLate) << cut.name << ' ' << s.clearDelay << " s";
      }
    }
  }
}

// error: of the told speed.
void expectSilent(const SimulationOrder& order, double error) {
  const KnownCut cut = simulate(order);
  ASSERT_TRUE(cut.stable) << cut.name;
  for (const std::vector<int>& channels : kAxes) {
    const Score s = score(cut, {"energy-ratio", channels, error});
    EXPECT_FALSE(s.falseAlarm) << cut.name << ' ' << s.alarm << " s";
  }
}

// Six teeth, chatter at order 9.99 that locks to the tenth: it stands still against the spindle as runout does, and
// grows out of it by 30 dB.
TEST(KnownCuts, ChatterThatLocksToAnOrderIsHeard) {
  const KnownCut cut = simulate(orderOf("varied", 8, "Z4-1429-Z6"));
  ASSERT_EQ(cut.teeth, 6);
  for (const std::vector<int>& channels : kAxes) {
    const Score s = score(cut, {"energy-ratio", channels, 0.0});
    EXPECT_TRUE(s.good()) << s.alarm << " s, frequency off by " << s.frequencyError;
  }
}

// A line a tenth of an order beside one that runout drives ten times as strongly is the chatter's own: that order gains
// nothing while the chatter grows. What is held here is the truth of the simulated cut.
TEST(KnownCuts, ALineBesideWhatRunoutDrivesIsNoSkirt) {
  const KnownCut cut = simulate(orderOf("hopf", 9, "Z2-109"));
  const double order = cut.chatterHz * 60.0 / cut.rpm;
  EXPECT_EQ(cut.kind, ChatterKind::Hopf);
  EXPECT_NEAR(order, 5.108, 0.01);
}

// Four teeth whose runout is as strong as their load, while the arc widens: teeth that leave the material make of it
// as much on the orders of period doubling as its own square, in a cut that is stable until 0.6 s later.
TEST(KnownCuts, TeethThatLeaveTheMaterialMakeNoDoubling) {
  const KnownCut cut = simulate(orderOf("immersion ramp", 2, "Z4-302"));
  ASSERT_GT(cut.at1, 1.5);
  for (const std::vector<int>& channels : kAxes) {
    const Score s = score(cut, {"energy-ratio", channels, 0.0});
    EXPECT_TRUE(s.timely()) << s.alarm << " s";
  }
}

// Two flutes whose runout meets a mode at order 5: most of what is heard is one line that is no tooth passing, from the
// tool's entry on.
TEST(KnownCuts, RunoutThatFillsTheCutIsNoChatter) {
  for (const char* name : {"Z2-1107", "Z2-1107-quick"}) expectSilent(orderOf("stable, strong runout", 9, name), 0.0);
}

// A depth that rises to just below the limit in a fraction of a second brings a mode nearer to it, and with the load's
// few per cent a turn the runout that the mode amplifies grows and turns by five times as much.
TEST(KnownCuts, RunoutThatAModeAmplifiesWhileTheLoadRisesIsNoChatter) {
  for (const char* name : {"Z2-1102-Z4", "Z2-1104-Z6-slowly", "Z2-1106-Z3"})
    expectSilent(orderOf("stable, strong runout", 6, name), 0.02);
}

// Runout that a narrow arc leaves little of on the orders between the tooth passings is a thousand times as much of the
// vibration at a wide one, in a cut far below its limit.
TEST(KnownCuts, RunoutThatAWiderArcBringsOutIsNoDoubling) {
  const SimulationOrder order = orderOf("stable, immersion ramp", 12, "Z2-312");
  for (const double error : {-0.02, 0.0}) expectSilent(order, error);
}

// An arc that widens turns every order a little, and the speed that is tracked by them. Where it stops, that ends at
// once: new vibration, but none that grows. In a slot tooth passings cancel, and what turns is nearly all there is.
TEST(KnownCuts, AnArcThatWidensRaisesNoAlarm) {
  for (const char* name : {"Z3-302", "Z3-309"}) expectSilent(orderOf("stable, immersion ramp", 9, name), 0.0);
  for (const char* name : {"Z3-2304", "Z3-2306", "Z4-2306"})
    expectSilent(orderOf("stable, into the slot", 6, name), 0.0);
}

// Where a corner begins forced vibration changes by a fifth of itself in a turn, before any spectrum can tell of what;
// where it turns back at once, runout between the teeth grows and turns in an arc that was never learned; over a hole
// what changes does so for two turns and falls again.
TEST(KnownCuts, ACornerRaisesNoAlarm) {
  for (const char* name : {"Z3-2401-slower", "Z3-2405-slower", "Z2-2401-corner", "Z2-2402-holes"}) {
    expectSilent(orderOf("stable, corners and steps", 6, name), 0.0);
  }
}

// A spindle whose speed runs away by 5 % a second, told by nobody: what a window finds is over by then, and the phases
// run away from what was found. The harmonics of a speed that is wrong by a per cent grow from turn to turn.
TEST(KnownCuts, ASpeedThatRunsAwayRaisesNoAlarm) {
  expectSilent(orderOf("stable, speed drifts", 9, "Z3-509"), -0.03);
  expectSilent(orderOf("stable, speed drifts", 12, "Z2-512"), -0.02);
}

// Chatter that grows while the drifting speed takes a spindle order across it: as near to it for a tenth of a second as
// if it stood on it.
TEST(KnownCuts, ChatterThatAnOrderCrossesIsHeardInTime) {
  for (const char* family : {"speed ramp", "speed ramp, told"}) {
    const KnownCut cut = simulate(orderOf(family, 11, "Z4-511"));
    for (const std::vector<int>& channels : kAxes) {
      const Score s = score(cut, {"energy-ratio", channels, 0.0});
      EXPECT_TRUE(s.good()) << family << ' ' << s.after20 << " s after 20 %, off by " << s.frequencyError;
    }
  }
}

// Two flutes with runout, at a speed that drifts: their order 5 crosses a mode before the cut is unstable and becomes
// less from then on. There is no onset to be heard, and what is locked to a spindle order goes with it.
TEST(KnownCuts, AnOrderThatLeavesAModeTellsNoOnset) {
  EXPECT_FALSE(simulate(orderOf("speed ramp", 8, "Z2-508")).at20 > 0.0);
  const KnownCut cut = simulate(orderOf("speed ramp", 12, "Z2-512"));
  EXPECT_EQ(cut.kind, ChatterKind::Flip);
  const double rpm = cut.spindleRpm[static_cast<std::size_t>(cut.at20 / cut.machineStep)];
  EXPECT_NEAR(cut.chatterHz, 5.0 * rpm / 60.0, 1e-6 * cut.chatterHz);
}

// Chatter at order 6.93. Over the turns in which it goes round once against the seventh, it is orthogonal to that and
// all other orders: what is left at its frequency is it alone.
TEST(KnownCuts, ALineNearAnOrderHasAFifthOfTheForcedAmplitudeWhenTheTruthSaysSo) {
  for (const char* name : {"Z4-206", "Z4-208"}) {
    const KnownCut cut = simulate(orderOf("depth ramp", 8, name));
    const double orders = cut.chatterHz * 60.0 / cut.rpm;
    const double turns = std::round(1.0 / std::abs(orders - std::round(orders)));
    const auto length = static_cast<std::size_t>(turns * 60.0 / cut.rpm * cut.recording.rate);
    const auto first = static_cast<std::size_t>(cut.at20 * cut.recording.rate) - length / 2;
    double line = 0.0;
    double all = 0.0;
    for (const auto& x : cut.clean) {
      std::complex<double> sum;
      for (std::size_t i = 0; i < length; ++i) {
        const double value = static_cast<double>(x[first + i]);
        sum += value * std::polar(1.0, -kTwoPi * cut.chatterHz / cut.recording.rate * static_cast<double>(i));
        all += value * value / static_cast<double>(length);
      }
      line += 2.0 * std::norm(sum / static_cast<double>(length));
    }
    // It grows by e in 30 ms, and these turns are a tenth of a second: their mean is up to half as much again.
    EXPECT_GT(std::sqrt(line / (all - line)), 0.15) << cut.name;
    EXPECT_LT(std::sqrt(line / (all - line)), 0.4) << cut.name;
  }
}

// Of a line at order 6.63 the filter on the sixth keeps a part, which turns by more than half a turn a turn. That order
// has outgrown its floor; the frequency told is that of the line all the same.
TEST(KnownCuts, AnOrderThatALineBrushesDoesNotTakeItsPlace) {
  const KnownCut cut = simulate(orderOf("depth ramp", 4, "Z4-204"));
  detect::testing::RunOptions options;
  options.teeth = cut.teeth;
  options.rpm = 0.97 * cut.rpm;
  options.channels = {1};
  int told = 0;
  for (const Verdict& v : detect::testing::run(cut.recording, options, "energy-ratio").verdicts) {
    const double time = sinceEpoch(v.time).value;
    if (!v.alarming() || time > cut.at20 + 0.1) continue;
    EXPECT_NEAR(v.frequency.value, cut.chatterHz, 0.01 * cut.chatterHz) << time << " s";
    ++told;
  }
  EXPECT_GT(told, 10);
}

// A face mill is seconds on its way into the work and out of it, and while its arc changes the tooth passings move and
// pull the speed that is tracked by a quarter of a per cent; its runout crosses a mode and turns by that.
TEST(KnownCuts, AFaceMillOnItsWayInAndOutRaisesNoAlarm) {
  expectSilent(orderOf("stable, face mill in and out", 9, "F4-2209"), -0.03);
  expectSilent(orderOf("stable, face mill in and out", 9, "F4-2209"), -0.02);
}

}  // namespace
}  // namespace stillcut::bench
