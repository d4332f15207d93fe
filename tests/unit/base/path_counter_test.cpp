#include "tests/support/path_counter.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace stillcut::test {
namespace {

// What the optimiser must not remove.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

class PathCounterTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!PathCounter::works()) GTEST_SKIP() << "a sanitizer owns malloc here";
  }
};

TEST_F(PathCounterTest, PlainArithmeticCountsNothing) {
  const PathCounter counter;
  std::array<double, 64> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i) * 0.5;
  keep(values);
  EXPECT_TRUE(counter.counts().none());
}

TEST_F(PathCounterTest, SeesNewMallocAndTheirKin) {
  const PathCounter counter;
  auto one = std::make_unique<int>(1);
  keep(one);
  one.reset();
  void* two = std::malloc(10);
  keep(two);
  two = std::realloc(two, 2000);
  keep(two);
  std::free(two);
  void* three = std::aligned_alloc(64, 128);
  keep(three);
  std::free(three);
  struct alignas(128) Wide {
    int x = 0;
  };
  const auto four = std::make_unique<Wide>();
  keep(four);
  EXPECT_EQ(counter.counts().allocations, 5u);
  EXPECT_EQ(counter.counts().releases, 3u);
}

TEST_F(PathCounterTest, SeesLocksAndThrows) {
  std::mutex mutex;
  const PathCounter locks;
  {
    const std::lock_guard guard(mutex);
    keep(mutex);
  }
  EXPECT_EQ(locks.counts().locks, 1u);
  const PathCounter throws;
  try {
    throw 1;
  } catch (int) {
  }
  EXPECT_GE(throws.counts().allocations, 1u);
}

TEST_F(PathCounterTest, CountsItsOwnThreadOnly) {
  std::vector<int> there;
  std::thread other([&] { there.resize(1000); });
  const PathCounter counter;
  std::vector<int> unused;
  keep(unused);
  const PathCounts counts = counter.counts();
  other.join();
  EXPECT_EQ(counts.allocations, 0u);
  EXPECT_EQ(there.size(), 1000u);
}

}  // namespace
}  // namespace stillcut::test
