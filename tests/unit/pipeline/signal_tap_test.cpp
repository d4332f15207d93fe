// The samples handed to the screen: in order, whole, and never waited for.
#include "core/pipeline/signal_tap.h"

#include <gtest/gtest.h>

#include <vector>

namespace stillcut::pipeline {
namespace {

CutSetup setup() {
  CutSetup s;
  s.rate = Hertz(1000);
  s.blockFrames = 10;
  s.channels = {{"x", SensorQuantity::Acceleration, 1.0, "x"}, {"y", SensorQuantity::Acceleration, 1.0, "y"}};
  return s;
}

SampleBlock block(std::uint64_t sequence, int frames = 10) {
  SampleBlock b;
  b.allocate(2, 10);
  b.frames = frames;
  b.rate = Hertz(1000);
  b.sequence = sequence;
  b.firstSample = instantFromNs(static_cast<std::int64_t>(sequence) * 10'000'000);
  b.channel(0)[0] = static_cast<float>(sequence);
  b.channel(1)[static_cast<std::size_t>(frames) - 1] = -static_cast<float>(sequence);
  return b;
}

TEST(SignalTap, HandsOverEveryBlockOnceAndInOrder) {
  SignalTap tap;
  tap.prepare(setup());
  for (std::uint64_t k = 1; k <= 5; ++k) tap.feed(block(k, k == 5 ? 4 : 10));
  std::vector<std::uint64_t> seen;
  tap.read([&](const SampleBlock& b) {
    seen.push_back(b.sequence);
    EXPECT_EQ(b.firstSample, block(b.sequence).firstSample);
    EXPECT_FLOAT_EQ(b.channel(0)[0], static_cast<float>(b.sequence));
    EXPECT_FLOAT_EQ(b.channel(1)[static_cast<std::size_t>(b.frames) - 1], -static_cast<float>(b.sequence));
  });
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{1, 2, 3, 4, 5}));
  tap.read([](const SampleBlock&) { FAIL() << "read before"; });
}

TEST(SignalTap, AScreenThatIsLateLosesTheNewestBlocksNotTheWorker) {
  SignalTap tap;
  tap.prepare(setup());
  for (std::uint64_t k = 1; k <= 1000; ++k) tap.feed(block(k));
  std::uint64_t count = 0, last = 0;
  tap.read([&](const SampleBlock& b) {
    ++count;
    last = b.sequence;
  });
  EXPECT_EQ(last, count) << "what is there follows without a hole";
  EXPECT_GE(count, 50U) << "half a second of blocks of 10 ms";
  EXPECT_LT(count, 1000U);
  tap.feed(block(1001));
  tap.read([&](const SampleBlock& b) { EXPECT_EQ(b.sequence, 1001U); });
}

TEST(SignalTap, WithoutChannelsOrRateNothingIsKept) {
  SignalTap tap;
  tap.feed(block(1));
  tap.prepare(CutSetup{});
  tap.feed(block(1));
  tap.read([](const SampleBlock&) { FAIL(); });
}

}  // namespace
}  // namespace stillcut::pipeline
