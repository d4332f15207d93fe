#include "core/pipeline/spectrum_tap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stillcut::pipeline {
namespace {

constexpr double kRate = 25600.0;
constexpr int kFrames = 128;

CutSetup oneChannel(double scale) {
  CutSetup s;
  s.rate = Hertz(kRate);
  s.blockFrames = kFrames;
  s.channels.resize(1);
  s.channels[0].scale = scale;
  return s;
}

// Feeds `blocks` blocks of a sine, beginning with block `from`.
void feed(SpectrumTap& tap, double frequency, double amplitude, int from, int blocks, std::uint32_t firstFlags = 0) {
  SampleBlock b;
  b.allocate(1, kFrames);
  b.frames = kFrames;
  b.rate = Hertz(kRate);
  for (int n = from; n < from + blocks; ++n) {
    b.flags = n == from ? firstFlags : 0;
    b.firstSample = Instant(toDuration(Seconds(n * kFrames / kRate)));
    for (int i = 0; i < kFrames; ++i) {
      const double t = (static_cast<double>(n) * kFrames + i) / kRate;
      b.channel(0)[static_cast<std::size_t>(i)] = static_cast<float>(amplitude * std::sin(kTwoPi * frequency * t));
    }
    tap.feed(b, Verdict{});
  }
}

TEST(SpectrumTap, ALineStandsAtItsFrequencyWithItsLevelInSi) {
  SpectrumTap tap;
  tap.prepare(oneChannel(50.0));
  feed(tap, 2000.0, 0.1, 0, 100);  // 0.1 device units, 50 SI units each: 5 peak, 10.97 dB re 1 rms
  ASSERT_GT(tap.count(), 10U);
  const SpectrumColumn& c = tap.column(tap.count() - 1);
  const auto strongest = std::max_element(c.level_dB.begin(), c.level_dB.end());
  const double bin = static_cast<double>(strongest - c.level_dB.begin());
  EXPECT_NEAR((bin + 0.5) * tap.top().value / kSpectrumBins, 2000.0, tap.top().value / kSpectrumBins);
  EXPECT_NEAR(*strongest, 20.0 * std::log10(5.0 / std::sqrt(2.0)), 0.3);
  EXPECT_LT(c.level_dB[kSpectrumBins / 2], *strongest - 80.0F);
}

TEST(SpectrumTap, ScrollsWithSamplesFiftyTimesASecond) {
  SpectrumTap tap;
  tap.prepare(oneChannel(1.0));
  feed(tap, 1000.0, 1.0, 0, 400);  // two seconds
  EXPECT_NEAR(static_cast<double>(tap.count()), 100.0, 5.0);
  const double apart = secondsBetween(tap.column(tap.count() - 2).time, tap.column(tap.count() - 1).time).value;
  EXPECT_NEAR(apart, 0.02, 1e-6);
}

TEST(SpectrumTap, ShowsTheChannelAskedForWithItsOwnScale) {
  CutSetup setup = oneChannel(1.0);
  setup.channels.push_back({"y", SensorQuantity::Acceleration, 10.0, "y"});
  SpectrumTap tap;
  tap.prepare(setup);
  SampleBlock b;
  b.allocate(2, kFrames);
  b.frames = kFrames;
  b.rate = Hertz(kRate);
  const auto run = [&](int from) {
    for (int n = from; n < from + 100; ++n) {
      b.firstSample = Instant(toDuration(Seconds(n * kFrames / kRate)));
      for (int i = 0; i < kFrames; ++i) {
        const double t = (static_cast<double>(n) * kFrames + i) / kRate;
        b.channel(0)[static_cast<std::size_t>(i)] = static_cast<float>(std::sin(kTwoPi * 1000.0 * t));
        b.channel(1)[static_cast<std::size_t>(i)] = static_cast<float>(std::sin(kTwoPi * 3000.0 * t));
      }
      tap.feed(b, Verdict{});
    }
    const SpectrumColumn& c = tap.column(tap.count() - 1);
    const auto strongest = std::max_element(c.level_dB.begin(), c.level_dB.end());
    const double bin = static_cast<double>(strongest - c.level_dB.begin());
    return std::pair{(bin + 0.5) * tap.top().value / kSpectrumBins, static_cast<double>(*strongest)};
  };
  EXPECT_NEAR(run(0).first, 1000.0, 30.0);
  tap.show(1);
  const auto [frequency, level] = run(100);
  EXPECT_EQ(tap.column(tap.count() - 1).channel, 1);
  EXPECT_NEAR(frequency, 3000.0, 30.0);
  EXPECT_NEAR(level, 20.0 * std::log10(10.0 / std::sqrt(2.0)), 0.3);
  tap.show(7);  // there is no such channel
  EXPECT_NEAR(run(200).first, 1000.0, 30.0);
}

TEST(SpectrumTap, NoColumnReachesAcrossAGap) {
  SpectrumTap tap;
  tap.prepare(oneChannel(1.0));
  feed(tap, 1000.0, 1.0, 0, 100);
  const std::uint64_t before = tap.count();
  feed(tap, 1000.0, 1.0, 300, 15, kBlockGap);  // 75 ms: less than a window
  EXPECT_EQ(tap.count(), before);
  feed(tap, 1000.0, 1.0, 315, 20);
  ASSERT_GT(tap.count(), before);
  EXPECT_TRUE(tap.column(before).afterGap);
  EXPECT_FALSE(tap.column(before + 1).afterGap);
  EXPECT_GE(sinceEpoch(tap.column(before).time).value, 300 * kFrames / kRate);
}

TEST(SpectrumTap, SilenceAndRubbishStayFinite) {
  SpectrumTap tap;
  tap.prepare(oneChannel(1.0));
  feed(tap, 1000.0, 0.0, 0, 100);
  feed(tap, 1000.0, std::numeric_limits<double>::infinity(), 100, 100);
  for (float level : tap.column(tap.count() - 1).level_dB) EXPECT_TRUE(std::isfinite(level));
}

}  // namespace
}  // namespace stillcut::pipeline
