// A structure with one mode along each axis is hit along x; two accelerometers hear it.
#include "core/daq/axis_knock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stillcut::daq {
namespace {

constexpr double kRate = 25600.0;

using Samples = std::vector<std::vector<float>>;

// What is hit rings along x at 700 Hz at once, and hands its energy over to y within some tens of milliseconds.
Samples knocks(int count, double cross, double noise = 0.01, double seconds = 4.0) {
  const auto length = static_cast<std::size_t>(seconds * kRate);
  Samples heard(2, std::vector<float>(length));
  std::mt19937_64 random(7);
  std::normal_distribution<> quiet(0.0, noise);
  for (std::size_t n = 0; n < length; ++n) {
    for (auto& channel : heard) channel[n] = static_cast<float>(quiet(random));
  }
  for (int k = 0; k < count; ++k) {
    const auto from = static_cast<std::size_t>((0.5 + 0.8 * k) * kRate);
    for (std::size_t n = from; n < length; ++n) {
      const double t = static_cast<double>(n - from) / kRate;
      const double ring = std::exp(-t / 0.05) * std::sin(2.0 * M_PI * 700.0 * t);
      const double handed = 4.0 * (1.0 - std::exp(-t / 0.03)) * std::exp(-t / 0.05) * std::sin(2.0 * M_PI * 650.0 * t);
      heard[0][n] += static_cast<float>(ring);
      heard[1][n] += static_cast<float>(cross * ring + handed);
    }
  }
  return heard;
}

std::vector<ChannelInfo> named(const char* first, const char* second) {
  ChannelInfo a, b;
  a.name = "front";
  a.axis = first;
  b.name = "side";
  b.axis = second;
  return {a, b};
}

std::string lineOf(const Samples& samples, const std::vector<ChannelInfo>& channels, std::size_t told = 0) {
  const auto heard = analyseKnocks(samples, Hertz(kRate), channels, told);
  return heard ? "" : heard.error().line();
}

TEST(AxisKnock, TheSensorThatMovesFirstLiesAlongTheBlow) {
  const auto channels = named("x", "y");
  const auto heard = analyseKnocks(knocks(4, 0.1), Hertz(kRate), channels, 0);
  ASSERT_TRUE(heard.ok()) << heard.error().line();
  EXPECT_EQ(heard->knocks, 4);
  EXPECT_EQ(heard->loudest, 0U);
  EXPECT_NE(text(knockSentence(*heard, channels)).find("4 knocks along x: 'front' measured most"), std::string::npos);
  std::vector<ChannelInfo> now = channels;
  applyKnocks(*heard, now);
  EXPECT_EQ(now[0].axis, "x");
}

TEST(AxisKnock, ExchangedAxesAreFoundAndSetRight) {
  auto channels = named("y", "x");
  const auto heard =
      analyseKnocks(knocks(3, 0.1), Hertz(kRate), channels, 1);  // the blows are along x: "side", it says
  ASSERT_TRUE(heard.ok()) << heard.error().line();
  EXPECT_EQ(heard->loudest, 0U);
  EXPECT_GT(heard->lead, 6.0);
  EXPECT_NE(text(knockSentence(*heard, channels)).find("'side' and 'front' are exchanged"), std::string::npos);
  applyKnocks(*heard, channels);
  EXPECT_EQ(channels[0].axis, "x");
  EXPECT_EQ(channels[1].axis, "y");
}

TEST(AxisKnock, WhatAnInputMakesOfAUnitDoesNotCount) {
  auto channels = named("x", "y");
  channels[1].scale = 0.02;
  Samples samples = knocks(3, 0.1);
  for (float& v : samples[1]) v = v * 50.0F + 3.0F;  // more sensitive, and off its zero
  const auto heard = analyseKnocks(samples, Hertz(kRate), channels, 0);
  ASSERT_TRUE(heard.ok()) << heard.error().line();
  EXPECT_EQ(heard->loudest, 0U);
}

TEST(AxisKnock, SaysWhyItCannotTell) {
  EXPECT_NE(lineOf(knocks(0, 0.1), named("x", "y")).find("none was measured"), std::string::npos);
  EXPECT_NE(lineOf(knocks(3, 0.9), named("x", "y")).find("of each other"), std::string::npos);
  EXPECT_NE(lineOf(knocks(1, 0.1, 0.01, 1.0), named("x", "y")).find("too short"), std::string::npos);
  EXPECT_NE(lineOf(knocks(3, 0.1), named("", "y")).find("has no axis"), std::string::npos);
  auto apart = named("x", "y");
  apart[1].place = "table";
  EXPECT_NE(lineOf(knocks(3, 0.1), apart).find("no other axis beside it"), std::string::npos);
  EXPECT_NE(lineOf(knocks(3, 0.1), named("x", "y"), 5).find("has no axis"), std::string::npos);
}

}  // namespace
}  // namespace stillcut::daq
