// A tap test as it happens: hits cut out of a stream, judged, averaged; with a hammer and without.
#include <gtest/gtest.h>

#include <functional>

#include "core/milling/identify/live/free_decay.h"
#include "core/milling/identify/live/tap_test.h"
#include "core/milling/identify/modal_fit.h"
#include "core/milling/simulation/simulated_tap.h"

namespace stillcut::identify {
namespace {

using milling::SimulatedTap;
using milling::TapBlow;
using milling::TapStructure;

constexpr int kBlock = 512;

// Blows every 1.2 s into a test along x, in blocks as a device delivers them.
class Bench {
 public:
  explicit Bench(TapTestOptions options = {}, TapStructure structure = milling::usualTapStructure())
      : tap_(std::move(structure), 7), test_(tap_.structure().rate.value, options) {
    pass(0.5);
  }
  void hit(const TapBlow& blow = {}, bool gap = false) {
    tap_.strike(blow);
    pass(0.1);
    pass(1.1, gap);
  }
  void pass(double seconds, bool gap = false) {
    const int blocks = static_cast<int>(seconds * tap_.structure().rate.value / kBlock) + 1;
    for (int b = 0; b < blocks; ++b) {
      std::vector<double> force, response;
      for (int k = 0; k < kBlock; ++k) {
        const SimulatedTap::Sample s = tap_.step();
        if (test_.options().withForce) force.push_back(s.force);
        response.push_back(s.acceleration[0]);
      }
      test_.feed(force, response, gap && b == 0);
    }
  }
  TapTest& test() { return test_; }
  std::vector<HitFault> faults() const {
    std::vector<HitFault> all;
    for (const TapHit& hit : test_.hits()) all.push_back(hit.fault);
    return all;
  }

 private:
  SimulatedTap tap_;
  TapTest test_;
};

TapBlow blow(double force, double width = 0.25e-3) {
  TapBlow b;
  b.force = force;
  b.width = width;
  return b;
}

TEST(TapTest, NamesWhatIsWrongWithAHitAndEndsWithFiveGoodOnes) {
  Bench bench;
  EXPECT_EQ(bench.test().phase(), TapTest::Phase::Waiting);
  bench.hit(blow(220));
  TapBlow twice = blow(240);
  twice.bounce = 0.3;
  bench.hit(twice);
  bench.hit(blow(800));  // the channel ends at 500 N
  bench.hit(blow(12));
  bench.hit(blow(200), true);
  const std::vector<HitFault> expected{HitFault::None, HitFault::DoubleHit, HitFault::ForceOverload, HitFault::Weak,
                                       HitFault::Gap};
  EXPECT_EQ(bench.faults(), expected);
  for (const double force : {180.0, 260.0, 200.0}) bench.hit(blow(force));
  EXPECT_EQ(bench.test().good(), 4);
  bench.hit(blow(230));
  EXPECT_EQ(bench.test().phase(), TapTest::Phase::Enough);
  bench.hit(blow(230));
  EXPECT_EQ(bench.test().hits().size(), 9U) << "enough is enough";
}

TEST(TapTest, ItsRecordsGiveTheModesOfTheStructure) {
  Bench bench;
  for (const double force : {180.0, 260.0, 200.0, 210.0, 240.0}) bench.hit(blow(force));
  const auto analysed = analyseHammer(bench.test().records(), bench.test().options().hammer);
  ASSERT_TRUE(analysed) << analysed.error().line();
  EXPECT_EQ(analysed->averages, 5);
  const auto fit = fitModes(analysed->frf, {});
  ASSERT_TRUE(fit) << fit.error().line();
  ASSERT_EQ(fit->modes.size(), 2U);
  const auto truth = milling::usualTapStructure().modes;
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(fit->modes[k].mode.frequency.value, truth[k].frequency.value, 2.0);
    EXPECT_NEAR(fit->modes[k].mode.damping, truth[k].damping, 0.05 * truth[k].damping);
    EXPECT_NEAR(fit->modes[k].mode.stiffness, truth[k].stiffness, 0.05 * truth[k].stiffness);
    EXPECT_GT(fit->modes[k].coherence, 0.99);
  }
}

// The hammer slips, the accelerometer is loose: its response over force is another.
TEST(TapTest, RefusesAHitThatDisagreesWithTheOthersOnceThereAreThree) {
  Bench bench;
  TapBlow aslant = blow(220);
  aslant.lean = 1.0;
  bench.hit(aslant);
  bench.hit(blow(220));
  EXPECT_EQ(bench.faults(), (std::vector<HitFault>{HitFault::None, HitFault::None})) << "nobody knows which is wrong";
  bench.hit(blow(220));
  EXPECT_EQ(bench.faults(), (std::vector<HitFault>{HitFault::Incoherent, HitFault::None, HitFault::None}));
  bench.test().use(0, true);
  EXPECT_EQ(bench.test().good(), 3) << "whoever measures has the last word";
  bench.test().use(1, false);
  EXPECT_EQ(bench.test().records().size(), 2U);
}

TEST(TapTest, AFirstTouchIsFoundTooWeakOnceTheHitsHaveCome) {
  Bench bench;
  for (const double force : {12.0, 200.0, 220.0}) bench.hit(blow(force));
  EXPECT_EQ(bench.faults(), (std::vector<HitFault>{HitFault::Weak, HitFault::None, HitFault::None}));
}

TEST(TapTest, AHammerThatCountsAPushAsNegativeIsAHammer) {
  Bench bench;
  for (int k = 0; k < 5; ++k) bench.hit(blow(-220));
  EXPECT_EQ(bench.test().good(), 5);
  const auto analysed = analyseHammer(bench.test().records(), bench.test().options().hammer);
  ASSERT_TRUE(analysed);
  const auto fit = fitModes(analysed->frf, {});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->modes[0].mode.stiffness, 2.4e7, 0.05 * 2.4e7);
}

