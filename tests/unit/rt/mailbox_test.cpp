#include "core/rt/mailbox.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include "core/model/snapshot.h"
#include "core/rt/triple_buffer.h"
#include "tests/support/path_counter.h"

namespace stillcut::rt {
namespace {

// As the override command: made only by its maker.
class Sealed {
 public:
  static Sealed make(int value) { return Sealed(value); }
  int value() const { return value_; }

 private:
  explicit Sealed(int value) : value_(value) {}
  int value_;
};

TEST(Mailbox, HasNothingBeforeTheFirstPost) {
  Mailbox<Sealed> box;
  EXPECT_FALSE(box.take().has_value());
  EXPECT_FALSE(box.latest().has_value());
}

TEST(Mailbox, TheNewestWinsAndIsTakenOnce) {
  Mailbox<Sealed> box;
  for (int i = 1; i <= 5; ++i) box.post(Sealed::make(i));
  const auto taken = box.take();
  ASSERT_TRUE(taken.has_value());
  EXPECT_EQ(taken->value(), 5);
  EXPECT_FALSE(box.take().has_value());
  EXPECT_EQ(box.latest()->value(), 5) << "the newest stays readable";
  box.post(Sealed::make(6));
  EXPECT_EQ(box.take()->value(), 6);
}

TEST(Mailbox, LookingDoesNotTake) {
  Mailbox<Sealed> box;
  box.post(Sealed::make(1));
  EXPECT_EQ(box.latest()->value(), 1);
  const auto taken = box.take();
  ASSERT_TRUE(taken.has_value()) << "latest() must not swallow what take() has not given yet";
  EXPECT_EQ(taken->value(), 1);
}

TEST(Mailbox, PostAndTakeNeitherAllocateNorLock) {
  Mailbox<MachineState> box;
  const test::PathCounter counter;
  for (int i = 0; i < 100; ++i) {
    MachineState state;
    state.programmedSpeed = Rpm(i);
    box.post(state);
    ASSERT_DOUBLE_EQ(box.take()->programmedSpeed.value, i);
  }
  EXPECT_TRUE(counter.counts().none());
}

using Wide = std::array<std::uint64_t, 32>;

TEST(Mailbox, TwoThreadsSeeWholeValuesThatNeverGoBack) {
  constexpr std::uint64_t kPosts = 200'000;
  Mailbox<Wide> box;
  std::thread writer([&] {
    Wide value;
    for (std::uint64_t i = 1; i <= kPosts; ++i) {
      value.fill(i);
      box.post(value);
    }
  });
  std::uint64_t last = 0;
  std::uint64_t torn = 0;
  std::uint64_t back = 0;
  while (last < kPosts) {
    const auto value = box.take();
    if (!value) {
      std::this_thread::yield();
      continue;
    }
    for (const std::uint64_t word : *value) torn += word == value->front() ? 0 : 1;
    back += value->front() > last ? 0 : 1;
    last = value->front();
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(back, 0u) << "each taken value is newer than the one before";
}

TEST(TripleBuffer, TheReadersValueStaysWholeWhileTheWriterGoesOn) {
  TripleBuffer<Snapshot> buffer;
  EXPECT_EQ(buffer.read(), nullptr);
  buffer.back().number = 1;
  buffer.publish();
  const Snapshot* seen = buffer.read();
  ASSERT_NE(seen, nullptr);
  EXPECT_TRUE(buffer.fresh());
  for (std::uint64_t i = 2; i < 10; ++i) {
    Snapshot& next = buffer.back();
    ASSERT_NE(&next, seen) << "the writer never touches what the reader holds";
    next.number = i;
    buffer.publish();
    EXPECT_EQ(seen->number, 1u);
  }
  EXPECT_EQ(buffer.read()->number, 9u);
  (void)buffer.read();
  EXPECT_FALSE(buffer.fresh());
}

}  // namespace
}  // namespace stillcut::rt
