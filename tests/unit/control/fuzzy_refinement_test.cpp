// Xu 2003, chapter 3, one refinement at a time; and the signs that the paper prints otherwise, by what a cut makes of
// them.
#include <gtest/gtest.h>

#include <memory>
#include <string_view>

#include "core/control/fuzzy.h"
#include "core/control/registry.h"

namespace stillcut::control {
namespace {

// Whole control cycles of 32 steps, coherence at its reference unless set, energy in
// levels of the stable cut.
class FuzzyCycles {
 public:
  explicit FuzzyCycles(std::string_view strategy, const char* key = nullptr, const char* value = nullptr)
      : strategy_(std::move(makeStrategy(strategy)).value()) {
    config::ParamCatalog catalog;
    catalog.add(fuzzyParams());
    config::ParamSet params;
    if (key != nullptr) {
      EXPECT_TRUE(params.set(catalog, key, value, "test"));
    }
    CutSetup setup;
    setup.teeth = 4;
    strategy_->prepare(setup, params);
    in_.dt = Seconds(1.0 / 128.0);
    in_.machine.valid = true;
    in_.machine.programmedSpeed = in_.machine.actualSpeed = Rpm(800.0);
    in_.machine.programmedFeed = fromMmPerMin(200.0);
    in_.verdict.valid = true;
    in_.verdict.phase = CutPhase::Steady;
    in_.verdict.state = CutState::Stable;
    run(8, 1.0);  // two seconds of stable cut
  }
  // Speed factor at the end.
  double run(int cycles, double energy) {
    for (int i = 0; i < 32 * cycles; ++i) {
      in_.now += toDuration(in_.dt);
      in_.coherence = coherence;
      in_.energy = energy;
      const OverrideRequest r = strategy_->decide(in_);
      if (r.kind != RequestKind::Set) continue;
      speed_ = r.speed.value / 800.0;
      feed_ = r.feed / in_.machine.programmedFeed;
    }
    return speed_;
  }
  double feed() const { return feed_; }
  // How far one more cycle lowers the speed.
  double step(double energy) {
    const double before = speed_;
    return before - run(1, energy);
  }

  double coherence = 0.8;  // gamma_ref: asks for nothing

 private:
  std::unique_ptr<Strategy> strategy_;
  StrategyInput in_;
  double speed_ = 1.0, feed_ = 1.0;
};

// Section 3.3.5.1: alpha, alpha^2 ... while the energy rises three cycles running. Both cuts are so loud that every
// membership is at its end.
TEST(FuzzyRefinement, OvershootIsSuppressedByLargerSteps) {
  FuzzyCycles standing("fuzzy"), rising("fuzzy");
  standing.run(8, 3.6);
  rising.run(8, 3.6);
  const double usual = standing.step(3.6);
  ASSERT_GT(usual, 0.0);
  EXPECT_NEAR(rising.step(3.7), usual, 1e-9);  // once is no trend
  EXPECT_NEAR(rising.step(3.8), 1.1 * usual, 1e-9);
  EXPECT_NEAR(rising.step(3.9), 1.21 * usual, 1e-9);
  EXPECT_NEAR(rising.step(3.9), usual, 1e-9);
}

// Section 3.3.5.2 and table 3.1: above the upper limit of the energy the feed is at its lowest within the cycle; the
// speed, which may be on its way through a narrow pocket, goes no faster.
TEST(FuzzyRefinement, AnImpactTakesTheFeedToItsLowestAtOnceAndTheSpeedNoFaster) {
  FuzzyCycles below("fuzzy"), above("fuzzy");
  below.run(2, 4.9);
  above.run(2, 4.9);
  ASSERT_GT(above.feed(), 0.6);
  const double usual = below.step(4.9);
  ASSERT_GT(usual, 0.0);
  EXPECT_NEAR(above.step(5.1), usual, 1e-9);
  EXPECT_NEAR(above.feed(), 0.5, 1e-9);  // gate.lowest-feed-override
  EXPECT_GT(below.feed(), 0.6);
}

// Section 3.3.4.1: large errors of the last cycles widen the inputs, small ones narrow them.
TEST(FuzzyRefinement, InputsAreScaledByTheErrorsOfThePast) {
  FuzzyCycles near("fuzzy"), far("fuzzy");
  near.coherence = far.coherence = 0.88;
  near.run(8, 1.52);  // energy 0.02 from its reference
  far.run(8, 0.6);    // 0.9 from it
  const double cautious = near.step(1.52);
  EXPECT_GT(far.step(1.52), cautious + 1e-3);  // the same present inputs
}

// Eq. 3-36, 3-37: single tuning takes the coherence error alone, double tuning the energy error too.
TEST(FuzzyRefinement, DirectTuningIsSingleOrDouble) {
  FuzzyCycles plain("fuzzy"), single("fuzzy-direct", "fuzzy-direct.tuning", "single"),
      both("fuzzy-direct", "fuzzy-direct.tuning", "double");
  for (FuzzyCycles* c : {&plain, &single, &both}) {
    c->coherence = 0.99;
    c->run(8, 3.6);
  }
  const double usual = plain.step(3.6);
  EXPECT_NEAR(single.step(3.6), 0.65 * usual, 1e-9);  // w_gamma
  EXPECT_NEAR(both.step(3.6), usual, 1e-9);           // 0.65 + 1.25, at most 1
  // At the coherence's reference single tuning has nothing to tune by, while the energy still is too high.
  FuzzyCycles deaf("fuzzy-direct", "fuzzy-direct.tuning", "single"), hears("fuzzy-direct");
  EXPECT_EQ(deaf.run(4, 3.6), 1.0);
  EXPECT_LT(hears.run(4, 3.6), 1.0);
}

// It chatters above 720 rpm, whoever asks.
class ChatteringAbove720 {
 public:
  explicit ChatteringAbove720(FuzzyCycles& cut) : cut_(cut) {}
  double run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 4.0); ++i) factor_ = cut_.run(1, factor_ > 0.9 ? 4.0 : 1.0);
    return factor_;
  }

 private:
  FuzzyCycles& cut_;
  double factor_ = 1.0;
};

// Figure 3.9 prints PB for energy PB: the speed would never leave the chatter.
TEST(FuzzySigns, EnergyAloneLeadsOutOfTheChatter) {
  for (const char* strategy : {"fuzzy", "fuzzy-learning", "fuzzy-direct"}) {
    FuzzyCycles cut(strategy);
    ChatteringAbove720 plant(cut);
    EXPECT_LT(plant.run(15.0), 0.9) << strategy;
  }
}

// Eq. 3-33 prints k + delta: rules that did not end the chatter would ask for less the longer it lasts.
TEST(FuzzySigns, RulesThatDoNotEndTheChatterLearnToAskForMore) {
  FuzzyCycles plain("fuzzy"), learning("fuzzy-learning");
  for (FuzzyCycles* c : {&plain, &learning}) {
    c->coherence = 0.95;
    c->run(12, 1.5);
  }
  const double before = plain.step(1.5);
  ASSERT_GT(before, 0.0);
  EXPECT_GT(learning.step(1.5), 1.02 * before);
}

}  // namespace
}  // namespace stillcut::control
