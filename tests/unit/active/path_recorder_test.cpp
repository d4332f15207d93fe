// The record that a path is identified from, and what the identified path promises.
#include "core/active/path_recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/active/path_filter.h"
#include "core/active/stability_margin.h"
#include "tests/support/path_counter.h"
#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

const Hertz kRate(5000.0);
const PathModel kPath{{0.0, 0.5, 0.3, -0.1}, {0.8, -0.5}};

std::array<safety::ActuatorLimits, kActiveAxes> limits() {
  safety::ActuatorLimits one;
  one.amplitude = 3.0;
  one.slew = 1e6;
  return {one, one};
}

class Recorded : public testing::Test {
 protected:
  void prepare(const RecordRequest& request) {
    const Status ok = recorder_.prepare(request, limits(), kRate);
    ASSERT_TRUE(ok.ok()) << ok.error().line();
    for (PathFilter& p : paths_) p.prepare(kPath);
  }
  // Until it is over; gives the samples it took.
  int run(int most = 100000) {
    int n = 0;
    for (; n < most && !recorder_.over(); ++n) {
      recorder_.begin();
      AxisPair errors{-paths_[0].arrive(), -paths_[1].arrive()};
      if (n >= deadFrom_) errors[1] = 0.125;
      const CommandPair commands = recorder_.step(errors);
      for (std::size_t a = 0; a < 2; ++a) {
        last_[a] = commands[a].value();
        paths_[a].push(last_[a]);
        largest_ = std::max(largest_, std::abs(last_[a]));
      }
    }
    return n;
  }

  PathRecorder recorder_;
  std::array<PathFilter, 2> paths_;
  AxisPair last_{};
  double largest_ = 0.0;
  int deadFrom_ = 1 << 30;
};

double meanProduct(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += a[n] * b[n];
  return sum / static_cast<double>(a.size());
}

TEST_F(Recorded, NoiseMovesBothAxesAtOnceAndNeitherKnowsTheOther) {
  prepare({.duration = Seconds(4.0), .rms = 0.1});
  EXPECT_FALSE(recorder_.over());
  const int took = run();
  ASSERT_TRUE(recorder_.over());
  EXPECT_TRUE(recorder_.complete().ok());
  EXPECT_GE(took, 20000);
  EXPECT_LE(took, 20000 + 30);  // and the ramp out
  EXPECT_EQ(last_[0], 0.0);
  EXPECT_EQ(last_[1], 0.0);
  EXPECT_LE(largest_, 3.0);
  const auto x = recorder_.output(0), y = recorder_.output(1);
  ASSERT_EQ(x.size(), 20000U);
  EXPECT_NEAR(std::sqrt(meanProduct(x, x)), 0.3, 0.02);
  EXPECT_LT(std::abs(meanProduct(x, y)) / meanProduct(x, x), 0.05);
}

TEST_F(Recorded, TheReadingIsThatOfThePathThatIsTakenOff) {
  prepare({.duration = Seconds(1.0), .rms = 0.1});
  run();
  const auto y = recorder_.output(0);
  const auto plain = plainPath(kPath.forward, kPath.backward, {y.begin(), y.end()});
  for (std::size_t n = 0; n < plain.size(); ++n) ASSERT_NEAR(recorder_.reading(0)[n], plain[n], 1e-9) << n;
}

TEST_F(Recorded, ASweepMovesOneAxisAfterTheOther) {
  prepare({.excitation = Excitation::Sweep, .duration = Seconds(4.0), .rms = 0.1});
  run();
  for (std::size_t a = 0; a < 2; ++a) {
    const auto own = recorder_.output(a);
    ASSERT_EQ(own.size(), 10000U);
    EXPECT_NEAR(std::sqrt(meanProduct(own, own)), 0.3, 0.02) << a;
    // From low to high: sign changes grow with time.
    const auto crossings = [&](std::size_t from, std::size_t to) {
      int count = 0;
      for (std::size_t n = from + 1; n < to; ++n) count += (own[n] > 0.0) != (own[n - 1] > 0.0) ? 1 : 0;
      return count;
    };
    EXPECT_GT(crossings(8000, 9500), 3 * crossings(1000, 2500)) << a;
  }
}

TEST_F(Recorded, ADeadSensorEndsItAndIsNamed) {
  deadFrom_ = 8000;
  prepare({.duration = Seconds(4.0), .rms = 0.1});
  const int took = run();
  EXPECT_LT(took, 8000 + 100);
  const Status whole = recorder_.complete();
  ASSERT_FALSE(whole.ok());
  EXPECT_NE(whole.error().line().find("stands still"), std::string::npos);
}

