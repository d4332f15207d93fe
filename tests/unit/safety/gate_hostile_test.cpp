// A million hostile steps through the gate, judged by an oracle that shares no code with it; and no allocation.
#include <gtest/gtest.h>

#include "core/safety/override_gate.h"
#include "tests/support/gate_oracle.h"
#include "tests/support/hostile_world.h"
#include "tests/support/path_counter.h"

namespace stillcut::safety {
namespace {

using testing::GateOracle;
using testing::HostileWorld;

class GateHostile : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(GateHostile, AMillionStepsWithoutABreach) {
  constexpr long kSteps = 1'000'000;
  HostileWorld world(GetParam());
  OverrideGate gate;
  GateOracle oracle;
  std::uint64_t engagements = 0;
  std::uint64_t allocations = 0;
  for (long i = 0; i < kSteps; ++i) {
    if (i == 0 || world.chance(0.0001)) {
      const GateLimits limits = world.limits();
      gate.prepare(limits);
      oracle.prepared(limits, world.cutter);
    }
    world.advance();
    world.in.request = world.wildRequest();
    const test::PathCounter counter;
    const GateOutput out = gate.step(world.in);
    allocations += counter.counts().allocations;
    const std::string breach = oracle.breach(world.in, out);
    ASSERT_TRUE(breach.empty()) << "step " << i << ": " << breach;
    world.answered(out);
    if (out.command) engagements = out.command->engagement();
  }
  EXPECT_EQ(allocations, 0U);
  // The gate was really driven, not merely refusing everything.
  EXPECT_GT(oracle.sets, kSteps / 8);
  EXPECT_GT(engagements, 500U);
  EXPECT_GT(oracle.withdrawn, 20);
}

INSTANTIATE_TEST_SUITE_P(Seeds, GateHostile, ::testing::Values(1U, 2U, 3U));

}  // namespace
}  // namespace stillcut::safety
