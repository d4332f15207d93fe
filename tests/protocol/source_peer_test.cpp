// Sources on real wires: a pty as the serial port, a socket, and PulseAudio null sinks through ALSA's pulse plugin,
// which stand in for audio-class devices. Waits are in real time, and each is bounded.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#ifdef STILLCUT_ALSA
#include <alsa/asoundlib.h>
#endif

#include "app/io/alsa_driver.h"
#include "app/io/comedi_driver.h"
#include "app/io/iio_driver.h"
#include "app/io/wires.h"
#include "core/daq/binary_frames.h"
#include "core/daq/registry.h"
#include "tests/protocol/fake_iiod.h"

namespace stillcut::daq {
namespace {

namespace fs = std::filesystem;

std::string frame(const FrameFormat& f, unsigned number) {
  std::string covered;
  covered += static_cast<char>(number);
  covered += static_cast<char>(number >> 8);
  for (int i = 0; i < f.instants; ++i) {
    const unsigned value = (number * static_cast<unsigned>(f.instants) + static_cast<unsigned>(i)) & 0x7FFF;
    covered += static_cast<char>(value);
    covered += static_cast<char>(value >> 8);
  }
  const std::uint32_t sum = checksumOf(f.checksum, covered);
  covered += static_cast<char>(sum);
  covered += static_cast<char>(sum >> 8);
  return f.sync + covered;
}

// 2000 frames of 8 instants, a millisecond each, in pieces of 1 to 37 bytes; 30 to 32 are lost, 60 is damaged.
class Sender {
 public:
  explicit Sender(int file) : thread_([this, file] { run(file); }) {}
  ~Sender() {
    stopped_ = true;
    thread_.join();
  }
  Sender(const Sender&) = delete;
  Sender& operator=(const Sender&) = delete;

 private:
  void run(int file) {
    FrameFormat f;
    f.sync = "\xAA\x55";
    f.counterBytes = 2;
    f.instants = 8;
    f.checksum = Checksum::Crc16;
    std::string bytes;
    std::size_t piece = 1;
    for (unsigned n = 0; n < 20000 && !stopped_; ++n) {
      std::string one = frame(f, n);
      if (n % 1000 == 930) continue;
      if (n % 1000 == 960) one[9] ^= 1;
      bytes += one;
      while (bytes.size() >= piece) {
        if (::write(file, bytes.data(), piece) < 0) return;
        bytes.erase(0, piece);
        piece = piece % 37 + 1;
      }
      ::usleep(1000);
    }
  }
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

SourceRequest requestOn(const Clock& clock, std::map<std::string, std::string> settings) {
  SourceRequest request;
  request.channels.resize(1);
  request.wires = app::makeWire;
  request.pcm = app::makeAlsaDriver;
  request.clock = &clock;
  request.settings = std::move(settings);
  return request;
}

TEST(SerialSource, ReadsAPortThroughSplitLostAndDamagedBytes) {
  int master = -1;
  int slave = -1;
  char path[256];
  termios raw{};
  ::cfmakeraw(&raw);
  ASSERT_EQ(::openpty(&master, &slave, path, &raw, nullptr), 0);
  SteadyClock clock;
  auto source = makeSource("serial", requestOn(clock, {{"device", path},
                                                       {"baud", "921600"},
                                                       {"rate_hz", "8000"},
                                                       {"sync", "AA 55"},
                                                       {"counter", "u16"},
                                                       {"instants", "8"},
                                                       {"checksum", "crc16"}}));
  ASSERT_TRUE(source) << source.error().line();
  std::uint64_t lost = 0;
  int frames = 0;
  {
    const Sender sender(master);
    const auto format = (*source)->open();
    ASSERT_TRUE(format) << format.error().line();
    SampleBlock block;
    block.allocate(1, format->blockFrames);
    float expected = -1.0F;
    const Instant end = clock.now() + std::chrono::seconds(4);
    while (clock.now() < end) {
      ASSERT_TRUE((*source)->read(block));
      lost += block.lostFrames;
      EXPECT_EQ(block.has(kBlockGap), block.lostFrames > 0);
      if (expected >= 0.0F) expected = std::fmod(expected + static_cast<float>(block.lostFrames), 32768.0F);
      for (const float v : block.channel(0)) {
        if (expected >= 0.0F) {
          ASSERT_EQ(v, expected);
        }
        expected = std::fmod(v + 1.0F, 32768.0F);
      }
      frames += block.frames;
    }
    (*source)->stop();
  }
  EXPECT_GT(frames, 2000);
  EXPECT_EQ(lost % 8, 0U);
  EXPECT_GT(lost, 0U);
  ::close(slave);
  ::close(master);
}

TEST(SerialSource, APortThatIsNotThereIsOneLine) {
  SteadyClock clock;
  auto source = makeSource(
      "serial", requestOn(clock, {{"device", "/dev/no-such-port"}, {"rate_hz", "8000"}, {"format", "text"}}));
  ASSERT_TRUE(source);
  const auto opened = (*source)->open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().line(), "source 'serial' at /dev/no-such-port: cannot be opened (is it there, and free?)");
}

#ifdef STILLCUT_ALSA
// A PulseAudio server of this test's own with one null sink; what is played to it is heard at its monitor.
class PulseTest : public ::testing::Test {
 protected:
  static constexpr int kRate = 96000;
  static constexpr int kChannels = 4;

