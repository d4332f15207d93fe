// The clock of a live device against what wires do: stalls and bursts, slow catching up, wrong rates, counters that
// leap, losses without a word. Time is computed, none passes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include "core/daq/block_stamper.h"

namespace stillcut::daq {
namespace {

// A device of `told` frames a second that makes `real` of them.
struct Wire {
  double told = 8000.0, real = 8000.0;
  int frames = 80;
  bool counts = false;
  std::uint64_t unit = 1;
  double jitter = 0.001;                                               // s
  std::function<double(double)> arrives = [](double t) { return t; };  // when what was taken at t arrives at best
  std::function<double(double)> lost = [](double) { return 0.0; };     // s of samples that are missing until t
  std::function<std::uint64_t(int)> tells = [](int) { return 0U; };    // what the device says before its k-th block
};

struct Stamps {
  int blocks = 0, gaps = 0;
  std::uint64_t lost = 0;
  double firstGap = 0.0;      // s
  std::vector<double> error;  // s, by block: stamp less truth
  std::vector<double> step;   // s from stamp to stamp
  double rate(const Wire& w, double from_s, double to_s) const {
    const auto from = static_cast<std::size_t>(from_s * w.real / w.frames);
    const auto to = static_cast<std::size_t>(to_s * w.real / w.frames);
    return static_cast<double>((to - from) * static_cast<std::size_t>(w.frames)) /
           std::accumulate(step.begin() + static_cast<long>(from), step.begin() + static_cast<long>(to), 0.0);
  }
  double worst(double from_s, double block_s) const {
    double worst = 0.0;
    for (std::size_t i = static_cast<std::size_t>(from_s / block_s); i < error.size(); ++i) {
      worst = std::max(worst, std::abs(error[i]));
    }
    return worst;
  }
};

Stamps run(const Wire& w, double seconds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> jitter(0.0, w.jitter);
  BlockStamper stamper;
  stamper.prepare(Hertz(w.told), w.frames, w.counts, w.unit);
  SampleBlock block;
  block.allocate(1, w.frames);
  Stamps out;
  double before = 0.0;
  for (int k = 0;; ++k) {
    const double nominal = (k + 1) * w.frames / w.real;
    const double taken = nominal + w.lost(nominal);
    if (taken > seconds) break;
    stamper.begin(block);
    block.frames = w.frames;
    block.lostFrames = w.tells(k);
    stamper.finish(block, Instant{} + toDuration(Seconds(1.0 + w.arrives(taken) + jitter(random))));
    const double first = sinceEpoch(block.firstSample).value - 1.0;
    if (block.has(kBlockGap) && out.gaps++ == 0) out.firstGap = taken;
    out.lost += block.lostFrames;
    out.error.push_back(first - (taken - w.frames / w.real));
    if (k > 0) out.step.push_back(first - before);
    before = first;
    ++out.blocks;
  }
  return out;
}

double stalled(double t, double from, double length) {
  return t > from && t < from + length ? from + length : t;
}

TEST(Arrivals, AStallThatEndsInABurstLosesNothing) {
  for (const bool counts : {false, true}) {
    for (const double stall : {0.4, 0.7, 0.9, 1.2, 1.8, 4.0}) {
      Wire w;
      w.counts = counts;
      w.arrives = [&](double t) { return stalled(t, 20.0, stall); };
      const Stamps s = run(w, 40.0);
      EXPECT_EQ(s.gaps, 0) << stall << counts;
      EXPECT_EQ(s.lost, 0U) << stall << counts;
      EXPECT_LT(s.worst(5.0, 0.01), 0.005) << stall << counts;
    }
  }
}

// A serial line of 1.25 times the rate needs four seconds to make up for one.
TEST(Arrivals, AWireThatCatchesUpSlowlyLosesNothing) {
  Wire w;
  w.arrives = [](double t) { return t > 20.0 ? std::max(t, 21.0 + (t - 20.0) / 1.25) : t; };
  const Stamps s = run(w, 60.0);
  EXPECT_EQ(s.gaps, 0);
  EXPECT_LT(s.worst(5.0, 0.01), 0.01);
}

TEST(Arrivals, AWrongRateIsFoundAndIsNoLoss) {
  for (const bool counts : {false, true}) {
    for (const double off : {-0.5, -0.3, -0.2, -0.1, -0.05, -0.03, -0.01, 0.0, 0.01, 0.03, 0.1, 0.25, 1.0}) {
      for (const double jitter : {0.001, 0.016}) {
        Wire w;
        w.counts = counts;
        w.real = w.told * (1.0 + off);
        w.jitter = jitter;
        const Stamps s = run(w, 30.0);
        EXPECT_LE(s.gaps, 2) << off << " " << jitter;  // where time is put right, and the rate known better
        const double block = 80 / w.real;
        const double soon = s.rate(w, 2.5, 4.5);
        EXPECT_EQ(std::abs(soon / w.told - 1.0) > 0.005, std::abs(off) > 0.005) << off << " " << jitter << " " << soon;
        EXPECT_NEAR(s.rate(w, 15.0, 29.0) / w.real, 1.0, 0.002) << off << " " << jitter;
        EXPECT_LT(s.worst(12.0, block), 0.03) << off << " " << jitter;
      }
    }
  }
}

TEST(Arrivals, ARateThatChangesIsFollowed) {
  for (const double off : {-0.025, -0.009, 0.009, 0.025}) {
    Wire w;
    w.lost = [&](double t) { return t > 60.0 ? (t - 60.0) * (1.0 / (1.0 + off) - 1.0) : 0.0; };
    const Stamps s = run(w, 120.0);
    EXPECT_LE(s.gaps, 2) << off;
    EXPECT_NEAR(s.rate(w, 100.0, 115.0) / (w.told * (1.0 + off)), 1.0, 0.001) << off;
  }
}

TEST(Arrivals, ASilentLossIsAGapOfItsLengthAndFoundOnce) {
  for (const double loss : {0.1, 0.36, 0.72, 2.0}) {
    for (const double stall : {0.0, 0.8}) {
      Wire w;
      w.lost = [&](double t) { return t > 20.0 ? loss : 0.0; };
      w.arrives = [&](double t) { return stalled(t, 20.0, std::max(loss, stall)); };
      const Stamps s = run(w, 60.0);
      EXPECT_EQ(s.gaps, 1) << loss << " " << stall;
      EXPECT_NEAR(static_cast<double>(s.lost), loss * 8000.0, 80.0) << loss << " " << stall;
      EXPECT_LT(s.firstGap, 20.0 + loss + 2.0) << loss << " " << stall;
      EXPECT_LT(s.worst(30.0, 0.01), 0.01) << loss << " " << stall;
    }
  }
}

// A counter of eight bits tells a loss but for multiples of 256; time tells how many of those.
TEST(Arrivals, ALossThatACounterCannotTellIsAMultipleOfItsRange) {
  Wire w;
  w.unit = 256;
  w.lost = [](double t) { return t > 20.0 ? 8.0 * 256.0 / 8000.0 : 0.0; };
  const Stamps s = run(w, 40.0);
  EXPECT_EQ(s.gaps, 1);
  EXPECT_EQ(s.lost, 2048U);
}

TEST(Arrivals, WhatIsToldIsBelievedAsFarAsTimeHasRoom) {
  for (const bool counts : {false, true}) {
    Wire w;
    w.counts = counts;
    w.lost = [](double t) { return t > 20.0 ? 0.5 : 0.0; };
    w.tells = [](int k) { return k == 2000 ? 4000U : k == 1000 || k == 3000 ? 480'000U : 0U; };
    const Stamps s = run(w, 60.0);
    EXPECT_EQ(s.gaps, 3);
    EXPECT_EQ(s.lost, 4000U);  // the leaps are gaps of unknown length
    EXPECT_LT(s.worst(3.0, 0.01), 0.01);
    EXPECT_GT(*std::min_element(s.step.begin(), s.step.end()), 0.005);
  }
}

// What came before a leap of the device's own time binds nothing after it: samples are never stamped at one moment.
TEST(Arrivals, ACutAfterWhichBlocksComeEarlierThanThoughtDoesNotStopTime) {
  BlockStamper stamper;
  stamper.prepare(Hertz(8000.0), 80, false);
  SampleBlock block;
  block.allocate(1, 80);
  double at = 0.0;
  Instant before{};
  int still = 0;
  for (int k = 0; k < 3000; ++k) {
    at += 0.01;
    if (k % 500 == 100) {
      at += 0.2;
      stamper.anew();
    }
    stamper.begin(block);
    block.frames = 80;
    stamper.finish(block, Instant{} + toDuration(Seconds(1.0 + at + (k % 500 == 100 ? 0.3 : 0.0))));
    still += k > 0 && block.firstSample <= before ? 1 : 0;
    before = block.firstSample;
  }
  EXPECT_LT(still, 6 * 35);  // no longer than the burst lasts
  EXPECT_NEAR(sinceEpoch(before).value, 1.0 + at - 0.01, 0.01);
}

}  // namespace
}  // namespace stillcut::daq
