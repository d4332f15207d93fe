// The calibrator from the command line: a recording of its tone, and a device that hears it and whose profile is set
// right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numbers>
#include <thread>

#include "tests/component/cli/made_files.h"
#include "tests/component/cli/program.h"
#include "tests/support/temp_folder.h"

namespace stillcut::cli_test {
namespace {

using testing::HasSubstr;

constexpr double kRms = 0.02;  // of the tone [device units]

double toneAt(int frame, double rate) {
  return std::numbers::sqrt2 * kRms * std::sin(2.0 * std::numbers::pi * 1000.0 * frame / rate);
}

std::vector<float> tone() {
  std::vector<float> x(static_cast<std::size_t>(3.0 * kRate));
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<float>(toneAt(static_cast<int>(i), kRate));
  return x;
}

// A bridge that sends the tone as text, to whoever connects, until it is destroyed.
class Bridge {
 public:
  Bridge() {
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    good_ = ::bind(socket_, reinterpret_cast<sockaddr*>(&address), length) == 0 && ::listen(socket_, 4) == 0 &&
            ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &length) == 0;
    port_ = ntohs(address.sin_port);
    if (good_) thread_ = std::thread([this] { serve(); });
  }
  ~Bridge() {
    ::shutdown(socket_, SHUT_RDWR);
    if (thread_.joinable()) thread_.join();
    ::close(socket_);
  }
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;
  bool good() const { return good_; }
  int port() const { return port_; }

 private:
  void serve() {
    while (true) {
      const int client = ::accept(socket_, nullptr, nullptr);
      if (client < 0) return;
      std::string lines;
      for (int frame = 0;; frame += 80) {
        lines.clear();
        for (int i = 0; i < 80; ++i) {
          char line[32];
          std::snprintf(line, sizeof line, "%.9f\n", toneAt(frame + i, 8000.0));
          lines += line;
        }
        if (::send(client, lines.data(), lines.size(), MSG_NOSIGNAL) < 0) break;
      }
      ::close(client);
    }
  }
  int socket_ = -1;
  bool good_ = false;
  int port_ = 0;
  std::thread thread_;
};

TEST(Calibrate, ARecordingOfTheToneGivesTheScale) {
  const record::TempFolder folder;
  writeSound(folder / "tone.wav", {std::vector<float>(tone().size(), 0.0F), tone()});
  const Outcome pascal = runCli(folder / "", {"calibrate", "tone.wav", "--channel", "1", "--level", "94 dB"});
  EXPECT_EQ(pascal.exitCode, 0) << pascal.err;
  EXPECT_THAT(pascal.out, HasSubstr("a tone of 1000.00 Hz"));
  EXPECT_THAT(pascal.out, HasSubstr("scale 50.11"));
  const Outcome wrong = runCli(folder / "", {"calibrate", "tone.wav", "--level", "94 dB"});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_EQ(wrong.err, "stillcut-cli: calibrator: there is no signal (is the sensor connected?)\n");
}

TEST(Calibrate, TheDeviceOfAProfileIsHeardAndItsChannelSetRight) {
  const record::TempFolder folder;
  const Bridge bridge;
  ASSERT_TRUE(bridge.good());
  folder.file("mill.toml",
              "version = 1\nmachine = \"M\"\n[tool]\nteeth = 4\n[[channels]]\nname = \"x\"\nquantity = "
              "\"acceleration\"\nsensitivity_mv = 102\nvolts = 10\n[source]\nid = \"tcp\"\n"
              "[source.settings]\nhost = \"127.0.0.1\"\nport = " +
                  std::to_string(bridge.port()) + "\nrate_hz = 8000\nformat = \"text\"\n");
  const std::vector<std::string> arguments{"calibrate", "--profile", "mill.toml", "--level", "1 g", "--seconds", "2"};
  const Outcome heard = runCli(folder / "", arguments);
  ASSERT_EQ(heard.exitCode, 0) << heard.err;
  // 0.02 of 10 V is 1 g: 200 mV/g.
  EXPECT_THAT(heard.out, HasSubstr("; 200 mV per unit"));
  std::vector<std::string> saving = arguments;
  saving.emplace_back("--save");
  ASSERT_EQ(runCli(folder / "", saving).exitCode, 0);
  std::ifstream in(folder / "mill.toml");
  const std::string saved{std::istreambuf_iterator<char>(in), {}};
  const std::string key = "sensitivity_mv = ";
  ASSERT_THAT(saved, HasSubstr(key));
  EXPECT_NEAR(std::stod(saved.substr(saved.find(key) + key.size())), 200.0, 1e-3);
  EXPECT_THAT(runCli(folder / "", arguments).out, HasSubstr("0.00 %)"));
}

TEST(Calibrate, WhatIsWrongIsOneLine) {
  const record::TempFolder folder;
  writeSound(folder / "tone.wav", {tone()});
  const auto line = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"calibrate"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = runCli(folder / "", arguments);
    EXPECT_EQ(outcome.exitCode, 2) << spelled(arguments);
    return outcome.err;
  };
  EXPECT_THAT(line({"--level", "1"}), HasSubstr("nothing to measure"));
  EXPECT_THAT(line({"tone.wav", "--level", "much"}), HasSubstr("'much' is none (rms in Pa, or as \"94 dB\")"));
  EXPECT_THAT(line({"tone.wav", "--level", "1", "--save"}), HasSubstr("--save: needs --profile"));
  EXPECT_THAT(line({"tone.wav", "--level", "1", "--channel", "4"}), HasSubstr("4"));
  EXPECT_THAT(line({"tone.wav", "--level", "1", "--frequency", "400"}), HasSubstr("near 400 Hz"));
}

}  // namespace
}  // namespace stillcut::cli_test
