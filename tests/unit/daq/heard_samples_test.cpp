// Some seconds of a sensor in one piece: of a device that loses samples, of one that says nothing, of one that knows
// its own scale.
#include "core/daq/measured_samples.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "core/daq/calibrator.h"

namespace stillcut::daq {
namespace {

constexpr double kRate = 1000.0;
constexpr int kFrames = 10;

// Counts frames; from block `silentFrom` on it says nothing until it is stopped.
class Counting final : public DaqSource {
 public:
  Result<SourceFormat> open() override { return format; }
  bool read(SampleBlock& block) noexcept override {
    const std::uint64_t number = blocks_++;
    if (number >= silentFrom) {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [&] { return stopped_; });
      return false;
    }
    const bool gap = gapEvery > 0 && number % static_cast<std::uint64_t>(gapEvery) == 0 && number > 0;
    block.flags = gap ? kBlockGap : 0U;
    block.rate = format.rate;
    block.frames = kFrames;
    block.firstSample = Instant{} + toDuration(Seconds(static_cast<double>(number) * kFrames / kRate));
    for (std::size_t f = 0; f < kFrames; ++f) block.samples[f] = static_cast<float>(number * kFrames + f);
    return true;
  }
  void stop() noexcept override {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    wake_.notify_all();
  }
  Message fault() const override { return {}; }
  std::uint64_t blocks() const { return blocks_; }

  SourceFormat format{Hertz(kRate), kFrames, {ChannelInfo{}}};
  int gapEvery = 0;  // blocks
  std::uint64_t silentFrom = ~0ULL;

 private:
  std::uint64_t blocks_ = 0;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopped_ = false;
};

MeasureRequest wanting(double seconds) {
  MeasureRequest request;
  request.length = Seconds(seconds);
  return request;
}

TEST(Hear, GivesWhatIsInOnePieceAfterAGap) {
  Counting device;
  device.gapEvery = 150;  // 1.5 s
  const auto heard = measure(device, device.format, wanting(1.5));
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->samples.front().size(), 1500U);
  EXPECT_EQ(heard->samples.front().front(), 0.0F);
}

TEST(Hear, SamplesLostAgainAndAgainEndInOneLine) {
  Counting device;
  device.gapEvery = 100;  // each second
  const auto heard = measure(device, device.format, wanting(2.0));
  ASSERT_FALSE(heard);
  EXPECT_EQ(heard.error().line(),
            "the device: has not delivered enough in one piece (the longest was 1 s of 2 s: samples are lost again and "
            "again)");
  EXPECT_LT(static_cast<double>(device.blocks()) * kFrames / kRate, 10.0);  // twice the length and five seconds
}

TEST(Hear, ADeviceThatSaysNothingIsGivenUp) {
  Counting device;
  device.silentFrom = 3;
  MeasureRequest request = wanting(0.0);
  request.length = Seconds(0.05);
  request.patience = Duration(0);
  const auto heard = measure(device, device.format, request);
  ASSERT_FALSE(heard);
  EXPECT_EQ(text(heard.error().why), "the longest was 0.03 s of 0.05 s");
}

TEST(Hear, EndsWhenItIsNotWantedAnyMore) {
  Counting device;
  device.silentFrom = 3;
  const std::atomic<bool> ended{true};
  MeasureRequest request = wanting(60.0);
  request.ended = &ended;
  EXPECT_FALSE(measure(device, device.format, request));
}

// A device that knows full scale to be 250 SI units, below a profile that makes 0.5 of each of them.
TEST(Hear, WhatIsSavedInTheProfileLeavesTheDevicesOwnScaleToIt) {
  MeasureRequest request = wanting(1.0);
  request.told.resize(1);
  request.told[0].scale = 0.5;
  request.told[0].name = "x";
  for (int again = 0; again < 2; ++again) {
    Counting device;
    device.format.channels = request.told;
    device.format.channels[0].scale *= 250.0;
    auto heard = measure(device, device.format, request);
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->channels[0].scale, request.told[0].scale);
    EXPECT_EQ(heard->samples[0][7], 7.0F * 250.0F);
    Calibration found;
    found.scale = 1000.0 / (7.0 * 250.0);  // sample 7 was 1000 of SI
    applyCalibration(found, heard->channels[0]);
    request.told = heard->channels;
    EXPECT_NEAR(250.0 * request.told[0].scale * 7.0, 1000.0, 1e-9) << "as the device is opened with it next";
  }
}

}  // namespace
}  // namespace stillcut::daq
