// Modbus RTU on a line where answers come late, are lost, or drown, on virtual time: no answer is ever taken for
// another question's, and what is let go of reaches the machine all the same.
#include "core/cnc/modbus/rtu_bus.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "core/cnc/modbus/modbus_link.h"
#include "tests/protocol/commands.h"
#include "tests/protocol/modbus/fake_drive.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

BusAddress address(int baud = 115200) {
  BusAddress a;
  a.wire.device = "/dev/serial/by-id/drive";
  a.wire.baud = baud;
  a.answerWithin = Seconds(0.1);
  return a;
}

struct BusBench {
  explicit BusBench(const BusAddress& where = address()) : bus(where, wired(), clock) {
    for (int i = 0; i < 50; ++i) drive.holding[i] = 1000 + i;
    bus.connect();
  }
  std::unique_ptr<ByteChannel> wired() { return std::make_unique<ScriptedWire>(clock, faults, drive); }
  void untilFree(double atMost = 2.0) {
    const Instant end = clock.now() + toDuration(Seconds(atMost));
    while (bus.busy() && clock.now() < end) bus.wait(std::chrono::milliseconds(2));
  }
  BusReply ask(int which) {
    untilFree();
    EXPECT_TRUE(bus.read(RegisterTable::Holding, which, 1));
    const Instant end = clock.now() + toDuration(Seconds(1.0));
    while (clock.now() < end) {
      if (const auto reply = bus.take()) return *reply;
      bus.wait(std::chrono::milliseconds(2));
    }
    ADD_FAILURE() << "no reply, and no end";
    return {};
  }

  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults;
  FakeDrive drive;
  RtuBus bus;
};

struct Lateness {
  double late;
  bool deaf;
};
class RtuLate : public ::testing::TestWithParam<Lateness> {};

// Every register has a value of its own, and all answers look alike: one that is taken for another shows.
TEST_P(RtuLate, AnswerIsNeverTakenForAnotherQuestions) {
  for (const int every : {2, 3, 7, 40}) {
    BusBench b;
    b.drive.late = GetParam().late;
    b.drive.deaf = GetParam().deaf;
    b.drive.lateEvery = every;
    int answered = 0;
    for (int i = 0; i < 400; ++i) {
      const int which = i % 50;
      const BusReply reply = b.ask(which);
      if (!reply.ok) continue;
      ++answered;
      ASSERT_EQ(reply.words[0], 1000 + which) << "late every " << every << ", question " << i;
    }
    EXPECT_GT(answered, every >= 7 ? 60 : 0) << every;
  }
}
INSTANTIATE_TEST_SUITE_P(By, RtuLate,
                         ::testing::Values(Lateness{0.099, false}, Lateness{0.101, false}, Lateness{0.15, false},
                                           Lateness{0.15, true}, Lateness{0.201, false}, Lateness{0.203, false},
                                           Lateness{0.25, false}, Lateness{0.25, true}, Lateness{0.45, false}));

TEST(Rtu, ALostAnswerCostsTimeAndNoNumber) {
  BusBench b;
  b.drive.loseEvery = 5;
  int lost = 0, unsure = 0;
  for (int i = 0; i < 100; ++i) {
    const BusReply reply = b.ask(i % 50);
    if (reply.ok) {
      EXPECT_EQ(reply.words[0], 1000 + i % 50);
    } else {
      ++(reply.unsure ? unsure : lost);
    }
  }
  EXPECT_EQ(lost, 20);
  EXPECT_EQ(unsure, 19) << "the first that came after each: whose is it?";
}

TEST(Rtu, TheLineIsSilentForThreeAndAHalfCharactersBetweenFrames) {
  for (const auto& [baud, gap] : {std::pair{9600, 3.5 * 11.0 / 9600.0}, std::pair{115200, 0.00175}}) {
    BusBench b(address(baud));
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(b.ask(i).ok);
    for (std::size_t i = 1; i < b.drive.asked.size(); ++i) {
      EXPECT_GE(secondsBetween(b.drive.answered[i - 1], b.drive.asked[i]).value, gap) << baud;
    }
  }
}

TEST(Rtu, NothingIsAskedUntilTheLateAnswerHasCome) {
  BusBench b;
  EXPECT_TRUE(b.ask(1).ok);
  b.drive.late = 0.17;
  b.drive.lateEvery = 2;
  EXPECT_FALSE(b.ask(2).ok);  // given up after 0.1 s
  b.drive.lateEvery = 0;
  const BusReply next = b.ask(3);
  EXPECT_TRUE(next.ok);
  EXPECT_EQ(next.words[0], 1003);
  ASSERT_EQ(b.drive.asked.size(), 3U);
  EXPECT_GT(b.drive.asked[2], b.drive.answered[1]);
}

TEST(Rtu, ExceptionIsAnAnswerAndNoiseAroundItIsNone) {
  BusBench b;
  b.drive.before = "\x01\x03\xFF garbage";
  EXPECT_TRUE(b.ask(4).ok);
  b.drive.refuses = true;
  const Instant before = b.clock.now();
  const BusReply refused = b.ask(4);
  EXPECT_FALSE(refused.ok || refused.unsure);
  EXPECT_LT(secondsBetween(before, b.clock.now()).value, 0.05) << "said at once, not waited for";
}

