// An audio-class device as a script: every sample format, short reads, overruns, removal and return.
#include <gtest/gtest.h>

#include <cstring>
#include <deque>
#include <optional>
#include <tuple>
#include <utility>

#include "core/daq/pcm_source.h"
#include "core/daq/registry.h"
#include "core/model/device_flags.h"

namespace stillcut::daq {
namespace {

// Frame n of channel c holds n * 8 + c in the upper 24 bits (16: the upper 16 of them).
class ScriptedPcm final : public PcmDriver {
 public:
  ScriptedPcm(ManualClock& clock, PcmFormat format) : clock_(clock), format_(std::move(format)) {}
  Result<PcmFormat> open(const PcmRequest& request) override {
    ++opens;
    if (absent > 0) {
      --absent;
      return Error{message("'device' = 'hw:9'"), message("cannot be opened"), message("No such device")};
    }
    rate_ = request.rate.value;
    return format_;
  }
  int read(void* into, int frames, Instant& taken) noexcept override {
    if (!script.empty()) {
      const int next = script.front();
      script.pop_front();
      if (next < 0) {
        pass(lostAtFault);
        return next;
      }
      frames = std::min(frames, next);
    }
    auto* at = static_cast<unsigned char*>(into);
    for (int f = 0; f < frames; ++f, ++frame) {
      for (int c = 0; c < format_.channels; ++c, at += format_.sampleBytes) {
        const auto value = static_cast<std::uint32_t>(f == 7 && c == 0 && set ? *set : frame * 8 + c);
        const std::uint32_t word = format_.sampleBytes == 4 && format_.bits == 32 ? value << 8 : value;
        std::memcpy(at, &word, static_cast<std::size_t>(format_.sampleBytes));
      }
    }
    pass(frames);
    frame -= frames;  // pass() has counted them as well
    taken = clock_.now();
    return frames;
  }
  bool recover() noexcept override { return true; }
  bool countsLosses() const noexcept override { return true; }

  void close() noexcept override {}

  std::deque<int> script;  // lengths of the next reads, or faults
  int lostAtFault = 0;
  int absent = 0;  // so many open() calls fail
  int opens = 0;
  int frame = 0;
  std::optional<int> set;  // in frame 7 of a read, in the place of its count

