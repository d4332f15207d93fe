// The Modbus link through Qt SerialBus against a real server (pymodbus), over TCP and over RTU on a pty pair. They wait
// for it in real time, and each wait is bounded.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QCoreApplication>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/io/tcp_wire.h"
#include "app/io/wires.h"
#include "core/cnc/modbus_link.h"
#include "tests/protocol/bounded_wait.h"
#include "tests/protocol/child.h"
#include "tests/protocol/commander.h"
#include "tests/protocol/commands.h"

namespace stillcut::cnc {
namespace {

using testing::Child;
namespace fs = std::filesystem;

constexpr const char* kScript = STILLCUT_SOURCE_DIR "/tests/protocol/modbus_peer.py";
constexpr int kPort = 15020;

bool pymodbusIsHere() {
  return std::system("/usr/bin/python3 -c 'import pymodbus, serial_asyncio' 2>/dev/null") == 0;
}

class ModbusReal : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!pymodbusIsHere()) GTEST_SKIP() << "python3-pymodbus is not installed";
  }
  void connect(const std::function<void(BusAddress&)>& to) {
    auto map = loadRegisterMap(STILLCUT_SOURCE_DIR "/resources/machines/modbus-example.toml");
    ASSERT_TRUE(map.ok());
    to(map->bus);
    auto bus = app::busMaker()(map->bus);
    ASSERT_TRUE(bus.ok());
    link_ = std::make_unique<ModbusLink>(std::move(map).value(), std::move(bus).value(), clock_);
  }
  bool until(const std::function<bool(const MachineState&)>& wanted, double seconds = 8.0) {
    return testing::within(Seconds(seconds), [&] {
      seen_ = link_->read(clock_.now());
      return wanted(seen_);
    });
  }
  // Everything a link has to do, on whatever wire.
  void readsMovesAndBringsBack() {
    ASSERT_TRUE(until([](const MachineState& m) { return m.valid && m.programRunning; }));
    EXPECT_EQ(seen_.programmedSpeed.value, 8000.0);
    EXPECT_NEAR(seen_.actualSpeed.value, 8000.0, 0.1);
    link_->apply(gate_.set(90.0), clock_.now());
    EXPECT_TRUE(until([](const MachineState& m) {
      return std::abs(m.actualSpeed.value - 7200.0) < 1.0 && std::abs(m.speedOverride.value - 0.9) < 1e-9;
    })) << seen_.actualSpeed.value;
    // The heartbeat holds it beyond the machine's patience of 0.2 s.
    const Instant began = clock_.now();
    EXPECT_FALSE(until([&](const MachineState& m) { return m.speedOverride.value > 0.95; }, 0.6));
    EXPECT_GT(secondsBetween(began, clock_.now()).value, 0.5);
    link_->release(clock_.now());
    EXPECT_TRUE(until([](const MachineState& m) { return std::abs(m.actualSpeed.value - 8000.0) < 1.0; }));
  }

  SteadyClock clock_;
  std::unique_ptr<ModbusLink> link_;
  testing::CommandMaker gate_;
  MachineState seen_;
};

TEST_F(ModbusReal, TcpReadsMovesAndBringsBack) {
  const Child server({"/usr/bin/python3", kScript, "tcp", std::to_string(kPort)});
  connect([](BusAddress& bus) { bus.wire = {.host = "127.0.0.1", .port = kPort, .device = {}}; });
  readsMovesAndBringsBack();
}

TEST_F(ModbusReal, TcpServerThatDiesIsDownAndOneThatComesBackIsTakenUp) {
  auto server = std::make_unique<Child>(std::vector<std::string>{"/usr/bin/python3", kScript, "tcp", "15021"});
  connect([](BusAddress& bus) { bus.wire = {.host = "127.0.0.1", .port = 15021, .device = {}}; });
  ASSERT_TRUE(until([](const MachineState& m) { return m.valid; }));
  server.reset();
  EXPECT_TRUE(until([](const MachineState& m) { return !m.valid && !m.linkUp; }));
  server = std::make_unique<Child>(std::vector<std::string>{"/usr/bin/python3", kScript, "tcp", "15021"});
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid; }));
}

// SIGKILL: nothing is said any more, and the machine's own watchdog of 0.2 s brings it back.
TEST_F(ModbusReal, KilledProgramIsTheMachinesOwnWayHome) {
  const Child server({"/usr/bin/python3", kScript, "tcp", "15023"});
  const auto toServer = [](BusAddress& bus) { bus.wire = {.host = "127.0.0.1", .port = 15023, .device = {}}; };
  connect(toServer);
  ASSERT_TRUE(until([](const MachineState& m) { return m.valid; }));
  const testing::Commander killed([&] {
    connect(toServer);
    return std::move(link_);
  });
  ASSERT_TRUE(killed.took());
  ASSERT_TRUE(until([](const MachineState& m) { return std::abs(m.speedOverride.value - 0.9) < 1e-9; }));
  killed.signal(SIGKILL);
  EXPECT_TRUE(until([](const MachineState& m) { return std::abs(m.speedOverride.value - 1.0) < 1e-9; }));
}

TEST_F(ModbusReal, WrongUnitIsSilenceAndSaidOnce) {
  const Child server({"/usr/bin/python3", kScript, "tcp", "15022"});
  connect([](BusAddress& bus) {
    bus.wire = {.host = "127.0.0.1", .port = 15022, .device = {}};
    bus.unit = 9;
  });
  const Status opened = link_->open();
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().line().find("127.0.0.1:15022 unit 9"), std::string::npos) << opened.error().line();
}

TEST_F(ModbusReal, RtuOverASerialPairReadsMovesAndBringsBack) {
  if (std::system("command -v socat >/dev/null") != 0) GTEST_SKIP() << "socat is not installed";
  const testing::TemporaryFolder folder;
  const std::string ours = folder.file("a");
  const std::string theirs = folder.file("b");
  const Child pair({"socat", "PTY,raw,echo=0,link=" + ours, "PTY,raw,echo=0,link=" + theirs});
  ASSERT_TRUE(testing::within(Seconds(5.0), [&] { return fs::exists(ours) && fs::exists(theirs); }));
  const Child server({"/usr/bin/python3", kScript, "rtu", theirs});
  connect([&](BusAddress& bus) { bus.wire = {.host = {}, .port = 0, .device = ours, .baud = 115200}; });
  readsMovesAndBringsBack();
}

}  // namespace
}  // namespace stillcut::cnc

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