constexpr const char* kMap = R"(version = 1
[bus]
device = "/dev/serial/by-id/drive"
baud = 115200
parity = "none"
answer_ms = 100
[override]
lowest_speed_percent = 50
highest_speed_percent = 120
lowest_feed_percent = 0
highest_feed_percent = 100
[read.programmed_speed]
address = 0
[read.actual_speed]
table = "input"
address = 10
words = 2
scale = 0.1
poll_ms = 20
[read.programmed_feed]
address = 1
[read.operator_speed]
address = 2
[read.speed_override]
address = 3
[read.running]
table = "input"
address = 0
bit = 4
[write.speed_override]
address = 100
scale = 0.1
[write.feed_override]
address = 101
scale = 0.1
)";

struct LinkBench {
  LinkBench() {
    drive.holding = {{0, 8000}, {1, 1200}, {2, 100}, {3, 100}, {100, 1000}, {101, 1000}};
    drive.input = {{0, 0x10}, {10, 80000 >> 16}, {11, 80000 & 0xFFFF}};
    auto map = parseRegisterMap(kMap, "drive.toml");
    EXPECT_TRUE(map.ok()) << map.error().line();
    auto made = std::make_unique<ScriptedWire>(clock, faults, drive);
    wire = made.get();
    link = std::make_unique<ModbusLink>(*map, std::make_unique<RtuBus>(map->bus, std::move(made), clock), clock);
  }
  template <class Look>
  void run(double seconds, Look&& look) {
    const Instant until = clock.now() + toDuration(Seconds(seconds));
    while (clock.now() < until) {
      look(link->read(clock.now()));
      clock.advance(Seconds(0.002));
    }
  }
  MachineState run(double seconds) {
    MachineState last;
    run(seconds, [&](const MachineState& m) { last = m; });
    return last;
  }
  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults;
  FakeDrive drive;
  ScriptedWire* wire = nullptr;
  CommandMaker gate;
  std::unique_ptr<ModbusLink> link;
};

TEST(ModbusRtu, LateAnswersGiveNoWrongStateAndFewGaps) {
  for (const double late : {0.15, 0.25, 0.4}) {
    LinkBench b;
    b.drive.late = late;
    b.drive.lateEvery = 40;
    int looks = 0, valid = 0;
    b.run(30.0, [&](const MachineState& m) {
      ++looks;
      if (!m.valid) return;
      ++valid;
      EXPECT_EQ(m.programmedSpeed.value, 8000.0);
      EXPECT_NEAR(toMmPerMin(m.programmedFeed), 1200.0, 1e-9);
      EXPECT_EQ(m.speedOverride.value, 1.0);
      EXPECT_NEAR(m.actualSpeed.value, 8000.0, 1e-9);
      EXPECT_TRUE(m.programRunning);
    });
    EXPECT_GT(valid, looks / 2) << late;
  }
}

TEST(ModbusRtu, AReleaseReachesADriveThatAnswersLate) {
  LinkBench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  ASSERT_EQ(b.drive.holding[100], 900);
  b.drive.late = 0.15;
  b.drive.lateEvery = 2;
  b.link->release(b.clock.now());
  EXPECT_EQ(b.drive.holding[100], 1000);
  EXPECT_EQ(b.drive.holding[101], 1000);
}

// Bytes without end: memory and ticks are bounded, and the overrides are sent home all the same.
TEST(ModbusRtu, AReleaseGoesOutIntoAFlood) {
  LinkBench b;
  b.run(0.5);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(0.5);
  ASSERT_EQ(b.drive.holding[100], 900);
  b.wire->flood(std::string(400, '\x01'), Seconds(0.001));
  const Instant began = b.clock.now();
  b.link->release(began);
  EXPECT_EQ(b.drive.holding[100], 1000);
  EXPECT_EQ(b.drive.holding[101], 1000);
  EXPECT_LT(secondsBetween(began, b.clock.now()).value, toSeconds(ModbusLink::kReleaseTime).value + 0.1);
}

TEST(ModbusRtu, ASpeedThatCannotBeIsNotBelievedAndSaidWhenTheLinkIsOpened) {
  LinkBench b;
  b.drive.input[10] = 1048576 >> 16;
  b.drive.input[11] = 1048576 & 0xFFFF;
  const Status opened = b.link->open();
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(
      opened.error().line(),
      "mill:5007 unit 1: 'actual_speed' reads 104858, which can not be (is its entry in the register map right?)");
}

TEST(ModbusRtu, AJumpOfOneReadingIsNotBelieved) {
  LinkBench b;
  b.run(0.5);
  int wrong = 0;
  for (int i = 0; i < 20; ++i) {
    const std::size_t before = b.drive.asked.size();
    b.drive.input[10] = 0;
    b.drive.input[11] = 12000;
    while (b.drive.asked.size() == before) b.run(0.002);  // one question sees it
    b.drive.input[10] = 80000 >> 16;
    b.drive.input[11] = 80000 & 0xFFFF;
    b.run(0.1, [&](const MachineState& m) { wrong += m.valid && m.actualSpeed.value != 8000.0 ? 1 : 0; });
  }
  EXPECT_EQ(wrong, 0);
  b.drive.input[10] = 0;
  b.drive.input[11] = 12000;  // and one that stays is
  EXPECT_NEAR(b.run(0.1).actualSpeed.value, 1200.0, 1e-9);
}

}  // namespace
}  // namespace stillcut::cnc
