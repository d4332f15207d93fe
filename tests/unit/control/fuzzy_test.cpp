// fuzzy, fuzzy-learning, fuzzy-direct against Xu 2003, chapter 3.
#include "core/control/fuzzy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/control/registry.h"

namespace stillcut::control {
namespace {

TEST(FuzzyRules, WeightedAverageOfThePapersExample) {
  WeightedAverage u;
  u.add(0.1, 5.0);
  u.add(0.1, 5.0);
  u.add(0.3, 5.0);
  u.add(0.7, 4.0);
  EXPECT_NEAR(u.value(), 4.4167, 5e-5);
}

TEST(FuzzyRules, MembershipsSumToOneAndNameAtMostTwoSets) {
  for (double x = -1.5; x <= 1.5; x += 0.01) {
    const auto d = memberships<kCoherenceSets>(x);
    EXPECT_NEAR(std::accumulate(d.begin(), d.end(), 0.0), 1.0, 1e-12);
    EXPECT_LE(std::count_if(d.begin(), d.end(), [](double v) { return v > 0.0; }), 2);
  }
  EXPECT_EQ(memberships<kCoherenceSets>(std::numeric_limits<double>::quiet_NaN())[4], 1.0);
}

TEST(FuzzyRules, SetsHaveTheirPeaksWhereTheyArePutAndSumToOne) {
  const SetCentres centres{0.1, 0.3, 0.9};
  const std::array<double, 9> peaks{-1.0, -0.9, -0.3, -0.1, 0.0, 0.1, 0.3, 0.9, 1.0};
  for (std::size_t k = 0; k < peaks.size(); ++k) EXPECT_EQ(memberships(peaks[k], centres)[k], 1.0) << k;
  for (double x = -1.5; x <= 1.5; x += 0.01) {
    const auto d = memberships(x, centres), uniform = memberships(x, kUniformCentres);
    const auto plain = memberships<kCoherenceSets>(x);
    EXPECT_NEAR(std::accumulate(d.begin(), d.end(), 0.0), 1.0, 1e-12);
    for (std::size_t k = 0; k < d.size(); ++k) EXPECT_NEAR(uniform[k], plain[k], 1e-12) << x;
  }
  EXPECT_EQ(memberships(std::numeric_limits<double>::quiet_NaN(), centres)[4], 1.0);
}

TEST(FuzzyRules, EveryCellIsAParameterWithThePrintedRuleAsItsDefault) {
  const config::ParamTable cells = fuzzyRuleParams();
  ASSERT_EQ(cells.size(), 162U);
  EXPECT_EQ(cells[0]->key, "fuzzy.speed-rule-nx-nx");
  EXPECT_EQ(cells[161]->key, "fuzzy.feed-rule-px-px");
  const FuzzyOptions defaults = fuzzyOptions({});
  EXPECT_EQ(defaults.speedRules, kSpeedRules);
  EXPECT_EQ(defaults.feedRules, kFeedRules);
  config::ParamSet changed;
  ASSERT_TRUE(changed.set(*cells[8 * 9 + 8], 1.0, "test").ok());
  EXPECT_EQ(fuzzyOptions(changed).speedRules[8][8], 1.0);
}

TEST(FuzzyRules, AChangedRuleActsOnTheRunningCutUnlessTheReferencesAreReversed) {
  Fuzzy fuzzy;
  fuzzy.prepare(CutSetup(), {});
  RuleTables told;
  ASSERT_TRUE(fuzzy.readRules(told));
  EXPECT_EQ(told.speed[8][8], 2.0F);
  EXPECT_EQ(told.lessons, 0U);
  config::ParamSet changed;
  ASSERT_TRUE(changed.set(*fuzzyRuleParams()[8 * 9 + 8], 1.0, "test").ok());
  fuzzy.retune(changed);
  ASSERT_TRUE(fuzzy.readRules(told));
  EXPECT_EQ(told.speed[8][8], 1.0F);
  ASSERT_TRUE(changed.set(*fuzzyRuleParams()[0], 9.0, "test").ok());
  for (const config::ParamDecl* decl : fuzzyParams()) {
    if (decl->key != "fuzzy.energy-reference") continue;
    ASSERT_TRUE(changed.set(*decl, 19.0, "test").ok());
  }
  fuzzy.retune(changed);
  ASSERT_TRUE(fuzzy.readRules(told));
  EXPECT_EQ(told.speed[0][0], 8.0F) << "what cannot be used together changes nothing";
}

TEST(FuzzyRules, TablesFallWithCoherenceAndWithItsChange) {
  for (const RuleTable* table : {&kSpeedRules, &kFeedRules}) {
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t j = 0; j < 9; ++j) {
        if (i > 0) {
          EXPECT_LE((*table)[i][j], (*table)[i - 1][j]) << i << "," << j;
        }
        if (j > 0) {
          EXPECT_LE((*table)[i][j], (*table)[i][j - 1]) << i << "," << j;
        }
      }
    }
  }
  EXPECT_EQ(kSpeedRules[8][8], 2.0);  // figure 3.7: PX, PX gives NB
  EXPECT_EQ(kFeedRules[4][4], kZero);
}

