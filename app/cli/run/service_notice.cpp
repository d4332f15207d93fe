#include "app/cli/run/service_notice.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace stillcut::app {
namespace {

constexpr Duration kUnwatched = std::chrono::seconds(1);
constexpr int kSignsPerWatch = 3;

int connectedTo(std::string_view place) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (place.size() < 2 || place.size() >= sizeof address.sun_path) return -1;
  std::memcpy(address.sun_path, place.data(), place.size());
  if (place.front() == '@') address.sun_path[0] = '\0';  // a name without a file
  const int handle = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + place.size());
  if (handle < 0 || connect(handle, reinterpret_cast<const sockaddr*>(&address), length) == 0) return handle;
  close(handle);
  return -1;
}

}  // namespace

ServiceNotice::ServiceNotice() {
  const char* place = std::getenv("NOTIFY_SOCKET");
  if (place != nullptr) socket_ = connectedTo(place);
  const char* watch = std::getenv("WATCHDOG_USEC");
  const long long within = watch != nullptr ? std::atoll(watch) : 0;
  period_ =
      within > 0 ? std::min(kUnwatched, Duration(std::chrono::microseconds(within)) / kSignsPerWatch) : kUnwatched;
}

ServiceNotice::~ServiceNotice() {
  if (socket_ >= 0) close(socket_);
}

void ServiceNotice::ready() {
  send("READY=1");
}

void ServiceNotice::alive(Instant now, const std::string& status) {
  if (now - last_ < period_) return;
  last_ = now;
  send(status == status_ ? "WATCHDOG=1" : "WATCHDOG=1\nSTATUS=" + status);
  status_ = status;
}

void ServiceNotice::stopping() {
  send("STOPPING=1");
}

// Never waits: a manager that does not read must not hold the run.
void ServiceNotice::send(const std::string& text) const {
  if (socket_ >= 0) (void)::send(socket_, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
}

}  // namespace stillcut::app
