// The Modbus link through Qt SerialBus against a real server (pymodbus), over TCP and over RTU on a pty pair. They wait
// for it in real time, and each wait is bounded.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QCoreApplication>
#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/io/wires.h"
#include "core/cnc/modbus/modbus_link.h"
#include "tests/protocol/commander.h"
#include "tests/protocol/commands.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"

namespace stillcut::cnc {
namespace {

using testing::Child;
namespace fs = std::filesystem;

constexpr const char* kScript = STILLCUT_SOURCE_DIR "/tests/protocol/modbus/modbus_peer.py";
constexpr int kPort = 15020;

bool pymodbusIsHere() {
  return std::system("/usr/bin/python3 -c 'import pymodbus, serial_asyncio' 2>/dev/null") == 0;
}

// The server, and where a link finds it. Over RTU a pty pair is the cable.
class Plc {
 public:
  enum class Wire { Tcp, Rtu };
  // `watched`: it goes home by itself; else it keeps what was written, over a restart too.
  Plc(Wire wire, int port, bool watched) : wire_(wire), port_(port), watched_(watched) {
    if (wire == Wire::Rtu) plugIn();
    start();
  }

  void start() {
    const std::vector<std::string> to = wire_ == Wire::Tcp ? std::vector<std::string>{"tcp", std::to_string(port_)}
                                                           : std::vector<std::string>{"rtu", theirs_};
    server_ = std::make_unique<Child>(
        std::vector<std::string>{"/usr/bin/python3", kScript, to[0], to[1], log_, watched_ ? "watched" : "retained"});
  }
  void die() { server_.reset(); }
  void signal(int number) const { server_->signal(number); }
  // RTU: the cable, and with it the device file.
  void plugIn() {
    cable_ = std::make_unique<Child>(
        std::vector<std::string>{"socat", "PTY,raw,echo=0,link=" + ours_, "PTY,raw,echo=0,link=" + theirs_});
    EXPECT_TRUE(testing::within(Seconds(5.0), [&] { return fs::exists(ours_) && fs::exists(theirs_); }));
  }
  void pull() {
    die();
    cable_.reset();
    for (const std::string& end : {ours_, theirs_}) fs::remove(end);
  }
  void locate(BusAddress& bus) const {
    bus.parity = 'N';  // a pty has none, and refuses it where nothing else is new
    bus.wire = wire_ == Wire::Tcp ? WireAddress{.host = "127.0.0.1", .port = port_, .device = {}}
                                  : WireAddress{.host = {}, .port = 0, .device = ours_, .baud = 115200};
  }
  // What was written there last: "100 900".
  bool lastWritten(const std::string& what, int value) const {
    std::ifstream log(log_);
    int last = -1;
    for (std::string word; log >> word;) {
      int n = 0;
      if (log >> n && word == what) last = n;
    }
    return last == value;
  }

 private:
  Wire wire_;
  int port_;
  bool watched_;
  testing::TemporaryFolder folder_;
  std::string ours_ = folder_.file("a"), theirs_ = folder_.file("b"), log_ = folder_.file("log");
  std::unique_ptr<Child> cable_, server_;
};

class ModbusReal : public ::testing::TestWithParam<Plc::Wire> {
 protected:
  void SetUp() override {
    if (!pymodbusIsHere()) GTEST_SKIP() << "python3-pymodbus is not installed";
    if (GetParam() == Plc::Wire::Rtu && std::system("command -v socat >/dev/null") != 0) {
      GTEST_SKIP() << "socat is not installed";
    }
    plc_ = std::make_unique<Plc>(GetParam(), kPort, watched());
    link_ = make();
  }
  virtual bool watched() const { return true; }
  std::unique_ptr<ModbusLink> make(const std::function<void(BusAddress&)>& change = nullptr) {
    auto map = loadRegisterMap(STILLCUT_SOURCE_DIR "/resources/machines/modbus-example.toml");
    EXPECT_TRUE(map.ok());
    plc_->locate(map->bus);
    map->watchdog = watched();
    // The feed that is in force can be read here: no knob stands before it.
    map->read[static_cast<std::size_t>(MachineSignal::FeedOverride)] = map->at(MachineCommand::FeedOverride);
    if (change) change(map->bus);
    auto bus = app::busMaker()(map->bus, clock_);
    EXPECT_TRUE(bus.ok());
    return std::make_unique<ModbusLink>(std::move(map).value(), std::move(bus).value(), clock_);
  }
  bool until(const std::function<bool(const MachineState&)>& wanted, double seconds = 8.0) {
    return testing::within(Seconds(seconds), [&] {
      seen_ = link_->read(clock_.now());
      ++ticks_;
      return wanted(seen_);
    });
  }
  static bool valid(const MachineState& m) { return m.valid; }
  static bool down(const MachineState& m) { return !m.valid && !m.linkUp; }
  // Both overrides, and the spindle with them.
  static bool at(const MachineState& m, double share) {
    return m.valid && std::abs(m.speedOverride.value - share) < 1e-9 && std::abs(m.feedOverride.value - share) < 1e-9 &&
           std::abs(m.actualSpeed.value - 8000.0 * share) < 1.0;
  }
  static bool taken(const MachineState& m) { return at(m, 0.9); }
  static bool home(const MachineState& m) { return at(m, 1.0); }
  bool take() {
    if (!until(valid)) return false;
    link_->apply(gate_.set(90.0), clock_.now());
    return until(taken);
  }
  bool broughtBack() const {
    return plc_->lastWritten("100", 1000) && plc_->lastWritten("101", 1000) && plc_->lastWritten("control", 0);
  }