TEST(FuzzyRules, ATableThatRisesIsRefusedAndATouchOfOneRuleIsNot) {
  const config::ParamTable cells = fuzzyRuleParams();
  const std::vector<std::pair<std::size_t, const RuleTable*>> tables{{0, &kSpeedRules}, {81, &kFeedRules}};
  for (const auto& [first, printed] : tables) {
    config::ParamSet byError, byChange;
    for (std::size_t k = 0; k < 81; ++k) {
      ASSERT_TRUE(byError.set(*cells[first + k], (*printed)[8 - k / 9][k % 9], "test").ok());
      ASSERT_TRUE(byChange.set(*cells[first + k], (*printed)[k / 9][8 - k % 9], "test").ok());
    }
    for (const config::ParamSet* reversed : {&byError, &byChange}) {
      const Status status = checkFuzzyOptions(fuzzyOptions(*reversed));
      ASSERT_FALSE(status.ok());
      const std::string line = status.error().line(), table = first == 0 ? "fuzzy.speed-rule-" : "fuzzy.feed-rule-";
      EXPECT_EQ(line.rfind(table, 0), 0U) << line;
      EXPECT_NE(line.find("must fall"), std::string::npos) << line;
      Fuzzy fuzzy;
      EXPECT_THROW(fuzzy.prepare(CutSetup(), *reversed), std::runtime_error);
      fuzzy.prepare(CutSetup(), {});
      fuzzy.retune(*reversed);
      RuleTables told;
      ASSERT_TRUE(fuzzy.readRules(told));
      EXPECT_EQ(told.speed[0][0], 8.0F) << "on the running cut it changes nothing";
      EXPECT_EQ(told.feed[8][0], 4.0F);
      EXPECT_TRUE(told.refused);
      fuzzy.retune({});
      ASSERT_TRUE(fuzzy.readRules(told));
      EXPECT_FALSE(told.refused);
    }
  }
  for (const config::ParamDecl* cell : cells) {
    for (const double touch : {-1.0, 1.0}) {
      config::ParamSet touched;
      ASSERT_TRUE(touched.set(*cell, cell->fallback + touch, "test").ok());
      EXPECT_TRUE(checkFuzzyOptions(fuzzyOptions(touched)).ok()) << cell->key;
    }
  }
}

TEST(FuzzyRules, EnergyAboveItsReferenceLowers) {
  EXPECT_LT(infer(kSpeedRules, {0.0, 0.0, 1.0, true}), 0.0);
  EXPECT_GT(infer(kSpeedRules, {0.0, 0.0, -1.0, true}), 0.0);
  EXPECT_NEAR(infer(kSpeedRules, {0.0, 0.0, 1.0, false}), 0.0, 1e-12);
}

