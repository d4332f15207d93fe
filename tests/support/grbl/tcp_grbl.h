// A scripted GRBL behind a TCP port, as an ESP32 board has it: one client at a time. Thread: its own; the rest, any.
#pragma once

#include <array>
#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "tests/support/delay_proxy.h"
#include "tests/support/grbl/fake_grbl.h"

namespace stillcut::cnc::testing {

class TcpGrbl {
 public:
  TcpGrbl() : listener_(listenOnLoopback(port_)) {
    thread_ = std::thread([this] { serve(); });
  }
  ~TcpGrbl() {
    stopped_ = true;
    thread_.join();
    ::close(listener_);
  }
  TcpGrbl(const TcpGrbl&) = delete;
  TcpGrbl& operator=(const TcpGrbl&) = delete;
  int port() const { return port_; }
  template <class Change>
  void with(Change&& change) {
    const std::lock_guard lock(mutex_);
    change(grbl_);
  }
  // Neither hears nor answers; what was said to it meanwhile is heard afterwards.
  void hang(bool hangs) { hangs_ = hangs; }

 private:
  void serve() {
    int client = -1;
    while (!stopped_) {
      if (hangs_) {
        ::poll(nullptr, 0, 2);
        continue;
      }
      std::array<pollfd, 2> entries{pollfd{listener_, POLLIN, 0}, pollfd{client, POLLIN, 0}};
      if (::poll(entries.data(), entries.size(), 20) <= 0) continue;
      if ((entries[0].revents & POLLIN) != 0) {
        if (client >= 0) ::close(client);
        client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        const int on = 1;
        ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        continue;
      }
      std::array<char, 256> bytes;
      const ssize_t n = ::recv(client, bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (n == 0) ::close(std::exchange(client, -1));
      if (n <= 0) continue;
      std::string reply;
      const std::lock_guard lock(mutex_);
      grbl_.take({bytes.data(), static_cast<std::size_t>(n)}, SteadyClock().now(),
                 [&](const std::string& text, double) { reply += text; });
      (void)!::send(client, reply.data(), reply.size(), MSG_NOSIGNAL);
    }
    if (client >= 0) ::close(client);
  }

  int port_ = 0, listener_;
  std::atomic<bool> stopped_{false}, hangs_{false};
  std::mutex mutex_;
  FakeGrbl grbl_;
  std::thread thread_;
};

}  // namespace stillcut::cnc::testing
