// The small parts of the wire: registers as numbers and back, lines out of bytes, words of stillcut-hal, typical
// delays.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/cnc/delay_gauge.h"
#include "core/cnc/line_splitter.h"
#include "core/cnc/linuxcnc/hal_messages.h"
#include "core/cnc/modbus/register_map.h"
#include "core/cnc/wire_number.h"

namespace stillcut::cnc {
namespace {

TEST(Register, EveryFormKeepsEveryWholeRawValue) {
  std::mt19937_64 random(3);
  for (int words : {1, 2}) {
    for (bool isSigned : {false, true}) {
      for (bool highFirst : {false, true}) {
        Register r;
        r.words = words;
        r.isSigned = isSigned;
        r.highWordFirst = highFirst;
        r.scale = 0.1;
        r.offset = -40.0;
        const double span = words == 1 ? 65536.0 : 4294967296.0;
        const double lowest = isSigned ? -span / 2.0 : 0.0;
        for (int trial = 0; trial < 2000; ++trial) {
          const double raw = trial == 0   ? lowest
                             : trial == 1 ? lowest + span - 1.0
                                          : lowest + static_cast<double>(random() % static_cast<std::uint64_t>(span));
          const auto coded = r.encode(raw * r.scale + r.offset);
          ASSERT_TRUE(coded.has_value());
          EXPECT_NEAR(r.decode(*coded), raw * r.scale + r.offset, 1e-6);
        }
        for (double beyond : {lowest - 1.0, lowest + span}) {
          EXPECT_FALSE(r.encode(beyond * r.scale + r.offset).has_value());
        }
        EXPECT_FALSE(r.encode(std::nan("")).has_value());
      }
    }
  }
}

TEST(Register, WordOrderIsTheWires) {
  Register r;
  r.words = 2;
  EXPECT_EQ(r.encode(65536.0), (RegisterWords{1, 0}));
  EXPECT_EQ(r.decode({1, 2}), 65538.0);
  r.highWordFirst = false;
  EXPECT_EQ(r.encode(65536.0), (RegisterWords{0, 1}));
  EXPECT_EQ(r.decode({2, 1}), 65538.0);
  r.isSigned = true;
  EXPECT_EQ(r.decode({0xffff, 0xffff}), -1.0);
}

TEST(Register, AFlagIsItsBitOrAnythingButZero) {
  Register r;
  EXPECT_FALSE(r.flag({0, 0}));
  EXPECT_TRUE(r.flag({0x10, 0}));
  for (int bit = 0; bit < 16; ++bit) {
    r.bit = bit;
    for (int other = 0; other < 16; ++other) {
      EXPECT_EQ(r.flag({static_cast<std::uint16_t>(1U << static_cast<unsigned>(other)), 0}), bit == other);
    }
  }
}

TEST(LineSplitter, HowTheBytesArriveDoesNotMatter) {
  const std::string text = "one\r\ntwo\n\rthree\n\n\n four \rfive";
  const std::vector<std::string> lines{"one", "two", "three", " four "};
  std::mt19937 random(9);
  for (int trial = 0; trial < 500; ++trial) {
    LineSplitter splitter;
    std::vector<std::string> got;
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t n = std::min<std::size_t>(1 + random() % 7, text.size() - i);
      splitter.feed(std::string_view(text).substr(i, n), [&](std::string_view line) { got.emplace_back(line); });
      i += n;
    }
    EXPECT_EQ(got, lines);
    splitter.feed("!\n", [&](std::string_view line) { got.emplace_back(line); });
    EXPECT_EQ(got.back(), "five!");
  }
}

TEST(LineSplitter, ALineTooLongIsDroppedWholeAndTheNextIsSound) {
  LineSplitter splitter;
  std::vector<std::size_t> sizes;
  const auto take = [&](std::string_view line) { sizes.push_back(line.size()); };
  splitter.feed(std::string(LineSplitter::kLongest, 'a') + "\n", take);
  splitter.feed(std::string(LineSplitter::kLongest + 1, 'b') + "\n", take);
  splitter.feed("next\n", take);
  EXPECT_EQ(sizes, (std::vector<std::size_t>{LineSplitter::kLongest, 4}));
  EXPECT_EQ(splitter.dropped(), 1u);
  splitter.feed("half of", take);
  splitter.clear();
  splitter.feed("new\n", take);
  EXPECT_EQ(sizes.back(), 3u);
}

TEST(DelayGauge, IsTheMedianOfTheLastFifteen) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> delay(0.001, 0.5);
  DelayGauge gauge;
  EXPECT_EQ(gauge.typical().value, 0.0);
  std::vector<double> all;
  for (int i = 0; i < 500; ++i) {
    all.push_back(delay(random));
    gauge.take(Seconds(all.back()));
    std::vector<double> last(all.end() - static_cast<std::ptrdiff_t>(std::min<std::size_t>(15, all.size())), all.end());
    std::sort(last.begin(), last.end());
    EXPECT_EQ(gauge.typical().value, last[last.size() / 2]) << i;
  }
}

