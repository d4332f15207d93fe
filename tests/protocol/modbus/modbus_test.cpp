// Register maps, and the Modbus link against a machine of registers on virtual time.
#include "core/cnc/modbus/modbus_link.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/protocol/commands.h"
#include "tests/protocol/modbus/fake_plc.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

struct Bench {
  Bench() : link(std::make_unique<ModbusLink>(exampleMap(), std::make_unique<FakeBus>(clock, plc), clock)) {}
  MachineState run(double seconds) {
    const Instant until = clock.now() + toDuration(Seconds(seconds));
    MachineState m;
    while (clock.now() < until) {
      plc.run(clock.now());
      m = link->read(clock.now());
      clock.advance(Seconds(0.005));
    }
    return m;
  }
  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  FakePlc plc;
  CommandMaker gate;
  std::unique_ptr<ModbusLink> link;
};

TEST(Register, EncodesAndDecodesWhatItCanHold) {
  Register r;
  r.scale = 0.1;
  r.words = 2;
  r.isSigned = true;
  for (const double value : {0.0, 80000.0, -80000.0, 214748364.7, -214748364.8}) {
    const auto raw = r.encode(value);
    ASSERT_TRUE(raw) << value;
    EXPECT_NEAR(r.decode(*raw), value, 1e-6);
  }
  EXPECT_FALSE(r.encode(214748365.0));
  r.highWordFirst = false;
  EXPECT_NEAR(r.decode(*r.encode(123456.7)), 123456.7, 1e-6);
  r.words = 1;
  r.isSigned = false;
  EXPECT_FALSE(r.encode(-0.1));
  EXPECT_FALSE(r.encode(6553.6));
  EXPECT_NEAR(r.decode(*r.encode(6553.5)), 6553.5, 1e-9);
}

// 32-bit floats as drives have them: IEEE 754, either word first.
TEST(Register, FloatsOfBothWordOrders) {
  Register r;
  r.isFloat = true;
  r.words = 2;
  EXPECT_EQ(r.decode({0x45FA, 0x0000}), 8000.0);
  EXPECT_NEAR(r.decode({0xC2F6, 0xE979}), -123.456, 1e-5);
  r.highWordFirst = false;
  EXPECT_EQ(r.decode({0x0000, 0x45FA}), 8000.0);
  for (const bool high : {true, false}) {
    r.highWordFirst = high;
    for (const double value : {0.0, 87.5, -12.25, 1e6}) EXPECT_EQ(r.decode(*r.encode(value)), value);
  }
  r.scale = 0.5;
  EXPECT_EQ(r.decode(*r.encode(87.5)), 87.5);
  EXPECT_FALSE(r.encode(1e300));
  EXPECT_FALSE(std::isfinite(r.decode({0x0000, 0x7FC0})));
}

