// Peers that flood, stop in the middle of a line, answer in words of their own, or refuse one of the two overrides:
// each override goes home by itself, and no tick is held up. On virtual time.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "core/cnc/grbl/grbl_link.h"
#include "core/cnc/modbus/modbus_link.h"
#include "tests/protocol/emc_bench.h"
#include "tests/protocol/modbus/fake_plc.h"
#include "tests/support/grbl/fake_grbl.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

struct GrblBench {
  GrblBench() {
    auto made = std::make_unique<ScriptedWire>(clock, faults, grbl);
    wire = made.get();
    link = std::make_unique<GrblLink>(GrblSettings{}, std::move(made), clock);
  }
  MachineState run(double seconds) {
    MachineState m;
    for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end;) {
      const Instant before = clock.now();
      m = link->read(before);
      longest = std::max(longest, secondsBetween(before, clock.now()).value);
      clock.advance(Seconds(0.005));
    }
    return m;
  }
  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults;
  FakeGrbl grbl;
  ScriptedWire* wire = nullptr;
  CommandMaker gate;
  double longest = 0.0;
  std::unique_ptr<GrblLink> link;
};

const std::string kFloods[] = {std::string(3000, '<'),     std::string("<Run|MPos:0,0,0|Ov:\r\n"),
                               std::string("\r\n\r\n"),    std::string("SET SET ACK ACK\r\n"),
                               std::string("error: \r\n"), std::string("PINVAL \r\nGET \r\n")};

TEST(HostileGrbl, AFloodHoldsUpNoReleaseAndNoTick) {
  for (const std::string& flood : kFloods) {
    GrblBench b;
    b.run(0.5);
    b.link->apply(b.gate.set(90.0), b.clock.now());
    b.run(1.0);
    ASSERT_EQ(b.grbl.spindle, 90);
    b.wire->flood(flood, Seconds(0.0005));
    b.run(0.1);
    EXPECT_LT(b.longest, 0.05);
    b.link->release(b.clock.now());
    EXPECT_EQ(b.grbl.spindle, 100) << flood.substr(0, 20);
    EXPECT_EQ(b.grbl.feed, 100) << flood.substr(0, 20);
    b.wire->flood({}, Seconds(1.0));
    EXPECT_TRUE(b.run(5.0).valid) << flood.substr(0, 20);
  }
}

TEST(HostileGrbl, HalfALineIsNoReportAndTheNextOneIsRead) {
  GrblBench b;
  b.run(0.5);
  b.faults.hang();
  b.wire->say("<Run|MPos:0.000,0.000,0.000|FS:1200,8800|Ov:1");
  b.run(0.5);
  b.faults.hang(false);
  const MachineState m = b.run(1.0);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.operatorFeed.value, 1.0);
}

TEST(HostileGrbl, ARefusedOverrideKeepsTheOtherFromNothing) {
  for (const bool feedRefused : {true, false}) {
    GrblBench b;
    b.run(0.5);
    b.link->apply(b.gate.set(90.0), b.clock.now());
    b.run(1.0);
    ASSERT_EQ(b.grbl.spindle, 90);
    (feedRefused ? b.grbl.refusesFeed : b.grbl.refusesSpeed) = true;
    b.link->release(b.clock.now());
    EXPECT_EQ(feedRefused ? b.grbl.spindle : b.grbl.feed, 100);
    (feedRefused ? b.grbl.refusesFeed : b.grbl.refusesSpeed) = false;
    b.run(2.0);
    EXPECT_EQ(b.grbl.spindle, 100);
    EXPECT_EQ(b.grbl.feed, 100);
  }
}

