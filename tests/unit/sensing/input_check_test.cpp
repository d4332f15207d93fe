// What one block shows: finite, not dead by what it measures, not cut flat by a limit.
#include "core/sensing/input_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace stillcut::detect {
namespace {

constexpr double kRate = 48000.0;
using Value = std::function<double(double t)>;

CutSetup measuring(const std::vector<SensorQuantity>& quantities) {
  CutSetup setup;
  setup.rate = Hertz(kRate);
  for (const SensorQuantity q : quantities) {
    setup.channels.emplace_back();
    setup.channels.back().quantity = q;
  }
  return setup;
}

// The first fault of a channel, or that a limit is reached.
ReasonCode said(const InputCheck& check, int channels) {
  for (int c = 0; c < channels; ++c) {
    if (check.fault(c).code != ReasonCode::None) return check.fault(c).code;
  }
  return check.clipped() ? ReasonCode::InputClipped : ReasonCode::None;
}

// What is said of the blocks of 5 ms that end after `from`, all of which have to be alike.
ReasonCode said(const CutSetup& setup, const std::vector<Value>& values, double seconds, double from) {
  InputCheck check;
  check.prepare(setup);
  SampleBlock block;
  block.allocate(static_cast<int>(values.size()), 240);
  block.frames = 240;
  std::vector<ReasonCode> codes;
  for (int n = 0; n < static_cast<int>(seconds * kRate); n += block.frames) {
    for (std::size_t c = 0; c < values.size(); ++c) {
      std::span<float> x = block.channel(static_cast<int>(c));
      for (std::size_t f = 0; f < x.size(); ++f) {
        x[f] = static_cast<float>(values[c]((n + static_cast<int>(f)) / kRate));
      }
    }
    check.look(block);
    const ReasonCode code = said(check, static_cast<int>(values.size()));
    if ((n + block.frames) / kRate > from) codes.push_back(code);
  }
  EXPECT_EQ(std::count(codes.begin(), codes.end(), codes.front()), static_cast<long>(codes.size()));
  return codes.front();
}

ReasonCode clipSaid(const Value& value, double from = 0.5) {
  return said(measuring({SensorQuantity::Acceleration}), {value}, 1.0, from);
}

Value tone(double hertz, double amplitude) {
  return [=](double t) { return amplitude * std::sin(2.0 * std::numbers::pi * hertz * t); };
}

Value noisy(Value value, double rms) {
  return [value = std::move(value), engine = std::mt19937(1),
          normal = std::normal_distribution<double>(0.0, rms)](double t) mutable { return value(t) + normal(engine); };
}

// A converter of so many steps from -1 to 1.
Value converted(Value value, double steps) {
  return [=](double t) { return std::round(std::clamp(value(t), -1.0, 1.0) * steps / 2.0) / (steps / 2.0); };
}

Value still(double at) {
  return [at](double) { return at; };
}

TEST(InputCheck, WhatIsFiniteAndMovesPasses) {
  EXPECT_EQ(clipSaid(tone(900.0, 0.7), 0.0), ReasonCode::None);
}

TEST(InputCheck, WhatIsNotFiniteIsRefused) {
  EXPECT_EQ(clipSaid(still(std::numeric_limits<double>::quiet_NaN()), 0.0), ReasonCode::InputNotFinite);
}

// Finite in a float, and its square fills every filter behind it.
TEST(InputCheck, WhatNoSensorHasIsRefusedAndTheGreatestCountIsNot) {
  EXPECT_EQ(clipSaid(tone(900.0, 3e38), 0.0), ReasonCode::InputAbsurd);
  EXPECT_EQ(clipSaid(tone(900.0, 2147483647.0), 0.0), ReasonCode::None);
}

TEST(InputCheck, ASensorOfWhatChangesIsDeadWhenItStandsStill) {
  for (const auto q : {SensorQuantity::Acceleration, SensorQuantity::Velocity, SensorQuantity::Sound}) {
    EXPECT_EQ(said(measuring({q}), {still(0.25)}, 0.5, 0.1), ReasonCode::InputDead);
    EXPECT_EQ(said(measuring({q, q}), {tone(900.0, 0.5), still(0.0)}, 0.5, 0.1), ReasonCode::InputDead);
  }
}

TEST(InputCheck, AForceACurrentOrASpeedMayRestBesideWhatMoves) {
  const auto kFirst = SensorQuantity::Acceleration;
  for (const auto q :
       {SensorQuantity::Displacement, SensorQuantity::Force, SensorQuantity::Current, SensorQuantity::SpindleSpeed}) {
    EXPECT_EQ(said(measuring({kFirst, q}), {tone(900.0, 0.5), still(6000.0)}, 0.5, 0.0), ReasonCode::None);
    EXPECT_EQ(said(measuring({kFirst, q}), {still(0.1), still(6000.0)}, 0.5, 0.1), ReasonCode::InputDead);
    EXPECT_EQ(said(measuring({q}), {still(3.0)}, 0.5, 0.1), ReasonCode::InputDead) << "nothing is heard";
  }
  // A speed that moves beside a dead force is no proof of life.
  EXPECT_EQ(
      said(measuring({SensorQuantity::Force, SensorQuantity::SpindleSpeed}), {still(3.0), tone(9.0, 60.0)}, 0.5, 0.1),
      ReasonCode::InputDead);
}

// Told a thousand times a second, the highest speed over and over: no converter at its limit.
TEST(InputCheck, AToldSpeedIsNotClipped) {
  const Value told = [](double t) { return 6000.0 - (std::lround(t * 1000.0) % 3 == 0 ? 5.0 : 0.0); };
  EXPECT_EQ(
      said(measuring({SensorQuantity::Acceleration, SensorQuantity::SpindleSpeed}), {tone(900.0, 0.5), told}, 0.5, 0.0),
      ReasonCode::None);
}

TEST(InputCheck, AToneCutFlatIsClippedHighOrLow) {
  for (const double hertz : {100.0, 1000.0, 3000.0, 5200.0}) {
    EXPECT_EQ(clipSaid(converted(noisy(tone(hertz, 2.0), 1e-3), 65536.0)), ReasonCode::InputClipped) << hertz;
  }
  EXPECT_EQ(clipSaid(converted(noisy(tone(1000.0, 1.2), 1e-3), 65536.0)), ReasonCode::InputClipped);
}

// An amplifier's limit within the converter's, on one side: after a shock that went beyond it, too.
TEST(InputCheck, ALimitBelowTheLargestEverHeardIsFound) {
  const Value cut = [](double t) { return std::min(0.7, std::sin(2.0 * std::numbers::pi * 1000.0 * t)); };
  EXPECT_EQ(clipSaid(cut), ReasonCode::InputClipped);
  const Value popped = [cut](double t) { return std::abs(t - 0.2) < 2e-5 ? 0.95 : cut(t); };
  EXPECT_EQ(clipSaid(popped), ReasonCode::InputClipped);
}

TEST(InputCheck, NaturalPeaksAreNotClippedHoweverCoarseTheConverter) {
  for (const double steps : {20.0, 64.0, 4096.0, 65536.0}) {
    for (const double hertz : {7.0, 100.0, 1000.0, 8000.0, 12000.0}) {  // the last at a quarter of the rate
      EXPECT_EQ(clipSaid(converted(tone(hertz, 0.71), steps), 0.0), ReasonCode::None) << steps << " " << hertz;
      EXPECT_EQ(clipSaid(converted(noisy(tone(hertz, 0.5), 0.1), steps), 0.0), ReasonCode::None)
          << steps << " " << hertz;
    }
  }
  // Air on a coarse converter whose zero is off: the last bit flips.
  EXPECT_EQ(clipSaid(converted(noisy(still(0.31), 0.01), 64.0), 0.0), ReasonCode::None);
}

// Forces of a tooth now and then, without noise, and nothing in between.
TEST(InputCheck, RestBetweenPulsesIsNoLimit) {
  const Value teeth = [](double t) {
    const double phase = std::fmod(t * 400.0, 1.0);
    return phase < 0.3 ? -0.02 + 0.8 * (0.4 + phase) : -0.02;
  };
  EXPECT_EQ(said(measuring({SensorQuantity::Force}), {teeth}, 0.5, 0.0), ReasonCode::None);
}

TEST(InputCheck, AGainTurnedUpMovesTheLimit) {
  // Cut flat at 0.5; from then on it reaches 0.9 uncut.
  const Value turned = noisy(tone(1000.0, 0.9), 1e-3);
  const Value both = [turned](double t) { return t < 0.4 ? std::clamp(turned(t), -0.5, 0.5) : turned(t); };
  EXPECT_EQ(clipSaid(both, 0.45), ReasonCode::None);
}

TEST(InputCheck, WhatTheDriverSawAtItsLimitIsClipped) {
  InputCheck check;
  check.prepare(measuring({SensorQuantity::Sound}));
  SampleBlock block;
  block.allocate(1, 100);
  block.frames = 100;
  for (std::size_t k = 0; k < 100; ++k) block.channel(0)[k] = std::sin(0.3F * static_cast<float>(k));
  block.flags = kBlockClipped;
  check.look(block);
  EXPECT_TRUE(check.clipped());
}

TEST(InputCheck, AFaultIsOfItsChannelAndAllAreBadWhereNoneMeasuresTheCut) {
  InputCheck check;
  check.prepare(measuring({SensorQuantity::Sound, SensorQuantity::Sound, SensorQuantity::SpindleSpeed}));
  SampleBlock block;
  block.allocate(3, 100);
  block.frames = 100;
  for (std::size_t k = 0; k < 100; ++k) {
    for (const int c : {0, 1, 2}) block.channel(c)[k] = std::sin(0.3F * static_cast<float>(k));
  }
  block.channel(1)[7] = std::numeric_limits<float>::infinity();
  check.look(block);
  EXPECT_EQ(check.fault(0).code, ReasonCode::None);
  EXPECT_EQ(check.fault(1).code, ReasonCode::InputNotFinite);
  EXPECT_FALSE(check.allBad());
  block.channel(0)[7] = std::numeric_limits<float>::infinity();
  check.look(block);
  EXPECT_TRUE(check.allBad()) << "a speed is no vibration";
}

}  // namespace
}  // namespace stillcut::detect
