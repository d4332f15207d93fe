// Settings that contradict themselves or each other are refused before anything runs, in one line with the key and the
// reason.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/compose/scenario_rig.h"
#include "core/config/profile.h"
#include "core/pipeline/catalog.h"
#include "tests/support/demo_cut.h"

namespace stillcut::app {
namespace {

struct BadSetting {
  const char* name;
  std::vector<const char*> settings;
  const char* key;
  const char* reason;
};

class BadSettings : public testing::TestWithParam<BadSetting> {};

TEST_P(BadSettings, AreOneLineWithKeyAndReason) {
  ScenarioOptions options;
  options.methods.strategy = "fuzzy";
  std::string line;
  for (const char* setting : GetParam().settings) {
    const Status set = config::applySetting(options.params, pipeline::fullCatalog(), setting);
    if (!set) line = set.error().line();
  }
  if (line.empty()) {
    const auto rig = buildScenarioRig(test::demoCut(), options);
    ASSERT_FALSE(rig.ok());
    line = rig.error().line();
  }
  EXPECT_THAT(line, testing::HasSubstr(GetParam().key));
  EXPECT_THAT(line, testing::HasSubstr(GetParam().reason));
  EXPECT_EQ(line.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadSettings,
    testing::Values(
        BadSetting{"not_a_number", {"gate.speed-slew=fast"}, "gate.speed-slew", "number"},
        BadSetting{"not_finite", {"gate.speed-slew=nan"}, "gate.speed-slew", "finite"},
        BadSetting{"zero_range", {"gate.speed-slew=0"}, "gate.speed-slew", "allowed: 0.1 to 500"},
        BadSetting{"negative", {"gate.hold-time=-1"}, "gate.hold-time", "allowed: 0 to 5000"},
        BadSetting{
            "lowest_above_100", {"gate.lowest-speed-override=120"}, "gate.lowest-speed-override", "allowed: 10 to 100"},
        BadSetting{"unknown_key", {"gate.speed-slow=1"}, "gate.speed-slow", "gate.speed-slew"},
        BadSetting{"speeds_crossed",
                   {"gate.lowest-speed=9000", "gate.highest-speed=8000"},
                   "gate.lowest-speed",
                   "not below the highest"},
        BadSetting{"tool_below_lowest",
                   {"gate.lowest-speed=9000", "gate.tool-highest-speed=8500"},
                   "gate.lowest-speed",
                   "not below the highest"},
        BadSetting{"holder_below_lowest",
                   {"gate.lowest-speed=9000", "gate.holder-highest-speed=8500"},
                   "gate.lowest-speed",
                   "not below the highest"},
        BadSetting{"speeds_equal",
                   {"gate.lowest-speed=9000", "gate.highest-speed=9000"},
                   "gate.lowest-speed",
                   "not below the highest"},
        BadSetting{"feeds_crossed",
                   {"gate.lowest-feed=3000", "gate.highest-feed=1000"},
                   "gate.lowest-feed",
                   "not below the highest"},
        BadSetting{"feeds_equal",
                   {"gate.lowest-feed=1000", "gate.highest-feed=1000"},
                   "gate.lowest-feed",
                   "not below the highest"},
        BadSetting{"edge_slower_than_lowest",
                   {"gate.lowest-speed=9000", "gate.highest-cutting-speed=100"},
                   "gate.lowest-speed",
                   "not below the highest"},
        BadSetting{"feed_range_reversed",
                   {"gate.highest-feed-override=90"},
                   "gate.highest-feed-override",
                   "allowed: 100 to 200"},
        BadSetting{"state_always_stale", {"gate.machine-age=10"}, "gate.machine-age", "at least two of its periods"},
        BadSetting{"sets_out_of_order", {"fuzzy.set-small=0.6"}, "fuzzy.set-small", "allowed: 0.05 to 0.35"},
        BadSetting{"rule_off_its_scale", {"fuzzy.speed-rule-nb-ps=0"}, "fuzzy.speed-rule-nb-ps", "allowed: 1"},
        BadSetting{"a_rule_that_rises_with_the_error",
                   {"fuzzy.feed-rule-pb-ze=8"},
                   "fuzzy.feed-rule-pb-ze",
                   "8 is above 4 of fuzzy.feed-rule-pm-ze (rules must fall as coherence rises)"},
        BadSetting{"a_rule_that_rises_with_the_change",
                   {"fuzzy.speed-rule-nx-px=9"},
                   "fuzzy.speed-rule-nx-px",
                   "9 is above 6 of fuzzy.speed-rule-nx-pb"},
        BadSetting{"references_reversed",
                   {"fuzzy.energy-reference=6", "fuzzy.energy-limit=5"},
                   "fuzzy.energy-limit",
                   "above fuzzy.energy-reference"}),
    [](const auto& which) { return std::string(which.param.name); });

TEST(BadScenario, RangesThatAreReversedOrEmptyAreRefused) {
  const auto lineOf = [](auto change) {
    milling::Scenario cut = test::demoCut();
    change(cut);
    const Status status = milling::check(cut, "s.toml");
    return status ? std::string() : status.error().line();
  };
  EXPECT_THAT(lineOf([](milling::Scenario& s) { std::swap(s.overrides.lowestSpeed, s.overrides.highestSpeed); }),
              testing::HasSubstr("s.toml: overrides: the speed range must rise"));
  EXPECT_THAT(lineOf([](milling::Scenario& s) { s.overrides.longestDelay = Seconds(0.0); }),
              testing::HasSubstr("the delays must rise"));
  EXPECT_THAT(lineOf([](milling::Scenario& s) { s.drive.acceleration = 0.0; }),
              testing::HasSubstr("s.toml: drive: every value must be above zero"));
  EXPECT_THAT(
      lineOf([](milling::Scenario& s) { std::swap(s.programme.depth.segments[0], s.programme.depth.segments[1]); }),
      testing::HasSubstr("s.toml: programme: depth"));
}

}  // namespace
}  // namespace stillcut::app
