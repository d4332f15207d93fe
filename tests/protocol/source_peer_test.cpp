// Sources on real wires: a pty as the serial port, a socket, libiio's network protocol. Waits are in real time, and
// each is bounded.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "app/io/comedi_driver.h"
#include "app/io/find_machines.h"
#include "app/io/iio_driver.h"
#include "core/daq/binary_frames.h"
#include "core/daq/registry.h"
#include "tests/protocol/source_request.h"
#include "tests/support/fake_iiod.h"

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
    const int crystal = ::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC);  // of the device
    const itimerspec millisecond{{0, 1'000'000}, {0, 1'000'000}};
    ::timerfd_settime(crystal, 0, &millisecond, nullptr);
    std::uint64_t ticks = 0;  // a thread that was late makes up for them: the crystal went on
    for (unsigned n = 0; n < 20000 && !stopped_; ++n, --ticks) {
      if (ticks == 0 && ::read(crystal, &ticks, sizeof ticks) < 0) break;
      std::string one = frame(f, n);
      if (n % 1000 == 930) continue;
      if (n % 1000 == 960) one[9] ^= 1;
      bytes += one;
      while (bytes.size() >= piece) {
        if (::write(file, bytes.data(), piece) < 0) stopped_ = true;
        bytes.erase(0, piece);
        piece = piece % 37 + 1;
      }
    }
    ::close(crystal);
  }
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

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
    int blockFrames = 0;
    std::thread([&] {  // as in the program: another thread opens than reads, and has ended by then
      const auto format = (*source)->open();
      ASSERT_TRUE(format) << format.error().line();
      blockFrames = format->blockFrames;
    })
        .join();
    ASSERT_GT(blockFrames, 0);
    SampleBlock block;
    block.allocate(1, blockFrames);
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

// The kernel's folders, as they are with two adapters plugged in and a port of the board.
TEST(SerialSource, PortsAreListedWithTheirMakers) {
  char folder[] = "/tmp/stillcut-ports-XXXXXX";
  ASSERT_NE(::mkdtemp(folder), nullptr);
  const fs::path root = folder;
  fs::create_directories(root / "dev");
  for (const char* name : {"ttyUSB1", "ttyACM0", "ttyS0", "null"}) std::ofstream(root / "dev" / name) << "";
  const fs::path usb = root / "usb/1-1";
  fs::create_directories(usb / "1-1:1.0/tty");
  fs::create_directories(root / "class/ttyACM0");
  fs::create_directory_symlink(usb / "1-1:1.0", root / "class/ttyACM0/device");
  std::ofstream(usb / "manufacturer") << "Raspberry Pi\n";
  std::ofstream(usb / "product") << "Pico\n";
  const auto ports = app::serialPorts((root / "dev").string(), (root / "class").string());
  ASSERT_EQ(ports.size(), 2U);
  EXPECT_EQ(ports[0].device, (root / "dev/ttyACM0").string());
  EXPECT_EQ(ports[0].label, "Raspberry Pi Pico");
  EXPECT_EQ(ports[1].device, (root / "dev/ttyUSB1").string());
  EXPECT_EQ(ports[1].label, "");
  // A name that lasts goes before the number of the day, whichever of the two was typed.
  fs::create_directories(root / "dev/serial/by-id");
  const fs::path lasting = root / "dev/serial/by-id/usb-Raspberry_Pi_Pico-if00";
  fs::create_symlink("../../ttyACM0", lasting);
  fs::create_symlink("../../ttyACM7", root / "dev/serial/by-id/usb-gone");
  const auto named = app::serialPorts((root / "dev").string(), (root / "class").string());
  ASSERT_EQ(named.size(), 2U);
  EXPECT_EQ(named[0].device, lasting.string());
  EXPECT_EQ(named[0].label, "Raspberry Pi Pico");
  EXPECT_EQ(named[1].device, (root / "dev/ttyUSB1").string());
  EXPECT_EQ(app::lastingName((root / "dev/ttyACM0").string(), (root / "dev").string()), lasting.string());
  EXPECT_EQ(app::lastingName(lasting.string(), (root / "dev").string()), lasting.string());
  EXPECT_EQ(app::lastingName("/dev/no-such-port", (root / "dev").string()), "/dev/no-such-port");
  fs::remove_all(root);
}

// What a person types to be looked at: names stay, a subnet is all of its addresses, and none is larger than 256.
TEST(FindMachines, TypedHostsAndSubnets) {
  const auto named = app::hostsIn(" mill,192.168.1.8  fe80::1 ");
  ASSERT_TRUE(named.ok());
  EXPECT_EQ(*named, (std::vector<std::string>{"mill", "192.168.1.8", "fe80::1"}));
  const auto net = app::hostsIn("192.168.1.37/30");
  ASSERT_TRUE(net.ok());
  EXPECT_EQ(*net, (std::vector<std::string>{"192.168.1.36", "192.168.1.37", "192.168.1.38", "192.168.1.39"}));
  ASSERT_TRUE(app::hostsIn("10.1.2.0/24").ok());
  EXPECT_EQ(app::hostsIn("10.1.2.0/24")->size(), 256U);
  EXPECT_TRUE(app::hostsIn("")->empty());
  for (const char* wrong :
       {"10.0.0.0/8", "0.0.0.0/0", "10.0.0.0/33", "10.0.0.0/", "10.0.0/24", "mill/24", "1.2.3.4/2x"}) {
    const auto hosts = app::hostsIn(wrong);
    ASSERT_FALSE(hosts.ok()) << wrong;
    EXPECT_NE(hosts.error().line().find(wrong), std::string::npos);
  }
}

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

