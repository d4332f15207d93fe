#include "app/io/keeper_process.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

#include "core/base/program_place.h"
#include "core/base/start_program.h"

namespace stillcut::app {
namespace {

constexpr Duration kLook = std::chrono::milliseconds(2);

}  // namespace

KeeperProcess::~KeeperProcess() {
  hangUp();
  (void)bury({});
}

std::string KeeperProcess::program() {
  return programPlace("stillcut-keeper", STILLCUT_KEEPER);
}

bool KeeperProcess::start(const KeeperBegin& begin) {
  hangUp();
  (void)bury({});
  const std::string place = program();
  std::array<int, 2> ends{};
  if (place.empty() || ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return false;
  peer_ = ends[0];
  greeted_ = false;
  const int started = startProgram({{place}, ends[1], true}, child_);
  ::close(ends[1]);
  const std::string text = toText(begin);
  const bool sent = started == 0 && ::send(peer_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
                                        static_cast<ssize_t>(text.size());
  if (!sent) hangUp();
  return sent;
}

bool KeeperProcess::send(const KeeperOrder& order) noexcept {
  if (peer_ < 0) return false;
  const ssize_t n = ::send(peer_, &order, sizeof order, MSG_NOSIGNAL | MSG_DONTWAIT);
  if (n == static_cast<ssize_t>(sizeof order)) return true;
  if (n < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) hangUp();
  return false;
}

bool KeeperProcess::wait(Duration atMost) const noexcept {
  pollfd entry{peer_, POLLIN, 0};
  const timespec limit{atMost.count() / 1'000'000'000, static_cast<long>(atMost.count() % 1'000'000'000)};
  return ::ppoll(&entry, 1, &limit, nullptr) > 0;
}

std::optional<KeeperReport> KeeperProcess::newest(Duration atMost) noexcept {
  std::optional<KeeperReport> newest;
  if (peer_ < 0 || !greeted_) return newest;
  wait(atMost);
  while (true) {
    KeeperReport report;
    const ssize_t n = ::recv(peer_, &report, sizeof report, MSG_DONTWAIT | MSG_TRUNC);
    if (n == static_cast<ssize_t>(sizeof report)) {
      newest = report;
    } else if (n == 0 || (n < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) {
      hangUp();
      return newest;
    } else if (n < 0) {
      return newest;
    }
  }
}

std::optional<KeeperOpened> KeeperProcess::opened(Duration atMost) {
  if (peer_ < 0 || greeted_ || !wait(atMost)) return std::nullopt;
  std::string text(kLongestKeeperText, '\0');
  const ssize_t n = ::recv(peer_, text.data(), text.size(), MSG_DONTWAIT);
  if (n < 0 && (errno == EAGAIN || errno == EINTR)) return std::nullopt;
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  auto first = keeperOpenedFrom(text);
  greeted_ = first.has_value();
  if (!greeted_) hangUp();
  return first;
}

bool KeeperProcess::bury(Duration atMost) noexcept {
  const SteadyClock clock;
  const Instant began = clock.now();
  while (child_ > 0) {
    status_ = -1;
    const pid_t gone = ::waitpid(child_, &status_, WNOHANG);
    if (gone == child_ || (gone < 0 && errno != EINTR)) child_ = -1;
    if (child_ <= 0 || clock.now() - began >= atMost) break;
    ::poll(nullptr, 0, static_cast<int>(kLook / std::chrono::milliseconds(1)));
  }
  return child_ <= 0;
}

bool KeeperProcess::endedInOrder() const noexcept {
  return WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

void KeeperProcess::kill() noexcept {
  if (child_ > 0) ::kill(child_, SIGKILL);
  hangUp();
}

void KeeperProcess::hangUp() noexcept {
  if (peer_ >= 0) ::close(std::exchange(peer_, -1));
}

}  // namespace stillcut::app
