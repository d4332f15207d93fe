// Golden traces: what every detector says of one short simulated cut that nobody controls, and what the default
// strategy makes of it. They assert nothing about right or wrong (the other tests do): they show what a change changes.
// Meant to change? tests/golden/update, and look at the difference.
#include <gtest/gtest.h>

#include <stdexcept>

#include "app/compose/scenario_rig.h"
#include "tests/golden/trace.h"
#include "tests/support/demo_cut.h"

namespace stillcut::app {
namespace {

constexpr int kEvery = 5;  // steps to a row: 50 ms
const std::vector<std::string> kDetectors{"energy-ratio", "parametric", "spectral", "coherence"};

struct Traces {
  test::Trace detectors, control;
};

Traces trace(const std::string& strategy, bool granted) {
  const milling::Scenario cut = test::demoCut();
  auto built =
      buildScenarioRig(cut, {.methods = {.detectors = kDetectors, .fallback = {}, .strategy = strategy}, .params = {}});
  if (!built) throw std::runtime_error(built.error().line());
  const ScenarioRig demo = std::move(built).value();
  const milling::SimulatedCut& plant = demo.source->plant();
  if (granted) demo.rig->send({OperatorAction::GrantBySimulation, Authority::Auto});
  Traces run;
  run.detectors.names = {"t"};
  for (const std::string& id : kDetectors) {
    for (const char* what : {".state", ".frequency_hz", ".severity"}) run.detectors.names.push_back(id + what);
  }
  run.control.names = {"t", "speed_rpm", "speed_override", "feed_override", "truth_ratio"};
  int steps = 0;
  demo.rig->runToEnd([&](const StepInput& input, const StepOutput& output) {
    if (++steps % kEvery != 0) return;
    const double t = sinceEpoch(input.block.end()).value;
    std::vector<double> says{t};
    for (int i = 0; i < output.verdictCount; ++i) {
      const Verdict& v = output.verdicts[static_cast<std::size_t>(i)];
      says.push_back(v.valid ? static_cast<double>(v.state) : -1.0);
      says.push_back(v.frequency.value);
      says.push_back(v.severity.value);
    }
    run.detectors.rows.push_back(std::move(says));
    const MachineState& m = input.machine;
    run.control.rows.push_back(
        {t, m.actualSpeed.value, m.speedOverride.value, m.feedOverride.value, plant.truth().chatterRatio()});
  });
  return run;
}

TEST(Golden, WhatEveryDetectorSaysOfTheUncontrolledCut) {
  const Traces run = trace("monitor", false);
  ASSERT_EQ(run.detectors.rows.size(), 100U);
  EXPECT_EQ(test::holdToGolden("detectors", run.detectors), "");
}

TEST(Golden, WhatTheDefaultStrategyMakesOfIt) {
  const Traces run = trace(Methods{}.strategy, true);
  EXPECT_EQ(test::holdToGolden("control", run.control), "");
}

TEST(Trace, SeesANumberAStateAndAMissingRow) {
  const test::Trace kept = test::Trace::parse("t,state,value\n0,0,100\n1,0,101\n2,1,102\n3,1,50\n");
  EXPECT_EQ(test::departures(kept, kept, 1e-3), "");
  test::Trace now = kept;
  now.rows[1][1] = 1;        // turns one row earlier
  now.rows[3][2] = 50.0999;  // within a thousandth of the largest
  EXPECT_EQ(test::departures(kept, now, 1e-3), "");
  now.rows[3][2] = 50.2;
  EXPECT_EQ(test::departures(kept, now, 1e-3), "value at 3 s: was 50, is 50.2\n");
  now = kept;
  now.rows[0][1] = 1;
  EXPECT_EQ(test::departures(kept, now, 1e-3), "state at 0 s: was 0, is 1\n");
  now.rows.pop_back();
  EXPECT_NE(test::departures(kept, now, 1e-3), "");
}

}  // namespace
}  // namespace stillcut::app
