// The Modbus link against libmodbus' own test server, built from Debian's libmodbus-dev, and its hostile registers: an
// exception, a wrong transaction id, half a second of sleep, one byte every 5 ms. Waits are bounded.
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
#include "tests/protocol/commands.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"

namespace stillcut::cnc {
namespace {

constexpr const char* kSource = "/usr/share/doc/libmodbus-dev/examples/unit-test-server.c";

// Registers of the server; its input register 0x108 always says 10.
constexpr int kQuiet = 0x160, kException = 0x170, kWrongTransaction = 0x171, kSleepsHalfASecond = 0x172,
              kSlowBytes = 0x173;

std::string mapWith(int feedRegister, int answerMs) {
  return R"(version = 1
label = "libmodbus"
[bus]
host = "127.0.0.1"
port = 1502
unit = 17
answer_ms = )" +
         std::to_string(answerMs) + R"(
[override]
lowest_speed_percent = 50
highest_speed_percent = 120
[read.programmed_speed]
table = "input"
address = 264
scale = 800.0
[read.actual_speed]
table = "input"
address = 264
scale = 800.0
[read.speed_override]
address = 355
[read.actual_feed]
address = )" +
         std::to_string(feedRegister) + R"(
[write.speed_override]
address = 355
)";
}

class ModbusHostile : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string build = std::string("cc -w -I/usr/include/modbus -o ") + program_ + " " + kSource + " -lmodbus";
    if (std::system((build + " 2>/dev/null").c_str()) != 0) GTEST_SKIP() << "libmodbus-dev or its examples are absent";
    server_ =
        std::make_unique<testing::Child>(std::vector<std::string>{"sh", "-c", "exec " + program_ + " >/dev/null"});
  }
  // Its look at the machine goes to `feedRegister` as well.
  void connect(int feedRegister, int answerMs = 200) {
    auto map = parseRegisterMap(mapWith(feedRegister, answerMs), "hostile.toml");
    ASSERT_TRUE(map.ok()) << map.error().line();
    auto bus = app::busMaker()(map->bus, clock_);
    ASSERT_TRUE(bus.ok());
    link_ = std::make_unique<ModbusLink>(std::move(map).value(), std::move(bus).value(), clock_);
  }
  bool until(const std::function<bool(const MachineState&)>& wanted, double seconds = 5.0) {
    return testing::within(Seconds(seconds), [&] {
      const Instant before = clock_.now();
      seen_ = link_->read(before);
      ticks_.push_back(secondsBetween(before, clock_.now()).value);
      return wanted(seen_);
    });
  }
  static bool valid(const MachineState& m) { return m.valid; }
  double usualTick() {
    std::sort(ticks_.begin(), ticks_.end());
    return ticks_.empty() ? 0.0 : ticks_[ticks_.size() / 2];
  }
  // A link thread that has to let go must not be kept by what the peer does.
  void expectShortTicksAndABoundedEnd() {
    EXPECT_LT(usualTick(), 0.05);
    const Instant began = clock_.now();
    link_.reset();
    EXPECT_LT(secondsBetween(began, clock_.now()).value, 2.0 * toSeconds(ModbusLink::kReleaseTime).value + 1.0);
  }

  testing::TemporaryFolder folder_;
  std::string program_ = folder_.file("unit-test-server");
  std::unique_ptr<testing::Child> server_;
  SteadyClock clock_;
  std::unique_ptr<ModbusLink> link_;
  testing::CommandMaker gate_;
  MachineState seen_;
  std::vector<double> ticks_;
};

TEST_F(ModbusHostile, QuietRegistersAreReadWrittenAndBroughtBack) {
  connect(kQuiet);
  ASSERT_TRUE(until(valid));
  EXPECT_EQ(seen_.programmedSpeed.value, 8000.0);
  EXPECT_GT(seen_.link.roundTrip.value, 0.0);
  link_->apply(gate_.set(90.0), clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return m.speedOverride.value == 0.9; }));
  EXPECT_GT(seen_.link.acknowledged, Instant{});
  link_->release(clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return m.speedOverride.value == 1.0; }));
}

TEST_F(ModbusHostile, ExceptionIsTheMachinesBusinessButNoState) {
  connect(kException);
  EXPECT_FALSE(until(valid, 1.0));
  EXPECT_TRUE(seen_.linkUp);
  expectShortTicksAndABoundedEnd();
}

TEST_F(ModbusHostile, AnswerToAnotherQuestionIsNotBelieved) {
  connect(kWrongTransaction);
  EXPECT_FALSE(until(valid, 1.5));
  expectShortTicksAndABoundedEnd();
}

TEST_F(ModbusHostile, PeerThatSleepsIsSilence) {
  connect(kSleepsHalfASecond, 100);
  EXPECT_FALSE(until(valid, 2.0));
  expectShortTicksAndABoundedEnd();
}

TEST_F(ModbusHostile, ByteByByteIsReadInTime) {
  connect(kSlowBytes, 400);
  EXPECT_TRUE(until(valid));
  expectShortTicksAndABoundedEnd();
}

TEST_F(ModbusHostile, ServerThatDiesIsDown) {
  connect(kQuiet);
  ASSERT_TRUE(until(valid));
  server_->kill();
  EXPECT_TRUE(until([](const MachineState& m) { return !m.valid && !m.linkUp; }));
  expectShortTicksAndABoundedEnd();
}

}  // namespace
}  // namespace stillcut::cnc
