// Wakeup: tells a waiting thread that there is something to do. A notify() before the wait is not lost.
// Thread: notify() on any thread, real-time (one system call at most, no lock); waitFor() on one thread.
#pragma once

#include "core/base/units.h"

namespace stillcut::rt {

class Wakeup {
 public:
  Wakeup();  // throws std::system_error when the system has no more file descriptors
  ~Wakeup();
  Wakeup(const Wakeup&) = delete;
  Wakeup& operator=(const Wakeup&) = delete;

  void notify() noexcept;
  // True when notified, false when the time ran out first.
  bool waitFor(Seconds limit) noexcept;

 private:
  int fd_;
};

}  // namespace stillcut::rt