// Whatever way a device packs what it counts, it comes out as SI: the scale in the server's description is 0.001, which
// leads to m/s2, and to mV, mA.
TEST_F(IioTest, AnyFormatOfAChannelIsRead) {
  const auto counts = [](std::int64_t c) { return [c](int) { return static_cast<std::uint64_t>(c); }; };
  struct Case {
    testing::IioElement element;
    double si;
    std::string input = "0";
  };
  const std::vector<Case> cases = {
      {{"accel_x", "le:s12/16>>4", 2, counts(-5 * 16)}, -0.005},
      {{"accel_x", "be:s16/16>>0", 2, counts(-300), "", true}, -0.3},
      {{"accel_x", "le:u12/16>>0", 2, counts(4000)}, 4.0},
      {{"accel_x", "le:u32/32>>0", 4, counts(4'000'000'000)}, 4e6},
      {{"accel_x", "le:s64/64>>0", 8, counts(-(std::int64_t{1} << 60))}, -0.001 * std::ldexp(1.0, 60)},
      {{"accel_x", "le:s40/64>>8", 8, counts(-(std::int64_t{1} << 46))}, -0.001 * std::ldexp(1.0, 38)},
      {{"rot_quaternion", "le:s16/16X4>>0", 8, counts(0x0004'0003'0002'0001)}, 0.003, "2"},
      {{"current0", "le:s24/32>>0", 4, counts(8'388'000)}, 8.388},
      {{"voltage0", "le:u12/16>>0", 2, counts(1000), "-2048"}, -1.048e-3},
  };
  for (const Case& c : cases) {
    server_.elements = {c.element};
    auto source = make({{"inputs", c.input + "," + c.input}});
    ASSERT_TRUE(source) << source.error().line();
    const auto format = (*source)->open();
    ASSERT_TRUE(format) << c.element.format << ": " << format.error().line();
    SampleBlock block;
    block.allocate(2, format->blockFrames);
    ASSERT_TRUE((*source)->read(block));
    const double si = static_cast<double>(block.channel(0)[7]) * format->channels[0].scale;
    EXPECT_NEAR(si, c.si, 1e-5 * std::abs(c.si)) << c.element.id << " " << c.element.format;
  }
}

// Twenty scans (0.8 ms) before scan 3000 never came, within one buffer: only the time stamps tell.
TEST_F(IioTest, ALossThatItsTimeStampsShowBeginsABlock) {
  server_.elements = {{"accel_x", "le:s64/64>>0", 8, [](int n) { return static_cast<std::uint64_t>(n) << 40; }},
                      {"timestamp", "le:s64/64>>0", 8,
                       [](int n) { return (n + (n >= 3000 ? 20U : 0U)) * std::uint64_t{390625} / 10; }}};
  auto source = make({{"inputs", "0,0"}});
  ASSERT_TRUE(source) << source.error().line();
  const auto format = (*source)->open();
  ASSERT_TRUE(format) << format.error().line();
  SampleBlock block;
  block.allocate(2, format->blockFrames);
  std::vector<double> begins;
  for (int k = 0; k < 5000 / format->blockFrames; ++k) {
    ASSERT_TRUE((*source)->read(block));
    if (block.has(kBlockGap)) begins.push_back(static_cast<double>(block.channel(0)[0]) * std::ldexp(1.0, 23));
  }
  EXPECT_EQ(begins, std::vector<double>{3000.0});
}

// A device that samples only when its trigger says so: without one the line says what it may need, with it it streams.
TEST_F(IioTest, StreamsAtItsTriggersPace) {
  server_.triggered = true;
  EXPECT_NE(problemOf({}).find("some devices need a 'trigger'"), std::string::npos) << problemOf({});
  EXPECT_EQ(problemOf({{"trigger", "clock"}}),
            "source 'iio' device 'adxl': there is no trigger 'clock' at ip:127.0.0.1 (there are: timer)");
  EXPECT_NE(problemOf({{"trigger", "temperature"}}).find("there is no trigger 'temperature'"), std::string::npos);
  auto source = make({{"trigger", "timer"}});
  ASSERT_TRUE(source) << source.error().line();
  const auto format = (*source)->open();
  ASSERT_TRUE(format) << format.error().line();
  EXPECT_TRUE(server_.hasTrigger);
  SampleBlock block;
  block.allocate(2, format->blockFrames);
  ASSERT_TRUE((*source)->read(block));
  EXPECT_EQ(block.frames, format->blockFrames);
}

TEST_F(IioTest, WhatIsNotThereIsOneLineWithWhatIs) {
  EXPECT_EQ(problemOf({{"device", "adis"}}),
            "source 'iio' device 'adis': is not at ip:127.0.0.1 (there are: adxl, temperature)");
  EXPECT_EQ(problemOf({{"inputs", "0,5"}}),
            "source 'iio' device 'adxl': has no input 5 ('inputs') (it has, from 0: accel_x, accel_y, accel_z)");
  const std::string rate = problemOf({{"rate_hz", "8000"}});
  EXPECT_NE(rate.find("'rate_hz' = 8000 is not among its rates"), std::string::npos) << rate;
  EXPECT_NE(rate.find("could at 12800 25600"), std::string::npos) << rate;
  EXPECT_NE(problemOf({{"uri", "ip:127.0.0.2"}}).find("'uri' = 'ip:127.0.0.2': does not answer"), std::string::npos);
  const auto found = app::iioDevices("ip:127.0.0.1");
  ASSERT_TRUE(found);
  const auto& devices = *found;
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