TEST(Modbus, AMapOfFloatsReadsAndMovesTheMachine) {
  for (const bool highFirst : {true, false}) {
    RegisterMap map = exampleMap();
    Register& speed = *map.read[static_cast<std::size_t>(MachineSignal::ActualSpeed)];
    speed = Register{
        .table = RegisterTable::Holding, .address = 40, .words = 2, .isFloat = true, .highWordFirst = highFirst};
    Register& order = *map.write[static_cast<std::size_t>(MachineCommand::SpeedOverride)];
    order = Register{
        .table = RegisterTable::Holding, .address = 50, .words = 2, .isFloat = true, .highWordFirst = highFirst};
    test::VirtualClock clock{instantFromNs(1'000'000'000)};
    FakePlc plc;
    ModbusLink link(map, std::make_unique<FakeBus>(clock, plc), clock);
    plc.holding(highFirst ? 40 : 41) = 0x45FA;
    MachineState m;
    CommandMaker gate;
    const auto run = [&](double seconds) {
      for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end;) {
        plc.run(clock.now());
        m = link.read(clock.now());
        clock.advance(Seconds(0.005));
      }
    };
    run(0.3);
    ASSERT_TRUE(m.valid);
    EXPECT_EQ(m.actualSpeed.value, 8000.0);
    link.apply(gate.set(90.0), clock.now());
    run(0.2);
    EXPECT_EQ(plc.holding(highFirst ? 50 : 51), 0x42B4);  // 90.0f
    // No number is no speed.
    plc.holding(highFirst ? 40 : 41) = 0x7FC0;
    run(1.0);
    EXPECT_FALSE(m.valid);
  }
}

TEST(RegisterMap, BadMapsAreRefusedWithPlaceAndReason) {
  const std::string good =
      "version = 1\n[bus]\nhost = 'h'\n[override]\nlowest_speed_percent = 50\n"
      "highest_speed_percent = 120\n[read.programmed_speed]\naddress = 0\n[read.actual_speed]\n"
      "address = 1\n[write.speed_override]\naddress = 2\n";
  ASSERT_TRUE(parseRegisterMap(good, "m").ok());
  struct Case {
    std::string from, to, says;
  };
  for (const Case& c :
       {Case{"address = 2", "address = 70000", "address"}, Case{"address = 2", "address = 2\nscale = 0.0", "scale"},
        Case{"address = 2", "address = 2\ntable = 'input'", "cannot be written"},
        Case{"address = 1\n", "address = 65535\nwords = 2\n", "no room"},
        Case{"version = 1", "version = 1\nwatchdog = true", "heartbeat"},
        Case{"address = 1\n", "address = 1\n[read.heartbeat]\naddress = 3\n", "[write.heartbeat]"},
        Case{"address = 1\n", "address = 1\nfloat = true\nwords = 1\n", "float"},
        Case{"address = 1\n", "address = 1\nfloat = true\nsigned = true\n", "float"},
        Case{"address = 1\n", "address = 65535\nfloat = true\n", "no room"},
        Case{"address = 1\n", "address = 1\nlowest = 5.0\nhighest = 5.0\n", "lowest"},
        Case{"host = 'h'", "host = 'h'\ndevice = '/dev/x'", "host"},
        Case{"[read.actual_speed]", "[read.actual_sped]", "actual_sp"}}) {
    std::string text = good;
    text.replace(text.find(c.from), c.from.size(), c.to);
    const auto map = parseRegisterMap(text, "m");
    ASSERT_FALSE(map.ok()) << c.to;
    EXPECT_NE(map.error().line().find(c.says), std::string::npos) << map.error().line();
  }
}

TEST(RegisterMap, ExampleClaimsNoWatchdogThatNobodyHasSeen) {
  const auto map = loadRegisterMap(STILLCUT_SOURCE_DIR "/resources/machines/modbus-example.toml");
  ASSERT_TRUE(map.ok()) << map.error().line();
  EXPECT_FALSE(map->watchdog);
}

TEST(Modbus, ReadsTheMachineAndWritesNothingUnasked) {
  Bench b;
  b.plc.run(b.clock.now());
  ASSERT_TRUE(b.link->open().ok());
  const MachineState m = b.run(0.5);
  ASSERT_TRUE(m.valid && m.linkUp && m.programRunning && m.atSpeed && !m.feedHold);
  EXPECT_EQ(m.programmedSpeed.value, 8000.0);
  EXPECT_NEAR(m.actualSpeed.value, 8000.0, 0.1);
  EXPECT_EQ(b.plc.writes, 0);
  EXPECT_TRUE(b.link->describe().machineWatchdog);
}

TEST(Modbus, CommandActsWhileTheHeartbeatBeatsAndReleaseBringsBack) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  const MachineState m = b.run(1.0);
  EXPECT_EQ(b.plc.holding(100), 900);
  EXPECT_EQ(b.plc.holding(101), 900);
  EXPECT_EQ((b.plc.words[{RegisterTable::Coil, 7}]), 1);
  EXPECT_NEAR(m.speedOverride.value, 0.9, 1e-9);
  EXPECT_NEAR(m.actualSpeed.value, 7200.0, 0.1);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.plc.holding(100), 1000);
  EXPECT_EQ(b.plc.holding(101), 1000);
  EXPECT_EQ((b.plc.words[{RegisterTable::Coil, 7}]), 0);
}

// The read-back tells it, which is what the gate goes by.
TEST(Modbus, AcknowledgedWithoutEffectIsReadBackAsNone) {
  Bench b;
  b.run(0.2);
  b.plc.lies = true;
  b.link->apply(b.gate.set(90.0), b.clock.now());
  const MachineState m = b.run(0.5);
  EXPECT_GT(m.link.acknowledged, Instant{});
  EXPECT_EQ(m.speedOverride.value, 1.0);
  EXPECT_NEAR(m.actualSpeed.value, 8000.0, 0.1);
}

TEST(Modbus, AbortedProgramIsNotRunningAndTheReleaseBringsBack) {
  Bench b;
  EXPECT_TRUE(b.run(0.2).programRunning);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.2);
  b.plc.running = false;
  EXPECT_FALSE(b.run(0.2).programRunning);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.plc.holding(100), 1000);
  EXPECT_EQ(b.plc.holding(101), 1000);
}

TEST(Modbus, EndOfTheLinkBringsTheOverridesAndControlBack) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.3);
  b.link.reset();
  EXPECT_EQ(b.plc.holding(100), 1000);
  EXPECT_EQ(b.plc.holding(101), 1000);
  EXPECT_EQ((b.plc.words[{RegisterTable::Coil, 7}]), 0);
}

