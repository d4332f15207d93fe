// Runs the built stillcut-cli as its users do: arguments in, exit code and two streams out.
#pragma once

#include <string>
#include <vector>

namespace stillcut::cli_test {

struct Outcome {
  int exitCode = -1;  // -1: it was ended by a signal, or ran out of time and was killed
  std::string out, err;
};

// In the folder `where`. The streams go to files elsewhere, so that `where` holds only what the program writes.
Outcome runCli(const std::string& where, const std::vector<std::string>& arguments);

// "stillcut-cli analyze a.wav", for failure messages.
std::string spelled(const std::vector<std::string>& arguments);

}  // namespace stillcut::cli_test
