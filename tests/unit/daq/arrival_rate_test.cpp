// From arrivals to verdicts: as long as it has not shown whether a device's rate is the told one, nothing is believed,
// and a wrong one never is. Time is computed, none passes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/daq/block_stamper.h"
#include "core/sensing/conditioner.h"

namespace stillcut {
namespace {

constexpr double kTold = 8000.0;
constexpr int kFrames = 80;

struct Heard {
  double firstValid = -1.0;  // s since the first block
  double named = -1.0;       // s until the rate is said to be wrong
  double valid = 0.0;        // s of blocks that were believed
};

// What a device of `real` samples a second delivers, told as 8000, through a transport that is up to `jitter` s late.
Heard hear(double real, double jitter, double seconds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> late(0.0, jitter);
  std::normal_distribution<float> noise(0.0F, 1.0F);
  CutSetup setup;
  setup.rate = Hertz(kTold);
  setup.blockFrames = kFrames;
  setup.teeth = 4;
  setup.nominalSpeed = Rpm(6000.0);
  setup.channels = {{"x", SensorQuantity::Acceleration, 1.0, "x"}};
  detect::Conditioner conditioner;
  conditioner.prepare(setup, {});
  daq::BlockStamper stamper;
  stamper.prepare(setup.rate, kFrames, false);
  SampleBlock block;
  block.allocate(1, kFrames);
  Heard heard;
  for (int k = 1; k * kFrames / real < seconds; ++k) {
    const double at = k * kFrames / real;
    stamper.begin(block);
    block.frames = kFrames;
    for (float& v : block.channel(0)) v = noise(random);
    stamper.finish(block, Instant{} + toDuration(Seconds(1.0 + at + late(random))));
    const detect::ConditionedBlock& conditioned = conditioner.process(block, {});
    if (conditioned.valid && heard.firstValid < 0.0) heard.firstValid = at;
    if (conditioned.valid) heard.valid += kFrames / real;
    if (conditioned.reason.code == ReasonCode::InputRate && heard.named < 0.0) heard.named = at;
  }
  return heard;
}

TEST(ArrivalRate, AWrongRateIsNeverBelievedAndNamedWithinSeconds) {
  for (const double off : {-0.9, -0.5, -0.3, -0.1, -0.05, 0.05, 0.1, 0.25, 1.0, 3.0}) {
    for (const double jitter : {0.0, 0.001, 0.016}) {
      const Heard heard = hear(kTold * (1.0 + off), jitter, 20.0);
      EXPECT_EQ(heard.valid, 0.0) << off << " " << jitter << " from " << heard.firstValid << " named " << heard.named;
      EXPECT_GT(heard.named, 0.0) << off << " " << jitter;
      EXPECT_LT(heard.named, 3.0 + 1.0 / (1.0 + off)) << off << " " << jitter;  // a second of samples, and three
    }
  }
}

TEST(ArrivalRate, TheToldRateIsBelievedWithinTwoSeconds) {
  for (const double jitter : {0.0, 0.001, 0.016}) {
    const Heard heard = hear(kTold * 1.0001, jitter, 20.0);
    EXPECT_EQ(heard.named, -1.0) << jitter;
    EXPECT_GT(heard.firstValid, 0.9) << jitter;  // by when it shows
    EXPECT_LT(heard.firstValid, 2.0) << jitter;
    EXPECT_GT(heard.valid, 18.0) << jitter;
  }
}

}  // namespace
}  // namespace stillcut
