// A Modbus TCP server of holding registers whose replies a test can delay, split, merge, garble, put out of order,
// close upon and withhold. A fluent script: server.script([](auto& s) { s.delay(30).split(1); }).
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace stillcut::cnc::testing {

struct ModbusScript {
  int delayMs = 0;
  std::size_t piece = 0;  // bytes of one segment; 0: all
  std::string noise;      // before every reply
  bool twice = false;     // each reply together with the one before
  bool stale = false;     // the one before, then this one
  bool hangUp = false;    // in the middle of every reply
  bool silent = false;

  ModbusScript& delay(int ms) { return delayMs = ms, *this; }
  ModbusScript& split(std::size_t bytes) { return piece = bytes, *this; }
  ModbusScript& garbage(std::string bytes) { return noise = std::move(bytes), *this; }
  ModbusScript& merge() { return twice = true, *this; }
  ModbusScript& wrongOrder() { return stale = true, *this; }
  ModbusScript& close() { return hangUp = true, *this; }
  ModbusScript& hang() { return silent = true, *this; }
};

class ScriptedModbus {
 public:
  ScriptedModbus() {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place;
    auto* const address = reinterpret_cast<sockaddr*>(&place);
    if (::bind(listener_, address, size) != 0 || ::listen(listener_, 4) != 0) return;
    ::getsockname(listener_, address, &size);
    port_ = ntohs(place.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  ~ScriptedModbus() {
    stopped_ = true;
    if (thread_.joinable()) thread_.join();
    hangUp();
    ::close(listener_);
  }
  ScriptedModbus(const ScriptedModbus&) = delete;
  ScriptedModbus& operator=(const ScriptedModbus&) = delete;

  int port() const { return port_; }  // 0: it does not run
  template <class Change>
  void script(Change&& change) {
    const std::lock_guard lock(mutex_);
    script_ = {};
    change(script_);
  }
  int holding(int address) {
    const std::lock_guard lock(mutex_);
    return words_[static_cast<std::size_t>(address)];
  }
  void put(int address, int value) {
    const std::lock_guard lock(mutex_);
    words_[static_cast<std::size_t>(address)] = static_cast<std::uint16_t>(value);
  }

 private:
  static constexpr std::size_t kHead = 7;  // transaction, protocol, length, unit

  void hangUp() {
    if (client_ >= 0) ::close(client_);
    client_ = -1;
    heard_.clear();
  }
  void serve() {
    while (!stopped_) {
      std::array<pollfd, 2> waits{{{listener_, POLLIN, 0}, {client_, POLLIN, 0}}};
      if (::poll(waits.data(), client_ >= 0 ? 2 : 1, 20) <= 0) continue;
      if (waits[0].revents != 0) {
        hangUp();
        client_ = ::accept(listener_, nullptr, nullptr);
        const int on = 1;
        ::setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
      } else if (client_ >= 0 && waits[1].revents != 0) {
        hear();
      }
    }
  }
  void hear() {
    std::array<char, 512> bytes;
    const auto n = ::recv(client_, bytes.data(), bytes.size(), 0);
    if (n <= 0) return hangUp();
    heard_.append(bytes.data(), static_cast<std::size_t>(n));
    while (heard_.size() >= kHead) {
      const std::size_t size = 6 + static_cast<std::size_t>(number(heard_, 4));
      if (heard_.size() < size) return;
      const std::string request = heard_.substr(0, size);
      heard_.erase(0, size);
      reply(request);
    }
  }
  static int number(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]) * 256 + static_cast<unsigned char>(bytes[at + 1]);
  }
  static std::string word(int value) { return {static_cast<char>(value / 256), static_cast<char>(value % 256)}; }

  // Function, then data.
  std::string act(std::string_view request) {
    const int function = static_cast<unsigned char>(request[kHead]);
    const auto first = static_cast<std::size_t>(number(request, kHead + 1)) % words_.size();
    if (function == 3) {
      const int count = number(request, kHead + 3);
      std::string data{static_cast<char>(3), static_cast<char>(2 * count)};
      for (int i = 0; i < count; ++i) data += word(words_[(first + static_cast<std::size_t>(i)) % words_.size()]);
      return data;
    }
    if (function != 6 && function != 16) return {static_cast<char>(function | 0x80), 1};
    words_[first] = static_cast<std::uint16_t>(number(request, function == 6 ? kHead + 3 : kHead + 6));
    return std::string(request.substr(kHead, 5));
  }
  void reply(const std::string& request) {
    const std::lock_guard lock(mutex_);
    const std::string data = act(request);
    const std::string whole = request.substr(0, 4) + word(static_cast<int>(data.size()) + 1) + request[6] + data;
    const std::string before = std::exchange(last_, whole);
    const ModbusScript s = script_;
    if (s.silent) return;
    if (s.delayMs > 0) ::poll(nullptr, 0, s.delayMs);
    if (s.hangUp) {
      send(whole.substr(0, whole.size() / 2), s.piece);
      return hangUp();
    }
    send(s.noise + (s.stale ? before : "") + whole + (s.twice ? before : ""), s.piece);
  }
  void send(const std::string& bytes, std::size_t piece) const {
    for (std::size_t at = 0; at < bytes.size(); at += piece == 0 ? bytes.size() : piece) {
      const std::string part = bytes.substr(at, piece == 0 ? bytes.size() : piece);
      ::send(client_, part.data(), part.size(), MSG_NOSIGNAL);
    }
  }

  int listener_ = -1, client_ = -1, port_ = 0;
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  ModbusScript script_;
  std::array<std::uint16_t, 16> words_{};
  std::string heard_, last_;
  std::thread thread_;
};

}  // namespace stillcut::cnc::testing
