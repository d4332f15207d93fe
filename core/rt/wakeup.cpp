#include "core/rt/wakeup.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>

namespace stillcut::rt {

Wakeup::Wakeup() : fd_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
}

Wakeup::~Wakeup() {
  ::close(fd_);
}

void Wakeup::notify() noexcept {
  const std::uint64_t one = 1;
  // Fails only when the counter is full, and then the waiter is awake anyway.
  [[maybe_unused]] const auto written = ::write(fd_, &one, sizeof one);
}

bool Wakeup::waitFor(Seconds limit) noexcept {
  const double ns = std::max(0.0, limit.value) * 1e9;
  timespec time{};
  time.tv_sec = static_cast<time_t>(ns / 1e9);
  time.tv_nsec = static_cast<long>(ns - static_cast<double>(time.tv_sec) * 1e9);
  pollfd watched{fd_, POLLIN, 0};
  if (::ppoll(&watched, 1, &time, nullptr) <= 0) return false;
  std::uint64_t count = 0;
  return ::read(fd_, &count, sizeof count) == static_cast<ssize_t>(sizeof count);
}

}  // namespace stillcut::rt
