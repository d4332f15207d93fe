// What a killed program has left standing: on record before it is sent, told from the operator's own at the next
// connection, and brought back at the operator's press and not before.
#include "core/cnc/remembering_link.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <stdexcept>

#include "core/cnc/grbl/grbl_link.h"
#include "core/cnc/modbus/modbus_link.h"
#include "core/cnc/simulated_machine.h"
#include "core/milling/simulation/simulated_cut.h"
#include "core/pipeline/link_runner.h"
#include "tests/protocol/emc_bench.h"
#include "tests/protocol/modbus/fake_plc.h"
#include "tests/support/grbl/fake_grbl.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

constexpr SentOverrides kLeft{{100, 83}, {100, 83}};

// What is on record outlives the link.
struct Record {
  std::optional<SentOverrides> now;
  int kept = 0;
  bool fresh = false;
};
class FakeMemory final : public OverrideMemory {
 public:
  explicit FakeMemory(Record& record) : record_(record), left_(record.now) {}
  std::optional<SentOverrides> left() const override { return left_; }
  bool fresh() const noexcept override { return record_.fresh; }
  void keep(const SentOverrides& sent) noexcept override {
    record_.now = sent;
    ++record_.kept;
  }
  void forget() noexcept override { record_.now.reset(); }

 private:
  Record& record_;
  std::optional<SentOverrides> left_;
};

// The gate's answer to the button, with nothing in force.
OverrideCommand backToProgrammed() {
  safety::testing::GateHarness gate;
  const safety::GateOutput out = gate.act(OperatorAction::BackToProgrammed);
  if (!out.command) throw std::runtime_error("the gate gives no Release");
  return *out.command;
}

struct GrblBench {
  explicit GrblBench(const std::optional<SentOverrides>& left) {
    record.now = left;
    auto wire = std::make_unique<ScriptedWire>(clock, faults, grbl);
    link = std::make_unique<RememberingLink>(std::make_unique<GrblLink>(GrblSettings{}, std::move(wire), clock),
                                             std::make_unique<FakeMemory>(record), offered);
  }
  MachineState run(double seconds) {
    const Instant until = clock.now() + toDuration(Seconds(seconds));
    MachineState m;
    while (clock.now() < until) {
      m = link->read(clock.now());
      clock.advance(Seconds(0.005));
    }
    return m;
  }
  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults;
  FakeGrbl grbl;
  Record record;
  std::shared_ptr<SentOverridesCell> offered = std::make_shared<SentOverridesCell>();
  CommandMaker gate;
  std::unique_ptr<RememberingLink> link;
};

TEST(RememberingLink, WhatIsSentIsOnRecordUntilItIsHome) {
  GrblBench b(std::nullopt);
  b.grbl.spindle = 110;  // the operator's own
  b.run(1.0);
  EXPECT_FALSE(b.record.now);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  ASSERT_TRUE(b.record.now) << "before the wire has taken anything";
  EXPECT_EQ(*b.record.now, (SentOverrides{{110, 99}, {100, 90}}));
  b.run(1.0);
  EXPECT_EQ(b.grbl.spindle, 99);
  const int kept = b.record.kept;
  b.link->apply(b.gate.set(90.0), b.clock.now());  // renewed, as in every block
  EXPECT_EQ(b.record.kept, kept);
  b.link->apply(b.gate.relinquish(), b.clock.now());
  b.run(1.0);
  EXPECT_EQ(b.grbl.spindle, 110);
  EXPECT_FALSE(b.record.now);
  EXPECT_FALSE(b.offered->get());
}

TEST(RememberingLink, GrblIsOfferedBackAndGoesHomeAtThePressAlone) {
  GrblBench b(kLeft);
  b.grbl.feed = b.grbl.spindle = 83;
  b.run(3.0);
  EXPECT_EQ(b.offered->get(), kLeft);
  EXPECT_EQ(b.grbl.moved, "") << "nothing moves without the operator";
  b.link->apply(backToProgrammed(), b.clock.now());
  b.run(1.0);
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
  EXPECT_FALSE(b.record.now);
  EXPECT_FALSE(b.offered->get());
}

TEST(RememberingLink, AHandBeforeThePressIsNotSentOver) {
  GrblBench b(kLeft);
  b.grbl.feed = b.grbl.spindle = 83;
  b.run(1.0);
  b.grbl.spindle = 95;
  b.run(3.0);
  ASSERT_TRUE(b.offered->get());
  EXPECT_EQ(b.offered->get()->speed.sent, b.offered->get()->speed.base) << "the spindle is the operator's";
  b.link->apply(backToProgrammed(), b.clock.now());
  b.run(1.0);
  EXPECT_EQ(b.grbl.spindle, 95);
  EXPECT_EQ(b.grbl.feed, 100);
}

TEST(RememberingLink, WhatDoesNotStandAsItWasLeftIsTheOperators) {
  for (const int stands : {100, 90, 70}) {
    GrblBench b(kLeft);
    b.grbl.feed = b.grbl.spindle = stands;
    b.run(3.0);
    EXPECT_FALSE(b.offered->get()) << stands;
    EXPECT_FALSE(b.record.now) << stands;
    b.link->apply(backToProgrammed(), b.clock.now());
    b.run(1.0);
    EXPECT_EQ(b.grbl.spindle, stands);
    EXPECT_EQ(b.grbl.feed, stands);
  }
}

