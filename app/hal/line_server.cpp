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

#include "app/hal/local_user.h"

namespace stillcut::hal {

LineServer::~LineServer() {
  for (const Client& client : clients_) {
    if (client.socket >= 0) ::close(client.socket);
  }
  if (listener_ >= 0) ::close(listener_);
}

Status LineServer::listen(const std::string& address, int port) {
  const std::string where = address + ":" + std::to_string(port);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  if (::inet_pton(AF_INET, address.c_str(), &place.sin_addr) != 1) return Error{where, message("is no dotted address")};
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  if (listener_ >= 0) ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (listener_ < 0 || ::bind(listener_, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 ||
      ::listen(listener_, static_cast<int>(kClients)) != 0) {
    return Error{where, message("cannot be listened on"), foreign(std::strerror(errno))};
  }
  return Done{};
}

int LineServer::port() const noexcept {
  sockaddr_in place{};
  socklen_t size = sizeof place;
  ::getsockname(listener_, reinterpret_cast<sockaddr*>(&place), &size);
  return ntohs(place.sin_port);
}

void LineServer::serve(Duration atMost, const Handlers& handlers) noexcept {
  std::array<pollfd, kClients + 1> entries{};  // a socket below 0 is passed over
  for (std::size_t i = 0; i < kClients; ++i) entries[i] = {clients_[i].socket, POLLIN, 0};
  entries[kClients] = {listener_, POLLIN, 0};
  if (::poll(entries.data(), entries.size(), static_cast<int>(atMost / std::chrono::milliseconds(1))) <= 0) return;
  for (std::size_t i = 0; i < kClients; ++i) {
    if (entries[i].revents != 0) hear(clients_[i], handlers);
  }
  if (entries[kClients].revents != 0) accept(handlers);
}

// A program of this computer that the list does not name is nobody's: by its address it is one of ours.
bool LineServer::admits(const sockaddr_in& peer, const sockaddr_in& here) const noexcept {
  try {
    const auto user = localUser(peer, here);
    return user ? *user == owner_ || *user == 0 : !isLoopback(peer) && peer.sin_addr.s_addr != here.sin_addr.s_addr;
  } catch (...) {  // no memory to look it up with
    return false;
  }
}

void LineServer::accept(const Handlers& handlers) noexcept {
  sockaddr_in peer{};
  socklen_t size = sizeof peer;
  const int fresh = ::accept4(listener_, reinterpret_cast<sockaddr*>(&peer), &size, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (fresh < 0) return;
  sockaddr_in here{};
  socklen_t length = sizeof here;
  if (::getsockname(fresh, reinterpret_cast<sockaddr*>(&here), &length) != 0 || !admits(peer, here)) {
    // At once and for good: what stays in the kernel's list makes the next look-up longer, beside the heartbeat.
    const linger now{1, 0};
    ::setsockopt(fresh, SOL_SOCKET, SO_LINGER, &now, sizeof now);
    ::close(fresh);
    return;
  }
  // A free place has been heard at 0.
  Client& place = *std::min_element(clients_.begin(), clients_.end(),
                                    [](const Client& a, const Client& b) { return a.heard < b.heard; });
  if (place.socket >= 0 && clock_.now() - place.heard < kSilence) {
    ::close(fresh);
    return;
  }
  drop(place, handlers);
  const int on = 1;
  ::setsockopt(fresh, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  place.socket = fresh;
  place.number = ++lastNumber_;
  place.heard = clock_.now();
}

void LineServer::hear(Client& client, const Handlers& handlers) noexcept {
  std::array<char, 512> bytes;
  const ssize_t n = ::recv(client.socket, bytes.data(), bytes.size(), 0);
  if (n <= 0) {
    if (n == 0 || (errno != EAGAIN && errno != EINTR)) drop(client, handlers);
    return;
  }
  client.heard = clock_.now();
  bool deaf = false;
  client.splitter.feed({bytes.data(), static_cast<std::size_t>(n)}, [&](std::string_view line) {
    if (deaf) return;
    const std::string_view answer = handlers.take(client.number, line);
    // A client that does not take a few dozen bytes is gone.
    const auto size = static_cast<ssize_t>(answer.size());
    deaf = size > 0 && ::send(client.socket, answer.data(), answer.size(), MSG_NOSIGNAL) != size;
  });
  if (deaf) drop(client, handlers);
}

void LineServer::drop(Client& client, const Handlers& handlers) noexcept {
  if (client.socket < 0) return;
  ::close(client.socket);
  handlers.gone(client.number);
  client.socket = -1;
  client.heard = {};
  client.splitter.clear();
}

}  // namespace stillcut::hal