  std::unique_ptr<Plc> plc_;
  SteadyClock clock_;
  std::unique_ptr<ModbusLink> link_;
  testing::CommandMaker gate_;
  MachineState seen_;
  int ticks_ = 0;
};

// Nobody but the link brings anything home.
class ModbusRetained : public ModbusReal {
 protected:
  bool watched() const override { return false; }
};

TEST_P(ModbusReal, ReadsMovesBothOverridesAndBringsThemBack) {
  ASSERT_TRUE(until([](const MachineState& m) { return m.valid && m.programRunning; }));
  EXPECT_EQ(seen_.programmedSpeed.value, 8000.0);
  EXPECT_NEAR(seen_.actualSpeed.value, 8000.0, 0.1);
  EXPECT_TRUE(home(seen_));
  ASSERT_TRUE(take()) << seen_.actualSpeed.value;
  EXPECT_TRUE(plc_->lastWritten("control", 1));
  // The heartbeat holds it beyond the machine's patience of 0.2 s.
  const Instant began = clock_.now();
  EXPECT_FALSE(until([](const MachineState& m) { return m.valid && !taken(m); }, 0.6));
  EXPECT_GT(secondsBetween(began, clock_.now()).value, 0.5);
  link_->release(clock_.now());
  EXPECT_TRUE(until(home));
  EXPECT_TRUE(broughtBack());
}

TEST_P(ModbusRetained, EndOfTheProgramBringsBack) {
  ASSERT_TRUE(take());
  link_.reset();
  EXPECT_TRUE(broughtBack());
}

// SIGKILL: nothing is said any more, and the machine's own watchdog of 0.2 s brings it back.
TEST_P(ModbusReal, KilledProgramIsTheMachinesOwnWayHome) {
  ASSERT_TRUE(until(valid));
  link_.reset();  // a serial port has one owner
  {
    const testing::Commander killed([&] { return make(); });
    ASSERT_TRUE(killed.took());
  }
  link_ = make();
  EXPECT_TRUE(until(home));
  EXPECT_TRUE(plc_->lastWritten("100", 900) && plc_->lastWritten("101", 900)) << "nobody of ours wrote it back";
}

TEST_P(ModbusRetained, ServerThatDiesIsDownAndOneThatComesBackIsTakenUpHome) {
  ASSERT_TRUE(take());
  plc_->die();
  EXPECT_TRUE(until(down));
  link_->release(clock_.now());  // the lease ran out meanwhile
  plc_->start();
  EXPECT_TRUE(until(home));
  EXPECT_TRUE(broughtBack());
}

TEST_P(ModbusRetained, HungServerIsDownHoldsTheEndOnceAndIsHomeWhenItGoesOn) {
  ASSERT_TRUE(take());
  plc_->signal(SIGSTOP);
  EXPECT_TRUE(until([](const MachineState& m) { return !m.valid; }));
  const Instant began = clock_.now();
  link_->release(clock_.now());
  link_->close();
  EXPECT_LT(secondsBetween(began, clock_.now()).value, toSeconds(ModbusLink::kReleaseTime).value + 0.5);
  plc_->signal(SIGCONT);
  EXPECT_TRUE(until(home));
  EXPECT_TRUE(broughtBack());
}

TEST_P(ModbusRetained, PulledCableIsDownAndHomeOnceItIsIn) {
  if (GetParam() == Plc::Wire::Tcp) GTEST_SKIP() << "over TCP it is as a server that dies";
  ASSERT_TRUE(take());
  plc_->pull();
  EXPECT_TRUE(until(down)) << seen_.valid << seen_.linkUp << " ticks " << ticks_;
  link_->release(clock_.now());
  plc_->plugIn();
  plc_->start();
  EXPECT_TRUE(until(home));
  EXPECT_TRUE(broughtBack());
}

TEST_P(ModbusReal, WrongUnitIsSilenceAndSaidOnce) {
  ASSERT_TRUE(until(valid));
  link_.reset();
  link_ = make([](BusAddress& bus) { bus.unit = 9; });
  const Status opened = link_->open();
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().line().find(" unit 9"), std::string::npos) << opened.error().line();
}

// It sleeps until something comes: a link thread that spun would take a core from the cut.
TEST_P(ModbusReal, WaitingTakesNoProcessorTime) {
  ASSERT_TRUE(until(valid));
  link_.reset();
  BusAddress address;
  plc_->locate(address);
  const auto bus = std::move(app::busMaker()(address, clock_)).value();
  bus->connect();
  ASSERT_TRUE(testing::within(Seconds(5.0), [&] { return bus->state() == WireState::Open; }));
  const auto used = [] {
    timespec t{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double before = used();
  const Instant began = clock_.now();
  for (int i = 0; i < 100; ++i) bus->wait(std::chrono::milliseconds(5));
  const double passed = secondsBetween(began, clock_.now()).value;
  EXPECT_GE(passed, 0.4);
  EXPECT_LT(used() - before, 0.25 * passed);
}

const auto kWires = ::testing::Values(Plc::Wire::Tcp, Plc::Wire::Rtu);
constexpr auto kNamed = [](const auto& wire) { return std::string(wire.param == Plc::Wire::Tcp ? "Tcp" : "Rtu"); };
INSTANTIATE_TEST_SUITE_P(Wires, ModbusReal, kWires, kNamed);
INSTANTIATE_TEST_SUITE_P(Wires, ModbusRetained, kWires, kNamed);

}  // namespace
}  // namespace stillcut::cnc

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
