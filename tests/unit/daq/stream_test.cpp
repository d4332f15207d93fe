// Bytes of a scripted wire: split anywhere, lost, damaged, cut off and taken up again.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/daq/binary_frames.h"
#include "core/daq/registry.h"
#include "core/daq/sample_clock.h"
#include "core/daq/stream_source.h"
#include "core/daq/text_lines.h"
#include "core/model/device_flags.h"

namespace stillcut::daq {
namespace {

// Time stands still but for waits: each takes its whole length.
class ScriptedWire final : public ByteChannel {
 public:
  explicit ScriptedWire(ManualClock& clock) : clock_(clock) {}
  std::string_view address() const noexcept override { return "script"; }
  void connect() noexcept override {
    ++connects;
    open_ = there;
  }
  WireState state() noexcept override { return open_ ? WireState::Open : WireState::Closed; }
  std::size_t read(std::span<char> into) noexcept override {
    if (!open_ || !next) return 0;
    const std::string bytes = next(into.size());
    std::copy(bytes.begin(), bytes.end(), into.begin());
    return bytes.size();
  }
  bool write(std::string_view) noexcept override { return open_; }
  void wait(Duration atMost) noexcept override { clock_.set(clock_.now() + atMost); }
  void close() noexcept override { open_ = false; }
  void unplug() { open_ = there = false; }

  bool there = true;
  int connects = 0;
  std::function<std::string(std::size_t)> next;

