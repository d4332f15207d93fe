// Parameters on the running cut: what is set before the first block acts as from the start, what is set in the middle
// is recorded and decided the same again, and what is locked, unknown or out of range changes nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "app/compose/recording_rig.h"
#include "core/control/registry.h"
#include "core/detect/caliskan/energy_ratio.h"
#include "core/detect/registry.h"
#include "core/evaluate/session_summary_builder.h"
#include "core/pipeline/catalog.h"
#include "core/session/open_recording.h"
#include "tests/component/demo_rig.h"
#include "tests/component/same_bits.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

using Outputs = std::vector<StepOutput>;
using config::ParamDecl;

RigSpec demoSpec(const Methods& methods, const config::ParamSet& params = {}) {
  RigSpec spec = test::demoRig();
  spec.methods = methods;
  spec.params = params;
  spec.deterministic = true;
  return spec;
}

OperatorInput setting(const ParamDecl& decl, double value) {
  OperatorInput input;
  input.action = OperatorAction::SetParameter;
  input.parameter = config::parameterId(decl.key);
  input.value = value;
  return input;
}

// The cut with `inputs` sent before block `at`; many, such as the rules of a table, as fast as blocks take them.
Outputs run(RigSpec spec, const std::vector<OperatorInput>& inputs, std::size_t at = 0, const std::string& path = "") {
  auto rig = Rig::build(std::move(spec));
  EXPECT_TRUE(rig.ok()) << rig.error().line();
  Outputs outputs;
  if (!rig) return outputs;
  if (!path.empty()) {
    EXPECT_TRUE((*rig)->recordTo(path, "").ok());
  }
  std::size_t sent = 0;
  const auto send = [&](std::size_t most) {
    for (; sent < inputs.size() && most > 0; ++sent, --most) EXPECT_TRUE((*rig)->send(inputs[sent]));
  };
  constexpr std::size_t kAtOnce = 16;
  if (at == 0) send(kAtOnce);
  (*rig)->runToEnd([&](const StepInput&, const StepOutput& output) {
    outputs.push_back(output);
    if (outputs.size() == at) send(kAtOnce);
    if (outputs.size() > at) send(kMaxInputsPerStep);
  });
  return outputs;
}

std::size_t firstDifference(const Outputs& a, const Outputs& b) {
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    if (!test::difference(a[i], b[i]).empty()) return i;
  }
  return std::min(a.size(), b.size());
}

// A value far from the default that a person could choose.
double another(const ParamDecl& decl) {
  if (decl.kind != config::ParamKind::Real) return decl.fallback == decl.lowest ? decl.highest : decl.lowest;
  const double middle = decl.lowest > 0.0 ? std::sqrt(decl.lowest * decl.highest) : 0.5 * (decl.lowest + decl.highest);
  return middle == decl.fallback ? 0.5 * (middle + decl.highest) : middle;
}

// Every open parameter set away from its default: from the start, or before the first block.
struct Chosen {
  config::ParamSet params;
  std::vector<OperatorInput> inputs;
};

// Of the 162 fuzzy rules every tenth: a step takes kMaxInputsPerStep, and all are to be there before the first
// decision. To the neighbouring singleton, since a table that rises further is refused.
Chosen others(config::ParamTable table) {
  Chosen chosen;
  int rules = 0;
  for (const ParamDecl* decl : table) {
    if (decl->lockedWhileRunning) continue;
    const bool rule = decl->key.find("-rule-") != std::string_view::npos;
    if (rule && rules++ % 10 != 0) continue;
    const double neighbour = decl->fallback < decl->highest ? decl->fallback + 1.0 : decl->fallback - 1.0;
    const double value = rule ? neighbour : another(*decl);
    EXPECT_TRUE(chosen.params.set(*decl, value, "test").ok());
    chosen.inputs.push_back(setting(*decl, value));
  }
  return chosen;
}

class Retuned : public testing::TestWithParam<std::string_view> {};

TEST_P(Retuned, EveryOpenParameterActsAsFromTheStart) {
  Methods methods;
  methods.detectors = {std::string(GetParam())};
  methods.strategy = "monitor";
  Chosen chosen;
  for (const auto& row : detect::detectorTable()) {
    if (row.id == GetParam()) chosen = others(row.params());
  }
  const Outputs set = run(demoSpec(methods), chosen.inputs);
  EXPECT_EQ(firstDifference(run(demoSpec(methods, chosen.params), {}), set), 500U);
  EXPECT_LT(firstDifference(run(demoSpec(methods), {}), set), 500U) << "the cut does not ask for these parameters";
}

