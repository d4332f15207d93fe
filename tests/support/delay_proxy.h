// A TCP port that leads to another one of this computer and holds every byte up for a while, both ways: a slow network,
// or a machine that thinks. Its cable can be pulled, and what comes from behind it can be made to lie. Thread: its own;
// the rest, any.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <deque>
#include <functional>
#include <list>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/time.h"

namespace stillcut::cnc::testing {

inline sockaddr_in loopback(int port) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return place;
}

// A socket that listens on `port`; 0: on any.
inline int listenOnLoopback(int& port) {
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in place = loopback(port);
  socklen_t size = sizeof place;
  if (::bind(listener, reinterpret_cast<sockaddr*>(&place), size) != 0 || ::listen(listener, 4) != 0 ||
      ::getsockname(listener, reinterpret_cast<sockaddr*>(&place), &size) != 0) {
    throw std::runtime_error("port " + std::to_string(port) + " cannot be listened on");
  }
  port = ntohs(place.sin_port);
  return listener;
}

class DelayProxy {
 public:
  DelayProxy(int to, Seconds delay) : to_(to), delay_(toDuration(delay)), listener_(listenOnLoopback(port_)) {
    thread_ = std::thread([this] { serve(); });
  }
  ~DelayProxy() {
    stopped_ = true;
    thread_.join();
    ::close(listener_);
  }
  DelayProxy(const DelayProxy&) = delete;
  DelayProxy& operator=(const DelayProxy&) = delete;
  int port() const { return port_; }
  // Of what comes from now on.
  void delay(Seconds late) { delay_ = toDuration(late); }
  // The cable is out: nothing gets through either way and nobody is told. What was sent meanwhile arrives once it is in
  // again, as TCP has it, or, of a `serial` line, never.
  void pull(bool out, bool serial = false) {
    serial_ = serial;
    out_ = out;
  }
  // What comes back from behind, changed as it passes; null: as it is.
  void lie(std::function<void(std::string&)> change) {
    const std::lock_guard lock(lieMutex_);
    lie_ = std::move(change);
  }

 private:
  struct Late {
    Instant due{};
    std::string bytes;  // empty: the end
  };
  struct Way {
    int from = -1, to = -1;
    std::deque<Late> late;
    bool over = false;
    bool fromBehind = false;
  };
  struct Pair {
    int near = -1, far = -1;
    std::array<Way, 2> ways;
  };

  void serve() {
    while (!stopped_) {
      std::vector<pollfd> entries{{out_ ? -1 : listener_, POLLIN, 0}};
      for (const Pair& p : pairs_) {
        for (const Way& w : p.ways) entries.push_back({w.over ? -1 : w.from, POLLIN, 0});
      }
      const timespec wait{0, delay_.load() > Duration::zero() && waiting() ? 200'000 : 5'000'000};
      ::ppoll(entries.data(), entries.size(), &wait, nullptr);
      std::size_t at = 1;
      for (Pair& p : pairs_) {
        for (Way& w : p.ways) {
          if (entries[at++].revents != 0) take(w);
          pass(w);
        }
      }
      if ((entries[0].revents & POLLIN) != 0) accept();
      pairs_.remove_if([](const Pair& p) {
        const bool over = (p.ways[0].over && p.ways[0].late.empty()) || (p.ways[1].over && p.ways[1].late.empty());
        if (over) ::close(p.near), ::close(p.far);
        return over;
      });
    }
    for (const Pair& p : pairs_) ::close(p.near), ::close(p.far);
  }
  bool waiting() const {
    for (const Pair& p : pairs_) {
      if (!p.ways[0].late.empty() || !p.ways[1].late.empty()) return true;
    }
    return false;
  }
  void accept() {
    const int near = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    const int far = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in place = loopback(to_);
    if (near < 0 || ::connect(far, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0) {
      ::close(near);
      ::close(far);
      return;
    }
    const int on = 1;
    for (const int s : {near, far}) ::setsockopt(s, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    pairs_.push_back({near, far, {Way{near, far, {}, false, false}, Way{far, near, {}, false, true}}});
  }
  void take(Way& w) const {
    std::array<char, 4096> bytes;
    const ssize_t n = ::recv(w.from, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (n < 0) return;
    w.over = n == 0;
    std::string came(bytes.data(), static_cast<std::size_t>(n));
    if (const std::lock_guard lock(lieMutex_); lie_ && w.fromBehind) lie_(came);
    if (out_ && serial_ && !w.over) return;
    w.late.push_back({clock_.now() + delay_.load(), std::move(came)});
  }
  void pass(Way& w) const {
    if (out_) return;
    while (!w.late.empty() && w.late.front().due <= clock_.now()) {
      const std::string& bytes = w.late.front().bytes;
      if (!bytes.empty() && ::send(w.to, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) w.over = true;
      w.late.pop_front();
    }
  }

  SteadyClock clock_;
  int to_, port_ = 0;
  std::atomic<Duration> delay_;
  int listener_;
  std::list<Pair> pairs_;
  std::atomic<bool> stopped_{false}, out_{false}, serial_{false};
  mutable std::mutex lieMutex_;
  std::function<void(std::string&)> lie_;
  std::thread thread_;
};

}  // namespace stillcut::cnc::testing