 private:
  ManualClock& clock_;
  bool open_ = false;
};

FrameFormat twoChannels() {
  FrameFormat f;
  f.sync = "\xAA\x55";
  f.counterBytes = 2;
  f.instants = 4;
  f.checksum = Checksum::Crc16;
  f.channels = 2;
  return f;
}

// Frame `number`: channel 0 counts instants, channel 1 the same below zero.
std::string frame(const FrameFormat& f, unsigned number) {
  std::string covered;
  const auto put = [&](unsigned value, int bytes) {
    for (int i = 0; i < bytes; ++i) covered += static_cast<char>(value >> (8 * (f.bigEndian ? bytes - 1 - i : i)));
  };
  put(number, f.counterBytes);
  for (int i = 0; i < f.instants; ++i) {
    const unsigned instant = number * static_cast<unsigned>(f.instants) + static_cast<unsigned>(i);
    put(instant & 0x7FFF, 2);
    put(0U - (instant & 0x7FFF), 2);
  }
  const std::uint32_t sum = checksumOf(f.checksum, covered);
  put(sum, checksumBytes(f.checksum));
  return f.sync + covered;
}

struct Taken {
  std::vector<float> first, second;
  std::uint64_t lost = 0;
};

Taken decode(StreamDecoder& decoder, std::string_view bytes, std::size_t pieces) {
  Taken out;
  std::array<float, 2> values{};
  std::uint64_t lost = 0;
  const auto drain = [&] {
    while (decoder.take(values, lost)) {
      out.first.push_back(values[0]);
      out.second.push_back(values[1]);
      out.lost += lost;
    }
  };
  while (!bytes.empty()) {
    const std::size_t taken = decoder.feed(bytes.substr(0, pieces));
    bytes.remove_prefix(taken);
    drain();
  }
  return out;
}

TEST(BinaryFrames, ArriveWholeHoweverTheyAreSplit) {
  for (const bool big : {false, true}) {
    FrameFormat f = twoChannels();
    f.bigEndian = big;
    std::string bytes = "rest of a frame";
    for (unsigned n = 0; n < 300; ++n) bytes += frame(f, n);
    for (const std::size_t pieces : {1UL, 7UL, 4096UL}) {
      BinaryFrames decoder(f);
      const Taken taken = decode(decoder, bytes, pieces);
      ASSERT_EQ(taken.first.size(), 1200U);
      EXPECT_EQ(taken.lost, 0U);
      for (std::size_t k = 0; k < taken.first.size(); ++k) {
        ASSERT_EQ(taken.first[k], static_cast<float>(k));
        ASSERT_EQ(taken.second[k], -static_cast<float>(k));
      }
    }
  }
}

TEST(BinaryFrames, LossAndDamageAreCountedAndNothingWrongComesThrough) {
  const FrameFormat f = twoChannels();
  std::string bytes;
  for (unsigned n = 0; n < 100; ++n) {
    std::string one = frame(f, n);
    if (n == 20 || n == 21) continue;            // lost
    if (n == 40) one[6] ^= 0x10;                 // damaged
    if (n == 60) one.erase(5, 3);                // bytes lost inside
    if (n == 80) one.insert(3, "\xAA\x55\x01");  // bytes too many, a sync word among them
    bytes += one;
  }
  BinaryFrames decoder(f);
  const Taken taken = decode(decoder, bytes, 64);
  EXPECT_EQ(taken.first.size(), 4U * 95U);
  EXPECT_EQ(taken.lost, 4U * 5U);
  EXPECT_EQ(decoder.damaged(), 3U);
  for (std::size_t k = 0; k < taken.first.size(); ++k) ASSERT_EQ(taken.second[k], -taken.first[k]);
}

TEST(BinaryFrames, KnowEverySampleAndChecksum) {
  EXPECT_EQ(checksumOf(Checksum::Crc16, "123456789"), 0x29B1U);      // CRC-16/CCITT-FALSE
  EXPECT_EQ(checksumOf(Checksum::Crc32, "123456789"), 0xCBF43926U);  // CRC-32/ISO-HDLC
  EXPECT_EQ(checksumOf(Checksum::Sum8, "\xFF\x02"), 1U);
  EXPECT_EQ(checksumOf(Checksum::Xor8, "\xFF\x02"), 0xFDU);
  const std::pair<SampleKind, std::string> minusTwo[] = {{SampleKind::I8, "\xFE"},
                                                         {SampleKind::I16, "\xFE\xFF"},
                                                         {SampleKind::I24, "\xFE\xFF\xFF"},
                                                         {SampleKind::I32, "\xFE\xFF\xFF\xFF"},
                                                         {SampleKind::F32, std::string("\0\0\0\xC0", 4)}};
  for (const auto& [kind, bytes] : minusTwo) {
    FrameFormat f;
    f.sync = "S";
    f.sample = kind;
    BinaryFrames decoder(f);
    float value = 0.0F;
    std::uint64_t lost = 0;
    decoder.feed("S" + bytes + "S");
    ASSERT_TRUE(decoder.take({&value, 1}, lost));
    EXPECT_EQ(value, -2.0F) << static_cast<int>(kind);
  }
}

TEST(TextLines, TakeNumbersHoweverTheyAreParted) {
  TextLines lines(2, false);
  const Taken taken = decode(lines, "half,\n1,2\r\n 3.5;-4\n\n+1e1\t 2 \nbroken,1\n7,8,9\n5 6\n", 5);
  EXPECT_EQ(taken.first, (std::vector<float>{1.0F, 3.5F, 10.0F, 5.0F}));
  EXPECT_EQ(taken.second, (std::vector<float>{2.0F, -4.0F, 2.0F, 6.0F}));
  EXPECT_EQ(taken.lost, 2U);
  EXPECT_EQ(lines.damaged(), 2U);
  TextLines counted(2, true);
  EXPECT_EQ(decode(counted, "\n1 1 1\n2 1 1\n6 1 1\nx 1 1\n8 1 1\n", 64).lost, 4U);
}

class StreamSourceTest : public ::testing::Test {
 protected:
  StreamSourceTest() { block_.allocate(2, 40); }
  std::unique_ptr<StreamSource> make(std::function<std::string(std::size_t)> next) {
    auto wire = std::make_unique<ScriptedWire>(clock_);
    wire_ = wire.get();
    wire_->next = std::move(next);
    SourceFormat format;
    format.rate = Hertz(4000.0);
    format.blockFrames = 40;
    format.channels.resize(2);
    return std::make_unique<StreamSource>("source 'serial'", format, std::move(wire),
                                          std::make_unique<BinaryFrames>(twoChannels()), clock_);
  }
  // A device that sends ten frames of four instants in ten milliseconds.
  std::function<std::string(std::size_t)> device() {
    return [this](std::size_t) {
      std::string bytes;
      for (int i = 0; i < 10; ++i) bytes += frame(twoChannels(), number_++);
      clock_.set(clock_.now() + std::chrono::milliseconds(10));
      return bytes;
    };
  }
  ManualClock clock_;
  ScriptedWire* wire_ = nullptr;
  unsigned number_ = 0;
  SampleBlock block_;
};

TEST_F(StreamSourceTest, DeliversEverySampleOnceWithTimesOfTheClock) {
  auto source = make(device());
  ASSERT_TRUE(source->open());
  EXPECT_TRUE(source->live());
  float expected = -1.0F;
  Instant before{};
  for (std::uint64_t k = 0; k < 200; ++k) {
    ASSERT_TRUE(source->read(block_));
    EXPECT_EQ(block_.sequence, k);
    EXPECT_EQ(block_.flags & ~kBlockRateUnverified, 0U);
    ASSERT_EQ(block_.frames, 40);
    if (k == 0) expected = block_.channel(0)[0];
    for (const float v : block_.channel(0)) ASSERT_EQ(v, expected++);
    if (k > 0) {
      EXPECT_NEAR(secondsBetween(before, block_.firstSample).value, 0.01, 1e-4);
    }
    before = block_.firstSample;
  }
  source->stop();
  EXPECT_FALSE(source->read(block_));
  EXPECT_TRUE(source->fault().empty());
}

// Many boards start anew when their port is opened, and say nothing until they have: the wire is opened once.
TEST_F(StreamSourceTest, WaitsForABoardThatStartsWhenItIsOpened) {
  for (const double boot : {0.0, 2.6, 5.0}) {
    auto device = this->device();
    const Instant plugged = clock_.now();
    auto source = make([this, device, plugged, boot](std::size_t n) {
      return secondsBetween(plugged, clock_.now()).value < boot ? std::string() : device(n);
    });
    EXPECT_TRUE(source->open()) << boot;
    clock_.set(clock_.now() + std::chrono::milliseconds(300));
    for (int k = 0; k < 50; ++k) {
      ASSERT_TRUE(source->read(block_));
      EXPECT_EQ(block_.flags & ~kBlockRateUnverified, 0U);
    }
    EXPECT_EQ(wire_->connects, 1) << boot;
    EXPECT_NEAR(secondsBetween(block_.end(), clock_.now()).value, 0.0, 1e-3);
  }
}

TEST_F(StreamSourceTest, ComesBackAHundredTimesAndSaysWhatIsMissing) {
  auto source = make(device());
  ASSERT_TRUE(source->open());
  ASSERT_TRUE(source->read(block_));
  for (int i = 0; i < 100; ++i) {
    wire_->unplug();
    clock_.set(clock_.now() + std::chrono::milliseconds(400));
    wire_->there = true;
    int reads = 0;
    do {
      const Instant ended = block_.end();
      ASSERT_TRUE(source->read(block_));
      if (!block_.has(kBlockGap)) continue;
      const double missing = secondsBetween(ended, block_.firstSample).value * 4000.0;
      EXPECT_NEAR(static_cast<double>(block_.lostFrames), missing, 1.0);
      EXPECT_GT(missing, 0.3 * 4000.0);
      break;
    } while (++reads < 5);
    EXPECT_TRUE(block_.has(kBlockGap)) << i;
  }
}

TEST_F(StreamSourceTest, ALostFrameIsAGapOfItsLength) {
  auto source = make(device());
  const auto format = source->open();
  ASSERT_TRUE(format);
  EXPECT_TRUE(format->doubt.empty());  // it counts
  ASSERT_TRUE(source->read(block_));
  number_ += 25;
  std::uint64_t lost = 0;
  for (int k = 0; k < 4; ++k) {
    ASSERT_TRUE(source->read(block_));
    lost += block_.lostFrames;
    EXPECT_EQ(block_.has(kBlockGap), block_.lostFrames > 0);
  }
  EXPECT_EQ(lost, 100U);
}

TEST_F(StreamSourceTest, WhatIsWrongIsOneLine) {
  auto silent = make([](std::size_t) { return std::string(); });
  auto opened = silent->open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().line(), "source 'serial' at script: nothing is sent (does the device stream?)");
  auto wrong = make([this](std::size_t n) {
    clock_.set(clock_.now() + std::chrono::milliseconds(10));
    return std::string(std::min<std::size_t>(n, 100), 'x');
  });
  opened = wrong->open();
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().line().find("no sample of the [[channels]]"), std::string::npos);
  auto absent = make({});
  wire_->there = false;
  opened = absent->open();
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().line().find("cannot be opened"), std::string::npos);

  SourceRequest request;
  request.channels.resize(2);
  request.settings = {{"rate_hz", "4000"}};
  const auto unsynced = makeSource("serial", request);
  ASSERT_FALSE(unsynced);
  EXPECT_EQ(unsynced.error().line(),
            "source 'serial': 'sync' is missing (binary frames begin with 1 to 8 bytes in hexadecimal, for example "
            "AA55)");
  request.settings = {{"format", "text"}};
  EXPECT_EQ(makeSource("tcp", request).error().line(),
            "source 'tcp': 'rate_hz' is missing (samples a second, from 100 to 1000000)");
}

