#include "app/compose/ending/interruption.h"

#include <poll.h>
#include <unistd.h>

#include <csignal>

namespace stillcut::app {
namespace {

volatile std::sig_atomic_t came = 0;
void onSignal(int /*number*/) {
  came = 1;
}

}  // namespace

void mindInterruption() noexcept {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  if (std::signal(SIGHUP, onSignal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

bool unread() noexcept {
  pollfd out{STDOUT_FILENO, 0, 0};
  return ::poll(&out, 1, 0) > 0 && (out.revents & POLLERR) != 0;
}

bool interrupted() noexcept {
  return came != 0;
}

}  // namespace stillcut::app
