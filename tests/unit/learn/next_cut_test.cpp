// The trial that is named keeps the user's limits and is worth making.
#include "core/learn/next_cut.h"

#include <gtest/gtest.h>

#include "tests/support/hidden_machines/learning_trial.h"

namespace stillcut::learn {
namespace {

TrialLimits limitsOf(const test::HiddenMachine& machine) {
  TrialLimits limits;
  limits.engagement = machine.model.engagement;
  limits.teeth = machine.model.tool.teeth;
  limits.lowest = machine.lowest;
  limits.highest = machine.highest;
  limits.deepest = machine.deepest;
  return limits;
}

LobePosterior begun(const test::HiddenMachine& machine) {
  LearnParams params;
  params.guesses = 300;
  return {priorOfTool(machine.model.tool.diameter, machine.material), test::rangeFor(machine), params};
}

TEST(NextCut, KeepsTheLimitsOfTheUser) {
  const test::HiddenMachine machine = test::hiddenMachine(21);
  LobePosterior posterior = begun(machine);
  TrialLimits limits = limitsOf(machine);
  limits.deepest = Metres(0.002);
  limits.lowest = Rpm(7000.0);
  limits.highest = Rpm(8000.0);
  limits.mostChatter = 0.3;
  const auto next = nextCut(posterior, limits);
  ASSERT_TRUE(next.ok());
  EXPECT_GE(next->speed, limits.lowest);
  EXPECT_LE(next->speed, limits.highest);
  EXPECT_LE(next->depth.value, limits.deepest.value * (1.0 + 1e-9));
  EXPECT_GE(next->probabilityStable, 0.7);
  EXPECT_GT(next->bits, 0.0);
  EXPECT_GE(next->removalExpected, 0.9 * next->removalNow);
}

TEST(NextCut, FiveChosenCutsRaiseWhatMayBeRemoved) {
  double before = 0.0;
  double after = 0.0;
  for (std::uint64_t seed = 601; seed <= 603; ++seed) {
    const test::HiddenMachine machine = test::hiddenMachine(seed);
    LobePosterior posterior = begun(machine);
    Random random(seed);
    TrialLimits limits = limitsOf(machine);
    for (int i = 0; i < 5; ++i) {
      limits.cutsLeft = 5 - i;
      const auto next = nextCut(posterior, limits);
      ASSERT_TRUE(next.ok());
      if (i == 0) before += next->removalNow;
      const CutEvidence cut = makeCut(machine, i, next->speed, next->depth, machine.model.engagement, random);
      ASSERT_TRUE(posterior.add(cut).ok());
    }
    after += learnedAdvice(posterior, test::workOf(machine), 0.1).removal;
  }
  EXPECT_GT(after, 1.3 * before);
}

TEST(NextCut, RefusesLimitsThatAreNone) {
  const test::HiddenMachine machine = test::hiddenMachine(21);
  LobePosterior posterior = begun(machine);
  TrialLimits limits = limitsOf(machine);
  limits.highest = limits.lowest;
  EXPECT_FALSE(nextCut(posterior, limits).ok());
  limits = limitsOf(machine);
  limits.deepest = Metres{};
  EXPECT_FALSE(nextCut(posterior, limits).ok());
  limits = limitsOf(machine);
  limits.risk = 1.0;
  EXPECT_FALSE(nextCut(posterior, limits).ok());
}

}  // namespace
}  // namespace stillcut::learn