TEST(DelayGauge, OneStallDoesNotMoveIt) {
  DelayGauge gauge;
  for (int i = 0; i < 20; ++i) gauge.take(Seconds(0.01));
  gauge.take(Seconds(5.0));
  EXPECT_EQ(gauge.typical().value, 0.01);
}

TEST(WireNumber, TakesTheWholeWordOrNothing) {
  EXPECT_EQ(wireNumber("12.5"), 12.5);
  EXPECT_EQ(wireNumber("-3e2"), -300.0);
  for (const char* bad : {"", "12,5", "1 ", " 1", "1x", "nan", "inf", "-inf", "1e999", "0x10", "--1"}) {
    EXPECT_FALSE(wireNumber(bad).has_value()) << bad;
  }
}

TEST(HalWords, RequestsComeBackAsTheyWent) {
  std::mt19937 random(4);
  const auto knob = [&]() -> std::optional<int> {
    return random() % 4 == 0 ? std::nullopt : std::optional(static_cast<int>(random() % 1001));
  };
  for (int trial = 0; trial < 5000; ++trial) {
    HalRequest wanted;
    wanted.hold = random() % 3 != 0;
    wanted.restoreSpeed = static_cast<int>(random() % 1001);
    wanted.restoreFeed = static_cast<int>(random() % 1001);
    if (wanted.hold) {
      wanted.speed = knob();
      wanted.feed = knob();
      wanted.adaptiveFeed = static_cast<double>(random() % 1001) * 0.001;
    }
    std::array<char, kHalLine> room{};
    std::string_view line = writeHalRequest(wanted, room);
    ASSERT_TRUE(line.ends_with('\n'));
    line.remove_suffix(1);
    const auto got = readHalRequest(line);
    ASSERT_TRUE(got.has_value()) << line;
    EXPECT_EQ(got->hold, wanted.hold);
    EXPECT_EQ(got->speed, wanted.speed);
    EXPECT_EQ(got->feed, wanted.feed);
    EXPECT_NEAR(got->adaptiveFeed, wanted.adaptiveFeed, 5e-4);
    EXPECT_EQ(got->restoreSpeed, wanted.restoreSpeed);
    EXPECT_EQ(got->restoreFeed, wanted.restoreFeed);
  }
}

TEST(HalWords, ReportsComeBackAsTheyWent) {
  for (HalLeaseState standing :
       {HalLeaseState::Unproven, HalLeaseState::Home, HalLeaseState::Held, HalLeaseState::Fallen}) {
    for (int percent : {0, 1, 99, 100, 250, 1000}) {
      const HalReport wanted{standing, percent, 1000 - percent, percent / 1000.0, percent};
      std::array<char, kHalLine> room{};
      std::string_view line = writeHalReport(wanted, room);
      line.remove_suffix(1);
      const auto got = readHalReport(line);
      ASSERT_TRUE(got.has_value()) << line;
      EXPECT_EQ(got->standing, wanted.standing);
      EXPECT_EQ(got->speed, wanted.speed);
      EXPECT_EQ(got->feed, wanted.feed);
      EXPECT_NEAR(got->adaptiveFeed, wanted.adaptiveFeed, 5e-4);
      EXPECT_EQ(got->watchdogMs, wanted.watchdogMs);
    }
  }
}

// A request that is not whole or out of range must not move a machine.
TEST(HalWords, WhatIsNoRequestIsNone) {
  for (const char* bad :
       {"", "set", "set 90", "set 90 95", "set 90 95 1.0", "set 90 95 1.0 100", "set x 95 1.0 100 100",
        "set -1 95 1.0 100 100", "set 1001 95 1.0 100 100", "set 90 95 1.5 100 100", "set 90 95 -0.1 100 100",
        "set 90 95 nan 100 100", "set 90 95 1.0 100 100 7", "home", "home 100", "home 100 100 100", "home a b",
        "hold 1", "SET 90 95 1.0 100 100"}) {
    EXPECT_FALSE(readHalRequest(bad).has_value()) << bad;
  }
  for (const char* bad : {"", "HELD", "HELD 1 2", "STOOD 90 95 1.000 104", "HELD 90 95 x 104", "HELD 90 95 1.000"}) {
    EXPECT_FALSE(readHalReport(bad).has_value()) << bad;
  }
}

}  // namespace
}  // namespace stillcut::cnc