// A cut whose vibration and severity the test sets.
class FuzzyTest : public ::testing::TestWithParam<std::string_view> {
 protected:
  void SetUp() override {
    strategy_ = std::move(makeStrategy(GetParam())).value();
    setup_.teeth = 4;
    in_.dt = Seconds(0.01);
    in_.machine.valid = true;
    in_.machine.programmedSpeed = in_.machine.actualSpeed = Rpm(800.0);
    in_.machine.programmedFeed = fromMmPerMin(200.0);
    in_.verdict.valid = true;
    in_.verdict.phase = CutPhase::Steady;
    strategy_->prepare(setup_, {});
  }
  OverrideRequest run(double seconds, double severity, double vibration) {
    in_.verdict.severity = Ratio(severity);
    in_.verdict.state = severity > 0.1 ? CutState::Chatter : CutState::Stable;
    in_.verdict.frequency = Hertz(severity > 0.1 ? 201.0 : 0.0);
    in_.vibration = vibration;
    OverrideRequest last;
    for (double t = 0.0; t < seconds; t += 0.01) {
      in_.now += toDuration(in_.dt);
      last = strategy_->decide(in_);
    }
    return last;
  }

  CutSetup setup_;
  StrategyInput in_;
  std::unique_ptr<Strategy> strategy_;
};

TEST_P(FuzzyTest, OnlyWhatLearnsMovesItsRulesAndTellsSo) {
  run(1.0, 0.01, 2.0);
  run(10.0, 0.6, 8.0);
  RuleTables told;
  EXPECT_TRUE(strategy_->readRules(told));
  int lowered = 0, raised = 0;
  for (std::size_t i = 0; i < kSpeedRules.size(); ++i) {
    for (std::size_t j = 0; j < kSpeedRules[i].size(); ++j) {
      lowered += told.speed[i][j] < static_cast<float>(kSpeedRules[i][j]) ? 1 : 0;
      raised += told.speed[i][j] > static_cast<float>(kSpeedRules[i][j]) ? 1 : 0;
    }
  }
  const bool learns = GetParam() == "fuzzy-learning";
  EXPECT_EQ(told.lessons > 0, learns);
  EXPECT_EQ(lowered > 0, learns) << "rules of high coherence ask for less";
  EXPECT_LE(raised, lowered);
}

TEST_P(FuzzyTest, AStableCutIsLeftAlone) {
  EXPECT_EQ(run(5.0, 0.01, 2.0).kind, RequestKind::None);
}

TEST_P(FuzzyTest, ChatterLowersSpeedAndFeedAndNeverStopsTheSpindle) {
  run(2.0, 0.01, 2.0);
  const OverrideRequest r = run(10.0, 0.9, 8.0);
  ASSERT_EQ(r.kind, RequestKind::Set);
  EXPECT_LT(r.speed.value, 800.0);
  EXPECT_GE(r.speed.value, 400.0 - 1e-9);
  EXPECT_LE(r.feed / in_.machine.programmedFeed, r.speed.value / 800.0 + 1e-9);  // feed per tooth
  EXPECT_EQ(r.reason.code, ReasonCode::FuzzyRules);
  EXPECT_NEAR(r.reason.n[1], 4.0, 0.01);  // times the stable cut
}

TEST_P(FuzzyTest, AboveTheUpperLimitTheFeedIsHeldWhileTheSpindleTurns) {
  run(2.0, 0.01, 2.0);
  const OverrideRequest r = run(1.0, 0.9, 25.0);
  EXPECT_EQ(r.feed.value, 0.0);
  EXPECT_GT(r.speed.value, 0.0);
}

// Without feed nothing is cut, which sounds like air: that must not keep the feed held.
TEST_P(FuzzyTest, AHeldFeedComesBackThoughNothingIsCut) {
  config::ParamSet mayStop;
  ASSERT_TRUE(mayStop.set(config::kLowestFeedOverride, 0.0, "test").ok());
  ASSERT_TRUE(mayStop.set(config::kLowestFeedPerTooth, 0.0, "test").ok());
  strategy_->prepare(setup_, mayStop);
  run(2.0, 0.01, 2.0);
  const OverrideRequest held = run(1.0, 0.9, 25.0);
  ASSERT_EQ(held.feed.value, 0.0);
  in_.verdict.phase = CutPhase::AirCutting;
  const OverrideRequest after = run(10.0, 0.0, 0.1);
  EXPECT_GT(after.feed.value, 0.5 * in_.machine.programmedFeed.value);
  EXPECT_LE(after.feed / in_.machine.programmedFeed, after.speed.value / 800.0 + 1e-9);
  EXPECT_EQ(after.speed, held.speed) << "in air nothing else is learned or moved";
}

