// The least and greatest of any stretch are those of its samples.
#include "core/model/wave_pyramid.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace stillcut {
namespace {

WaveExtent ofCells(const std::vector<float>& samples, std::int64_t from, std::int64_t to) {
  WaveExtent extent;
  const auto end = std::min<std::int64_t>((to + WavePyramid::kCell - 1) / WavePyramid::kCell * WavePyramid::kCell,
                                          static_cast<std::int64_t>(samples.size()));
  for (std::int64_t k = from / WavePyramid::kCell * WavePyramid::kCell; k < end; ++k)
    extent.take(samples[static_cast<std::size_t>(k)]);
  return extent;
}

TEST(WavePyramid, AnyStretchIsWhatItsSamplesAre) {
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  std::vector<float> samples(123'457);
  for (float& v : samples) v = normal(random);
  WavePyramid wave;
  for (std::size_t at = 0; at < samples.size();) {
    const std::size_t count = std::min<std::size_t>(1 + random() % 5000, samples.size() - at);
    wave.add(std::span(samples).subspan(at, count));
    at += count;
  }
  ASSERT_EQ(wave.samples(), static_cast<std::int64_t>(samples.size()));
  for (int k = 0; k < 2000; ++k) {
    const auto from = static_cast<std::int64_t>(random() % samples.size());
    const auto to = from + 1 + static_cast<std::int64_t>(random() % (samples.size() - static_cast<std::size_t>(from)));
    const WaveExtent is = wave.over(from, to), right = ofCells(samples, from, to);
    ASSERT_EQ(is.low, right.low) << from << " .. " << to;
    ASSERT_EQ(is.high, right.high) << from << " .. " << to;
  }
}

TEST(WavePyramid, WhatIsMissingIsInNoCell) {
  std::vector<float> samples(640, 1.0F);
  for (std::size_t k = 128; k < 256; ++k) samples[k] = std::numeric_limits<float>::quiet_NaN();
  WavePyramid wave;
  wave.add(samples);
  EXPECT_TRUE(wave.over(0, 128).present());
  EXPECT_FALSE(wave.over(128, 256).present());
  EXPECT_EQ(wave.over(0, 640).high, 1.0F);
  EXPECT_FALSE(wave.over(700, 900).present()) << "past the end";
}

}  // namespace
}  // namespace stillcut
