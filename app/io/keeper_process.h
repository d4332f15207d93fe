// KeeperProcess: one process of stillcut-keeper and the socket to it. It has a session of its own, so that a Ctrl-C or
// a closed terminal ends the program alone, and it outlives the program for as long as it needs to bring the machine
// home. Thread: one at a time. Nothing blocks but start() and bury().
#pragma once

#include <sys/types.h>

#include <optional>
#include <span>
#include <string>

#include "app/io/keeper_messages.h"

namespace stillcut::app {

class KeeperProcess {
 public:
  KeeperProcess() = default;
  ~KeeperProcess();  // closes the socket; the keeper ends when the machine is home
  KeeperProcess(const KeeperProcess&) = delete;
  KeeperProcess& operator=(const KeeperProcess&) = delete;

  // Empty: there is none on this computer.
  static std::string program();
  // False: it did not start.
  bool start(const KeeperBegin& begin);
  bool running() const noexcept { return peer_ >= 0; }
  bool greeted() const noexcept { return greeted_; }  // its first message has come
  bool send(const KeeperOrder& order) noexcept;
  // The newest report that has come, waiting at most so long for one. Closed once the keeper has gone.
  std::optional<KeeperReport> newest(Duration atMost) noexcept;
  // Its first message.
  std::optional<KeeperOpened> opened(Duration atMost);
  // Waits until it has ended, at most so long; true: it has.
  bool bury(Duration atMost) noexcept;
  // The one buried last: by itself, its work done.
  bool endedInOrder() const noexcept;
  void kill() noexcept;
  // It goes on by itself until the machine is home.
  void leave() noexcept { hangUp(); }

 private:
  bool wait(Duration atMost) const noexcept;
  void hangUp() noexcept;

  int peer_ = -1;
  pid_t child_ = -1;
  int status_ = -1;  // of the one buried last, as waitpid() has it
  bool greeted_ = false;
};

}  // namespace stillcut::app
