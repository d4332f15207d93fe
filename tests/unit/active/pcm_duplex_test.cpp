// The audio-class device above its driver: scales and channels, and everything a driver may say.
#include "core/active/pcm_duplex.h"

#include <gtest/gtest.h>

#include <deque>

#include "tests/unit/active/commands.h"

namespace stillcut::active {
namespace {

struct Script {
  PcmDuplexRequest asked;
  std::deque<int> reads, writes;  // what they say; 0 when the list is empty
  bool restarts = true;
  int restarted = 0;
  std::vector<std::int32_t> in, out;
  bool refuses = false;
};

class ScriptedDriver final : public PcmDuplexDriver {
 public:
  explicit ScriptedDriver(Script& script) : script_(script) {}
  Result<PcmDuplexFormat> open(const PcmDuplexRequest& request) override {
    if (script_.refuses)
      return Error{message("device 'hw:9'"), message("cannot be opened for output"), message("No such device")};
    script_.asked = request;
    return PcmDuplexFormat{2, request.inputs, request.outputs};
  }
  int read(std::int32_t* into) noexcept override {
    std::copy(script_.in.begin(), script_.in.end(), into);
    return next(script_.reads);
  }
  int write(const std::int32_t* from) noexcept override {
    script_.out.assign(from, from + 2 * static_cast<std::ptrdiff_t>(script_.asked.outputs));
    return next(script_.writes);
  }
  bool restart() noexcept override {
    ++script_.restarted;
    return script_.restarts;
  }
  void close() noexcept override {}

 private:
  static int next(std::deque<int>& list) {
    if (list.empty()) return 0;
    const int said = list.front();
    list.pop_front();
    return said;
  }
  Script& script_;
};

class Pcm : public testing::Test {
 protected:
  static PcmDuplexSettings settings() {
    PcmDuplexSettings s;
    s.input = {0, 2};
    s.output = {3, 1};
    s.sensor = {100.0, 50.0};
    s.stroke = {4e-6, 4e-6};
    return s;
  }
  Script script_;
  PcmDuplex device_{settings(), std::make_unique<ScriptedDriver>(script_)};
  std::array<double, 4> in_{};
};

TEST_F(Pcm, GivesAxesTheirChannelsAndUnits) {
  const auto format = device_.open();
  ASSERT_TRUE(format.ok());
  EXPECT_EQ(format->frames, 2);
  EXPECT_EQ(script_.asked.inputs, 3);
  EXPECT_EQ(script_.asked.outputs, 4);
  script_.in = {1 << 30, 7, -(1 << 30), 1 << 29, 7, 0};
  EXPECT_EQ(device_.read(in_), DuplexEvent::Block);
  EXPECT_DOUBLE_EQ(in_[0], 50.0);
  EXPECT_DOUBLE_EQ(in_[1], 25.0);
  EXPECT_DOUBLE_EQ(in_[2], -25.0);
  EXPECT_DOUBLE_EQ(in_[3], 0.0);
  EXPECT_EQ(device_.write(commanded({2e-6, -1.0, 1e-6, 0.0})), DuplexEvent::Block);
  EXPECT_EQ(script_.out, (std::vector<std::int32_t>{0, 1 << 29, 0, 1 << 30, 0, 0, 0, -2147483647}));
}

TEST_F(Pcm, ALossEitherWayIsSaidAndItStreamsAgain) {
  ASSERT_TRUE(device_.open().ok());
  script_.reads = {kDuplexLost};
  EXPECT_EQ(device_.read(in_), DuplexEvent::Lost);
  EXPECT_EQ(device_.read(in_), DuplexEvent::Block);
  script_.writes = {kDuplexLost};
  EXPECT_EQ(device_.write(commanded({0.0, 0.0, 0.0, 0.0})), DuplexEvent::Lost);
  EXPECT_EQ(script_.restarted, 2);
}

TEST_F(Pcm, WhatDoesNotComeBackIsGone) {
  ASSERT_TRUE(device_.open().ok());
  script_.restarts = false;
  script_.reads = {kDuplexLost, kDuplexGone};
  EXPECT_EQ(device_.read(in_), DuplexEvent::Gone);
  EXPECT_EQ(device_.read(in_), DuplexEvent::Gone);
  EXPECT_EQ(script_.restarted, 1);
  EXPECT_EQ(device_.read(in_), DuplexEvent::Block);
  device_.stop();
  EXPECT_EQ(device_.read(in_), DuplexEvent::Gone);
}

TEST_F(Pcm, SaysWhyItCannotBeOpened) {
  script_.refuses = true;
  EXPECT_NE(device_.open().error().line().find("hw:9"), std::string::npos);
  PcmDuplexSettings mute = settings();
  mute.stroke[1] = 0.0;
  PcmDuplex broken(mute, std::make_unique<ScriptedDriver>(script_));
  EXPECT_FALSE(broken.open().ok());
}

}  // namespace
}  // namespace stillcut::active
