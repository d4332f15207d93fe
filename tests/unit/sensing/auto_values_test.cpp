// What a detector has set itself can be read, with its reason: of every parameter that is automatic, and of what it
// learns.
#include "core/sensing/auto_values.h"

#include <algorithm>
#include <cmath>

#include "core/detect/caliskan/energy_ratio.h"
#include "core/detect/liao/spectral.h"
#include "core/detect/registry.h"
#include "core/detect/turning_harmonics.h"
#include "core/detect/van_dijk/parametric.h"
#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

struct Nominal {
  double value = 0.0;
  std::string_view why;
};

template <class Part>
Nominal told(const Part& part, std::string_view key) {
  const AutoValueTable table = part.autoValues();
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].key == key) return {part.own(i).value, table[i].whys[part.own(i).why]};
  }
  ADD_FAILURE() << key << ": nobody tells";
  return {};
}

CutSignal stableCut() {
  CutSignal s;
  s.seconds = 2.5;
  return s;
}

RunOptions options(const CutSignal& s) {
  RunOptions o;
  o.teeth = s.teeth;
  o.rpm = 60.0 * s.spindle * 1.01;
  return o;
}

// No window and no limit are nothing that is found.
bool isFound(const config::ParamDecl& decl) {
  return decl.mayBeAutomatic && !decl.key.starts_with("coherence.band-") && decl.key != kVibrationLimit.key;
}

TEST(AutoValues, EveryAutomaticParameterHasAReadingAndEveryReadingItsReasons) {
  const auto check = [](config::ParamTable params, AutoValueTable table) {
    EXPECT_LE(table.size(), AutoValues::kMost);
    for (const config::ParamDecl* decl : params) {
      const auto same = [&](const AutoValueDecl& own) { return own.key == decl->key && own.unit == decl->unit; };
      EXPECT_EQ(std::any_of(table.begin(), table.end(), same), isFound(*decl)) << decl->key;
    }
    for (const AutoValueDecl& own : table) {
      EXPECT_GE(own.whys.size(), 2U) << own.key;
      EXPECT_FALSE(own.label.empty()) << own.key;
    }
  };
  check(conditionerParams(), Conditioner::autoValues());
  for (const DetectorRow& row : detectorTable()) check(row.params(), row.make()->autoValues());
}

TEST(AutoValues, AStableCutTeachesEveryDetectorItsFloor) {
  const CutSignal s = stableCut();
  Recording recording = makeCut(s);
  CutSignal other = s;
  other.seed = 2;
  recording.channels.push_back(makeCut(other).channels.front());
  for (const DetectorRow& row : detectorTable()) {
    const auto detector = row.make();
    detector->prepare(setupFor(recording, options(s)), {});
    const std::string floor = std::string(row.id) + ".floor";
    EXPECT_TRUE(std::isnan(told(*detector, floor).value)) << floor;
    EXPECT_EQ(told(*detector, floor).why, kNotLearned);
    run(recording, options(s), *detector);
    EXPECT_GT(told(*detector, floor).value, 0.0) << floor;
    EXPECT_EQ(told(*detector, floor).why, kMeanOfStable) << floor;
  }
}

// The numbers are those in force, and the reason is the one that counted.
TEST(AutoValues, TheEnergyRatioSaysWhatItsFilterIs) {
  const CutSignal s = stableCut();
  const Recording recording = makeCut(s);
  EnergyRatioDetector detector;
  run(recording, options(s), detector);
  EXPECT_EQ(told(detector, kErHarmonics.key).value, 48.0);
  EXPECT_EQ(told(detector, kErHarmonics.key).why, "12 tooth passings");
  const double turn = s.rate / s.spindle;
  EXPECT_NEAR(told(detector, kErLambda.key).value / lambdaForGain(2.0 / (2.0 * turn), 48), 1.0, 0.02);
  // A threshold above the floor, and above nothing: with this noise the floor decides.
  const Nominal onset = told(detector, "energy-ratio.onset"), floor = told(detector, "energy-ratio.floor");
  EXPECT_DOUBLE_EQ(onset.value, 4.0 * floor.value);
  EXPECT_EQ(onset.why, "four times the noise floor in energy");

  RunOptions slow = options(s);
  slow.params = {{"energy-ratio.harmonics", 20.0}, {"energy-ratio.onset-amplitude", 0.9}};
  EnergyRatioDetector set;
  run(recording, slow, set);
  EXPECT_EQ(told(set, kErHarmonics.key).value, 20.0);
  EXPECT_EQ(told(set, kErHarmonics.key).why, kSetByHand);
  EXPECT_DOUBLE_EQ(told(set, "energy-ratio.onset").value, 0.81);
  EXPECT_EQ(told(set, "energy-ratio.onset").why, "the smallest onset, as set, which the noise does not reach");
}

// A variance limit that is fixed where the automatic one stood alarms where that did.
TEST(AutoValues, TheParametricLimitIsInTheSensorsUnit) {
  CutSignal s = stableCut();
  s.seconds = 3.0;
  s.growthStart = 2.0;
  const Recording recording = makeCut(s);
  ParametricDetector detector;
  double limit = 0.0, before = 0.0;
  RunOptions o = options(s);
  o.onBlock = [&](const ConditionedBlock& block, const Verdict& v) {
    const double time = sinceEpoch(block.end()).value;
    if (time < 1.5 || time > 1.9) return;  // learned, and nothing grows yet
    limit = told(detector, kParVariance.key).value;
    before = std::max(before, v.indicators[0]);
  };
  const RunResult automatic = run(recording, o, detector);
  ASSERT_GT(automatic.firstAlarm, s.growthStart);
  EXPECT_GT(limit, 2.0 * before) << "the stable cut stays below it";
  RunOptions fixed = options(s);
  fixed.params = {{"parametric.variance", limit}};
  ParametricDetector held;
  EXPECT_NEAR(run(recording, fixed, held).firstAlarm, automatic.firstAlarm, 0.05);
  EXPECT_EQ(told(held, kParVariance.key).value, limit);
  EXPECT_EQ(told(held, kParVariance.key).why, kSetByHand);
}

TEST(AutoValues, WhatIsHeldInAnAlarmSaysSo) {
  CutSignal s = stableCut();
  s.growthStart = 1.5;
  EnergyRatioDetector detector;
  const RunResult result = run(makeCut(s), options(s), detector);
  ASSERT_TRUE(result.verdicts.back().alarming());
  EXPECT_EQ(told(detector, "energy-ratio.floor").why, kHeldInAlarm);
}

}  // namespace
}  // namespace stillcut::detect::testing
