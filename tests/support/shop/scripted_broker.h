// A broker that says what a test tells it to: it takes connections and their packets (MQTT 3.1.1), and hands them out.
// It answers nothing by itself. Thread: that of the test.
#pragma once

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/delay_proxy.h"

namespace stillcut::shop::testing {

class ScriptedBroker {
 public:
  enum Type : std::uint8_t { Connect = 1, Publish = 3, PubRel = 6, Disconnect = 14 };
  struct Packet {
    std::uint8_t type = 0, flags = 0;
    std::string body;
    // Of PUBLISH (whose quality of service is not 0) and PUBREL.
    std::string number() const {
      const std::size_t at = type == Publish ? 2 + static_cast<std::uint8_t>(body[1]) : 0;
      return body.substr(at, 2);
    }
    int quality() const { return flags >> 1 & 3; }
  };

  ScriptedBroker() : listener_(cnc::testing::listenOnLoopback(port_)) {}
  ~ScriptedBroker() {
    hangUp();
    ::close(listener_);
  }
  ScriptedBroker(const ScriptedBroker&) = delete;
  ScriptedBroker& operator=(const ScriptedBroker&) = delete;
  int port() const { return port_; }
  int connections() const { return connections_; }

  // The packets that came since the last look. A client that hung up is forgotten; the next one is taken.
  std::vector<Packet> heard() {
    std::vector<Packet> all;
    if (socket_ < 0) {
      socket_ = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      connections_ += socket_ >= 0 ? 1 : 0;
    }
    std::array<char, 4096> bytes;
    ssize_t n = 0;
    while (socket_ >= 0 && (n = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT)) > 0)
      in_.append(bytes.data(), static_cast<std::size_t>(n));
    while (take(all)) {
    }
    if (socket_ >= 0 && n == 0) hangUp();
    return all;
  }
  void say(std::uint8_t first, const std::string& body) const {
    const std::string packet = std::string{static_cast<char>(first), static_cast<char>(body.size())} + body;
    if (socket_ >= 0) ::send(socket_, packet.data(), packet.size(), MSG_NOSIGNAL);
  }
  void welcome(bool sessionKept) const { say(0x20, {static_cast<char>(sessionKept ? 1 : 0), '\0'}); }
  void hangUp() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
    in_.clear();
  }

 private:
  bool take(std::vector<Packet>& all) {
    std::size_t at = 1, length = 0;
    for (int shift = 0;; shift += 7) {
      if (at >= in_.size()) return false;
      const auto byte = static_cast<std::uint8_t>(in_[at++]);
      length |= static_cast<std::size_t>(byte & 127U) << shift;
      if (byte < 128) break;
    }
    if (in_.size() < at + length) return false;
    const auto first = static_cast<std::uint8_t>(in_[0]);
    all.push_back(
        {static_cast<std::uint8_t>(first >> 4), static_cast<std::uint8_t>(first & 15), in_.substr(at, length)});
    in_.erase(0, at + length);
    return true;
  }

  int port_ = 0;
  int listener_, socket_ = -1, connections_ = 0;
  std::string in_;
};

}  // namespace stillcut::shop::testing