TEST(TapTest, ARingingToolIsWaitedFor) {
  TapStructure bell = milling::usualTapStructure();
  bell.modes = {{Hertz(300.0), 0.001, 2.0e7, {1.0, 0.0}}};  // down to a fiftieth after 2 s
  TapTestOptions options;
  options.catcher.length = 0.3;
  Bench bench(options, bell);
  bench.hit(blow(220));
  EXPECT_EQ(bench.test().phase(), TapTest::Phase::Ringing);
  bench.pass(1.5);
  EXPECT_EQ(bench.test().phase(), TapTest::Phase::Waiting);
}

TEST(TapTest, WithoutAHammerFrequenciesAndDampingComeFromTheDecay) {
  TapTestOptions options;
  options.withForce = false;
  Bench bench(options);
  for (const double force : {180.0, 260.0, 200.0, 210.0, 240.0}) bench.hit(blow(force));
  ASSERT_EQ(bench.test().good(), 5);
  const auto found = analyseDecays(bench.test().records(), {});
  ASSERT_TRUE(found) << found.error().line();
  ASSERT_EQ(found->modes.size(), 2U);
  const auto truth = milling::usualTapStructure().modes;
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(found->modes[k].frequency.value, truth[k].frequency.value, 0.005 * truth[k].frequency.value);
    EXPECT_NEAR(found->modes[k].damping, truth[k].damping, 0.15 * truth[k].damping);
  }
  EXPECT_DOUBLE_EQ(found->modes[0].flexibility, 1.0) << "the softest";
  const double share = truth[0].damping * truth[0].stiffness / (truth[1].damping * truth[1].stiffness);
  EXPECT_NEAR(found->modes[1].flexibility, share, 0.3 * share);
}

TEST(FreeDecay, CutsTheHitsOutOfALongRecord) {
  SimulatedTap tap(milling::usualTapStructure(), 3);
  std::vector<double> response;
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < 20000; ++i) response.push_back(tap.step().acceleration[0]);
    tap.strike(blow(200));
  }
  for (int i = 0; i < 6000; ++i) response.push_back(tap.step().acceleration[0]);
  EXPECT_EQ(cutDecays(response, 25600.0, 0.4).size(), 4U);
  EXPECT_FALSE(analyseDecays({}, {}));
}

}  // namespace
}  // namespace stillcut::identify
