// Streams in a storm: whatever a serial line does to the bytes, what comes through a decoder was sent, in order, and
// what is missing is never hidden.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/daq/binary_frames.h"
#include "core/daq/text_lines.h"

namespace stillcut::daq {
namespace {

struct Instant3 {
  std::array<float, 3> values{};
  std::uint64_t lost = 0;
};

std::vector<Instant3> decode(StreamDecoder& decoder, std::string_view bytes, std::mt19937& random) {
  std::vector<Instant3> out;
  Instant3 one;
  while (!bytes.empty()) {
    const std::size_t n = decoder.feed(bytes.substr(0, 1 + random() % 300));
    bytes.remove_prefix(n);
    while (decoder.take(one.values, one.lost)) out.push_back(one);
    if (n == 0) break;
  }
  return out;
}

void put(std::string& bytes, std::uint32_t value, int size, bool big) {
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * (big ? size - 1 - i : i)));
}

// Instant k of channel c, as a float that no other instant has.
float sent(unsigned instant, int channel) {
  return static_cast<float>(instant) * 4.0F + static_cast<float>(channel);
}

std::string frame(const FrameFormat& f, unsigned number) {
  std::string covered;
  put(covered, number, f.counterBytes, f.bigEndian);
  for (int i = 0; i < f.instants; ++i) {
    for (int c = 0; c < f.channels; ++c) {
      const float value = sent(number * static_cast<unsigned>(f.instants) + static_cast<unsigned>(i), c);
      put(covered, std::bit_cast<std::uint32_t>(value), 4, f.bigEndian);
    }
  }
  std::string all = f.sync + covered;
  put(all, checksumOf(f.checksum, covered), checksumBytes(f.checksum), f.bigEndian);
  return all;
}

FrameFormat formatOf(unsigned trial) {
  FrameFormat f;
  f.sync = trial % 2 == 0 ? "\xAA\x55" : "SYNC";
  f.counterBytes = trial % 3 == 0 ? 4 : 2;
  f.instants = 1 + static_cast<int>(trial % 5);
  f.sample = SampleKind::F32;
  f.bigEndian = trial % 4 == 1;
  f.checksum = trial % 5 == 0 ? Checksum::Crc16 : Checksum::Crc32;
  f.channels = 3;
  return f;
}

// The number of the instant that was sent as these values; -1: nobody sent them.
long whichOf(const Instant3& one) {
  const double instant = (one.values[0]) / 4.0;
  const bool whole = instant >= 0.0 && instant == std::floor(instant) && instant < 1e6;
  for (int c = 0; c < 3; ++c) {
    if (!whole || one.values[static_cast<std::size_t>(c)] != sent(static_cast<unsigned>(instant), c)) return -1;
  }
  return static_cast<long>(instant);
}

TEST(BinaryStorm, NothingWrongComesThroughAndWhatIsMissingIsCounted) {
  for (unsigned trial = 0; trial < 40; ++trial) {
    std::mt19937 random(trial + 1);
    const FrameFormat f = formatOf(trial);
    std::string bytes;
    for (auto n = 0; n < 400; ++n) {
      std::string one = frame(f, n);
      switch (n > 2 && n < 397 ? random() % 25 : 99) {
        case 0:
          continue;  // lost
        case 1:
          one[random() % one.size()] ^= static_cast<char>(1U << (random() % 8));
          break;
        case 2:
          one.erase(random() % one.size(), 1 + random() % 5);
          break;
        case 3:
          one.insert(random() % one.size(), f.sync);
          break;
        case 4:
          one.resize(random() % one.size());
          break;
        default:
          break;
      }
      bytes += one;
    }
    BinaryFrames decoder(f);
    long expected = 0;
    std::size_t taken = 0;
    for (const Instant3& one : decode(decoder, bytes, random)) {
      const long instant = whichOf(one);
      ASSERT_GE(instant, 0) << "trial " << trial;
      ASSERT_EQ(instant, expected + static_cast<long>(one.lost)) << "trial " << trial;
      expected = instant + 1;
      ++taken;
    }
    EXPECT_EQ(expected, 400L * f.instants);
    EXPECT_GT(taken, 250U * static_cast<unsigned>(f.instants));
    EXPECT_LT(taken, 400U * static_cast<unsigned>(f.instants));
    EXPECT_GT(decoder.damaged(), 0U);
  }
}

