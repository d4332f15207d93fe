// stillcut-reader FILE INNER OPTIONS, with a socket as standard input: reads one HDF5 or MP3 file for another program
// of Stillcut, which goes on if this one dies of it. Not started by hand.
#include <unistd.h>

#include <cstdio>
#include <exception>

#include "core/session/isolated_server.h"

int main(int argc, char** argv) {
  constexpr int kArguments = 4;
  if (argc != kArguments) {
    std::fputs("stillcut-reader is started by stillcut and stillcut-cli to read HDF5 and MP3 files\n", stderr);
    return 2;
  }
  try {
    return stillcut::record::serveIsolated(STDIN_FILENO, argv[1], argv[2], argv[3]);
  } catch (const std::exception&) {
    return 1;
  }
}