// A program of ours that died has left its overrides there; this one has ordered nothing.
TEST(Modbus, WhatWasLeftByAProgramThatDiedIsReleased) {
  Bench b;
  b.plc.watched = false;
  b.plc.holding(100) = b.plc.holding(101) = 830;
  b.run(0.5);
  EXPECT_EQ(b.plc.writes, 0) << "nobody has said so";
  b.link->adopt(Ratio(1.0), Ratio(1.0));
  b.link->release(b.clock.now());
  EXPECT_EQ(b.plc.holding(100), 1000);
  EXPECT_EQ(b.plc.holding(101), 1000);
}

// Another master writes the same register: read back, left alone, and brought home in the end.
TEST(Modbus, AnotherMastersOverrideIsReadBackAndNotFoughtOver) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.3);
  b.plc.holding(100) = 700;
  const MachineState m = b.run(0.5);
  EXPECT_NEAR(m.speedOverride.value, 0.7, 1e-9);  // not taken, the gate says
  EXPECT_EQ(b.plc.holding(100), 700);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.plc.holding(100), 1000);
}

// On another computer, perhaps: no lock of this one reaches there.
TEST(Modbus, AnotherMastersHeartbeatHasTheOverrides) {
  RegisterMap map = exampleMap();
  Register count;
  count.address = 102;
  map.read[static_cast<std::size_t>(MachineSignal::Heartbeat)] = count;
  Bench b;
  const auto make = [&] {
    return std::make_unique<ModbusLink>(map, std::make_unique<FakeBus>(b.clock, b.plc), b.clock);
  };
  b.link = make();
  const auto other = make();
  MachineState seen;
  const auto run = [&](double seconds) {
    const Instant until = b.clock.now() + toDuration(Seconds(seconds));
    MachineState m;
    while (b.clock.now() < until) {
      m = b.run(0.005);
      seen = other->read(b.clock.now());
    }
    return m;
  };
  run(0.5);
  EXPECT_TRUE(seen.controlOurs) << "nobody is in command";
  b.link->apply(b.gate.set(90.0), b.clock.now());
  EXPECT_TRUE(run(1.0).controlOurs) << "one's own heartbeat is no other's";
  EXPECT_FALSE(seen.controlOurs);
  EXPECT_EQ(seen.block, OverrideInhibit::OtherClient);
  // Both at once: both are told.
  other->apply(b.gate.set(80.0), b.clock.now());
  EXPECT_FALSE(run(0.5).controlOurs);
  EXPECT_FALSE(seen.controlOurs);
  other->release(b.clock.now());
  b.link->release(b.clock.now());
  run(1.5);
  EXPECT_TRUE(seen.controlOurs) << "what stands and does not count is nobody's";
  EXPECT_EQ(b.plc.holding(100), 1000);
}

// Its own watchdog has brought it back meanwhile, and what we had ordered before is not ordered again.
TEST(Modbus, RestartedMachineIsReadAnewAndHome) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  b.plc.gone = true;
  EXPECT_FALSE(b.run(0.5).linkUp);
  b.link->release(b.clock.now());  // the lease ran out meanwhile
  b.plc.words.clear();
  b.plc.gone = false;
  const MachineState m = b.run(1.5);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.speedOverride.value, 1.0);
}

TEST(Modbus, LatestWinsAndNothingQueuesUp) {
  Bench b;
  b.run(0.2);
  const int before = b.plc.writes;
  for (const double percent : {80.0, 105.0, 85.0, 95.0}) b.link->apply(b.gate.set(percent), b.clock.now());
  b.run(1.0);
  EXPECT_EQ(b.plc.holding(100), 950);
  // Control, two overrides a command at most, and the heartbeat every 50 ms.
  EXPECT_LE(b.plc.writes - before, 1 + 2 * 4 + 21);
}

TEST(Modbus, OperatorsKnobIsTheMachinesAffair) {
  Bench b;
  b.plc.operatorKnob = 110;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  const MachineState m = b.run(0.5);
  EXPECT_EQ(b.plc.holding(100), 900);
  EXPECT_NEAR(m.operatorSpeed.value, 1.1, 1e-9);
  EXPECT_NEAR(m.speedOverride.value, 0.99, 1e-9);
}

// We are killed: nothing beats any more, and the machine restores by itself.
TEST(Modbus, SilenceOfOursIsEndedByTheMachinesWatchdog) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  ASSERT_EQ(b.plc.holding(100), 900);
  b.clock.advance(Seconds(0.25));
  b.plc.run(b.clock.now());
  EXPECT_EQ(b.plc.holding(100), 1000);
}

TEST(Modbus, RefusedSilentAndLostAreInvalidAndComeBack) {
  Bench b;
  b.run(0.2);
  for (bool FakePlc::*fault : {&FakePlc::refuses, &FakePlc::silent, &FakePlc::gone}) {
    b.plc.*fault = true;
    EXPECT_FALSE(b.run(1.0).valid);
    b.plc.*fault = false;
    EXPECT_TRUE(b.run(1.5).valid);
  }
}

