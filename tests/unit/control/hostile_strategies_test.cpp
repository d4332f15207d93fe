// Every strategy between hostile verdicts and the gate: nothing that it asks for makes the gate breach its rules, an
// unusable input is never answered with a Set, and deciding never allocates.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/control/registry.h"
#include "core/safety/override_gate.h"
#include "tests/support/gate_oracle.h"
#include "tests/support/hostile_world.h"
#include "tests/support/path_counter.h"

namespace stillcut::control {
namespace {

class HostileStrategies : public ::testing::TestWithParam<std::string_view> {};

TEST_P(HostileStrategies, AMillionStepsBehindTheGate) {
  constexpr long kSteps = 1'000'000;
  auto strategy = makeStrategy(GetParam());
  ASSERT_TRUE(strategy.ok());
  CutSetup setup;
  setup.teeth = 4;
  (*strategy)->prepare(setup, {});
  safety::testing::HostileWorld world(7);
  safety::testing::GateOracle oracle;
  safety::OverrideGate gate;
  long allocations = 0;
  std::set<ReasonCode> said;
  for (long i = 0; i < kSteps; ++i) {
    if (i == 0 || world.chance(0.0003)) {
      const safety::GateLimits limits = world.limits();
      gate.prepare(limits);
      oracle.prepared(limits);
      (*strategy)->reset();
    }
    world.advance();
    if (world.chance(0.001)) (*strategy)->relinquish();
    const auto level = [&world](double highest) {
      return world.chance(0.1) ? world.nonsense() : world.uniform(0.0, highest);
    };
    const StrategyInput in{.now = world.in.now,
                           .dt = world.in.dt,
                           .verdict = world.in.verdict,
                           .machine = world.in.machine,
                           .perturbation = level(10.0),
                           .vibration = level(100.0),
                           .coherence = level(1.0),
                           .energy = level(100.0)};
    const test::PathCounter counter;
    world.in.request = (*strategy)->decide(in);
    const safety::GateOutput out = gate.step(world.in);
    allocations += counter.counts().allocations;
    if (!in.verdict.valid || !in.machine.valid) {
      ASSERT_NE(world.in.request.kind, RequestKind::Set);
    }
    if (said.insert(world.in.request.reason.code).second) {
      const std::string_view words = pattern(world.in.request.reason.code);
      EXPECT_NE(words.find('{'), std::string_view::npos) << "without a number: '" << words << "'";
    }
    for (const double number : world.in.request.reason.n) {
      ASSERT_TRUE(std::isfinite(number)) << "step " << i << ": " << sentence(world.in.request.reason);
    }
    const std::string breach = oracle.breach(world.in, out);
    ASSERT_TRUE(breach.empty()) << "step " << i << ": " << breach;
    world.answered(out);
  }
  EXPECT_EQ(allocations, 0U);
  if ((*strategy)->describe().id == "monitor") {
    EXPECT_EQ(oracle.sets, 0);
  } else {
    EXPECT_GT(oracle.sets, kSteps / 50);
  }
}

INSTANTIATE_TEST_SUITE_P(All, HostileStrategies, ::testing::ValuesIn([] {
                           std::vector<std::string_view> ids;
                           for (const StrategyEntry& entry : strategyTable()) ids.push_back(entry.id);
                           return ids;
                         }()),
                         [](const auto& test) {
                           std::string name(test.param);
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace stillcut::control