TEST(HostileLinuxCnc, AFloodHoldsUpNoReleaseAndNoTick) {
  for (const std::string& flood : kFloods) {
    EmcBench b;
    b.run(0.5);
    b.link->apply(b.gate.set(90.0), b.clock.now());
    b.run(1.0);
    ASSERT_EQ(b.mill.spindle, 90);
    for (ScriptedWire* w : {b.controlWire, b.watchWire, b.halWire}) w->flood(flood, Seconds(0.0005));
    for (int i = 0; i < 20; ++i) {
      const Instant before = b.clock.now();
      b.link->read(before);
      EXPECT_LT(secondsBetween(before, b.clock.now()).value, 0.05);
    }
    const Instant began = b.clock.now();
    b.link->release(began);
    EXPECT_EQ(b.mill.spindle, 100) << flood.substr(0, 20);
    EXPECT_EQ(b.mill.feed, 100) << flood.substr(0, 20);
    EXPECT_LT(secondsBetween(began, b.clock.now()).value, toSeconds(LinuxCncLink::kReleaseTime).value + 0.1);
  }
}

// 93 for 83, once and for three seconds: nothing is moved by it, and once it is over there is a way home.
TEST(HostileLinuxCnc, AFalseReportIsNoHandAndLeavesNothingBehind) {
  for (const int lies : {1, 2, 30}) {
    for (const bool offWhileItLies : {false, true}) {
      EmcBench b;
      b.run(0.5);
      const OverrideCommand command = b.gate.set(83.0);
      b.link->apply(command, b.clock.now());
      b.run(1.0);
      ASSERT_EQ(b.mill.spindle, 83);
      const int sets = b.mill.sets;
      b.mill.lies = lies;
      b.mill.liedPercent = 93;
      for (int i = 0; i < 300; ++i) {
        if (!offWhileItLies) b.link->apply(command, b.clock.now());
        if (offWhileItLies && i == 30) b.link->release(b.clock.now());
        b.run(0.01);
        EXPECT_GE(std::min(b.mill.spindle, b.mill.feed), 83);
        EXPECT_LE(std::max(b.mill.spindle, b.mill.feed), 100);
      }
      b.mill.lies = 0;
      EXPECT_TRUE(offWhileItLies || b.mill.sets == sets) << "something is sent for a lie";
      b.link->release(b.clock.now());
      const MachineState m = b.run(1.0);
      EXPECT_EQ(b.mill.spindle, 100) << lies << offWhileItLies;
      EXPECT_EQ(b.mill.feed, 100) << lies << offWhileItLies;
      EXPECT_EQ(m.operatorSpeed.value, 1.0) << "a lie is nobody's choice";
    }
  }
}

// It obeys, and nothing that it says is an answer: the one override does not wait for the other's.
TEST(HostileLinuxCnc, AnAnswerInOtherWordsKeepsNoOverrideAway) {
  EmcBench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(1.0);
  ASSERT_EQ(b.mill.spindle, 90);
  b.mill.mumbles = true;
  const Instant began = b.clock.now();
  b.link->release(began);
  EXPECT_EQ(b.mill.feed, 100);
  EXPECT_EQ(b.mill.spindle, 100);
  EXPECT_LT(secondsBetween(began, b.clock.now()).value, toSeconds(LinuxCncLink::kReleaseTime).value + 0.1);
}

TEST(HostileModbus, ARefusedOverrideKeepsTheOtherFromNothing) {
  for (const int refused : {100, 101}) {
    test::VirtualClock clock{instantFromNs(1'000'000'000)};
    FakePlc plc;
    plc.watched = false;
    plc.holding(100) = plc.holding(101) = 1000;
    ModbusLink link(exampleMap(), std::make_unique<FakeBus>(clock, plc), clock);
    CommandMaker gate;
    const auto run = [&](double seconds) {
      for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end;) {
        plc.run(clock.now());
        link.read(clock.now());
        clock.advance(Seconds(0.005));
      }
    };
    run(0.5);
    link.apply(gate.set(90.0), clock.now());
    run(0.5);
    ASSERT_EQ(plc.holding(100), 900);
    ASSERT_EQ(plc.holding(101), 900);
    plc.refused = refused;
    link.release(clock.now());
    EXPECT_EQ(plc.holding(201 - refused), 1000) << refused;
    plc.refused = -1;
    run(1.0);
    EXPECT_EQ(plc.holding(refused), 1000);
  }
}

}  // namespace
}  // namespace stillcut::cnc
