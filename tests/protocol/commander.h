// A program that commands 90 % through a link of its own, to be killed or stopped.
#pragma once

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <functional>
#include <memory>

#include "core/cnc/cnc_link.h"
#include "tests/protocol/commands.h"
#include "tests/support/bounded_wait.h"

namespace stillcut::cnc::testing {

class Commander {
 public:
  explicit Commander(const std::function<std::unique_ptr<CncLink>()>& makeLink) {
    if (::pipe(pipe_.data()) != 0) return;
    child_ = ::fork();
    if (child_ == 0) run(makeLink);
  }
  ~Commander() {
    signal(SIGKILL);
    ::waitpid(child_, nullptr, 0);
    for (const int end : pipe_) ::close(end);
  }
  Commander(const Commander&) = delete;
  Commander& operator=(const Commander&) = delete;

  // Its 90 % are in force.
  bool took() const {
    pollfd inForce{pipe_[0], POLLIN, 0};
    return ::poll(&inForce, 1, 15000) == 1;
  }
  pid_t process() const { return child_; }
  void signal(int number) const { ::kill(child_, number); }

 private:
  [[noreturn]] void run(const std::function<std::unique_ptr<CncLink>()>& makeLink) const {
    const auto link = makeLink();
    const SteadyClock clock;
    CommandMaker gate;
    const OverrideCommand command = gate.set(90.0);
    bool told = false;
    while (true) {
      within(Seconds(60.0), [&] {
        const MachineState m = link->read(clock.now());
        link->apply(command, clock.now());
        return !told && m.valid && std::abs(m.speedOverride.value - 0.9) < kNear &&
               std::abs(m.feedOverride.value - 0.9) < kNear;
      });
      told = ::write(pipe_[1], "k", 1) == 1;
    }
  }

  static constexpr double kNear = 0.002;  // the gate's own command is as near

  std::array<int, 2> pipe_{};
  pid_t child_ = -1;
};

}  // namespace stillcut::cnc::testing