TEST_P(FuzzyTest, OneCycleMovesNoFurtherThanItsStep) {
  run(2.0, 0.01, 2.0);
  double last = 800.0;
  for (int i = 0; i < 40; ++i) {
    const OverrideRequest r = run(0.05, 0.9, 8.0);
    const double now = r.kind == RequestKind::Set ? r.speed.value : 800.0;
    EXPECT_LE(last - now, 0.26 * 400.0 / 4.0);  // eq. 3-29 over a range time of 4 s, cycles of 0.25 s
    last = now;
  }
}

TEST_P(FuzzyTest, MovesNoOftenerThanTheMachineActs) {
  in_.machine.link.effect = Seconds(0.6);
  run(2.0, 0.01, 2.0);
  int moves = 0;
  double last = 800.0;
  for (int i = 0; i < 300; ++i) {  // 3 s: twelve cycles of 0.25 s, five of the machine
    const OverrideRequest r = run(0.01, 0.9, 8.0);
    const double now = r.kind == RequestKind::Set ? r.speed.value : 800.0;
    moves += std::abs(now - last) > 1e-9 ? 1 : 0;
    last = now;
  }
  EXPECT_GE(moves, 3);
  EXPECT_LE(moves, 5);
}

TEST_P(FuzzyTest, TheSpeedDoesNotClimbBackWhileTheAlarmIsFresh) {
  run(2.0, 0.01, 2.0);
  const double low = run(2.0, 0.9, 8.0).speed.value;
  EXPECT_NEAR(run(20.0, 0.01, 1.8).speed.value, low, 1e-9);
  EXPECT_GT(run(60.0, 0.01, 1.0).speed.value, low);
}

TEST_P(FuzzyTest, ALevelThatFallsLeavesTheSpeedWhereItIs) {
  run(2.0, 0.01, 2.0);
  const double low = run(2.0, 0.9, 12.0).speed.value;
  double level = 12.0;
  for (int i = 0; i < 3; ++i) {  // a pocket: in each cycle of 0.25 s a quarter less, still above the reference
    level *= 0.75;
    run(0.25, 0.9, level);
  }
  EXPECT_NEAR(run(0.01, 0.9, level).speed.value, low, 0.01 * 800.0);  // the cycle in which it began to fall may move
}

// gamma_max of averaged spectra is still that of the chatter when the level has long gone.
TEST_P(FuzzyTest, CoherenceOfThePastMovesNothing) {
  run(2.0, 0.01, 2.0);
  in_.coherence = 0.99;
  in_.energy = 2.0;
  run(2.0, 0.01, 2.0);
  in_.energy = 9.0;
  run(2.0, 0.9, 9.0);
  in_.energy = 2.0;
  run(0.5, 0.01, 2.0);
  const double after = run(0.01, 0.01, 2.0).speed.value;
  EXPECT_NEAR(run(1.0, 0.01, 2.0).speed.value, after, 1e-6);
}

TEST_P(FuzzyTest, UnusableInputIsNeverASet) {
  in_.verdict.valid = false;
  EXPECT_EQ(run(1.0, 0.9, 8.0).kind, RequestKind::None);
  in_.verdict.valid = true;
  run(2.0, 0.9, 8.0);
  in_.machine.valid = false;
  EXPECT_EQ(run(0.1, 0.9, 8.0).kind, RequestKind::Hold);
}

INSTANTIATE_TEST_SUITE_P(Xu, FuzzyTest, ::testing::Values("fuzzy", "fuzzy-learning", "fuzzy-direct"),
                         [](const auto& test) {
                           std::string name(test.param);
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace stillcut::control
