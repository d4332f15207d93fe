// Devices whose cable can be pulled and put back, each behind the program's own way to it: a serial port (pty), a
// socket and libiio's network protocol. Thread: start(), unplug() and plug() on one; each streams on threads of its
// own.
#pragma once

#include <fcntl.h>
#include <netinet/in.h>
#include <pty.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include "core/daq/binary_frames.h"
#include "tests/support/fake_iiod.h"

namespace stillcut::testing {

class Peer {
 public:
  Peer() = default;
  virtual ~Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  // Empty: it is there; else why not.
  virtual std::string plug() = 0;
  virtual void unplug() = 0;
  virtual const char* source() const = 0;
  virtual std::map<std::string, std::string> settings() const = 0;
};

// Frames of eight instants of two channels of 16 bits, counted and with a CRC, a millisecond each, as long as they are
// taken.
class FrameSender {
 public:
  explicit FrameSender(int file) : file_(file) {
    ::fcntl(file, F_SETFL, O_NONBLOCK);
    thread_ = std::thread([this] { run(); });
  }
  ~FrameSender() {
    stopped_ = true;
    thread_.join();
    ::close(file_);
  }
  FrameSender(const FrameSender&) = delete;
  FrameSender& operator=(const FrameSender&) = delete;
  static std::map<std::string, std::string> settings() {
    return {{"rate_hz", "8000"}, {"sync", "AA55"}, {"counter", "u16"}, {"instants", "8"}, {"checksum", "crc16"}};
  }

 private:
  void run() const {
    const int crystal = ::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC);
    const itimerspec millisecond{{0, 1'000'000}, {0, 1'000'000}};
    ::timerfd_settime(crystal, 0, &millisecond, nullptr);
    std::uint64_t ticks = 0;  // a thread that was late makes up for them
    std::uint32_t state = 1;
    for (unsigned n = 0; !stopped_; ++n, --ticks) {
      if (ticks == 0 && ::read(crystal, &ticks, sizeof ticks) < 0) break;
      std::string covered{static_cast<char>(n), static_cast<char>(n >> 8)};
      for (int value = 0; value < 16; ++value) {
        state = state * 1664525U + 1013904223U;
        covered += static_cast<char>(state >> 24);
        covered += static_cast<char>(static_cast<std::int8_t>(state >> 16) / 4);
      }
      const std::uint32_t sum = daq::checksumOf(daq::Checksum::Crc16, covered);
      const std::string frame = "\xAA\x55" + covered + static_cast<char>(sum) + static_cast<char>(sum >> 8);
      // What nobody takes is lost, as in a device.
      if (::write(file_, frame.data(), frame.size()) < 0 && errno != EAGAIN) break;
    }
    ::close(crystal);
  }
  int file_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

// A new port every time, under the same name, as udev makes one.
class SerialPeer final : public Peer {
 public:
  SerialPeer() {
    char folder[] = "/tmp/stillcut-serial-XXXXXX";
    if (::mkdtemp(folder) != nullptr) folder_ = folder;
  }
  ~SerialPeer() override {
    SerialPeer::unplug();
    std::filesystem::remove_all(folder_);
  }
  std::string plug() override {
    int master = -1;
    char path[256];
    termios raw{};
    ::cfmakeraw(&raw);
    if (::openpty(&master, &slave_, path, &raw, nullptr) != 0) return "no pty can be opened";
    std::filesystem::create_symlink(path, port());
    sender_ = std::make_unique<FrameSender>(master);
    return {};
  }
  void unplug() override {
    std::filesystem::remove(port());
    if (slave_ >= 0) ::close(slave_);
    slave_ = -1;
    sender_.reset();  // the other end hangs up
  }
  const char* source() const override { return "serial"; }
  std::map<std::string, std::string> settings() const override {
    auto all = FrameSender::settings();
    all.emplace("device", port());
    all.emplace("baud", "921600");
    return all;
  }

 private:
  std::string port() const { return folder_ / "port"; }
  std::filesystem::path folder_;
  int slave_ = -1;  // kept open, so that what nobody reads yet waits
  std::unique_ptr<FrameSender> sender_;
};

// A bridge that goes away with its listening socket.
class SocketPeer final : public Peer {
 public:
  ~SocketPeer() override { SocketPeer::unplug(); }
  std::string plug() override {
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port_);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (::bind(socket_, reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(socket_, 1) != 0 ||
        ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      return "no port can be opened";
    }
    port_ = ntohs(address.sin_port);
    accepting_ = std::thread([this] {
      for (int client = 0; (client = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC)) >= 0;) {
        sender_ = std::make_unique<FrameSender>(client);
      }
    });
    return {};
  }
  void unplug() override {
    if (!accepting_.joinable()) return;
    ::shutdown(socket_, SHUT_RDWR);
    accepting_.join();
    sender_.reset();
    ::close(socket_);
  }
  const char* source() const override { return "tcp"; }
  std::map<std::string, std::string> settings() const override {
    auto all = FrameSender::settings();
    all.emplace("host", "127.0.0.1");
    all.emplace("port", std::to_string(port_));
    return all;
  }

 private:
  int socket_ = -1;
  std::uint16_t port_ = 0;  // the system's choice, then the same
  std::thread accepting_;
  std::unique_ptr<FrameSender> sender_;
};

class IioPeer final : public Peer {
 public:
  std::string plug() override {
    server_ = std::make_unique<FakeIiod>();
    server_->paced = true;
    server_->elements.clear();
    for (const char* axis : {"accel_x", "accel_y"}) {
      const std::uint64_t other = axis[6] == 'x' ? 1664525U : 22695477U;
      server_->elements.push_back({axis, "le:s24/32>>0", 4, [other](int n) {
                                     return (static_cast<std::uint64_t>(n) * other * 2654435761U >> 20) % 65536U;
                                   }});
    }
    return server_->good() ? "" : "another iiod is running";
  }
  void unplug() override { server_.reset(); }
  const char* source() const override { return "iio"; }
  std::map<std::string, std::string> settings() const override {
    return {{"device", "adxl"}, {"uri", "ip:127.0.0.1"}, {"rate_hz", "25600"}};
  }

 private:
  std::unique_ptr<FakeIiod> server_;
};

}  // namespace stillcut::testing
