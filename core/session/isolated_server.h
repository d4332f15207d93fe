// The other end of openIsolated(): what the program stillcut-reader does. Thread: the main one of its process; waits.
#pragma once

#include <string>

namespace stillcut::record {

// Serves the file over the socket `peer` until nobody asks any more. Kills the process when the library needs more
// than a minute for an answer or four gigabytes of memory. `options`: JSON as isolated_messages.h has it.
int serveIsolated(int peer, const std::string& path, const std::string& inner, const std::string& options);

}  // namespace stillcut::record