// A keeper that was killed in the middle of a ramp: its successor knows that nobody else had the time.
TEST(RememberingLink, WhatWasOnItsWayAMomentAgoIsOurs) {
  GrblBench b(kLeft);
  b.record.fresh = true;
  b.grbl.feed = b.grbl.spindle = 91;
  b.run(3.0);
  EXPECT_TRUE(b.offered->get());
  b.link->apply(backToProgrammed(), b.clock.now());
  b.run(1.0);
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

// The last step of the ramp may be younger than its record.
TEST(RememberingLink, AnOrderThatWasOneStepAheadOfItsRecordIsKnownAgain) {
  GrblBench b(SentOverrides{{100, 84}, {100, 85}});
  b.grbl.feed = b.grbl.spindle = 83;
  b.run(2.0);
  EXPECT_TRUE(b.offered->get());
}

TEST(RememberingLink, ANewEngagementEndsTheOffer) {
  GrblBench b(kLeft);
  b.grbl.feed = b.grbl.spindle = 83;
  b.run(1.0);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  EXPECT_FALSE(b.offered->get());
  EXPECT_EQ(b.grbl.spindle, 75);
  b.link->apply(b.gate.relinquish(), b.clock.now());
  b.run(1.0);
  EXPECT_EQ(b.grbl.spindle, 83);
}

TEST(RememberingLink, LinuxCncIsOfferedBackAndGoesHomeAtThePressAlone) {
  EmcBench b;
  b.mill.feed = b.mill.spindle = b.mill.shownFeed = b.mill.shownSpindle = 83;
  Record record{kLeft};
  const auto offered = std::make_shared<SentOverridesCell>();
  RememberingLink link(std::move(b.link), std::make_unique<FakeMemory>(record), offered);
  const auto run = [&](double seconds) {
    const Instant until = b.clock.now() + toDuration(Seconds(seconds));
    while (b.clock.now() < until) {
      (void)link.read(b.clock.now());
      b.clock.advance(Seconds(0.005));
    }
  };
  ASSERT_TRUE(link.open());  // reads once, and lets go of the connection: what it read then is no reading of the next
  run(5.0);
  EXPECT_EQ(offered->get(), kLeft);
  EXPECT_EQ(b.mill.spindle, 83);
  link.apply(backToProgrammed(), b.clock.now());
  run(10.0);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_EQ(b.mill.feed, 100);
  EXPECT_FALSE(record.now);
}

// Its feed override is not read back, and its knob is another register.
TEST(RememberingLink, ModbusIsOfferedBackAndGoesHomeAtThePressAlone) {
  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  FakePlc plc;
  plc.watched = false;
  plc.holding(100) = plc.holding(101) = 830;
  Record record{kLeft};
  const auto offered = std::make_shared<SentOverridesCell>();
  RememberingLink link(std::make_unique<ModbusLink>(exampleMap(), std::make_unique<FakeBus>(clock, plc), clock),
                       std::make_unique<FakeMemory>(record), offered);
  const auto run = [&](double seconds) {
    for (const Instant until = clock.now() + toDuration(Seconds(seconds)); clock.now() < until;) {
      plc.run(clock.now());
      link.read(clock.now());
      clock.advance(Seconds(0.005));
    }
  };
  run(1.0);
  EXPECT_EQ(offered->get(), kLeft);
  EXPECT_EQ(plc.writes, 0) << "nothing moves without the operator";
  link.apply(backToProgrammed(), clock.now());
  run(1.0);
  EXPECT_EQ(plc.holding(100), 1000);
  EXPECT_EQ(plc.holding(101), 1000);
  EXPECT_FALSE(record.now);
  EXPECT_FALSE(offered->get());
}

// The program's own machine, through the runner that checks leases.
TEST(RememberingLink, TheSimulatedMachineGoesHomeThroughTheRunner) {
  const auto scenario = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml");
  ASSERT_TRUE(scenario.ok());
  milling::SimulatedCut cut(*scenario);
  const auto port = std::make_shared<milling::PlantPort>();
  SampleBlock block;
  block.allocate(static_cast<int>(scenario->cutSetup().channels.size()), scenario->blockFrames);
  Instant now{};
  const auto blocks = [&](int count, const std::function<void()>& tick) {
    for (int i = 0; i < count; ++i) {
      port->serve(cut);
      ASSERT_TRUE(cut.fill(block));
      now = block.end();
      port->publish(cut);
      tick();
    }
  };
  Record record;
  CommandMaker gate;
  {  // killed: its plant goes on
    RememberingLink link(std::make_unique<SimulatedMachine>(*scenario, port), std::make_unique<FakeMemory>(record),
                         std::make_shared<SentOverridesCell>());
    const OverrideCommand command = gate.set(90.0);
    blocks(200, [&] {
      link.apply(command, now);
      (void)link.read(now);
    });
  }
  ASSERT_TRUE(record.now) << "nobody has brought it home";
  const auto offered = std::make_shared<SentOverridesCell>();
  RememberingLink link(std::make_unique<SimulatedMachine>(*scenario, port), std::make_unique<FakeMemory>(record),
                       offered);
  rt::Mailbox<OverrideCommand> commands;
  rt::Mailbox<MachineState> states;
  pipeline::LinkRunner runner(link, commands, states);
  blocks(100, [&] { runner.tick(now); });
  ASSERT_TRUE(offered->get());
  EXPECT_EQ(offered->get()->speed, (SentOverride{100, 90}));
  EXPECT_NEAR(states.latest()->speedOverride.value, 0.9, 0.01);
  commands.post(backToProgrammed());
  blocks(400, [&] { runner.tick(now); });
  EXPECT_NEAR(states.latest()->speedOverride.value, 1.0, 0.005);
  EXPECT_FALSE(offered->get());
  EXPECT_FALSE(record.now);
}

}  // namespace
}  // namespace stillcut::cnc
