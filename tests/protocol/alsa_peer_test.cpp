// PulseAudio null sinks through ALSA's pulse plugin, which stand in for audio-class devices. Waits are in real time,
// and each is bounded.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <map>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/compose/rig.h"
#include "core/pipeline/catalog.h"
#include "core/rt/wakeup.h"
#include "tests/protocol/source_request.h"
#include "tests/support/null_sink.h"

namespace stillcut::daq {
namespace {

class PulseTest : public ::testing::Test {
 protected:
  static constexpr int kRate = 96000;
  static constexpr int kChannels = 4;

  void SetUp() override {
    const std::string missing = sink_.start(kRate, kChannels, "front-left,front-right,rear-left,rear-right");
    if (!missing.empty()) GTEST_SKIP() << missing;
  }
  Result<std::unique_ptr<DaqSource>> heard(std::map<std::string, std::string> settings, std::size_t channels) {
    settings.emplace("device", "heard");
    SourceRequest request = requestOn(clock_, std::move(settings));
    request.channels.resize(channels);
    return makeSource("alsa", request);
  }
  testing::NullSink sink_;
  SteadyClock clock_;
};

// Plays frame n of channel c as (n * 4 + c) in the upper 24 bits.
class Counter {
 public:
  void operator()(std::span<std::int32_t> out) {
    for (std::size_t f = 0; f < out.size() / 4; ++f, ++frame_) {
      for (std::uint32_t c = 0; c < 4; ++c)
        out[4 * f + c] = static_cast<std::int32_t>(((frame_ * 4 + c) & 0x7FFFFF) << 8);
    }
  }

