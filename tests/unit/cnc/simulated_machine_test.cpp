// The simulated control and its plant, by turns in one thread.
#include "core/cnc/simulated_machine.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "core/cnc/registry.h"
#include "tests/support/gate_harness.h"

namespace stillcut::cnc {
namespace {

milling::Scenario demo() {
  Result<milling::Scenario> s = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml");
  if (!s) throw std::runtime_error(s.error().line());
  return *s;
}

// Plant, port and machine; run() is what the source's thread does.
struct Bench {
  Bench() : plant(demo()), port(std::make_shared<milling::PlantPort>()), machine(demo(), port) {
    block.allocate(2, 256);
    port->publish(plant);
  }
  void run(double seconds) {
    const double until = plant.time().value + seconds;
    while (plant.time().value < until) {
      port->serve(plant);
      plant.fill(block);
      port->publish(plant);
    }
  }
  Instant now() const { return block.end(); }

  milling::SimulatedCut plant;
  std::shared_ptr<milling::PlantPort> port;
  SimulatedMachine machine;
  SampleBlock block;
};

// A command as only the gate can make it: chatter, Auto, a wish for 80 %.
OverrideCommand eightyPercent() {
  safety::testing::GateHarness gate;
  gate.settleAt(8000.0, 800.0);
  for (int i = 0; i < 100; ++i) {
    const safety::GateOutput out = gate.step();
    if (out.command && out.command->kind() == CommandKind::Set) return *out.command;
  }
  throw std::runtime_error("the gate gives no command");
}

TEST(SimulatedMachine, ReadsTheProgrammedCut) {
  Bench b;
  ASSERT_TRUE(b.machine.open().ok());
  b.run(0.1);
  const MachineState m = b.machine.read(b.now());
  EXPECT_TRUE(m.valid && m.linkUp && m.programRunning && m.atSpeed && m.overridesEnabled && m.controlOurs);
  EXPECT_EQ(m.programmedSpeed.value, 8500.0);
  EXPECT_NEAR(toMmPerMin(m.programmedFeed), 0.08 * 4 * 8500.0, 1e-6);
  EXPECT_NEAR(secondsBetween(m.time, b.now()).value, 0.0, 1.0 / 25600.0);  // as old as the newest sample
  EXPECT_TRUE(b.machine.describe().simulated);
}

TEST(SimulatedMachine, CommandTurnsTheSpindleAndReleaseBringsItBack) {
  Bench b;
  const OverrideCommand command = eightyPercent();
  b.run(0.1);
  b.machine.apply(command, b.now());
  b.run(1.5);
  MachineState m = b.machine.read(b.now());
  EXPECT_NEAR(m.speedOverride.value, command.speed().value, 0.001);
  EXPECT_NEAR(m.actualSpeed.value, 8500.0 * command.speed().value, 20.0);
  EXPECT_EQ(m.programmedSpeed.value, 8500.0);
  b.machine.release(b.now());
  b.run(1.5);
  m = b.machine.read(b.now());
  EXPECT_EQ(m.speedOverride.value, 1.0);
  EXPECT_NEAR(m.actualSpeed.value, 8500.0, 20.0);
}

TEST(SimulatedMachine, OperatorsKnobMultiplies) {
  Bench b;
  const OverrideCommand command = eightyPercent();
  b.machine.turnKnobs(Ratio(0.9), Ratio(0.5));
  b.machine.apply(command, b.now());
  b.run(0.3);
  const MachineState m = b.machine.read(b.now());
  EXPECT_EQ(m.operatorSpeed.value, 0.9);
  EXPECT_NEAR(m.speedOverride.value, 0.9 * command.speed().value, 0.001);
}

TEST(SimulatedMachine, DisabledOverridesGiveTheProgrammedValues) {
  Bench b;
  b.machine.apply(eightyPercent(), b.now());
  b.machine.enableOverrides(false);
  b.run(0.3);
  EXPECT_FALSE(b.machine.read(b.now()).overridesEnabled);
  EXPECT_EQ(b.machine.read(b.now()).speedOverride.value, 1.0);
}

TEST(SimulatedMachine, LostLinkReadsInvalidAndTheMachineRestores) {
  Bench b;
  b.machine.apply(eightyPercent(), b.now());
  b.run(0.3);
  b.machine.loseLink(true);
  EXPECT_FALSE(b.machine.read(b.now()).valid);
  EXPECT_FALSE(b.machine.read(b.now()).linkUp);
  b.machine.apply(eightyPercent(), b.now());  // lost with the link
  b.run(0.3);
  b.machine.loseLink(false);
  EXPECT_TRUE(b.machine.read(b.now()).valid);
  EXPECT_EQ(b.machine.read(b.now()).speedOverride.value, 1.0);
}

TEST(SimulatedMachine, TakesNothingWhileAnotherClientHasControl) {
  Bench b;
  b.machine.giveControlAway(true);
  b.machine.apply(eightyPercent(), b.now());
  b.run(0.3);
  EXPECT_FALSE(b.machine.read(b.now()).controlOurs);
  EXPECT_EQ(b.machine.read(b.now()).speedOverride.value, 1.0);
}

TEST(LinkRegistry, SavedDelaysAreEveryLinksAndComeBack) {
  LinkRequest request;
  const milling::Scenario scenario = demo();
  request.scenario = &scenario;
  request.port = std::make_shared<milling::PlantPort>();
  saveDelay(request.settings, kSavedEffect, Seconds(0.0961));
  EXPECT_NEAR(savedDelay(request.settings, kSavedEffect).value, 0.0961, 1e-9);
  EXPECT_EQ(savedDelay(request.settings, kSavedDelay).value, 0.0);
  EXPECT_TRUE(makeLink("simulated", request).ok());
  request.settings["effect_ms"] = "soon";
  EXPECT_EQ(savedDelay(request.settings, kSavedEffect).value, 0.0);
  const auto refused = makeLink("simulated", request);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().line(), "link 'simulated': 'effect_ms' is no delay (soon)");
}

TEST(LinkRegistry, MakesWhatItListsAndNamesTheKnown) {
  const milling::Scenario s = demo();
  LinkRequest request;
  EXPECT_FALSE(makeLink("simulated", request).ok());
  request.scenario = &s;
  request.port = std::make_shared<milling::PlantPort>();
  EXPECT_TRUE(makeLink("simulated", request).ok());
  EXPECT_FALSE(makeLink("linuxncn", request).ok());
}

}  // namespace
}  // namespace stillcut::cnc