// Done, and its acknowledgement lost just before the release: what may stand there is brought home.
TEST(Modbus, WriteWhoseReplyIsLostIsTakenForDone) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.3);
  b.link->release(b.clock.now());  // 100 % is acknowledged
  ASSERT_EQ(b.plc.holding(100), 1000);
  b.plc.lostReply = 100;
  b.link->apply(b.gate.set(90.0), b.clock.now());
  while (b.plc.holding(100) != 900 && b.clock.now() < instantFromNs(5'000'000'000)) b.run(0.001);
  ASSERT_EQ(b.plc.holding(100), 900);
  b.plc.lostReply = -1;
  b.plc.lastBeat = b.clock.now() + std::chrono::seconds(10);  // no watchdog helps
  b.link->release(b.clock.now());
  EXPECT_EQ(b.plc.holding(100), 1000);
  EXPECT_EQ(b.plc.holding(101), 1000);
}

TEST(Modbus, PulledCableRestoresTheProgrammedValuesOnceItIsIn) {
  Bench b;
  b.run(0.2);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  b.plc.gone = true;
  b.run(0.3);
  b.link->release(b.clock.now());
  b.plc.gone = false;
  b.plc.holding(100) = 900;  // a machine without a watchdog
  b.plc.lastBeat = b.clock.now() + std::chrono::seconds(10);
  b.run(1.5);
  EXPECT_EQ(b.plc.holding(100), 1000);
}

// A wire that holds every answer up: registers side by side are asked for together, or nothing would ever be fresh.
TEST(Modbus, ASlowWireIsReadInAsFewQuestionsAsTheMapAllows) {
  Bench b;
  b.plc.latency = std::chrono::milliseconds(40);
  ASSERT_TRUE(b.link->open());
  const MachineState m = b.run(2.0);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.actualSpeed.value, 8000.0);
  EXPECT_EQ(m.programmedSpeed.value, 8000.0);
  EXPECT_TRUE(m.programRunning);
  EXPECT_LT(secondsBetween(m.time, b.clock.now()).value, 0.3);
  // In command with a heartbeat between, and a machine that goes home after 0.2 s without one.
  b.link->apply(b.gate.set(98.0), b.clock.now());
  for (int k = 0; k < 20; ++k) EXPECT_TRUE(b.run(0.1).valid) << k;
  EXPECT_EQ(b.plc.holding(100), 980);
}

TEST(Modbus, AMachineThatRefusesSeveralRegistersAtOnceIsAskedForEach) {
  Bench b;
  b.plc.refusesFrom = 2;
  const MachineState m = b.run(1.0);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.programmedSpeed.value, 8000.0);
  EXPECT_EQ(m.operatorSpeed.value, 1.0);
}

TEST(Modbus, AWireThatIsTooSlowIsNamedAsThat) {
  Bench b;
  b.plc.latency = std::chrono::milliseconds(190);
  b.plc.run(b.clock.now());
  const Status opened = b.link->open();
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().line().find("an answer takes 190 ms, and 3 of them tell all"), std::string::npos)
      << opened.error().line();
}

TEST(ReadPlan, AsksForNeighboursTogetherAndForNoGap) {
  const ReadPlan plan(exampleMap());
  const ReadSpan& holding = plan.of(static_cast<std::size_t>(MachineSignal::ProgrammedSpeed));
  EXPECT_EQ(holding.first, 0);
  EXPECT_EQ(holding.count, 4);
  EXPECT_TRUE(holding.has(static_cast<std::size_t>(MachineSignal::SpeedOverride)));
  EXPECT_FALSE(holding.has(static_cast<std::size_t>(MachineSignal::Running)));  // of another table
  EXPECT_EQ(plan.of(static_cast<std::size_t>(MachineSignal::FeedHold)).count, 1);
  EXPECT_EQ(plan.of(static_cast<std::size_t>(MachineSignal::ActualSpeed)).count, 2);
  EXPECT_EQ(plan.questions(), 3);

  RegisterMap gaps = exampleMap();
  gaps.read[static_cast<std::size_t>(MachineSignal::ProgrammedFeed)]->address = 5;
  EXPECT_EQ(ReadPlan(gaps).questions(), 5);  // holding 0; 2 and 3; 5; the two of input
}

TEST(Modbus, NobodyThereIsOneLine) {
  Bench b;
  b.plc.gone = true;
  EXPECT_EQ(b.link->open().error().line(), "plc:502 unit 1: no connection (is the machine on, and the address right?)");
}

}  // namespace
}  // namespace stillcut::cnc
