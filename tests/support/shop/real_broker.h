// A real mosquitto on a port of this computer, a line to it that is cut at random, and somebody who listens to all it
// hands out. Where Debian's package mosquitto is missing, tests skip.
#pragma once

#include <mosquitto.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"
#include "tests/support/delay_proxy.h"

namespace stillcut::shop::testing {

using cnc::testing::Child;
using cnc::testing::within;

inline std::string brokerProgram() {
  for (const char* path : {"/usr/sbin/mosquitto", "/usr/local/sbin/mosquitto"}) {
    if (std::filesystem::exists(path)) return path;
  }
  return {};
}
inline constexpr const char* kNoBroker = "mosquitto is not installed: not tried against a real broker";

inline int freePort() {
  int port = 0;
  ::close(cnc::testing::listenOnLoopback(port));
  return port;
}

inline bool listens(int port) {
  const int s = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const sockaddr_in place = cnc::testing::loopback(port);
  const bool ok = ::connect(s, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0;
  ::close(s);
  return ok;
}

// A configuration that is a whole one, and the port it names.
struct WholeConfiguration {
  std::string text;
  int port;
};

class RealBroker {
 public:
  RealBroker(const std::string& folder, const WholeConfiguration& whole) : folder_(folder), port_(whole.port) {
    std::ofstream(folder_ + "/mosquitto.conf") << "user root\n" << whole.text;
    start();
  }
  // `more`: further lines of its configuration.
  explicit RealBroker(const std::string& folder, const std::string& more = "allow_anonymous true\n")
      : folder_(folder), port_(freePort()) {
    std::ofstream(folder_ + "/mosquitto.conf")
        << "user root\nlistener " << port_ << " 127.0.0.1\npersistence true\npersistence_location " << folder_
        << "/\nmax_queued_messages 0\nset_tcp_nodelay true\nlog_dest file " << folder_ << "/mosquitto.log\n"
        << more;
    start();
  }
  void start() {
    program_ = std::make_unique<Child>(std::vector<std::string>{brokerProgram(), "-c", folder_ + "/mosquitto.conf"});
    if (!within(Seconds(20.0), [this] { return listens(port_); }))
      throw std::runtime_error("mosquitto does not listen");
  }
  // In order: it keeps sessions and retained messages on disk.
  void stop() {
    // More than once: a mosquitto that has just begun to listen forgets a signal that comes before its loop.
    const bool over = within(Seconds(20.0), [this] {
      program_->signal(SIGTERM);
      return program_->ended().has_value();
    });
    if (!over) throw std::runtime_error("mosquitto does not end");
  }
  int port() const { return port_; }

 private:
  std::string folder_;
  int port_;
  std::unique_ptr<Child> program_;
};

// Passes bytes on and cuts every connection after a random number of them, in the middle of whatever is said.
class CutLine {
 public:
  CutLine(int to, unsigned seed, std::size_t least, std::size_t most)
      : to_(to), random_(seed), length_(least, most), listener_(cnc::testing::listenOnLoopback(port_)) {
    thread_ = std::thread([this] { serve(); });
  }
  ~CutLine() {
    stopped_ = true;
    thread_.join();
    ::close(listener_);
  }
  int port() const { return port_; }
  int cuts() const { return cuts_; }

 private:
  void serve() {
    while (!stopped_) {
      pollfd entry{listener_, POLLIN, 0};
      if (::poll(&entry, 1, 20) <= 0) continue;
      const int near = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      const int far = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
      const sockaddr_in place = cnc::testing::loopback(to_);
      if (::connect(far, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) pass(near, far);
      ::close(near);
      ::close(far);
    }
  }
  void pass(int near, int far) {
    std::size_t left = length_(random_);
    while (!stopped_) {
      std::array<pollfd, 2> entries{{{near, POLLIN, 0}, {far, POLLIN, 0}}};
      if (::poll(entries.data(), entries.size(), 20) <= 0) continue;
      for (std::size_t k = 0; k < 2; ++k) {
        if (entries[k].revents == 0) continue;
        std::array<char, 2048> bytes;
        const ssize_t n = ::recv(k == 0 ? near : far, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (n <= 0) return;
        const std::size_t go = std::min(left, static_cast<std::size_t>(n));
        if (::send(k == 0 ? far : near, bytes.data(), go, MSG_NOSIGNAL) < 0) return;
        left -= go;
        if (left > 0) continue;
        ++cuts_;
        return;
      }
    }
  }

  int to_, port_ = 0;
  std::mt19937 random_;
  std::uniform_int_distribution<std::size_t> length_;
  int listener_;
  std::atomic<bool> stopped_{false};
  std::atomic<int> cuts_{0};
  std::thread thread_;
};

// Keeps everything that the broker hands out, exactly once and in its order, also over a restart of the broker.
class Subscriber {
 public:
  struct Heard {
    std::string topic, payload;
    bool retained;
  };
  explicit Subscriber(int port, const std::string& what = "#", const std::string& user = {},
                      const std::string& password = {}, const std::string& ca = {}) {
    mosquitto_lib_init();
    client_ = mosquitto_new(("subscriber " + what).c_str(), false, this);
    what_ = what;
    if (!user.empty()) mosquitto_username_pw_set(client_, user.c_str(), password.c_str());
    if (!ca.empty()) mosquitto_tls_set(client_, ca.c_str(), nullptr, nullptr, nullptr, nullptr);
    mosquitto_connect_callback_set(client_, [](mosquitto* client, void* self, int /*code*/) {
      mosquitto_subscribe(client, nullptr, static_cast<Subscriber*>(self)->what_.c_str(), 2);
    });
    mosquitto_subscribe_callback_set(client_, [](mosquitto*, void* self, int, int, const int*) {
      static_cast<Subscriber*>(self)->subscribed_ = true;
    });
    mosquitto_message_callback_set(client_, [](mosquitto*, void* self, const mosquitto_message* m) {
      Subscriber& me = *static_cast<Subscriber*>(self);
      const std::scoped_lock lock(me.mutex_);
      me.heard_.push_back({m->topic, std::string(static_cast<const char*>(m->payload), m->payloadlen), m->retain});
    });
    mosquitto_reconnect_delay_set(client_, 1, 1, false);
    mosquitto_connect(client_, "127.0.0.1", port, 20);
    mosquitto_loop_start(client_);
    if (!within(Seconds(20.0), [this] { return subscribed_.load(); })) throw std::runtime_error("cannot subscribe");
  }
  ~Subscriber() {
    mosquitto_disconnect(client_);
    mosquitto_loop_stop(client_, true);
    mosquitto_destroy(client_);
    mosquitto_lib_cleanup();
  }
  std::vector<Heard> heard() const {
    const std::scoped_lock lock(mutex_);
    return heard_;
  }
  std::size_t count() const {
    const std::scoped_lock lock(mutex_);
    return heard_.size();
  }

 private:
  std::string what_;
  mosquitto* client_;
  std::atomic<bool> subscribed_{false};
  mutable std::mutex mutex_;
  std::vector<Heard> heard_;
};

}  // namespace stillcut::shop::testing
