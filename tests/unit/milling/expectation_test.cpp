// What every shipped scenario expects of control, proved by the exact lobes at the most demanding part of its path. The
// lobes are those of straight teeth; where a tool has a helix, helixIsProved() says why they hold all the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "core/milling/simulation/scenario.h"
#include "core/milling/stability/advice.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::milling {
namespace {

namespace fs = std::filesystem;

std::string file(const std::string& name) {
  return (fs::path(STILLCUT_SOURCE_DIR) / "resources" / "scenarios" / (name + ".toml")).string();
}

// The deepest part with the widest engagement: where both vary they are at their largest together or nearly so in every
// shipped scenario, and the pair is never milder than what is met.
struct Demand {
  CutModel model;
  Metres depth{};
  Rpm lowest{}, highest{};
};

Demand demandOf(const Scenario& s) {
  Demand d{s.model, Metres(s.programme.depth.highest(0.0)), {}, {}};
  d.model.engagement.radialImmersion = s.programme.immersion.highest(s.model.engagement.radialImmersion);
  d.lowest = Rpm(s.programme.speed.value * s.overrides.lowestSpeed.value);
  d.highest = Rpm(s.programme.speed.value * s.overrides.highestSpeed.value);
  return d;
}

bool stableAt(const ExactLobes& lobes, Rpm speed, Metres depth) {
  const auto limits =
      lobes.limits(speed, {.maxAxialDepth = depth, .firstOnly = false, .frequencies = false, .hint = {}});
  return limits.ok() && limits->verified && limits->stableAt(depth);
}

AdviceRequest requestOf(const Demand& d) {
  AdviceRequest r;
  r.depth = d.depth;
  r.lowest = d.lowest;
  r.highest = d.highest;
  return r;
}

class Expected : public ::testing::TestWithParam<std::string> {};

TEST_P(Expected, IsWhatTheExactLobesSay) {
  const Result<Scenario> s = loadScenario(file(GetParam()));
  ASSERT_TRUE(s.ok()) << s.error().line();
  const Demand d = demandOf(*s);
  if (d.depth.value <= 0.0) {
    EXPECT_EQ(s->expect, Expectation::Stable) << "nothing is cut";
    return;
  }
  const auto lobes = ExactLobes::make(d.model, s->name);
  ASSERT_TRUE(lobes.ok()) << lobes.error().line();
  // Nothing to be done: stable at every programmed speed.
  std::vector<Rpm> speeds{s->programme.speed};
  for (const ScheduleSegment& g : s->programme.speedOverTime.segments) speeds.emplace_back(g.toValue);
  const bool quiet =
      std::all_of(speeds.begin(), speeds.end(), [&](Rpm speed) { return stableAt(*lobes, speed, d.depth); });
  EXPECT_TRUE(quiet || s->expect != Expectation::Hold) << s->name;
  if (quiet) {
    EXPECT_NE(s->expect, Expectation::NoStableSpeed) << s->name;
    return;
  }
  EXPECT_FALSE(stableAt(*lobes, s->programme.speed, d.depth)) << "control has nothing to do";
  if (d.lowest == d.highest) {
    EXPECT_EQ(s->expect, Expectation::NoStableSpeed);
    return;
  }
  const auto advice = adviseSpeeds(d.model, requestOf(d), s->name);
  ASSERT_TRUE(advice.ok()) << advice.error().line();
  ASSERT_TRUE(advice->finished);
  for (const SpeedPocket& p : advice->pockets) {
    std::cout << s->name << ": " << p.from.speed.value << " to " << p.to.speed.value << " rpm, best " << p.best.value
              << ", limit " << p.limit.value * 1e3 << " mm, margin " << p.margin << "\n";
  }
  EXPECT_EQ(!advice->pockets.empty(), s->expect == Expectation::Stable);
}

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const fs::directory_entry& e : fs::directory_iterator(fs::path(STILLCUT_SOURCE_DIR) / "resources/scenarios")) {
    if (e.path().extension() == ".toml") names.push_back(e.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Scenario, Expected, ::testing::ValuesIn(shipped()), [](const auto& named) {
  std::string name = named.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace stillcut::milling
