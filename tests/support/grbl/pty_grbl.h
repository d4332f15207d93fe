// A scripted GRBL on a real pty, for links that open a serial port by its path.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "core/base/time.h"
#include "tests/support/grbl/fake_grbl.h"

namespace stillcut::cnc::testing {

// FakeGrbl on the master end of a pty; a person would type `path`.
class PtyGrbl {
 public:
  explicit PtyGrbl(std::string path) : path_(std::move(path)) { plugIn(); }
  ~PtyGrbl() { pull(); }
  PtyGrbl(const PtyGrbl&) = delete;
  PtyGrbl& operator=(const PtyGrbl&) = delete;

  void plugIn() {
    int slave = -1;
    char name[128] = {};
    termios raw{};
    ::cfmakeraw(&raw);
    ASSERT_EQ(::openpty(&master_, &slave, name, &raw, nullptr), 0);
    keepOpen_ = slave;
    std::filesystem::remove(path_);
    std::filesystem::create_symlink(name, path_);
    stopped_ = false;
    thread_ = std::thread([this] { serve(); });
  }
  // The cable, the adapter and its device file go.
  void pull() {
    if (!thread_.joinable()) return;
    stopped_ = true;
    thread_.join();
    ::close(keepOpen_);
    ::close(master_);
    std::filesystem::remove(path_);
  }
  template <class Change>
  void with(Change&& change) {
    const std::lock_guard lock(mutex_);
    change(grbl_);
  }
  // Steps that were taken.
  std::size_t steps() {
    const std::lock_guard lock(mutex_);
    return grbl_.moved.size();
  }
  bool stands(int speed, int feed) {
    const std::lock_guard lock(mutex_);
    return grbl_.spindle == speed && grbl_.feed == feed;
  }

 private:
  void serve() {
    while (!stopped_) {
      pollfd input{master_, POLLIN, 0};
      if (::poll(&input, 1, 20) <= 0) continue;
      char bytes[256];
      const auto n = ::read(master_, bytes, sizeof bytes);
      if (n <= 0) continue;
      std::string reply;
      {
        const std::lock_guard lock(mutex_);
        grbl_.take({bytes, static_cast<std::size_t>(n)}, SteadyClock().now(),
                   [&](const std::string& text, double) { reply += text; });
      }
      for (std::size_t at = 0; at < reply.size(); at += 7) {  // in pieces, as adapters deliver
        const std::string_view piece = std::string_view(reply).substr(at, 7);
        if (::write(master_, piece.data(), piece.size()) < 0) return;
      }
    }
  }

  std::string path_;
  int master_ = -1, keepOpen_ = -1;
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  FakeGrbl grbl_;
  std::thread thread_;
};

}  // namespace stillcut::cnc::testing
