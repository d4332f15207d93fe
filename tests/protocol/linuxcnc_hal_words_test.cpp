// The words between the LinuxCNC link and stillcut-hal, as they come: together, in pieces, out of order, as garbage.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "tests/protocol/hal_bench.h"

namespace stillcut::cnc {
namespace {

using namespace testing;
using Bench = HalBench;

TEST(LinuxCncHal, ReportsThatComeTogetherAreHeard) {
  Bench b;
  b.faults.merge(0.015);
  b.engage(90.0);
  EXPECT_EQ(b.mill.spindle, 90);
}

// A report that is kept back is silence: the machine may go home, and nowhere else.
TEST(LinuxCncHal, ReportsInTheWrongOrderAreOursOrHome) {
  Bench b;
  b.engage(90.0);
  b.faults.wrongOrder(37);
  for (int i = 0; i < 1000; ++i) {
    b.run(Bench::kStep);
    EXPECT_TRUE(b.mill.spindle == 90 || b.mill.spindle == 100) << b.mill.spindle;
  }
  b.faults = {};
  b.link->apply(b.gate.relinquish(), b.clock.now());
  b.run(1.0);
  EXPECT_EQ(b.mill.spindle, 100);
  b.engage(92.0);
  EXPECT_EQ(b.mill.spindle, 92);
}

TEST(LinuxCncHal, SplitAndGarbledLinesAreNoOrders) {
  Bench b;
  b.faults.split(3).garbage("HELD 9999 1 1 1\n\x01zz\n");
  b.engage(90.0);
  EXPECT_EQ(b.mill.spindle, 90);
  for (const char* line : {"set", "set 90", "set 90 90 1", "set 90 90 2 100 100", "set 1e9 90 1 100 100", "home 100",
                           "set 90.5 90 1 100 100", "set nan 90 1 100 100", "home 100 100 100", "set -1 9 1 1 1"}) {
    EXPECT_FALSE(readHalRequest(line)) << line;
  }
}

TEST(LinuxCncHal, WordsAreReadAsTheyWereWritten) {
  std::array<char, kHalLine> text{};
  HalRequest r;
  r.hold = true;
  r.feed = 1000;
  r.adaptiveFeed = 0.25;
  r.restoreSpeed = 70;
  std::string line(writeHalRequest(r, text));
  EXPECT_EQ(line, "set - 1000 0.250 70 100\n");
  line.pop_back();
  const auto back = readHalRequest(line);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->hold && !back->speed && back->feed == 1000 && back->restoreSpeed == 70);
  const HalReport report{HalLeaseState::Fallen, 90, 95, 0.5, 71};
  line = writeHalReport(report, text);
  line.pop_back();
  const auto heard = readHalReport(line);
  ASSERT_TRUE(heard);
  EXPECT_TRUE(heard->standing == HalLeaseState::Fallen && heard->speed == 90 && heard->feed == 95 &&
              heard->adaptiveFeed == 0.5 && heard->watchdogMs == 71);
}

}  // namespace
}  // namespace stillcut::cnc
