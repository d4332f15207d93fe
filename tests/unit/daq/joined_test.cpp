// Devices whose crystals differ, each sampling the same world: what comes out is one instant of it on every channel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/daq/clock_aligner.h"
#include "core/daq/joined_source.h"
#include "core/daq/registry.h"
#include "core/model/device_flags.h"

namespace stillcut::daq {
namespace {

double world(double frequency, double t) {
  return std::sin(2.0 * std::numbers::pi * frequency * t);
}

// Samples `frequency` with a crystal that is `ppm` off; what time it is, is shared: nobody runs ahead of it for long.
class Device final : public DaqSource {
 public:
  Device(Hertz rate, double ppm, double frequency, std::shared_ptr<std::atomic<double>> now, bool leads)
      : rate_(rate),
        actual_(rate.value * (1.0 + 1e-6 * ppm)),
        frequency_(frequency),
        now_(std::move(now)),
        leads_(leads) {}
  Result<SourceFormat> open() override { return SourceFormat{rate_, kFrames, {ChannelInfo{}}}; }
  bool read(SampleBlock& block) noexcept override {
    block.flags = 0;
    double end = static_cast<double>(frame_ + kFrames) / actual_;
    if (awayFrom > 0.0 && end > awayFrom && end < awayTo) {
      frame_ += static_cast<long>((awayTo - awayFrom) * actual_);
      end = static_cast<double>(frame_ + kFrames) / actual_;
      block.flags = kBlockGap;
    }
    if (end < uncheckedUntil) block.flags |= kBlockRateUnverified;
    if (leads_) now_->store(end);
    while (!leads_ && end > now_->load() + 0.05 && !stopped_) std::this_thread::yield();
    if (stopped_) return false;
    block.frames = kFrames;
    block.rate = rate_;
    block.lostFrames = 0;
    block.sequence = static_cast<std::uint64_t>(frame_ / kFrames);
    // Stamped with what a smoothed clock leaves of a transport's jitter.
    block.firstSample = toInstant(static_cast<double>(frame_) / actual_ + jitter_(engine_));
    for (int f = 0; f < kFrames; ++f, ++frame_) {
      const double value = world(frequency_, static_cast<double>(frame_ - frame_ % repeated) / actual_);
      block.samples[static_cast<std::size_t>(f)] = offset + static_cast<float>(std::clamp(gain * value, -limit, limit));
    }
    return true;
  }
  void stop() noexcept override { stopped_ = true; }
  Message fault() const override { return {}; }
  bool live() const override { return true; }
  double actual() const { return actual_; }
  static Instant toInstant(double t) { return instantFromNs(1'000'000'000) + toDuration(Seconds(t)); }

  double awayFrom = 0.0, awayTo = 0.0;
  double uncheckedUntil = 0.0;
  double gain = 1.0, limit = 1e3;
  float offset = 0.0F;
  long repeated = 1;  // frames in a row that are one sample

 private:
  static constexpr int kFrames = 240;
  Hertz rate_;
  double actual_;
  double frequency_;
  std::shared_ptr<std::atomic<double>> now_;
  bool leads_;
  std::atomic<bool> stopped_{false};
  long frame_ = 0;
  std::mt19937 engine_{1};
  std::normal_distribution<double> jitter_{0.0, 1e-6};
};

// Stands still, so that every device is waited for; but for a while in which one is known to be away.
class PatientClock final : public Clock {
 public:
  explicit PatientClock(std::shared_ptr<std::atomic<double>> now) : now_(std::move(now)) {}
  Instant now() const noexcept override {
    const double t = now_->load();
    return t > from - 0.02 && t < to ? Device::toInstant(1e6) : Instant{};
  }
  double from = 0.0, to = 0.0;

 private:
  std::shared_ptr<std::atomic<double>> now_;
};

class Joined : public ::testing::Test {
 protected:
  // The second device beside one of 48 kHz that is 80 ppm fast.
  void make(Hertz rate, double ppm, double frequency, Seconds delay = {}) {
    auto first = std::make_unique<Device>(Hertz(48000.0), 80.0, 1000.0, now_, true);
    auto second = std::make_unique<Device>(rate, ppm, frequency, now_, false);
    first_ = first.get();
    second_ = second.get();
    std::vector<JoinedPart> parts;
    parts.push_back({std::move(first), {}});
    parts.push_back({std::move(second), delay});
    source_ = std::make_unique<JoinedSource>(std::move(parts), clock_);
    const auto format = source_->open();
    ASSERT_TRUE(format);
    EXPECT_EQ(format->channels.size(), 2U);
    EXPECT_EQ(format->rate.value, 48000.0);
    block_.allocate(2, format->blockFrames);
  }
  // Largest difference of the second channel from the world at the times of the first, from `settled` on.
  double worstFrom(double settled, double until, double frequency) {
    double worst = 0.0;
    for (double t = 0.0; t < until;) {
      EXPECT_TRUE(source_->read(block_));
      for (int f = 0; f < block_.frames; ++f) {
        t = secondsBetween(Device::toInstant(0.0), block_.firstSample).value + f / first_->actual();
        const auto at = static_cast<std::size_t>(f);
        if (t > settled)
          worst = std::max(worst, std::abs(static_cast<double>(block_.channel(1)[at]) - world(frequency, t)));
      }
    }
    return worst;
  }
  std::shared_ptr<std::atomic<double>> now_ = std::make_shared<std::atomic<double>>(0.0);
  PatientClock clock_{now_};
  Device* first_ = nullptr;
  Device* second_ = nullptr;
  std::unique_ptr<JoinedSource> source_;
  SampleBlock block_;
};

TEST_F(Joined, TwoCrystalsShowOneInstant) {
  make(Hertz(25600.0), -60.0, 1000.0);
  EXPECT_LT(worstFrom(1.0, 12.0, 1000.0), 0.03);  // 2 pi 1000 Hz times 4 us
  const auto clocks = source_->clocks();
  ASSERT_EQ(clocks.size(), 1U);
  EXPECT_NEAR(clocks[0].rate.value, 25600.0 * (1.0 - 60e-6), 25600.0 * 10e-6);
  EXPECT_GT(clocks[0].residual.value, 0.3e-6);
  EXPECT_LT(clocks[0].residual.value, 5e-6);
}

TEST_F(Joined, AKnownDelayIsTakenOff) {
  make(Hertz(48000.0), 0.0, 500.0, Seconds(-0.002));  // stamped 2 ms too early
  double worst = 0.0;
  for (int i = 0; i < 400; ++i) {
    ASSERT_TRUE(source_->read(block_));
    const double t = secondsBetween(Device::toInstant(0.0), block_.firstSample).value;
    if (t > 0.5) worst = std::max(worst, std::abs(static_cast<double>(block_.channel(1)[0]) - world(500.0, t - 0.002)));
  }
  EXPECT_LT(worst, 0.03);
}

TEST_F(Joined, WhatASlowerRateCannotHoldDoesNotFoldBack) {
  make(Hertz(96000.0), 20.0, 36000.0);
  double loudest = 0.0;
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(source_->read(block_));
    if (i < 50) continue;
    for (const float v : block_.channel(1)) loudest = std::max(loudest, std::abs(static_cast<double>(v)));
  }
  EXPECT_LT(loudest, 0.01);
}

// A sensor check that sees only what comes out has to find what it would find in the device itself.
TEST_F(Joined, WhatStandsStillComesOutBitByBit) {
  make(Hertz(44100.0), -60.0, 0.0);
  second_->offset = 0.3217F;  // and no tone
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(source_->read(block_));
    for (const float v : block_.channel(1)) ASSERT_EQ(v, 0.3217F);
  }
}

TEST_F(Joined, AWaveformThatIsCutFlatIsClippedAndNoOther) {
  for (const bool cut : {true, false}) {
    now_->store(0.0);
    make(Hertz(44100.0), -60.0, 700.0);
    second_->gain = 2.0;
    if (cut) second_->limit = 1.0;
    int clipped = 0;
    for (int i = 0; i < 200; ++i) {
      ASSERT_TRUE(source_->read(block_));
      if (i >= 100) clipped += block_.has(kBlockClipped) ? 1 : 0;
    }
    EXPECT_EQ(clipped, cut ? 100 : 0);
  }
}

// In what comes out neither shows any more: it is at the other's rate, and interpolated.
TEST_F(Joined, AWrongRateAndRepeatedValuesOfTheOtherAreSaid) {
  struct Case {
    double ppm;
    long repeated;
    bool said;
  };
  for (const Case& c : {Case{200.0, 1, false}, Case{20'000.0, 1, true}, Case{-9'000.0, 1, true}, Case{0.0, 2, true}}) {
    now_->store(0.0);
    make(Hertz(44100.0), c.ppm, 700.0);
    second_->repeated = c.repeated;
    int said = 0;
    for (int i = 0; i < 600; ++i) {
      ASSERT_TRUE(source_->read(block_));
      if (i >= 400) said += block_.has(kBlockRateMismatch) ? 1 : 0;
    }
    EXPECT_EQ(said, c.said ? 200 : 0) << c.ppm << " " << c.repeated;
    if (c.said) {
      EXPECT_EQ(rateMismatchChannel(block_), 1);
    }
  }
}

// It is as new as the newest of its devices.
TEST_F(Joined, ItsRateIsUncheckedWhileOneOfThemIs) {
  make(Hertz(44100.0), 0.0, 700.0);
  second_->uncheckedUntil = 1.5;
  int late = 0;
  for (int i = 0; i < 600; ++i) {
    ASSERT_TRUE(source_->read(block_));
    const double t = secondsBetween(Device::toInstant(0.0), block_.firstSample).value;
    if (t < 1.3) {
      EXPECT_TRUE(block_.has(kBlockRateUnverified)) << t;
    }
    late += t > 2.8 && block_.has(kBlockRateUnverified) ? 1 : 0;
  }
  EXPECT_EQ(late, 0);
}

TEST_F(Joined, WhileOneIsAwayAllIsAGapOfThatLength) {
  clock_.from = 1.0;
  clock_.to = 1.5;
  make(Hertz(48000.0), 0.0, 500.0);
  second_->awayFrom = clock_.from;
  second_->awayTo = clock_.to;
  std::uint64_t lost = 0;
  Instant end{};
  int gaps = 0;
  for (int i = 0; i < 400; ++i) {
    ASSERT_TRUE(source_->read(block_));
    EXPECT_EQ(block_.has(kBlockGap), block_.lostFrames > 0);
    if (end != Instant{}) {
      EXPECT_NEAR(secondsBetween(end, block_.firstSample).value, static_cast<double>(block_.lostFrames) / 48000.0,
                  1e-4);
    }
    end = block_.end();
    lost += block_.lostFrames;
    gaps += block_.has(kBlockGap) ? 1 : 0;
  }
  EXPECT_EQ(gaps, 1);
  EXPECT_NEAR(static_cast<double>(lost), 24000.0, 2500.0);
}

class NoCard final : public PcmDriver {
 public:
  Result<PcmFormat> open(const PcmRequest& /*request*/) override { return Error{{}, message("no card")}; }
  int read(void* /*into*/, int /*frames*/, Instant& /*taken*/) noexcept override { return kPcmGone; }
  bool recover() noexcept override { return false; }
  bool countsLosses() const noexcept override { return true; }
  void close() noexcept override {}
};

TEST(JoinedRegistry, ASettingOfAPartNamesThePart) {
  const ManualClock clock;
  SourceRequest request;
  request.clock = &clock;
  request.pcm = [] { return std::make_unique<NoCard>(); };
  request.channels.resize(2);
  const auto line = [&](std::map<std::string, std::string> settings) {
    request.settings = std::move(settings);
    const auto made = makeSource("joined", request);
    return made ? std::string() : made.error().line();
  };
  EXPECT_EQ(line({}), "source 'joined': '1_id' is missing (two devices or more are joined: 1_id, 2_id ...)");
  EXPECT_EQ(line({{"1_id", "alsa"}}),
            "source 'joined': '2_id' is missing (two devices or more are joined: 1_id, 2_id ...)");
  EXPECT_EQ(line({{"1_id", "alsa"}, {"2_id", "joined"}}), "source 'joined': '2_id' is 'joined' (a device)");
  EXPECT_EQ(line({{"1_id", "alsa"}, {"2_id", "serial"}, {"2_rate_hz", "8000"}}),
            "source 'joined', device 2: source 'serial': 'sync' is missing (binary frames begin with 1 to 8 bytes in "
            "hexadecimal, for example AA55)");
  EXPECT_EQ(line({{"1_id", "alsa"}, {"2_id", "alsa"}, {"2_channels", "2"}}),
            "source 'joined': '2_channels' is 2 (the [[channels]] are 2 in all, and 1 of them are taken)");
  EXPECT_EQ(
      line({{"1_id", "alsa"}, {"2_id", "alsa"}, {"device", "hw:0"}}),
      "source 'joined': 'device' is not known (1_id, 1_channels, 1_delay_ms and 1_ with the device's own settings, "
      "then 2_)");
}

}  // namespace
}  // namespace stillcut::daq
