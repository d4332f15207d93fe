// The simulated work-holder as a block device, on virtual time.
#include "core/active/simulated_duplex.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/active/active_engine.h"
#include "core/milling/simulation/scenario.h"
#include "core/rt/deadline_stats.h"
#include "tests/unit/active/commands.h"

namespace stillcut::active {
namespace {

milling::Scenario ford(double rate) {
  auto scenario = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/ford-unstable.toml");
  EXPECT_TRUE(scenario.ok());
  scenario->rate = Hertz(rate);
  return *scenario;
}

TEST(SimulatedDuplex, AnOutputIsHeardALengthOfABlockLater) {
  for (int frames : {1, 8, 32}) {
    milling::Scenario scenario = ford(5000.0);
    SimulatedDuplex still(scenario, frames, 1), moved(scenario, frames, 1);
    ASSERT_TRUE(still.open().ok());
    ASSERT_TRUE(moved.open().ok());
    std::vector<double> a(2 * static_cast<std::size_t>(frames)), b(a.size());
    const std::vector<safety::ActuatorCommand> rest(a.size());
    std::vector<safety::ActuatorCommand> out = rest;
    ASSERT_EQ(still.read(a), DuplexEvent::Block);
    ASSERT_EQ(moved.read(b), DuplexEvent::Block);
    EXPECT_EQ(a, b);
    out[0] = commanded({1e-6})[0];  // the first frame of x
    (void)still.write(rest);
    (void)moved.write(out);
    std::vector<double> heard;
    for (int block = 0; block < 40 / frames + 1; ++block) {
      (void)still.read(a);
      (void)moved.read(b);
      for (int f = 0; f < frames; ++f) heard.push_back(b[static_cast<std::size_t>(f)] - a[static_cast<std::size_t>(f)]);
      (void)moved.write(rest);
    }
    // Nothing but what the one sample did, and it begins with the block after it was written.
    double largest = 0.0;
    for (double r : heard) largest = std::max(largest, std::abs(r));
    EXPECT_GT(largest, 1e-3);
    EXPECT_GT(std::abs(heard[0]) + std::abs(heard[1]) + std::abs(heard[2]), 0.05 * largest);
  }
}

TEST(SimulatedDuplex, RefusesAPlantWithoutATable) {
  milling::Scenario scenario = ford(5000.0);
  EXPECT_TRUE(SimulatedDuplex::check(scenario).ok());
  auto deaf = scenario;
  std::erase_if(deaf.sensors, [](const auto& s) { return s.axis == "y"; });
  EXPECT_NE(SimulatedDuplex::check(deaf).error().line().find("along y"), std::string::npos);
  scenario.workHolder.reset();
  EXPECT_NE(SimulatedDuplex::check(scenario).error().line().find("[work_holder]"), std::string::npos);
}

}  // namespace
}  // namespace stillcut::active
