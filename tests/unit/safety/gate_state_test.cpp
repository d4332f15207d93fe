// The gate's table of states by itself, and the time of its steps.
#include "core/safety/gate_state.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/safety/step_clock.h"

namespace stillcut::safety {
namespace {

constexpr GateState state(std::size_t i) {
  return static_cast<GateState>(i);
}
constexpr GateCause cause(std::size_t i) {
  return static_cast<GateCause>(i);
}

TEST(GateState, ASetEndsInAReleaseAndNothingElse) {
  for (std::size_t s = 0; s < kGateStates; ++s) {
    for (std::size_t c = 0; c < kGateCauses; ++c) {
      const GateState next = after(state(s), cause(c));
      if (commands(state(s)) && !commands(next)) {
        EXPECT_EQ(next, GateState::OwesRelease) << s << " " << c;
      }
      if (!commands(state(s)) && commands(next)) {
        EXPECT_EQ(cause(c), GateCause::Takes) << s;
        EXPECT_EQ(state(s), GateState::Idle);
      }
      if (state(s) == GateState::OwesRelease && next != state(s)) {
        EXPECT_EQ(cause(c), GateCause::Sends);
      }
    }
  }
}

TEST(GateState, WhoLetsGoIsNotCalledBack) {
  std::set<GateState> reached{GateState::LettingGo};
  for (std::size_t round = 0; round < kGateStates; ++round) {
    for (const GateState from : std::set<GateState>(reached)) {
      for (std::size_t c = 0; c < kGateCauses; ++c) {
        if (from != GateState::OwesRelease) reached.insert(after(from, cause(c)));
      }
    }
  }
  EXPECT_EQ(reached, (std::set<GateState>{GateState::LettingGo, GateState::OwesRelease}));
}

TEST(GateState, WhateverIsInForceCanBeDroppedAndGivenUp) {
  for (const GateState s : {GateState::Engaged, GateState::Returning, GateState::LettingGo}) {
    EXPECT_EQ(after(s, GateCause::Drops), GateState::OwesRelease);
    EXPECT_EQ(after(s, GateCause::GivesUp), GateState::LettingGo);
  }
  EXPECT_EQ(after(GateState::Returning, GateCause::Follows), GateState::Engaged);
}

TEST(StepClock, TellsStillAndBackAndJumpFromAStep) {
  StepClock clock;
  const auto at = [&clock](std::int64_t ms, double measured = 0.005) {
    return clock.advance(instantFromNs(ms * 1'000'000), Seconds(measured), Seconds(0.2));
  };
  using Step = StepClock::Step;
  EXPECT_EQ(at(1000), Step::First);
  EXPECT_EQ(at(1010), Step::Good);
  EXPECT_DOUBLE_EQ(clock.elapsed(), 0.01);
  EXPECT_DOUBLE_EQ(clock.moveTime(), 0.005);
  EXPECT_EQ(at(1020, std::numeric_limits<double>::quiet_NaN()), Step::Unmeasured);
  EXPECT_DOUBLE_EQ(clock.elapsed(), 0.01);
  EXPECT_EQ(clock.moveTime(), 0.0);
  EXPECT_EQ(at(1020), Step::Back);
  EXPECT_EQ(at(1000), Step::Back);
  EXPECT_EQ(at(1300), Step::Jump);
  EXPECT_EQ(clock.elapsed(), 0.0);
  clock.restart();
  EXPECT_EQ(at(5000), Step::First);
}

}  // namespace
}  // namespace stillcut::safety
