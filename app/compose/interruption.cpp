#include "app/compose/interruption.h"

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
}

bool interrupted() noexcept {
  return came != 0;
}

}  // namespace stillcut::app