 private:
  std::uint32_t frame_ = 1;
};

TEST_F(PulseTest, TwentyFourBitsArriveInOrderOnTheirOwnChannels) {
  auto source = heard({{"rate_hz", "96000"}, {"inputs", "0,1,2,3"}}, kChannels);
  ASSERT_TRUE(source) << source.error().line();
  const auto format = (*source)->open();
  ASSERT_TRUE(format) << format.error().line();
  const testing::NullSinkPlayer player(kRate, kChannels, Counter());
  SampleBlock block;
  block.allocate(kChannels, format->blockFrames);
  std::int64_t expected = -1;
  long counted = 0;
  Instant first{};
  const Instant end = clock_.now() + std::chrono::seconds(15);
  while (counted < 2L * kRate && clock_.now() < end) {
    ASSERT_TRUE((*source)->read(block));
    ASSERT_EQ(block.frames, format->blockFrames);
    for (int f = 0; f < block.frames; ++f) {
      const auto at = static_cast<std::size_t>(f);
      const auto value = static_cast<std::int64_t>(block.channel(0)[at] * 8388608.0F);
      if (value == 0 && expected < 0) continue;  // not yet playing
      if (expected >= 0) {
        ASSERT_EQ(value, expected) << counted;
      }
      for (std::size_t c = 1; c < kChannels; ++c) {
        ASSERT_EQ(static_cast<std::int64_t>(block.channel(static_cast<int>(c))[at] * 8388608.0F),
                  value + static_cast<std::int64_t>(c))
            << c << " at " << f << " of " << counted << ": " << block.channel(1)[at] * 8388608.0F << " "
            << block.channel(2)[at] * 8388608.0F << " " << block.channel(3)[at] * 8388608.0F;
      }
      expected = (value + 4) & 0x7FFFFF;
      if (counted++ == 0) first = block.firstSample;
    }
  }
  EXPECT_TRUE(player.couldPlay());
  ASSERT_GE(counted, 2L * kRate);
  EXPECT_NEAR(secondsBetween(first, block.end()).value, static_cast<double>(counted) / kRate, 0.05);
}

// Channels are the inputs that the profile names, in its order: a wrong one would show here as another number.
TEST_F(PulseTest, AnInputIsTheOneThatWasAskedFor) {
  auto source = heard({{"rate_hz", "96000"}, {"inputs", "3,1"}}, 2);
  ASSERT_TRUE(source) << source.error().line();
  const auto format = (*source)->open();
  ASSERT_TRUE(format) << format.error().line();
  const testing::NullSinkPlayer player(kRate, kChannels, Counter());
  SampleBlock block;
  block.allocate(2, format->blockFrames);
  long counted = 0;
  const Instant end = clock_.now() + std::chrono::seconds(15);
  while (counted < kRate / 4 && clock_.now() < end) {
    ASSERT_TRUE((*source)->read(block));
    for (std::size_t f = 0; f < static_cast<std::size_t>(block.frames); ++f) {
      const auto first = static_cast<std::int64_t>(block.channel(0)[f] * 8388608.0F);
      if (first == 0) continue;  // not yet playing
      ASSERT_EQ(first % 4, 3);
      ASSERT_EQ(static_cast<std::int64_t>(block.channel(1)[f] * 8388608.0F), first - 2);
      ++counted;
    }
  }
  EXPECT_GE(counted, kRate / 4);
}

// The cable is pulled in the middle and put back: the stream goes on by itself, with a gap as long as it was out.
TEST_F(PulseTest, ADeviceThatGoesAndComesBackIsTakenUpAgainWithAGap) {
  auto source = heard({{"rate_hz", "96000"}}, 1);
  ASSERT_TRUE(source) << source.error().line();
  const auto format = (*source)->open();
  ASSERT_TRUE(format) << format.error().line();
  SampleBlock block;
  block.allocate(1, format->blockFrames);
  for (int i = 0; i < 20; ++i) ASSERT_TRUE((*source)->read(block));
  std::atomic<bool> plugged{false};
  std::thread cable([this, &plugged] {
    sink_.unplug();
    EXPECT_EQ(sink_.plug(), "");  // takes as long as a server needs to start
    plugged = true;
  });
  Instant before = block.end();
  bool gap = false;
  for (const Instant end = clock_.now() + std::chrono::seconds(15); !gap && clock_.now() < end;) {
    if (!(*source)->read(block)) break;
    gap = block.has(kBlockGap);
    if (gap) {
      EXPECT_GT(block.lostFrames, 0U);
      EXPECT_NEAR(secondsBetween(before, block.firstSample).value, static_cast<double>(block.lostFrames) / kRate, 1e-3);
    }
    before = block.end();
  }
  EXPECT_TRUE(gap);
  EXPECT_TRUE(plugged);
  for (int i = 0; i < 20; ++i) ASSERT_TRUE((*source)->read(block));
  cable.join();
}

// Two of every three samples are made up by the server: what is told is kept to the clock, and yet not believed.
TEST(PulseRates, AStreamThatSomebodyStretchedIsNotBelieved) {
  constexpr int kNative = 32000, kAsked = 96000;
  testing::NullSink sink;
  if (const std::string missing = sink.start(kNative, 1, "mono", "trivial"); !missing.empty()) GTEST_SKIP() << missing;
  const auto clock = std::make_shared<SteadyClock>();
  SourceRequest request = requestOn(*clock, {{"device", "heard"}, {"rate_hz", std::to_string(kAsked)}});
  request.channels = {{.name = "x", .scale = 100.0, .axis = "x"}};
  auto source = makeSource("alsa", request);
  ASSERT_TRUE(source) << source.error().line();
  app::RigSpec spec;
  spec.clock = clock;
  spec.device = std::move(source).value();
  spec.setup.teeth = 4;
  spec.setup.nominalSpeed = Rpm(8500.0);
  spec.watched = true;
  auto rig = app::Rig::build(std::move(spec));
  ASSERT_TRUE(rig) << rig.error().line();
  std::uint32_t state = 1;
  const testing::NullSinkPlayer player(kNative, 1, [&state](std::span<std::int32_t> out) {
    for (std::int32_t& sample : out) {
      state = state * 1664525U + 1013904223U;
      sample = static_cast<std::int32_t>(state) / 8;
    }
  });
  (*rig)->start({});
  rt::Wakeup never;  // only its time-out is used
  ReasonCode found = ReasonCode::None;
  for (const Instant end = clock->now() + std::chrono::seconds(15);
       found != ReasonCode::InputRepeated && clock->now() < end;) {
    never.waitFor(Seconds(0.05));
    const Snapshot* s = (*rig)->read();
    if (s == nullptr) continue;
    found = s->sensors.fault.code;
    if (found == ReasonCode::InputRepeated) {
      EXPECT_FALSE(s->verdicts[0].valid);
    }
  }
  EXPECT_EQ(found, ReasonCode::InputRepeated);
  EXPECT_TRUE((*rig)->stop());
}

TEST_F(PulseTest, ADeviceBehindASoundServerIsToldFromOneOfItsOwn) {
  auto source = heard({{"device", "heard"}, {"rate_hz", std::to_string(kRate)}}, 1);
  ASSERT_TRUE(source) << source.error().line();
  const auto opened = (*source)->open();
  ASSERT_TRUE(opened) << opened.error().line();
  EXPECT_NE(text(opened->doubt).find("a sound server's"), std::string::npos) << text(opened->doubt);
  auto direct = heard({{"device", "null"}, {"rate_hz", std::to_string(kRate)}}, 1);
  ASSERT_TRUE(direct) << direct.error().line();
  const auto bare = (*direct)->open();
  ASSERT_TRUE(bare) << bare.error().line();
  EXPECT_TRUE(bare->doubt.empty());
  // What converts may stand before a server.
  auto behind = heard({{"device", "plug:null"}, {"rate_hz", std::to_string(kRate)}}, 1);
  ASSERT_TRUE(behind) << behind.error().line();
  const auto converted = (*behind)->open();
  ASSERT_TRUE(converted) << converted.error().line();
  EXPECT_NE(text(converted->doubt).find("'plug:null' converts"), std::string::npos) << text(converted->doubt);
}

TEST_F(PulseTest, ARateThatWouldBeConvertedIsRefusedWithTheOneThereIs) {
  auto source = heard({{"device", "fixed"}, {"rate_hz", "48000"}}, 1);
  ASSERT_TRUE(source) << source.error().line();
  const auto opened = (*source)->open();
  ASSERT_FALSE(opened) << "96 kHz were taken for 48";
  EXPECT_EQ(opened.error().line(),
            "source 'alsa' device 'fixed': 'rate_hz' = 48000 is not among its rates (it has 96000)");
}

TEST_F(PulseTest, WhatTheDeviceDoesNotHaveIsOneLine) {
  for (const auto& [settings, line] : std::vector<std::pair<std::map<std::string, std::string>, std::string>>{
           {{{"device", "hw:77"}}, "'device' = 'hw:77': cannot be opened"},
           {{{"inputs", "31"}, {"bits", "8"}}, "'bits'"},
           {{{"rate_hz", "4000"}}, "'rate_hz'"}}) {
    auto source = heard(settings, 1);
    std::string said = source ? "" : source.error().line();
    if (source) {
      const auto opened = (*source)->open();
      said = opened ? "it opened" : opened.error().line();
    }
    EXPECT_NE(said.find(line), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace stillcut::daq