 private:
  void pass(int frames) noexcept {
    frame += frames;
    clock_.set(clock_.now() + toDuration(Seconds(frames / rate_)));
  }
  ManualClock& clock_;
  PcmFormat format_;
  double rate_ = 48000.0;
};

class PcmSourceTest : public ::testing::Test {
 protected:
  std::unique_ptr<PcmSource> make(const PcmFormat& format, const std::vector<int>& inputs = {0, 2}) {
    auto driver = std::make_unique<ScriptedPcm>(clock_, format);
    driver_ = driver.get();
    PcmRequest request;
    request.rate = Hertz(48000.0);
    block_.allocate(static_cast<int>(inputs.size()), format.periodFrames);
    return std::make_unique<PcmSource>("source 'alsa'", request, std::vector<ChannelInfo>(inputs.size()), inputs,
                                       std::move(driver), clock_);
  }
  static PcmFormat format(int bits, int bytes) { return {4, bytes, bits, 100, {}}; }
  ManualClock clock_;
  ScriptedPcm* driver_ = nullptr;
  SampleBlock block_;
};

TEST_F(PcmSourceTest, TwentyFourBitsComeThroughBitByBitFromTheRightInputs) {
  for (const auto& [bits, bytes] : {std::pair{32, 4}, {24, 3}, {24, 4}}) {
    auto source = make(format(bits, bytes));
    ASSERT_TRUE(source->open());
    for (int k = 0; k < 20; ++k) {
      ASSERT_TRUE(source->read(block_));
      for (int f = 0; f < 100; ++f) {
        const int frame = 100 * k + f;
        ASSERT_EQ(block_.channel(0)[f], static_cast<float>(frame * 8) / 8388608.0F) << bits << " in " << bytes;
        ASSERT_EQ(block_.channel(1)[f], static_cast<float>(frame * 8 + 2) / 8388608.0F);
      }
      EXPECT_EQ(block_.flags & ~kBlockRateUnverified, 0U);
    }
  }
  auto narrow = make(format(16, 2), {1});
  ASSERT_TRUE(narrow->open());
  ASSERT_TRUE(narrow->read(block_));
  EXPECT_EQ(block_.channel(0)[3], 25.0F / 32768.0F);
}

TEST_F(PcmSourceTest, ShortReadsMakeWholeBlocks) {
  auto source = make(format(24, 3));
  ASSERT_TRUE(source->open());
  driver_->script = {30, 0, 1, 69, 0, 99, 1};
  for (int k = 0; k < 2; ++k) {
    ASSERT_TRUE(source->read(block_));
    EXPECT_EQ(block_.frames, 100);
    EXPECT_EQ(block_.channel(0)[99], static_cast<float>((100 * k + 99) * 8) / 8388608.0F);
    EXPECT_EQ(block_.flags & ~kBlockRateUnverified, 0U);
  }
}

TEST_F(PcmSourceTest, AnOverrunIsAGapOfItsLength) {
  auto source = make(format(32, 4));
  ASSERT_TRUE(source->open());
  driver_->script = {100, 40, kPcmOverrun};
  driver_->lostAtFault = 4800;
  ASSERT_TRUE(source->read(block_));
  ASSERT_TRUE(source->read(block_));
  EXPECT_EQ(block_.frames, 40);  // what was whole comes out first
  ASSERT_TRUE(source->read(block_));
  EXPECT_TRUE(block_.has(kBlockGap));
  EXPECT_NEAR(static_cast<double>(block_.lostFrames), 4800.0, 1.0);
  EXPECT_EQ(block_.channel(0)[0], static_cast<float>((140 + 4800) * 8) / 8388608.0F);
  ASSERT_TRUE(source->read(block_));
  EXPECT_FALSE(block_.has(kBlockGap));
}

TEST_F(PcmSourceTest, IsTakenUpAgainAfterItWasUnplugged) {
  auto source = make(format(32, 4));
  ASSERT_TRUE(source->open());
  driver_->script = {100, kPcmGone};
  driver_->lostAtFault = 48000;
  ASSERT_TRUE(source->read(block_));
  const std::uint64_t sequence = block_.sequence;
  ASSERT_TRUE(source->read(block_));
  EXPECT_EQ(driver_->opens, 2);
  EXPECT_TRUE(block_.has(kBlockGap));
  EXPECT_NEAR(static_cast<double>(block_.lostFrames), 48000.0, 1.0);
  EXPECT_EQ(block_.sequence, sequence + 481);
}

// Audio-class: both ends of the whole numbers are the converter's.
TEST_F(PcmSourceTest, FullScaleIsClipped) {
  for (const auto& [bits, bytes, most] :
       {std::tuple{32, 4, 0x7FFFFF}, {24, 3, 0x7FFFFF}, {24, 4, 0x7FFFFF}, {16, 2, 0x7FFF}}) {
    for (const int value : {most, -most - 1, most - 1, -most, 0}) {
      auto source = make(format(bits, bytes), {0});
      ASSERT_TRUE(source->open());
      ASSERT_TRUE(source->read(block_));
      EXPECT_FALSE(block_.has(kBlockClipped));
      driver_->set = value;
      ASSERT_TRUE(source->read(block_));
      EXPECT_EQ(block_.has(kBlockClipped), value == most || value == -most - 1) << value << " of " << bits;
    }
  }
}

// It opens, and fails at the first read, again and again: asked twice a second, not in a tight loop.
TEST_F(PcmSourceTest, ADeviceThatOpensAndDeliversNothingIsNotAskedInATightLoop) {
  class Broken final : public PcmDriver {
   public:
    explicit Broken(int fault) : fault_(fault) {}
    Result<PcmFormat> open(const PcmRequest& /*request*/) override {
      ++opens;
      return PcmFormat{1, 4, 32, 100, {}};
    }
    int read(void* /*into*/, int /*frames*/, Instant& /*taken*/) noexcept override { return fault_; }
    bool recover() noexcept override { return false; }
    bool countsLosses() const noexcept override { return true; }
    void close() noexcept override {}
    int opens = 0;

   private:
    int fault_;
  };
  // A tenth of a second passes whenever it is looked at; at the end of the test the source is stopped.
  class Passing final : public Clock {
   public:
    Instant now() const noexcept override {
      now_ += std::chrono::milliseconds(100);
      if (now_ > Instant{} + std::chrono::seconds(4) && source != nullptr) source->stop();
      return now_;
    }
    PcmSource* source = nullptr;

   private:
    mutable Instant now_{};
  };
  for (const int fault : {static_cast<int>(kPcmGone), static_cast<int>(kPcmOverrun), 0}) {
    Passing clock;
    auto driver = std::make_unique<Broken>(fault);
    const Broken& broken = *driver;
    PcmRequest request;
    request.rate = Hertz(48000.0);
    PcmSource source("source 'alsa'", request, std::vector<ChannelInfo>(1), {0}, std::move(driver), clock);
    ASSERT_TRUE(source.open());
    clock.source = &source;
    block_.allocate(1, 100);
    EXPECT_FALSE(source.read(block_));
    EXPECT_GT(broken.opens, 1) << fault;
    EXPECT_LE(broken.opens, 10) << fault;
  }
}

TEST_F(PcmSourceTest, WhileItIsAwayOneLineSaysSo) {
  // The clock goes on, a second at each look, so that the next try comes; what it says in between is kept.
  class Away final : public Clock {
   public:
    Instant now() const noexcept override {
      if (source != nullptr && said.empty()) said = text(source->trouble());
      return now_ += std::chrono::seconds(1);
    }
    const PcmSource* source = nullptr;
    mutable std::string said;

   private:
    mutable Instant now_{};
  };
  Away clock;
  auto driver = std::make_unique<ScriptedPcm>(clock_, format(32, 4));
  ScriptedPcm& device = *driver;
  PcmRequest request;
  request.rate = Hertz(48000.0);
  PcmSource source("source 'alsa'", request, std::vector<ChannelInfo>(1), {0}, std::move(driver), clock);
  ASSERT_TRUE(source.open());
  block_.allocate(1, 100);
  clock.source = &source;
  device.script = {100, kPcmGone};
  device.absent = 2;
  ASSERT_TRUE(source.read(block_));
  EXPECT_TRUE(source.trouble().empty());
  ASSERT_TRUE(source.read(block_));
  EXPECT_EQ(clock.said, "source 'alsa' 'device' = 'hw:9': cannot be opened (No such device)");
  EXPECT_TRUE(source.trouble().empty()) << "it is back";
}

TEST_F(PcmSourceTest, WhatIsWrongIsOneLine) {
  auto source = make(format(32, 4));
  driver_->absent = 1;
  const auto opened = source->open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().line(), "source 'alsa' 'device' = 'hw:9': cannot be opened (No such device)");

  SourceRequest request;
  request.channels.resize(2);
  for (const char* bad : {"0", "0,", "0,x", "-1,0", "0;1", "0,1,2"}) {
    request.settings = {{"inputs", bad}};
    const auto made = makeSource("alsa", request);
    ASSERT_FALSE(made) << bad;
    EXPECT_NE(made.error().line().find("'inputs' is '"), std::string::npos) << made.error().line();
  }
  request.settings = {{"rate_hz", "7000"}};
  EXPECT_EQ(makeSource("alsa", request).error().line(),
            "source 'alsa': 'rate_hz' is '7000' (must be a number from 8000 to 192000)");
}

}  // namespace
}  // namespace stillcut::daq