std::string caseName(const testing::TestParamInfo<std::string_view>& tested) {
  std::string name(tested.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(EveryDetector, Retuned, testing::Values("parametric", "spectral", "energy-ratio", "coherence"),
                         caseName);

TEST(Retune, EveryOpenParameterOfEveryStrategyActsAsFromTheStart) {
  for (const auto& entry : control::strategyTable()) {
    Methods methods;
    methods.strategy = entry.id;
    const Chosen chosen = others(entry.params);
    const OperatorInput advise{OperatorAction::SetAuthority, Authority::Advise};
    std::vector<OperatorInput> inputs = chosen.inputs;
    inputs.insert(inputs.begin(), advise);
    EXPECT_EQ(firstDifference(run(demoSpec(methods, chosen.params), {advise}), run(demoSpec(methods), inputs)), 500U)
        << entry.id;
  }
}

TEST(Retune, InTheMiddleOfACutIsRecordedAndDecidedTheSameAgain) {
  const record::TempFolder folder;
  const std::string path = folder / "tuned.h5";
  constexpr std::size_t kAt = 200;
  const Methods methods;
  const OperatorInput stricter = setting(detect::kErOnsetAmplitude, 0.5);
  const Outputs usual = run(demoSpec(methods), {});
  const Outputs tuned = run(demoSpec(methods), {stricter}, kAt, path);
  const std::size_t first = firstDifference(usual, tuned);
  EXPECT_GE(first, kAt);
  ASSERT_LT(first, 500U) << "the setting has done nothing";

  auto replay = buildReplayRig(path);
  ASSERT_TRUE(replay.ok()) << replay.error().line();
  Outputs again;
  replay->rig->runToEnd([&](const StepInput&, const StepOutput& output) { again.push_back(output); });
  EXPECT_EQ(firstDifference(tuned, again), 500U);
  // What was learned before it stays: there is a verdict at once.
  EXPECT_EQ(usual[kAt].verdicts[0].valid, tuned[kAt].verdicts[0].valid);

  // And a report of it tells what was set, when.
  const auto summary = evaluate::summarizeRecording(path);
  ASSERT_TRUE(summary.ok()) << summary.error().line();
  ASSERT_EQ(summary->settingChanges.size(), 1U);
  EXPECT_EQ(config::parameterId(summary->settingChanges[0].key), stricter.parameter);
  EXPECT_DOUBLE_EQ(std::stod(summary->settingChanges[0].value), stricter.value);
  EXPECT_NEAR(summary->settingChanges[0].time.value / summary->length.value, static_cast<double>(kAt) / 500.0, 0.01);
}

TEST(Retune, LockedUnknownAndSenselessValuesChangeNothing) {
  const Methods methods;
  const Outputs usual = run(demoSpec(methods), {});
  OperatorInput unknown = setting(detect::kErChatter, 0.5);
  unknown.parameter ^= 1U;
  const std::vector<OperatorInput> nothing{
      setting(detect::kErHarmonics, 8.0),          setting(detect::kErChatter, 1e9),
      setting(detect::kErChatter, -1.0),           setting(detect::kErChatter, config::kAutomatic),
      setting(config::kLowestSpeedOverride, 90.0), unknown};
  EXPECT_EQ(firstDifference(usual, run(demoSpec(methods), nothing, 100)), 500U);
}

TEST(Retune, NoTwoParametersHaveTheSameNumber) {
  std::set<std::uint32_t> ids;
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  for (const ParamDecl* decl : catalog.all())
    EXPECT_TRUE(ids.insert(config::parameterId(decl->key)).second) << decl->key;
  EXPECT_GT(ids.size(), 60U);
}

TEST(Retune, DetectorsSayWhatTheyChoseThemselves) {
  const CutSetup setup = test::demoCut().cutSetup();
  detect::EnergyRatioDetector detector;
  detector.prepare(setup, {});
  EXPECT_EQ(detector.chosen(detect::kErHarmonics), 48.0);  // twelve tooth passings of four teeth
  EXPECT_TRUE(std::isnan(detector.chosen(detect::kErLambda)));
}

}  // namespace
}  // namespace stillcut::app
