// Work in a process of its own: what it says comes back, and its death is survived and noticed.
#include "core/record/run_apart.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

namespace stillcut::record {
namespace {

TEST(RunApart, TellsWhatTheWorkReturned) {
  int ours = 1;
  const auto result = runApart(
      [&ours] {
        ours = 2;
        return 42;
      },
      Seconds(20.0));
  EXPECT_EQ(result, 42);
  EXPECT_EQ(ours, 1) << "the child shares no memory";
}

TEST(RunApart, DeathIsNoResult) {
  EXPECT_FALSE(runApart([]() -> int { std::abort(); }, Seconds(20.0)));
  EXPECT_FALSE(runApart([] { return std::raise(SIGSEGV); }, Seconds(20.0)));
}

}  // namespace
}  // namespace stillcut::record
