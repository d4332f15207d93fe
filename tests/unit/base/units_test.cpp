#include "core/base/units.h"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

#include "core/base/time.h"
#include "tests/support/virtual_clock.h"

namespace stillcut {
namespace {

// A speed cannot be passed where a frequency is meant, nor a bare number as either.
static_assert(!std::is_convertible_v<Rpm, Hertz>);
static_assert(!std::is_constructible_v<Hertz, Rpm>);
static_assert(!std::is_convertible_v<double, Seconds>);
static_assert(std::is_trivially_copyable_v<Hertz>);

TEST(Units, SpindleSpeedAndFrequency) {
  EXPECT_DOUBLE_EQ(toHertz(Rpm(6000.0)).value, 100.0);
  EXPECT_DOUBLE_EQ(toRpm(Hertz(100.0)).value, 6000.0);
  EXPECT_DOUBLE_EQ(toothPassing(Rpm(8800.0), 4).value, 8800.0 / 60.0 * 4.0);
}

TEST(Units, FeedInMillimetresPerMinute) {
  EXPECT_NEAR(fromMmPerMin(1408.0).value, 0.0234666666666, 1e-12);
  EXPECT_NEAR(toMmPerMin(fromMmPerMin(1408.0)), 1408.0, 1e-9);
}

TEST(Units, Arithmetic) {
  Metres path(0.5);
  path += Metres(0.25);
  path -= Metres(0.5);
  path *= 4.0;
  EXPECT_DOUBLE_EQ(path.value, 1.0);
  EXPECT_DOUBLE_EQ((-path).value, -1.0);
  EXPECT_DOUBLE_EQ((path + Metres(1.0) - Metres(0.5)).value, 1.5);
  EXPECT_DOUBLE_EQ((2.0 * path / 4.0).value, 0.5);
  EXPECT_DOUBLE_EQ(Metres(3.0) / Metres(2.0), 1.5);
  EXPECT_LT(Metres(1.0), Metres(2.0));
}

TEST(Units, FiniteMeansNeitherNanNorInfinite) {
  EXPECT_TRUE(isFinite(Hertz(1.0)));
  EXPECT_FALSE(isFinite(Hertz(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_FALSE(isFinite(Hertz(-std::numeric_limits<double>::infinity())));
}

TEST(StreamTime, SecondsRoundToTheNearestNanosecondBothWays) {
  EXPECT_EQ(toDuration(Seconds(256.0 / 25600.0)).count(), 10'000'000);
  EXPECT_EQ(toDuration(Seconds(1.0 / 3.0)).count(), 333'333'333);
  EXPECT_EQ(toDuration(Seconds(-0.5)).count(), -500'000'000);
  EXPECT_DOUBLE_EQ(secondsBetween(instantFromNs(1'000'000'000), instantFromNs(3'500'000'000)).value, 2.5);
  EXPECT_DOUBLE_EQ(sinceEpoch(instantFromNs(-250'000'000)).value, -0.25);
}

TEST(StreamTime, TheSteadyClockNeverGoesBack) {
  const SteadyClock clock;
  Instant last = clock.now();
  for (int i = 0; i < 1000; ++i) {
    const Instant now = clock.now();
    ASSERT_GE(now, last);
    last = now;
  }
}

TEST(StreamTime, TheVirtualClockMovesOnlyWhenTold) {
  test::VirtualClock clock(instantFromNs(5));
  EXPECT_EQ(toNs(clock.now()), 5);
  clock.advance(Seconds(0.001));
  EXPECT_EQ(toNs(clock.now()), 1'000'005);
  EXPECT_EQ(clock.now(), clock.now());
}

}  // namespace
}  // namespace stillcut
