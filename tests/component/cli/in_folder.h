// A test in a folder of its own, where the program is run and what it wrote is read.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/component/cli/program.h"
#include "tests/support/temp_folder.h"

namespace stillcut::cli_test {

class InFolder : public testing::Test {
 protected:
  // Expects that it ends well (`analyze` with 1 where it finds chatter) and gives what was printed.
  std::string run(const std::vector<std::string>& arguments) {
    const Outcome outcome = runCli(folder_ / "", arguments);
    const int worst = !arguments.empty() && arguments.front() == "analyze" ? 1 : 0;
    EXPECT_TRUE(outcome.exitCode >= 0 && outcome.exitCode <= worst) << spelled(arguments) << "\n" << outcome.err;
    return outcome.out;
  }
  std::string content(const std::string& name) {
    std::ifstream in(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  record::TempFolder folder_;
};

}  // namespace stillcut::cli_test
