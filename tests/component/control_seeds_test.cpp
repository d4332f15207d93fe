// The default strategy with the program's own detector on every scenario, whatever the noise: two seeds that are not
// the scenario's own. What each scenario expects must not hang on one of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/closed_loop/loop_run.h"

namespace stillcut::test {
namespace {

class EverySeed : public testing::TestWithParam<const char*> {};

TEST_P(EverySeed, EndsAsExpectedWithinThreeChanges) {
  milling::Scenario cut = scenarioNamed(GetParam());
  for (const std::uint64_t seed : {2U, 3U}) {
    cut.seed = seed;
    LoopRun run(cut, {});
    run.toEnd();
    const evaluate::SimulationReport result = evaluate::report(run.history(), run.history(), run.plant());
    EXPECT_EQ(result.outcome, name(cut.expect)) << seed;
    const int back = cut.expect == milling::Expectation::NoStableSpeed ? 1 : 0;  // to the programmed speed
    EXPECT_LE(result.speedChanges, 3 + back) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Named, EverySeed,
                         testing::Values("air-cut", "caliskan-1", "caliskan-2", "caliskan-3", "demo", "ford-stable",
                                         "ford-unstable", "liao-1", "liao-2", "loose-sensor", "production-stable",
                                         "van-dijk-ramp", "xu-aluminium", "xu-steel", "xu-thin-wall-double",
                                         "xu-thin-wall-single"),
                         [](const auto& which) {
                           std::string name(which.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace stillcut::test
