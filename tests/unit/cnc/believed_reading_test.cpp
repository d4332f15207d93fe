// What is believed of a register, reading by reading.
#include "core/cnc/modbus/believed_reading.h"

#include <gtest/gtest.h>

namespace stillcut::cnc {
namespace {

constexpr Instant at(int n) {
  return instantFromNs(n);
}

TEST(BelievedReading, TheFirstIsBelievedWhenItIsReadTwice) {
  BelievedReading r;
  EXPECT_FALSE(r.take(8000.0, 100.0, at(1)));
  EXPECT_FALSE(r.ever());
  EXPECT_TRUE(r.take(8001.0, 100.0, at(2)));
  EXPECT_EQ(r.value(), 8001.0);
  EXPECT_EQ(r.when(), at(2));
}

TEST(BelievedReading, OneThatJumpsAndIsNotSeenAgainChangesNothing) {
  BelievedReading r;
  r.take(8000.0, 100.0, at(1));
  r.take(8000.0, 100.0, at(2));
  EXPECT_FALSE(r.take(1200.0, 100.0, at(3)));
  EXPECT_FALSE(r.take(104857.6, 100.0, at(4)));  // nor do two that do not agree
  EXPECT_EQ(r.value(), 8000.0);
  EXPECT_EQ(r.when(), at(2));
  EXPECT_TRUE(r.take(8000.0, 100.0, at(5)));
  EXPECT_FALSE(r.take(1200.0, 100.0, at(6)));  // the doubt of before is over
}

TEST(BelievedReading, AJumpThatStaysIsBelievedTheSecondTime) {
  BelievedReading r;
  r.take(8000.0, 100.0, at(1));
  r.take(8000.0, 100.0, at(2));
  EXPECT_FALSE(r.take(0.0, 100.0, at(3)));
  EXPECT_TRUE(r.take(0.0, 100.0, at(4)));
  EXPECT_EQ(r.value(), 0.0);
  EXPECT_EQ(r.when(), at(4));
}

TEST(BelievedReading, ARampIsFollowed) {
  BelievedReading r;
  r.take(0.0, 100.0, at(0));
  for (int n = 1; n <= 100; ++n) {
    EXPECT_TRUE(r.take(80.0 * n, 100.0, at(n)));
    EXPECT_EQ(r.value(), 80.0 * n);
  }
}

}  // namespace
}  // namespace stillcut::cnc
