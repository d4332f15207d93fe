#include "core/rt/deadline_stats.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/support/path_counter.h"

namespace stillcut::rt {
namespace {

// Buckets are 10^(1/20) apart; a quantile is the upper edge of its bucket.
constexpr double kBucket = 1.1221;

TEST(DeadlineStats, IsZeroWithoutRecords) {
  const DeadlineStats stats;
  EXPECT_EQ(stats.count(), 0u);
  EXPECT_DOUBLE_EQ(stats.quantile(0.99).value, 0.0);
  EXPECT_DOUBLE_EQ(stats.worst().value, 0.0);
}

TEST(DeadlineStats, QuantilesAreRightToOneBucket) {
  DeadlineStats stats;
  for (int i = 1; i <= 1000; ++i) stats.record(Seconds(i * 1e-6));
  EXPECT_EQ(stats.count(), 1000u);
  EXPECT_DOUBLE_EQ(stats.worst().value, 1e-3);
  for (const double share : {0.5, 0.99, 0.999}) {
    const double exact = share * 1e-3;
    EXPECT_GE(stats.quantile(share).value, exact * 0.999999) << share;
    EXPECT_LE(stats.quantile(share).value, exact * kBucket * 1.000001) << share;
  }
}

TEST(DeadlineStats, OneSlowBlockShowsInTheWorstAndNotInTheMedian) {
  DeadlineStats stats;
  for (int i = 0; i < 9999; ++i) stats.record(Seconds(100e-6));
  stats.record(Seconds(0.25));
  EXPECT_LE(stats.quantile(0.5).value, 100e-6 * kBucket);
  EXPECT_LE(stats.quantile(0.999).value, 100e-6 * kBucket);
  EXPECT_DOUBLE_EQ(stats.worst().value, 0.25);
}

TEST(DeadlineStats, CountsWhatIsOutsideItsRangeToo) {
  DeadlineStats stats;
  stats.record(Seconds(0.0));
  stats.record(Seconds(-1.0));
  stats.record(Seconds(1000.0));
  EXPECT_EQ(stats.count(), 3u);
  EXPECT_DOUBLE_EQ(stats.worst().value, 1000.0);
  EXPECT_LE(stats.quantile(0.5).value, 1e-7 * kBucket);
}

TEST(DeadlineStats, RecordIsRealTimeAndReadableFromAnotherThread) {
  constexpr int kRecords = 100'000;
  DeadlineStats stats;
  bool clean = false;
  std::thread recorder([&] {
    const test::PathCounter counter;
    for (int i = 0; i < kRecords; ++i) stats.record(Seconds(50e-6));
    clean = counter.counts().none();
  });
  while (stats.count() < kRecords) {
    ASSERT_LE(stats.quantile(0.99).value, 50e-6 * kBucket);
    std::this_thread::yield();
  }
  recorder.join();
  EXPECT_TRUE(clean);
}

}  // namespace
}  // namespace stillcut::rt
