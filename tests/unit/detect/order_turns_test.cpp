// Orders that turn against the spindle, and the floor that rises by time alone.
#include "core/detect/growth/order_turns.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "core/base/units.h"
#include "core/detect/growth/timed_floor.h"

namespace stillcut::detect {
namespace {

using Amplitudes = std::array<std::complex<double>, 3>;

// Order 1 stands still, a line at 2.03 turns, order 3 turns as it likes.
OrderTurns after(int turns) {
  OrderTurns out;
  out.prepare(3);
  for (int k = 0; k < turns; ++k) {
    const Amplitudes now{1.0, std::polar(2.0, kTwoPi * 0.03 * k), std::polar(1.0, 1.7 * k * k)};
    out.endTurn(now);
  }
  return out;
}

TEST(OrderTurns, ALineBesideAnOrderTurnsByWhatItStandsBeside) {
  const OrderTurns turns = after(60);
  EXPECT_NEAR(turns.drift(2), 0.03, 1e-3);
  EXPECT_NEAR(turns.change(2), 2.0 * std::sin(0.5 * kTwoPi * 0.03), 1e-3);
  EXPECT_TRUE(turns.turns(2));
  EXPECT_FALSE(turns.turns(1));
  EXPECT_FALSE(turns.turns(3));
}

TEST(OrderTurns, OfAnOrderThatThereIsNotTellsNothing) {
  const OrderTurns turns = after(60);
  for (const int order : {0, 4}) {
    EXPECT_EQ(turns.drift(order), 0.0);
    EXPECT_FALSE(turns.turns(order));
    EXPECT_TRUE(std::isinf(turns.change(order)));
    EXPECT_EQ(turns.leak(order, 1.0), 0.0);
  }
}

// A line that stands on its order, or is none, leaks nothing.
TEST(OrderTurns, OnlyWhatTurnsLeaks) {
  const OrderTurns turns = after(60);
  EXPECT_NEAR(turns.leak(1, 1.0), 0.0, 1e-6);
  EXPECT_NEAR(turns.leak(2, 6.0), 0.5 * turns.change(2) * turns.change(2), 1e-9);
  EXPECT_EQ(turns.leak(3, 1.0), 0.0);
}

// A hundredfold growth within a second hardly moves it; where it stays it is the floor some minutes later.
TEST(TimedFloor, RisesByTimeAlone) {
  constexpr Hertz kSpindle(100.0);
  TimedFloor floor;
  EXPECT_FALSE(floor.learned());
  floor.learn(0.01, 1.0);
  for (int turn = 0; turn < 100; ++turn) floor.follow(1.0, 100.0, 1.0, kSpindle);
  EXPECT_LT(floor.share(), 0.012);
  EXPECT_LT(floor.energy(), 1.2);
  for (int turn = 0; turn < 9000; ++turn) floor.follow(1.0, 100.0, 1.0, kSpindle);
  EXPECT_GT(floor.share(), 0.9);
}

TEST(TimedFloor, FallsWithinSomeTurns) {
  TimedFloor floor;
  floor.learn(1.0, 100.0);
  for (int turn = 0; turn < 40; ++turn) floor.follow(0.1, 10.0, 1.0, Hertz(10.0));
  EXPECT_NEAR(floor.share(), 0.1, 0.02);
  EXPECT_NEAR(floor.energy(), 10.0, 2.0);
}

}  // namespace
}  // namespace stillcut::detect
