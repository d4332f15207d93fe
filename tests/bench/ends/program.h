// The program that is tried: a process with a gate, a worker and a link thread as in a run, which drives both overrides
// to 83 %, and is told over a pipe what is to become of it. Its gate sees whether the machine answers; once it has let
// go, for whatever reason, it does not take the overrides again. Thread: one.
#pragma once

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <optional>

#include "core/pipeline/link_runner.h"
#include "tests/bench/ends/machine.h"
#include "tests/support/gate_harness.h"

namespace stillcut::ends {

inline constexpr int kOurs = 83;    // %
inline constexpr int kPace_ms = 5;  // of the link's thread, as a run has it

class Program {
 public:
  explicit Program(Machine& machine) {
    if (::pipe(orders_.data()) != 0) return;
    process_ = ::fork();
    if (process_ == 0) run(machine);
  }
  ~Program() {
    signal(SIGKILL);
    ::waitpid(process_, nullptr, 0);
    for (const int end : orders_) ::close(end);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  int process() const { return process_; }
  void signal(int number) const { ::kill(process_, number); }
  // 'o': authority Off. 'c': it is closed. 'w': its worker hangs.
  void tell(char what) const { (void)!::write(orders_[1], &what, 1); }

 private:
  [[noreturn]] void run(Machine& machine) const {
    safety::testing::GateHarness gate;
    gate.settleAt(1e4 * kOurs / 100.0, 1e3 * kOurs / 100.0);
    const auto link = machine.link();
    const SteadyClock clock;
    rt::Mailbox<OverrideCommand> commands;
    rt::Mailbox<MachineState> states;
    for (Status opened = link->open(); !opened; opened = link->open())
      std::fprintf(stderr, "%s\n", opened.error().line().c_str());
    pipeline::LinkRunner runner(*link, commands, states);
    bool works = true;
    const auto tick = [&] {
      runner.tick(clock.now());
      ::poll(nullptr, 0, kPace_ms);
    };
    for (std::optional<MachineState> seen; !seen || !seen->valid; seen = states.latest()) tick();
    while (true) {
      if (works) {
        const auto out = gate.step();
        if (out.command) commands.post(*out.command);
        works = out.commanding || out.command;
      }
      const Instant until = clock.now() + std::chrono::milliseconds(10);
      while (clock.now() < until) tick();
      if (const auto state = states.latest()) {
        gate.machine.valid = state->valid;
        gate.machine.linkUp = state->linkUp;
        gate.machine.endedEngagement = state->endedEngagement;
      }
      pollfd told{orders_[0], POLLIN, 0};
      if (::poll(&told, 1, 0) <= 0) continue;
      char what = 0;
      (void)!::read(orders_[0], &what, 1);
      if (what == 'w') works = false;
      if (what == 'c') {
        runner.finish();
        ::_exit(0);
      }
      // At once, as Off and every end of a run is: the way of a ramp is the gate's, and tested there.
      if (what == 'o') {
        works = false;
        link->release(clock.now());
      }
    }
  }

  std::array<int, 2> orders_{};
  pid_t process_ = -1;
};

}  // namespace stillcut::ends
