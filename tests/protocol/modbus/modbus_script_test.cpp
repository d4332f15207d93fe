// The Modbus link through Qt SerialBus against a server that keeps to a script: nothing it does gives a wrong number, a
// long tick or a link that stays down once it has come to its senses. Waits are bounded.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/io/wires.h"
#include "core/cnc/modbus/modbus_link.h"
#include "tests/protocol/commander.h"
#include "tests/protocol/commands.h"
#include "tests/protocol/modbus/scripted_modbus.h"
#include "tests/support/bounded_wait.h"

namespace stillcut::cnc {
namespace {

using testing::ModbusScript;

constexpr int kProgrammed = 0, kActual = 1, kOverride = 2, kRunning = 3;

std::string mapTo(int port) {
  return "version = 1\nlabel = 'scripted'\n[bus]\nhost = '127.0.0.1'\nport = " + std::to_string(port) +
         "\nanswer_ms = 100\n[override]\nlowest_speed_percent = 50\nhighest_speed_percent = 120\n"
         "[read.programmed_speed]\naddress = 0\n[read.actual_speed]\naddress = 1\n"
         "[read.speed_override]\naddress = 2\nscale = 0.1\n[read.running]\naddress = 3\n"
         "[write.speed_override]\naddress = 2\nscale = 0.1\n";
}

class ModbusScripted : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_GT(server_.port(), 0);
    server_.put(kProgrammed, 8000);
    server_.put(kActual, 8000);
    server_.put(kOverride, 1000);
    server_.put(kRunning, 1);
    link_ = make();
    ASSERT_TRUE(until(valid));
  }
  std::unique_ptr<CncLink> make() {
    auto map = parseRegisterMap(mapTo(server_.port()), "scripted.toml");
    EXPECT_TRUE(map.ok()) << map.error().line();
    auto bus = app::busMaker()(map->bus, clock_);
    EXPECT_TRUE(bus.ok());
    return std::make_unique<ModbusLink>(std::move(map).value(), std::move(bus).value(), clock_);
  }
  // Ticks until `wanted`; whatever is believed on the way has to be right.
  bool until(const std::function<bool(const MachineState&)>& wanted, double seconds = 5.0) {
    return testing::within(Seconds(seconds), [&] {
      const Instant before = clock_.now();
      seen_ = link_->read(before);
      ticks_.push_back(secondsBetween(before, clock_.now()).value);
      if (seen_.valid) {
        EXPECT_EQ(seen_.programmedSpeed.value, 8000.0);
        EXPECT_EQ(seen_.actualSpeed.value, 8000.0);
        EXPECT_TRUE(seen_.speedOverride.value == 1.0 || std::abs(seen_.speedOverride.value - 0.9) < 0.001);
      }
      return wanted(seen_);
    });
  }
  static bool valid(const MachineState& m) { return m.valid; }
  static bool down(const MachineState& m) { return !m.valid; }
  double usualTick() {
    std::sort(ticks_.begin(), ticks_.end());
    return ticks_[ticks_.size() / 2];
  }
  template <class Change>
  void expectRightNumbersOrNoneAndComesBack(const char* what, Change&& change) {
    SCOPED_TRACE(what);
    server_.script(change);
    ticks_.clear();
    EXPECT_FALSE(until([](const MachineState& m) { return m.valid && m.speedOverride.value != 1.0; }, 0.7));
    EXPECT_LT(usualTick(), 0.05);
    server_.script([](ModbusScript&) {});
    EXPECT_TRUE(until(valid));
  }

  testing::ScriptedModbus server_;
  SteadyClock clock_;
  std::unique_ptr<CncLink> link_;
  testing::CommandMaker gate_;
  MachineState seen_;
  std::vector<double> ticks_;
};

TEST_F(ModbusScripted, LateAndByteByByteIsReadAndObeyed) {
  server_.script([](ModbusScript& s) { s.delay(10).split(1); });
  link_->apply(gate_.set(90.0), clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid && m.speedOverride.value != 1.0; }));
  EXPECT_EQ(server_.holding(kOverride), 900);
  link_->release(clock_.now());
  EXPECT_EQ(server_.holding(kOverride), 1000);
}

TEST_F(ModbusScripted, WhateverItSaysIsRightOrNotBelieved) {
  expectRightNumbersOrNoneAndComesBack("merge", [](ModbusScript& s) { s.merge(); });
  expectRightNumbersOrNoneAndComesBack("wrong order", [](ModbusScript& s) { s.wrongOrder(); });
  expectRightNumbersOrNoneAndComesBack("garbage",
                                       [](ModbusScript& s) { s.garbage(std::string("\x01\xff\x00\x07HTTP/1.1", 12)); });
  expectRightNumbersOrNoneAndComesBack("close", [](ModbusScript& s) { s.close(); });
  expectRightNumbersOrNoneAndComesBack("delay", [](ModbusScript& s) { s.delay(150); });
}

TEST_F(ModbusScripted, HungServerIsDownAndTheEndIsBounded) {
  link_->apply(gate_.set(90.0), clock_.now());
  ASSERT_TRUE(until([&](const MachineState&) { return server_.holding(kOverride) == 900; }));
  server_.script([](ModbusScript& s) { s.hang(); });
  EXPECT_TRUE(until(down));
  const Instant began = clock_.now();
  link_.reset();
  EXPECT_LT(secondsBetween(began, clock_.now()).value, 2.0 * toSeconds(ModbusLink::kReleaseTime).value + 1.0);
}

// A map that claims no watchdog, and a PLC that has none: what the manual says of it.
TEST_F(ModbusScripted, KilledProgramLeavesTheOverrideWhereNobodyWatches) {
  EXPECT_FALSE(link_->describe().machineWatchdog);
  link_.reset();
  {
    const testing::Commander killed([&] { return make(); });
    ASSERT_TRUE(testing::within(Seconds(5.0), [&] { return server_.holding(kOverride) == 900; }));
  }  // killed
  EXPECT_FALSE(testing::within(Seconds(0.5), [&] { return server_.holding(kOverride) != 900; }));
  link_ = make();
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid && m.speedOverride.value != 1.0; }));
  link_->release(clock_.now());
}

}  // namespace
}  // namespace stillcut::cnc
