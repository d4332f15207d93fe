#include "core/rt/spsc_ring.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>

#include "core/model/sample_block.h"
#include "tests/support/path_counter.h"

namespace stillcut::rt {
namespace {

TEST(SpscRing, CapacityIsThePowerOfTwoAtOrAboveWhatIsAsked) {
  EXPECT_EQ(SpscRing<int>(0).capacity(), 1u);
  EXPECT_EQ(SpscRing<int>(1).capacity(), 1u);
  EXPECT_EQ(SpscRing<int>(5).capacity(), 8u);
  EXPECT_EQ(SpscRing<int>(8).capacity(), 8u);
}

TEST(SpscRing, FullRefusesEmptyGivesNothingAndOrderIsKept) {
  SpscRing<int> ring(4);
  EXPECT_EQ(ring.front(), nullptr);
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(ring.push(i));
  EXPECT_FALSE(ring.push(99));
  EXPECT_EQ(ring.reserve(), nullptr);
  EXPECT_EQ(ring.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    ASSERT_NE(ring.front(), nullptr);
    EXPECT_EQ(*ring.front(), i);
    ring.pop();
  }
  EXPECT_EQ(ring.front(), nullptr);
  EXPECT_EQ(ring.size(), 0u);
}

TEST(SpscRing, AReservedSlotIsUnseenUntilCommitted) {
  SpscRing<int> ring(2);
  *ring.reserve() = 7;
  EXPECT_EQ(ring.front(), nullptr);
  EXPECT_EQ(ring.size(), 0u);
  ring.commit();
  ASSERT_NE(ring.front(), nullptr);
  EXPECT_EQ(*ring.front(), 7);
}

TEST(SpscRing, EverySlotIsPreparedOnceAndReusedInPlace) {
  int prepared = 0;
  SpscRing<SampleBlock> ring(4, [&](SampleBlock& block) {
    block.allocate(2, 256);
    ++prepared;
  });
  EXPECT_EQ(prepared, 4);
  const test::PathCounter counter;
  for (std::uint64_t i = 0; i < 20; ++i) {
    SampleBlock* block = ring.reserve();
    ASSERT_NE(block, nullptr);
    ASSERT_EQ(block->samples.size(), 512u);
    block->sequence = i;
    ring.commit();
    ASSERT_EQ(ring.front()->sequence, i);
    ring.pop();
  }
  EXPECT_TRUE(counter.counts().none());
}

// Sixteen words that must stay equal: a slot read while it is written shows as a torn one.
using Wide = std::array<std::uint64_t, 16>;

TEST(SpscRing, TwoThreadsLoseNothingAndTearNothing) {
  constexpr std::uint64_t kItems = 200'000;
  SpscRing<Wide> ring(8);
  std::thread producer([&] {
    for (std::uint64_t i = 0; i < kItems;) {
      Wide* slot = ring.reserve();
      if (slot == nullptr) {
        std::this_thread::yield();
        continue;
      }
      slot->fill(i++);
      ring.commit();
    }
  });
  std::uint64_t wrong = 0;
  for (std::uint64_t expected = 0; expected < kItems;) {
    const Wide* slot = ring.front();
    if (slot == nullptr) {
      std::this_thread::yield();
      continue;
    }
    for (const std::uint64_t word : *slot) wrong += word == expected ? 0 : 1;
    ring.pop();
    ++expected;
  }
  producer.join();
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(ring.front(), nullptr);
}

}  // namespace
}  // namespace stillcut::rt
