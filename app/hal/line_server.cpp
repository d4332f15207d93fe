#include "app/hal/line_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace stillcut::hal {

LineServer::~LineServer() {
  drop();
  if (listener_ >= 0) ::close(listener_);
}

Status LineServer::listen(const std::string& address, int port) {
  const std::string where = address + ":" + std::to_string(port);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  if (::inet_pton(AF_INET, address.c_str(), &place.sin_addr) != 1) return Error{where, "is no dotted address", ""};
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  if (listener_ >= 0) ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (listener_ < 0 || ::bind(listener_, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 ||
      ::listen(listener_, 2) != 0) {
    return Error{where, "cannot be listened on", std::strerror(errno)};
  }
  return Done{};
}

void LineServer::serve(Duration atMost, bool mayReplace,
                       const std::function<std::string_view(std::string_view)>& take) noexcept {
  std::array<pollfd, 2> entries{{{listener_, POLLIN, 0}, {client_, POLLIN, 0}}};
  const nfds_t count = client_ >= 0 ? 2 : 1;
  if (::poll(entries.data(), count, static_cast<int>(atMost / std::chrono::milliseconds(1))) <= 0) return;
  if (count == 2 && entries[1].revents != 0) hear(take);
  if (entries[0].revents != 0) accept(mayReplace);
}

void LineServer::accept(bool mayReplace) noexcept {
  const int fresh = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (fresh < 0) return;
  if (client_ >= 0 && !mayReplace) {
    ::close(fresh);
    return;
  }
  drop();
  const int on = 1;
  ::setsockopt(fresh, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  client_ = fresh;
}

void LineServer::hear(const std::function<std::string_view(std::string_view)>& take) noexcept {
  std::array<char, 512> bytes;
  const ssize_t n = ::recv(client_, bytes.data(), bytes.size(), 0);
  if (n <= 0) {
    if (n == 0 || (errno != EAGAIN && errno != EINTR)) drop();
    return;
  }
  splitter_.feed({bytes.data(), static_cast<std::size_t>(n)}, [&](std::string_view line) {
    if (client_ < 0) return;
    const std::string_view answer = take(line);
    // A client that does not take a few dozen bytes is gone.
    const auto size = static_cast<ssize_t>(answer.size());
    if (size > 0 && ::send(client_, answer.data(), answer.size(), MSG_NOSIGNAL) != size) drop();
  });
}

void LineServer::drop() noexcept {
  if (client_ >= 0) ::close(client_);
  client_ = -1;
  splitter_.clear();
}

}  // namespace stillcut::hal