  void SetUp() override {
    if (std::system("command -v pulseaudio >/dev/null") != 0) GTEST_SKIP() << "pulseaudio is not installed";
    if (std::system("ls /usr/lib/*/alsa-lib/libasound_module_pcm_pulse.so >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "libasound2-plugins is not installed";
    }
    char folder[] = "/tmp/stillcut-pulse-XXXXXX";
    ASSERT_NE(::mkdtemp(folder), nullptr);
    folder_ = folder;
    const std::string socket = (folder_ / "socket").string();
    std::ofstream(folder_ / "alsa.conf") << "</usr/share/alsa/alsa.conf>\n"
                                         << "pcm.heard { type pulse server \"unix:" << socket
                                         << "\" device \"null4.monitor\" }\n"
                                         << "pcm.played { type pulse server \"unix:" << socket
                                         << "\" device \"null4\" }\n";
    ::setenv("ALSA_CONFIG_PATH", (folder_ / "alsa.conf").c_str(), 1);
    ::setenv("XDG_RUNTIME_DIR", folder, 1);
    ::setenv("HOME", folder, 1);
    pid_ = ::fork();
    if (pid_ == 0) {
      const std::string listen = "--load=module-native-protocol-unix auth-anonymous=1 socket=" + socket;
      const std::string sink = "--load=module-null-sink sink_name=null4 format=s32le rate=" + std::to_string(kRate) +
                               " channels=" + std::to_string(kChannels) +
                               " channel_map=front-left,front-right,rear-left,rear-right";
      ::execlp("pulseaudio", "pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "--log-target=null",
               listen.c_str(), sink.c_str(), static_cast<char*>(nullptr));
      ::_exit(127);
    }
    for (int i = 0; i < 100 && !fs::exists(socket); ++i) ::usleep(50000);
    if (!fs::exists(socket)) GTEST_SKIP() << "pulseaudio does not start here";
  }
  void TearDown() override {
    if (pid_ > 0) {
      ::kill(pid_, SIGTERM);
      ::waitpid(pid_, nullptr, 0);
    }
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  fs::path folder_;
  pid_t pid_ = -1;
};

// Plays frame n of channel c as (n * 4 + c) in the upper 24 bits, until it is destroyed.
class Player {
 public:
  Player() : thread_([this] { run(); }) {}
  ~Player() {
    stopped_ = true;
    thread_.join();
  }
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;
  std::string problem;

 private:
  void run() {
    snd_pcm_t* pcm = nullptr;
    if (::snd_pcm_open(&pcm, "played", SND_PCM_STREAM_PLAYBACK, 0) < 0) {
      problem = "cannot play";
      return;
    }
    ::snd_pcm_set_params(pcm, SND_PCM_FORMAT_S32_LE, SND_PCM_ACCESS_RW_INTERLEAVED, 4, 96000, 0, 200000);
    std::vector<std::int32_t> out(4 * 960);
    for (std::uint32_t n = 1; !stopped_;) {
      for (std::size_t f = 0; f < 960; ++f, ++n) {
        for (std::uint32_t c = 0; c < 4; ++c) out[4 * f + c] = static_cast<std::int32_t>(((n * 4 + c) & 0x7FFFFF) << 8);
      }
      if (::snd_pcm_writei(pcm, out.data(), 960) < 0) ::snd_pcm_prepare(pcm);
    }
    ::snd_pcm_close(pcm);
  }
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

TEST_F(PulseTest, TwentyFourBitsArriveInOrderOnTheirOwnChannels) {
  SteadyClock clock;
  SourceRequest request = requestOn(clock, {{"device", "heard"}, {"rate_hz", "96000"}, {"inputs", "0,1,2,3"}});
  request.channels.resize(kChannels);
  auto source = makeSource("alsa", request);
  ASSERT_TRUE(source) << source.error().line();
  const auto format = (*source)->open();
  ASSERT_TRUE(format) << format.error().line();
  const Player player;
  SampleBlock block;
  block.allocate(kChannels, format->blockFrames);
  std::int64_t expected = -1;
  long counted = 0;
  Instant first{};
  const Instant end = clock.now() + std::chrono::seconds(15);
  while (counted < 2L * kRate && clock.now() < end) {
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
  EXPECT_EQ(player.problem, "");
  ASSERT_GE(counted, 2L * kRate);
  EXPECT_NEAR(secondsBetween(first, block.end()).value, static_cast<double>(counted) / kRate, 0.05);
}

TEST_F(PulseTest, ARateOrAChannelThatIsNotThereIsOneLine) {
  SteadyClock clock;
  auto source = makeSource("alsa", requestOn(clock, {{"device", "heard"}, {"inputs", "31"}, {"bits", "16"}}));
  ASSERT_TRUE(source) << source.error().line();
  auto absent = makeSource("alsa", requestOn(clock, {{"device", "hw:77"}}));
  ASSERT_TRUE(absent);
  const auto opened = (*absent)->open();
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().line().find("'device' = 'hw:77': cannot be opened"), std::string::npos);
}
#endif

TEST(ComediSource, ACardThatIsNotThereIsOneLine) {
  if (!app::makeComediDriver(0, 0)) GTEST_SKIP() << "this build has no Comedi";
  SteadyClock clock;
  SourceRequest request = requestOn(clock, {{"device", "/dev/comedi77"}, {"rate_hz", "25600"}});
  request.comedi = app::makeComediDriver;
  auto source = makeSource("comedi", request);
  ASSERT_TRUE(source) << source.error().line();
  const auto opened = (*source)->open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().line(),
            "source 'comedi' 'device' = '/dev/comedi77': cannot be opened (No such file or directory)");
}

class IioTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!app::makeIioDriver("", "")) GTEST_SKIP() << "this build has no libiio";
    if (!server_.good()) GTEST_SKIP() << "port 30431 is taken";
  }
  Result<std::unique_ptr<DaqSource>> make(std::map<std::string, std::string> settings) {
    settings.emplace("uri", "ip:127.0.0.1");
    settings.emplace("device", "adxl");
    settings.emplace("rate_hz", "25600");
    SourceRequest request = requestOn(clock_, std::move(settings));
    request.iio = app::makeIioDriver;
    request.channels.resize(2);
    return makeSource("iio", request);
  }
  std::string problemOf(std::map<std::string, std::string> settings) {
    auto source = make(std::move(settings));
    if (!source) return source.error().line();
    const auto opened = (*source)->open();
    return opened ? "" : opened.error().line();
  }
  SteadyClock clock_;
  testing::FakeIiod server_;
};

TEST_F(IioTest, StreamsWhatTheServerSendsAndComesBackAfterItHangsUp) {
  auto source = make({{"inputs", "0,2"}});
  ASSERT_TRUE(source) << source.error().line();
  server_.hangUpAfter = 50;
  const auto format = (*source)->open();
  ASSERT_TRUE(format) << format.error().line();
  EXPECT_EQ(format->rate.value, 25600.0);
  EXPECT_NEAR(format->channels[0].scale, 0.001 * 8388608.0, 1e-2);
  SampleBlock block;
  block.allocate(2, format->blockFrames);
  int expected = 0;
  int gaps = 0;
  for (int k = 0; k < 100; ++k) {
    ASSERT_TRUE((*source)->read(block));
    if (k == 50) {
      EXPECT_TRUE(block.has(kBlockGap));
      expected = 0;  // the server begins anew
    }
    gaps += block.has(kBlockGap) ? 1 : 0;
    for (std::size_t f = 0; f < static_cast<std::size_t>(block.frames); ++f, ++expected) {
      ASSERT_EQ(block.channel(0)[f] * 8388608.0F, static_cast<float>(3 * expected)) << k;
      ASSERT_EQ(block.channel(1)[f] * 8388608.0F, static_cast<float>(3 * expected + 2)) << k;
    }
  }
  EXPECT_EQ(gaps, 1);
}

TEST_F(IioTest, WhatIsNotThereIsOneLineWithWhatIs) {
  EXPECT_EQ(problemOf({{"device", "adis"}}), "source 'iio' device 'adis': is not at ip:127.0.0.1 (there are: adxl)");
  EXPECT_EQ(problemOf({{"inputs", "0,5"}}),
            "source 'iio' device 'adxl': has no input 5 ('inputs') (it has, from 0: accel_x, accel_y, accel_z)");
  const std::string rate = problemOf({{"rate_hz", "8000"}});
  EXPECT_NE(rate.find("'rate_hz' = 8000 is not among its rates"), std::string::npos) << rate;
  EXPECT_NE(rate.find("could at 12800 25600"), std::string::npos) << rate;
  EXPECT_NE(problemOf({{"uri", "ip:127.0.0.2"}}).find("'uri' = 'ip:127.0.0.2': does not answer"), std::string::npos);
  const auto devices = app::iioDevices("ip:127.0.0.1");
  ASSERT_EQ(devices.size(), 1U);
  EXPECT_EQ(devices[0].name, "adxl");
  EXPECT_NE(devices[0].range.find("accel_x, accel_y, accel_z"), std::string::npos);
}

}  // namespace
}  // namespace stillcut::daq

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const auto events = stillcut::app::wireEvents();
  return RUN_ALL_TESTS();
}
