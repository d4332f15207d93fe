// stillcut-decoder FILE INNER OPTIONS, with a socket as standard input: decodes the sound track of one file of a phone
// or a camera for another program of Stillcut, which goes on if this one dies of it. Not started by hand.
#include <unistd.h>

#include <cstdio>
#include <exception>

#include "core/session/isolated_server.h"

int main(int argc, char** argv) {
  constexpr int kArguments = 4;
  if (argc != kArguments) {
    std::fputs("stillcut-decoder is started by stillcut and stillcut-cli to read phones' files\n", stderr);
    return 2;
  }
  try {
    return stillcut::record::serveMedia(STDIN_FILENO, argv[1], argv[3]);
  } catch (const std::exception&) {
    return 1;
  }
}
