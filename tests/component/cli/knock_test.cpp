// Exchanged axes from the command line, by a recording of knocks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/component/cli/program.h"
#include "tests/support/temp_folder.h"

namespace stillcut::cli_test {
namespace {

using testing::HasSubstr;

// Three blows; what the second channel hears is a fifth of the first.
std::string knocksOf(const char* first, const char* second) {
  std::string text = std::string("t (s),") + first + " (m/s^2)," + second + " (m/s^2)\n";
  constexpr double kRate = 4000.0;
  for (int n = 0; n < 10000; ++n) {
    double blow = 0.0;
    for (const int at : {2000, 4500, 7000}) {
      const double t = (n - at) / kRate;
      if (t >= 0.0) blow += std::exp(-t / 0.02) * std::cos(2.0 * M_PI * 600.0 * t);
    }
    const double quiet = 1e-3 * ((n * 7919) % 13 - 6);
    text += std::to_string(n / kRate) + "," + std::to_string(blow + quiet) + "," + std::to_string(0.2 * blow - quiet) +
            "\n";
  }
  return text;
}

TEST(Knock, TellsExchangedAxesFromRightOnes) {
  const record::TempFolder folder;
  folder.file("right.csv", knocksOf("x", "y"));
  folder.file("exchanged.csv", knocksOf("y", "x"));
  const Outcome right = runCli(folder / "", {"knock", "right.csv"});
  EXPECT_EQ(right.exitCode, 0) << right.err;
  EXPECT_THAT(right.out, HasSubstr("3 knocks along x: 'x' measured most, 14."));
  EXPECT_THAT(right.out, HasSubstr("it is right"));
  const Outcome exchanged = runCli(folder / "", {"knock", "exchanged.csv", "--along", "1"});
  EXPECT_EQ(exchanged.exitCode, 0) << exchanged.err;
  EXPECT_THAT(exchanged.out, HasSubstr("'x' and 'y' are exchanged"));
}

TEST(Knock, WhatIsWrongIsOneLine) {
  const record::TempFolder folder;
  folder.file("knocks.csv", knocksOf("x", "y"));
  folder.file("unnamed.csv", knocksOf("a", "b"));
  const auto line = [&](std::vector<std::string> more) {
    more.insert(more.begin(), "knock");
    const Outcome outcome = runCli(folder / "", more);
    EXPECT_EQ(outcome.exitCode, 2) << spelled(more);
    return outcome.err;
  };
  EXPECT_THAT(line({}), HasSubstr("nothing to measure"));
  EXPECT_THAT(line({"knocks.csv", "--save"}), HasSubstr("--save: needs --profile"));
  EXPECT_THAT(line({"knocks.csv", "--along", "2"}), HasSubstr("knocks.csv: has no channel 2 (it has 0 to 1)"));
  EXPECT_THAT(line({"unnamed.csv"}), HasSubstr("has no axis"));
}

}  // namespace
}  // namespace stillcut::cli_test
