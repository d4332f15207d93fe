#include "app/io/tcp_wire.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace stillcut::app {

using cnc::WireState;

Result<std::unique_ptr<cnc::ByteChannel>> TcpWire::make(const std::string& host, int port) {
  std::string name = host + ":" + std::to_string(port);
  addrinfo wanted{};
  wanted.ai_family = AF_UNSPEC;
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found);
  if (error != 0) return Error{name, message("the host cannot be found"), foreign(::gai_strerror(error))};
  std::vector<Place> places;
  for (const addrinfo* a = found; a != nullptr; a = a->ai_next) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(a->ai_addr);
    places.push_back({a->ai_family, {bytes, bytes + a->ai_addrlen}});
  }
  ::freeaddrinfo(found);
  return std::unique_ptr<cnc::ByteChannel>(new TcpWire(std::move(name), std::move(places)));
}

TcpWire::~TcpWire() {
  TcpWire::close();
}

void TcpWire::connect() noexcept {
  close();
  // "localhost" is ::1 and 127.0.0.1, and servers listen on one of them: a try each.
  const Place& place = places_[next_];
  next_ = (next_ + 1) % places_.size();
  socket_ = ::socket(place.family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket_ < 0) return;
  const int on = 1;
  ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  const auto* address = reinterpret_cast<const sockaddr*>(place.address.data());
  const int result = ::connect(socket_, address, static_cast<socklen_t>(place.address.size()));
  if (result == 0) {
    state_ = WireState::Open;
  } else if (errno == EINPROGRESS) {
    state_ = WireState::Opening;
  } else {
    close();
  }
}

int TcpWire::poll(short events, int milliseconds) const noexcept {
  pollfd entry{socket_, events, 0};
  const int ready = ::poll(&entry, 1, milliseconds);
  return ready > 0 ? entry.revents : 0;
}

WireState TcpWire::state() noexcept {
  if (state_ == WireState::Opening) {
    const int seen = poll(POLLOUT, 0);
    if (seen != 0) {
      int error = 0;
      socklen_t size = sizeof error;
      ::getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &size);
      if (error == 0 && (seen & POLLOUT) != 0) {
        state_ = WireState::Open;
        next_ = (next_ + places_.size() - 1) % places_.size();  // this place is the good one
      } else {
        close();
      }
    }
  }
  return state_;
}

std::size_t TcpWire::read(std::span<char> into) noexcept {
  if (state() != WireState::Open) return 0;
  const ssize_t n = ::recv(socket_, into.data(), into.size(), 0);
  if (n > 0) return static_cast<std::size_t>(n);
  if (n == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) close();
  return 0;
}

bool TcpWire::write(std::string_view bytes) noexcept {
  if (state() != WireState::Open) return false;
  const ssize_t n = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (n == static_cast<ssize_t>(bytes.size())) return true;
  close();
  return false;
}

void TcpWire::wait(Duration atMost) noexcept {
  const auto milliseconds = std::max<std::int64_t>(1, atMost.count() / 1'000'000);
  if (state_ == WireState::Closed) {
    ::poll(nullptr, 0, static_cast<int>(milliseconds));
  } else {
    poll(state_ == WireState::Opening ? POLLOUT : POLLIN, static_cast<int>(milliseconds));
  }
}

void TcpWire::close() noexcept {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
  state_ = WireState::Closed;
}

}  // namespace stillcut::app
