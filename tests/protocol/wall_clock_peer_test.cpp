// Programs whose wall clock is set again and again while they hold a machine (tests/support/wall_clock_steps.cpp):
// every lease, age and delay is the steady clock's, so that nothing of it shows. On a real pty with a scripted GRBL.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <string>

#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"
#include "tests/support/grbl/pty_grbl.h"

namespace stillcut::cnc {
namespace {

using testing::within;

class GrblAndTheWallClock : public ::testing::Test {
 protected:
  // stillcut-cli, with what it prints in `said`.
  testing::Child start(const std::string& arguments) {
    return testing::Child({"sh", "-c",
                           "exec env LD_PRELOAD=" STILLCUT_WALL_CLOCK_STEPS " " STILLCUT_CLI " " + arguments + " >" +
                               folder_.file("said") + " 2>&1"});
  }
  std::string said() const {
    std::ifstream file(folder_.file("said"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string measuring() const { return "devices --try grbl --with device=" + path_ + " --measure-effect"; }

  testing::TemporaryFolder folder_;
  std::string path_ = folder_.file("machine");
  testing::PtyGrbl controller_{path_};
};

TEST_F(GrblAndTheWallClock, IsSetAndTheClockOfTheTestIsNot) {
  testing::Child date({"sh", "-c",
                       "for k in 1 2 3 4 5 6 7 8 9; do LD_PRELOAD=" STILLCUT_WALL_CLOCK_STEPS
                       " date +%s; sleep 0.02; done >" +
                           folder_.file("said")});
  ASSERT_TRUE(within(Seconds(10.0), [&] { return date.ended().has_value(); }));
  std::ifstream times(folder_.file("said"));
  long lowest = 0, highest = 0;
  for (long t = 0; times >> t; highest = std::max(highest, t)) lowest = lowest == 0 ? t : std::min(lowest, t);
  EXPECT_GE(highest - lowest, 7000) << said();
}

TEST_F(GrblAndTheWallClock, AnOrderActsIsMeasuredAndIsTakenBack) {
  testing::Child program = start(measuring());
  std::optional<int> status;
  ASSERT_TRUE(within(Seconds(60.0), [&] { return (status = program.ended()).has_value(); }));
  EXPECT_TRUE(WIFEXITED(*status) && WEXITSTATUS(*status) == 0) << said();
  std::smatch found;
  const std::string text = said();
  ASSERT_TRUE(std::regex_search(text, found, std::regex("([0-9]+) ms"))) << text;
  EXPECT_LT(std::stol(found[1]), 2000) << text;
  EXPECT_TRUE(controller_.stands(100, 100));
}

// Its keeper has the same wall clock.
TEST_F(GrblAndTheWallClock, AKilledProgramIsBroughtHome) {
  testing::Child program = start(measuring());
  ASSERT_TRUE(within(Seconds(30.0), [&] { return controller_.stands(95, 95); })) << said();
  program.kill();
  EXPECT_TRUE(within(Seconds(1.0), [&] { return controller_.stands(100, 100); }));
}

}  // namespace
}  // namespace stillcut::cnc