TEST(BinaryStorm, NoiseAloneIsNoFrame) {
  std::mt19937 random(99);
  FrameFormat f = formatOf(1);
  BinaryFrames decoder(f);
  std::string noise(200000, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  EXPECT_TRUE(decode(decoder, noise, random).empty());
  // And the first whole frame after it is found.
  const std::string sound = frame(f, 7) + frame(f, 8);
  EXPECT_EQ(decode(decoder, sound, random).size(), 2U * static_cast<unsigned>(f.instants));
}

// Without a checksum the next sync word tells that a frame is whole: bytes that were dropped put nothing wrong among
// the samples, and without a counter each such place is a gap of unknown length.
TEST(BinaryStorm, WithoutAChecksumDroppedBytesAreGapsAndNoSamples) {
  std::mt19937 random(17);
  for (const int counterBytes : {0, 2}) {
    FrameFormat f = formatOf(0);
    f.checksum = Checksum::None;
    f.counterBytes = counterBytes;
    f.instants = 2;
    BinaryFrames decoder(f);
    std::string bytes;
    for (unsigned n = 0; n < 2000; ++n) {
      std::string one = frame(f, n);
      if (n % 100 == 50) one.erase(random() % one.size(), 1 + random() % 3);
      bytes += one;
    }
    long last = -1;
    int gaps = 0;
    for (const Instant3& one : decode(decoder, bytes, random)) {
      const long instant = whichOf(one);
      ASSERT_GT(instant, last);
      EXPECT_EQ(one.lost > 0, last >= 0 && instant != last + 1) << instant;
      gaps += one.lost > 0 ? 1 : 0;
      last = instant;
    }
    EXPECT_EQ(gaps, 20);
    EXPECT_EQ(decoder.damaged(), 20U);
  }
}

TEST(BinaryStorm, ResetForgetsHalfAFrameAndItsCounter) {
  std::mt19937 random(3);
  const FrameFormat f = formatOf(0);
  BinaryFrames decoder(f);
  decode(decoder, frame(f, 5) + frame(f, 6).substr(0, 9), random);
  decoder.reset();
  const auto after = decode(decoder, frame(f, 100), random);
  ASSERT_EQ(after.size(), static_cast<std::size_t>(f.instants));
  EXPECT_EQ(after.front().lost, 0U);
}

TEST(BinaryStorm, ACounterThatWrapsLosesNothingAndOneThatGoesBackSaysSo) {
  std::mt19937 random(4);
  FrameFormat f = formatOf(1);
  f.counterBytes = 2;
  f.instants = 1;
  BinaryFrames decoder(f);
  std::string bytes;
  for (auto n = 65530; n < 65543; ++n) bytes += frame(f, n);
  for (const Instant3& one : decode(decoder, bytes, random)) EXPECT_EQ(one.lost, 0U);
  const auto restarted = decode(decoder, frame(f, 0) + frame(f, 1), random);
  ASSERT_EQ(restarted.size(), 2U);
  EXPECT_EQ(restarted[0].lost, StreamDecoder::kUnknown);
  EXPECT_EQ(restarted[1].lost, 0U);
}

std::string line(unsigned number, bool counted, char between) {
  std::string text = counted ? std::to_string(number) + between : "";
  for (int c = 0; c < 3; ++c) {
    text += std::to_string(static_cast<int>(sent(number, c)));
    text += c < 2 ? std::string(1, between) : "";
  }
  return text + "\n";
}

TEST(TextStorm, CountedLinesComeInOrderAndGapsHaveTheirLength) {
  for (unsigned trial = 0; trial < 40; ++trial) {
    std::mt19937 random(trial + 100);
    const char between = ",;\t "[trial % 4];
    std::string bytes = "rest of a line\n";
    for (auto n = 0; n < 500; ++n) {
      std::string one = line(n, true, between);
      switch (n > 2 && n < 497 ? random() % 25 : 99) {
        case 0:
          continue;
        case 1:
          one.insert(one.find(between), "x");
          break;
        case 2:
          one = one.substr(0, one.rfind(between)) + "\n";  // the last value is missing
          break;
        case 3:
          one.insert(one.size() - 1, std::string(1, between) + "8");
          break;
        default:
          break;
      }
      bytes += one;
    }
    TextLines decoder(3, true);
    long expected = 0;
    for (const Instant3& one : decode(decoder, bytes, random)) {
      const long instant = whichOf(one);
      ASSERT_EQ(instant, expected + static_cast<long>(one.lost)) << trial;
      expected = instant + 1;
    }
    EXPECT_EQ(expected, 500L);
    EXPECT_GT(decoder.damaged(), 0U);
  }
}

TEST(TextStorm, WithoutACounterADamagedLineIsOneInstant) {
  std::mt19937 random(6);
  TextLines decoder(3, false);
  const auto out = decode(decoder, "\n1,2,3\n4,5\nbroken\n7,8,9\n", random);
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[1].lost, 2U);
  EXPECT_EQ(decoder.damaged(), 2U);
}

TEST(TextStorm, WhatIsNoFiniteNumberIsDamage) {
  std::mt19937 random(7);
  for (const char* bad : {"nan,1,2", "1,inf,2", "1,2,1e99", "1,2,0x3", "1,2,--3", "1 2", "1,2,3,4", "a,b,c"}) {
    TextLines decoder(3, false);
    const auto out = decode(decoder, "\n" + std::string(bad) + "\n1,2,3\n", random);
    ASSERT_EQ(out.size(), 1U) << bad;
    EXPECT_EQ(out[0].lost, 1U) << bad;
    EXPECT_EQ(out[0].values, (std::array<float, 3>{1, 2, 3}));
  }
}

TEST(TextStorm, ALineWithoutEndDoesNotFillTheMemory) {
  std::mt19937 random(8);
  TextLines decoder(3, false);
  EXPECT_TRUE(decode(decoder, "\n" + std::string(100000, '1'), random).empty());
  const auto out = decode(decoder, "\n1,2,3\n", random);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].values[2], 3.0F);
}

}  // namespace
}  // namespace stillcut::daq
