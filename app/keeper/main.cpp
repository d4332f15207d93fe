// stillcut-keeper, with a socket as standard input: holds the link to one machine for another program of Stillcut, and
// brings the operator's overrides back when that one dies or hangs. It is started by that program alone.
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "app/io/comedi_output.h"
#include "app/io/one_program_link.h"
#include "app/io/wires.h"
#include "app/keeper/keeper.h"
#include "core/rt/realtime_thread.h"

namespace stillcut::app {
namespace {

volatile std::sig_atomic_t ended = 0;
void onSignal(int /*number*/) {
  ended = 1;
}

int start() {
  int kind = 0;
  socklen_t size = sizeof kind;
  if (::getsockopt(STDIN_FILENO, SOL_SOCKET, SO_TYPE, &kind, &size) != 0 || kind != SOCK_SEQPACKET) {
    std::fputs("stillcut-keeper is started by stillcut and stillcut-cli to hold the link to a machine\n", stderr);
    return 2;
  }
  for (const int number : {SIGTERM, SIGINT, SIGHUP}) std::signal(number, onSignal);
  const auto events = wireEvents();  // outlives the link and its wires
  const SteadyClock clock;
  const auto make = [&clock](const KeeperBegin& begin) {
    cnc::LinkRequest request;
    request.settings = begin.settings;
    request.folder = begin.folder;
    request.wires = makeWire;
    request.buses = busMaker();
    request.analog = begin.silentOutputs ? makeSilentOutput : makeComediOutput;
    request.programmedSpeed = begin.programmedSpeed;
    request.programmedFeed = begin.programmedFeed;
    request.clock = &clock;
    return makeOneProgramLink(begin.link, request, begin.locks, begin.owner);
  };
  // Where the user may: it waits neither for the disk nor for a busy computer when it is needed.
  (void)rt::lockMemory();
  const sched_param first{1};
  (void)::sched_setscheduler(0, SCHED_FIFO, &first);
  return Keeper(STDIN_FILENO, clock, make, [] { return ended != 0; }).run();
}

}  // namespace
}  // namespace stillcut::app

int main() {
  return stillcut::app::start();
}