// A transport that delivers late and in bursts; then one that drops a block without a word.
TEST(SampleClock, FollowsTheDevicesRateThroughJitterAndFindsSilentLoss) {
  SampleClock clock;
  clock.prepare(Hertz(25600.0), 256, false);
  const double rate = 25600.0 * 1.0004;
  double taken = 1.0;
  double error = 0.0;
  for (int k = 0; k < 6000; ++k) {
    const double begin = taken;
    taken += 256 / rate;
    const double jitter = 1e-3 * (k * 7 % 11) / 11.0 + (k % 500 < 4 ? 0.02 * (4 - k % 500) / 4.0 : 0.0);
    const Instant first = clock.stamp(256, instantFromNs(std::llround((taken + jitter) * 1e9)));
    EXPECT_EQ(clock.lost(), 0U) << k;
    if (k > 3000) error = std::max(error, std::abs(sinceEpoch(first).value - begin));
  }
  EXPECT_LT(error, 2e-3);
  EXPECT_NEAR(clock.rate().value, rate, 1e-4 * rate);
  taken += 2560 / rate;
  std::uint64_t lost = 0;
  for (int k = 0; k < 200; ++k) {
    taken += 256 / rate;
    clock.stamp(256, instantFromNs(std::llround(taken * 1e9)));
    lost += clock.lost();
  }
  EXPECT_NEAR(static_cast<double>(lost), 2560.0, 256.0);
}

// A device that counts what it loses, has lost nothing, and is a tenth slower than it was said to be.
TEST(SampleClock, TakesLatenessOfACountingDeviceForItsRate) {
  SampleClock clock;
  clock.prepare(Hertz(8000.0), 80, true);
  double taken = 0.0;
  double error = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const double begin = taken;
    taken += 80 / 7200.0;
    const Instant first = clock.stamp(80, instantFromNs(std::llround(taken * 1e9)));
    EXPECT_EQ(clock.lost(), 0U);
    if (k > 1000) error = std::max(error, std::abs(sinceEpoch(first).value - begin));
  }
  EXPECT_NEAR(clock.rate().value, 7200.0, 10.0);
  EXPECT_LT(error, 5e-3);
}

}  // namespace
}  // namespace stillcut::daq