TEST_F(Recorded, IsStoppedAtAnyTime) {
  prepare({.duration = Seconds(4.0), .rms = 0.1});
  run(5000);
  EXPECT_NEAR(recorder_.part(), 0.25, 0.01);
  std::array<ActiveAxis, kActiveAxes> told;
  recorder_.tell(told);
  EXPECT_EQ(told[0].state, ActuatorState::On);
  EXPECT_GT(told[1].strokeRms, 0.05);
  recorder_.release();
  EXPECT_LE(run(), 26);
  EXPECT_NE(recorder_.complete().error().line().find("stopped"), std::string::npos);
}

TEST_F(Recorded, RefusesWhatIsNoExcitation) {
  EXPECT_FALSE(recorder_.prepare({.duration = Seconds(0.1)}, limits(), kRate).ok());
  EXPECT_FALSE(recorder_.prepare({.rms = 0.5}, limits(), kRate).ok());
  EXPECT_FALSE(recorder_.prepare({.rms = std::nan("")}, limits(), kRate).ok());
  auto none = limits();
  none[1].slew = 0.0;
  EXPECT_FALSE(recorder_.prepare({}, none, kRate).ok());
}

TEST_F(Recorded, AFrameAsksForNoMemoryAndTakesNoLock) {
  if (!test::PathCounter::works()) GTEST_SKIP() << "the sanitizer counts";
  prepare({.duration = Seconds(1.0), .rms = 0.1});
  const test::PathCounter counter;
  run();
  EXPECT_TRUE(counter.counts().none());
}

// A model and what was measured: `turned` radians apart at every frequency.
IdentifiedPath found(double turned, double coherence = 1.0) {
  IdentifiedPath path;
  path.model = kPath;
  for (double f = 10.0; f < 2000.0; f += 10.0) {
    const auto model = kPath.response(Hertz(f), kRate);
    path.report.frequency.push_back(f);
    path.report.modelled.push_back(model);
    path.report.measured.push_back(model * std::polar(1.0, turned));
    path.report.coherence.push_back(coherence);
  }
  return path;
}

TEST(PathPromise, WhatIsLeftOfNinetyDegreesIsWhatTheLoopMayBecomeLater) {
  const std::array<Hertz, 2> lines{Hertz(339.0), Hertz(1024.0)};
  const ActivePath good = stabilityMarginOf(found(0.0), lines, kRate);
  EXPECT_TRUE(good.predictedStable);
  EXPECT_NEAR(good.phaseMargin, 0.5 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(good.delayMargin.value, 0.25 / 1030.0, 0.01 / 1030.0);  // a quarter of a period of the highest line
  const ActivePath turned = stabilityMarginOf(found(1.0), lines, kRate);
  EXPECT_NEAR(turned.phaseMargin, 0.5 * std::numbers::pi - 1.0, 1e-9);
  EXPECT_LT(turned.delayMargin.value, good.delayMargin.value);
  const ActivePath wrong = stabilityMarginOf(found(-2.0), lines, kRate);
  EXPECT_FALSE(wrong.predictedStable);
  EXPECT_EQ(wrong.delayMargin.value, 0.0);
}

TEST(PathPromise, WhatIsNotHeardIsNotPromised) {
  const std::array<Hertz, 1> lines{Hertz(339.0)};
  EXPECT_FALSE(stabilityMarginOf(found(0.0, 0.5), lines, kRate).predictedStable);
  EXPECT_TRUE(stabilityMarginOf(found(0.0), {}, kRate).predictedStable);  // no lines: everything counts
  const std::array<Hertz, 2> oneDeaf{Hertz(339.0), Hertz(2300.0)};
  EXPECT_FALSE(stabilityMarginOf(found(0.0), oneDeaf, kRate).predictedStable);  // every line counts
  const std::array<Hertz, 1> beyond{Hertz(2300.0)};
  EXPECT_FALSE(stabilityMarginOf(found(0.0), beyond, kRate).predictedStable);
}

TEST(PathPromise, TheDelayIsThatOfTheFirstThatIsHeard) {
  EXPECT_EQ(leadingDelay(kPath), 2);
  PathModel late = kPath;
  late.delay = 64;
  EXPECT_EQ(leadingDelay(late), 66);
  EXPECT_EQ(stabilityMarginOf({late, found(0.0).report}, {}, kRate).delay.value, 66.0 / kRate.value);
}

}  // namespace
}  // namespace stillcut::active
