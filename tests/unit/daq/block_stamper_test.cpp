// Times, sequence numbers and gaps of a live device's blocks, and the hand on a replay.
#include "core/daq/block_stamper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/daq/replay_control.h"
#include "core/model/device_flags.h"

namespace stillcut::daq {
namespace {

constexpr Hertz kRate{10000.0};
constexpr int kFrames = 100;  // 10 ms

Instant at(double seconds) {
  return Instant{} + toDuration(Seconds(seconds));
}

class Stamped {
 public:
  explicit Stamped(bool countsLosses) {
    block_.allocate(1, kFrames);
    stamper_.prepare(kRate, kFrames, countsLosses);
  }
  const SampleBlock& finish(double seen, std::uint64_t lost = 0) {
    stamper_.begin(block_);
    EXPECT_EQ(block_.frames, 0);
    EXPECT_EQ(block_.flags & ~kBlockRateUnverified, 0U);
    block_.frames = kFrames;
    block_.lostFrames = lost;
    stamper_.finish(block_, at(seen));
    return block_;
  }
  void anew() { stamper_.anew(); }

 private:
  SampleBlock block_;
  BlockStamper stamper_;
};

TEST(BlockStamper, BlocksFollowEachOtherWithoutGapsOrOverlap) {
  Stamped stamped(true);
  Instant ended{};
  for (int i = 0; i < 500; ++i) {
    const SampleBlock& block = stamped.finish(5.0 + 0.01 * i);
    EXPECT_EQ(block.sequence, static_cast<std::uint64_t>(i));
    EXPECT_FALSE(block.has(kBlockGap));
    EXPECT_EQ(block.rate, kRate);
    EXPECT_NEAR(i == 0 ? 0.0 : secondsBetween(ended, block.firstSample).value, 0.0, 1e-6);
    ended = block.end();
  }
  EXPECT_NEAR(sinceEpoch(ended).value, 5.0 + 0.01 * 499, 1e-3);
}

TEST(BlockStamper, JitterOfTheTransportDoesNotShow) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(0.0, 0.004);
  Stamped stamped(true);
  Instant before{};
  for (int i = 0; i < 2000; ++i) {
    const SampleBlock& block = stamped.finish(1.0 + 0.01 * i + jitter(random));
    if (i > 1000) {
      EXPECT_NEAR(secondsBetween(before, block.firstSample).value, 0.01, 2e-4) << i;
    }
    before = block.firstSample;
  }
}

TEST(BlockStamper, TimeNeverGoesBackWhateverTheClockShows) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> wild(-0.5, 0.5);
  Stamped stamped(false);
  Instant before{};
  for (int i = 0; i < 3000; ++i) {
    const SampleBlock& block = stamped.finish(10.0 + 0.01 * i + (i % 50 == 0 ? wild(random) : 0.0));
    EXPECT_GE(block.firstSample, before) << i;
    before = block.firstSample;
  }
}

TEST(BlockStamper, WhatTheDeviceLostIsAGapOfItsLengthAndSequenceNumbersSkipIt) {
  Stamped stamped(true);
  for (int i = 0; i < 10; ++i) stamped.finish(1.0 + 0.01 * i);
  const Instant ended = stamped.finish(1.10).end();
  const SampleBlock& block = stamped.finish(1.10 + 0.01 + 0.03, 300);
  EXPECT_TRUE(block.has(kBlockGap));
  EXPECT_EQ(block.lostFrames, 300U);
  EXPECT_EQ(block.sequence, 14U);  // 10, then three that never came
  EXPECT_NEAR(secondsBetween(ended, block.firstSample).value, 0.03, 2e-3);
}

TEST(BlockStamper, NothingIsMissingBeforeTheFirstBlock) {
  Stamped stamped(true);
  const SampleBlock& block = stamped.finish(3.0, 50);
  EXPECT_FALSE(block.has(kBlockGap));
  EXPECT_EQ(block.lostFrames, 0U);
  EXPECT_EQ(block.sequence, 0U);
}

TEST(BlockStamper, AfterACutTheClockSaysHowMuchIsMissing) {
  Stamped stamped(false);
  for (int i = 0; i < 50; ++i) stamped.finish(1.0 + 0.01 * i);
  stamped.anew();
  const SampleBlock& block = stamped.finish(1.49 + 2.0);
  EXPECT_TRUE(block.has(kBlockGap));
  EXPECT_NEAR(static_cast<double>(block.lostFrames), 19900.0, 30.0);
  EXPECT_NEAR(static_cast<double>(block.sequence), 50.0 + 199.0, 1.0);
  EXPECT_FALSE(stamped.finish(3.50).has(kBlockGap));
}

// A driver that drops blocks without a word: the lateness that stays is what is missing.
TEST(BlockStamper, SilentLossIsFoundByTime) {
  Stamped stamped(false);
  std::uint64_t lost = 0;
  for (int i = 0; i < 600; ++i) {
    const double missing = i >= 300 ? 0.1 : 0.0;  // ten blocks never came
    lost += stamped.finish(1.0 + 0.01 * i + missing).lostFrames;
  }
  // To a block: the loop follows a little until the half second is over.
  EXPECT_NEAR(static_cast<double>(lost), 1000.0, 100.0);
}

TEST(ReplayControl, PaceStaysWithinItsBounds) {
  ReplayControl control;
  EXPECT_EQ(control.pace(), 0.0);
  const std::pair<double, double> cases[] = {{1.0, 1.0},
                                             {0.01, kSlowestPace},
                                             {1e9, kFastestPace},
                                             {-3.0, 0.0},
                                             {0.0, 0.0},
                                             {std::numeric_limits<double>::quiet_NaN(), 0.0},
                                             {std::numeric_limits<double>::infinity(), kFastestPace}};
  for (const auto& [wanted, got] : cases) {
    control.setPace(wanted);
    EXPECT_EQ(control.pace(), got) << wanted;
  }
}

TEST(ReplayControl, StepsLetOutSoManyBlocksAndNoMore) {
  ReplayControl control;
  EXPECT_TRUE(control.mayGo());
  control.pause();
  EXPECT_TRUE(control.paused());
  EXPECT_FALSE(control.mayGo());
  control.step(3);
  control.step(-5);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(control.mayGo());
  EXPECT_FALSE(control.mayGo());
  control.step(2);
  control.pause();  // what was still to come is forgotten
  EXPECT_FALSE(control.mayGo());
  control.resume();
  EXPECT_TRUE(control.mayGo());
}

TEST(ReplayControl, APlaceIsGoneToOnceAndTheNewestCounts) {
  ReplayControl control;
  EXPECT_FALSE(control.takeGoTo().has_value());
  control.goTo(Seconds(3.0));
  control.goTo(Seconds(7.0));
  EXPECT_EQ(control.takeGoTo(), Seconds(7.0));
  EXPECT_FALSE(control.takeGoTo().has_value());
}

TEST(ReplayControl, ALoopNeedsItsEndAfterItsBegin) {
  ReplayControl control;
  EXPECT_FALSE(control.loop().on);
  control.loopBetween(Seconds(2.0), Seconds(1.0));
  EXPECT_FALSE(control.loop().on);
  control.loopBetween(Seconds(1.0), Seconds(2.0));
  EXPECT_TRUE(control.loop().on);
  EXPECT_EQ(control.loop().to, Seconds(2.0));
  control.endLoop();
  EXPECT_FALSE(control.loop().on);
  control.tellPosition(Seconds(4.5));
  EXPECT_EQ(control.position(), Seconds(4.5));
}

}  // namespace
}  // namespace stillcut::daq
