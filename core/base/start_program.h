// Starts a program that comes with this one, apart from it: of what is open here it gets one end of a socket, as its
// standard input. Signals and scheduling are the ordinary ones, whatever the calling thread has.
// Thread: any.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace stillcut {

struct ProgramStart {
  std::vector<std::string> words;  // the program's path, then its arguments
  int input = -1;                  // its standard input; stays open here as well
  bool ownSession = false;         // survives the end of the session, as at a logout
};

// 0, and `child` is its id; else an errno, and `child` is -1.
int startProgram(ProgramStart start, pid_t& child);

}  // namespace stillcut
