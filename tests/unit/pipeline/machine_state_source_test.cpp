#include "core/pipeline/machine_state_source.h"

#include <gtest/gtest.h>

#include "core/pipeline/link_runner.h"

namespace stillcut::pipeline {
namespace {

StepInput blockAt(double end_s) {
  StepInput in;
  in.block.rate = Hertz(1000.0);
  in.block.frames = 10;
  in.block.firstSample = Instant(toDuration(Seconds(end_s - 0.01)));
  return in;
}

TEST(LiveStateSource, GivesTheNewestStateAndInputsInOrder) {
  rt::Mailbox<MachineState> states;
  rt::SpscRing<OperatorInput> inputs(8);
  LiveStateSource feed(states, inputs);

  StepInput step = blockAt(1.0);
  step.machine.valid = true;  // left over from an older use of the slot
  feed.complete(step);
  EXPECT_FALSE(step.machine.valid);
  EXPECT_EQ(step.inputCount, 0);

  MachineState state;
  state.valid = true;
  state.actualSpeed = Rpm(5000.0);
  states.post(state);
  state.actualSpeed = Rpm(5100.0);
  states.post(state);
  for (int i = 0; i < 6; ++i) {
    inputs.push({i % 2 == 0 ? OperatorAction::Hold : OperatorAction::EndHold, Authority::Off});
  }
  feed.complete(step);
  EXPECT_DOUBLE_EQ(step.machine.actualSpeed.value, 5100.0);
  ASSERT_EQ(step.inputCount, kMaxInputsPerStep);
  EXPECT_EQ(step.inputs[0].action, OperatorAction::Hold);
  EXPECT_EQ(step.inputs[1].action, OperatorAction::EndHold);
  feed.complete(step);  // the rest comes with the next block; the state stays the newest there is
  EXPECT_EQ(step.inputCount, 2);
  EXPECT_DOUBLE_EQ(step.machine.actualSpeed.value, 5100.0);
}

// Tells its speed as a slow control does: what was measured 30 ms ago, and when. The spindle runs up meanwhile.
class SlowToTell final : public cnc::CncLink {
 public:
  static constexpr Seconds kLate{0.030};
  static Rpm speedAt(Instant time) { return Rpm(5000.0 + 1000.0 * sinceEpoch(time).value); }
  cnc::LinkInfo describe() const override { return {.id = "slow", .label = "Slow"}; }
  Status open() override { return Done{}; }
  MachineState read(Instant now) noexcept override {
    MachineState m;
    m.time = now;
    m.valid = m.linkUp = true;
    m.link.speed = now - toDuration(kLate);
    m.actualSpeed = speedAt(m.link.speed);
    return m;
  }
  void apply(const OverrideCommand& /*command*/, Instant /*now*/) noexcept override {}
  void release(Instant /*now*/) noexcept override {}
};

// On the samples' clock, and nobody restamps: with every block comes what the machine told of a moment before its end,
// which moment, and so how late it is.
TEST(LiveStateSource, TelemetryKeepsItsPlaceAmongTheSamplesAndItsDelay) {
  SlowToTell link;
  rt::Mailbox<OverrideCommand> commands;
  rt::Mailbox<MachineState> states;
  rt::SpscRing<OperatorInput> inputs(8);
  LinkRunner runner(link, commands, states);
  LiveStateSource feed(states, inputs);
  constexpr double kTick = 0.007, kBlock = 0.010;  // the link's thread and the samples go by different steps
  int ticks = 0;
  for (int block = 100; block < 300; ++block) {
    const double end = block * kBlock;
    for (; (ticks + 1) * kTick <= end; ++ticks) runner.tick(Instant(toDuration(Seconds((ticks + 1) * kTick))));
    StepInput step = blockAt(end);
    feed.complete(step);
    ASSERT_TRUE(step.machine.valid);
    EXPECT_DOUBLE_EQ(step.machine.actualSpeed.value, SlowToTell::speedAt(step.machine.link.speed).value);
    const double late = secondsBetween(step.machine.link.speed, step.block.end()).value;
    EXPECT_GE(late, SlowToTell::kLate.value - 1e-6);
    EXPECT_LE(late, SlowToTell::kLate.value + kTick + 1e-6);
    EXPECT_NEAR(secondsBetween(step.machine.link.speed, step.machine.time).value, SlowToTell::kLate.value, 1e-9);
  }
}

TEST(SpeedLogSource, InterpolatesAndHoldsTheEnds) {
  SpeedLogSource feed({{Seconds(1.0), Rpm(6000.0)}, {Seconds(2.0), Rpm(7000.0)}});
  constexpr double kFirst = 5000.0;  // sessions carry the clock of their cut; the log begins with the first sample
  StepInput first = blockAt(kFirst + 0.01);
  feed.complete(first);
  const auto speedAt = [&](double t) {
    StepInput step = blockAt(kFirst + t);
    feed.complete(step);
    EXPECT_TRUE(step.machine.valid);
    EXPECT_TRUE(step.machine.linkUp);  // otherwise the speed is not believed
    return step.machine.actualSpeed.value;
  };
  EXPECT_DOUBLE_EQ(speedAt(0.5), 6000.0);
  EXPECT_NEAR(speedAt(1.25), 6250.0, 1e-3);
  EXPECT_DOUBLE_EQ(speedAt(9.0), 7000.0);
}

TEST(SpeedLogSource, WithoutALogTheMachineIsUnknown) {
  SpeedLogSource feed({});
  StepInput step = blockAt(1.0);
  feed.complete(step);
  EXPECT_FALSE(step.machine.valid);
}

}  // namespace
}  // namespace stillcut::pipeline
