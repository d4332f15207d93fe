// RealtimeThread: a named thread that asks for real-time scheduling and says what it got.
// Thread: construction and destruction on the owner's; destruction asks the body to stop and joins it.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <thread>

namespace stillcut::rt {

enum class Scheduling { Ordinary, Fifo };

struct ThreadRequest {
  std::string name = "stillcut";  // at most 15 characters are shown by the system
  Scheduling scheduling = Scheduling::Ordinary;
  int priority = 50;  // of Fifo, 1 .. 99
};

class RealtimeThread {
 public:
  RealtimeThread(const ThreadRequest& request, std::function<void(std::stop_token)> body);

  void requestStop() { thread_.request_stop(); }
  // What the system granted: Fifo needs a privilege (limits.d or root); without it the thread runs as an ordinary one.
  Scheduling granted() const { return granted_; }

 private:
  Scheduling granted_ = Scheduling::Ordinary;
  std::jthread thread_;
};

// Keeps the program's memory from being swapped out. False: not permitted.
bool lockMemory();

}  // namespace stillcut::rt
