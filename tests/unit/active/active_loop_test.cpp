// Both axes as one loop: coupled plants, what the loop tells of itself, and a change of step and leak on the way.
#include "core/active/active_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/active/path_filter.h"
#include "tests/support/path_counter.h"
#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

constexpr double kRate = 5000.0;
const PathModel kPath{{0.0, 0.5, 0.3, -0.1}, {0.8, -0.5}};

std::array<AxisOptions, kActiveAxes> options() {
  AxisOptions axis;
  axis.controller.filter = {.taps = 35, .step = 0.1, .normalised = true};
  axis.path = kPath;
  axis.limits.amplitude = 10.0;
  axis.limits.slew = 1e6;
  axis.lines = {Hertz(339.0), Hertz(471.0), Hertz(2600.0)};
  return {axis, axis};
}

double tone(double hertz, int n) {
  return std::sin(2.0 * std::numbers::pi * hertz / kRate * n);
}

// Two axes whose actuators are also heard on the other one.
class Coupled {
 public:
  explicit Coupled(double coupling) : coupling_(coupling) {
    for (PathFilter& p : paths_) p.prepare(kPath);
    EXPECT_TRUE(loop.prepare(options(), Hertz(kRate)).ok());
    loop.engage();
  }
  void run(int samples) {
    left = alone = {};
    for (int n = 0; n < samples; ++n, ++now_) {
      const AxisPair d{tone(339.0, now_) + 0.5 * tone(471.0, now_), 0.7 * tone(471.0, now_)};
      const AxisPair s{paths_[0].arrive(), paths_[1].arrive()};
      const AxisPair e{d[0] - s[0] - coupling_ * s[1], d[1] - s[1] + coupling_ * s[0]};
      loop.begin();
      const CommandPair y = loop.step(e);
      for (std::size_t a = 0; a < 2; ++a) {
        paths_[a].push(y[a].value());
        jump = std::max(jump, std::abs(y[a].value() - last_[a]));
        last_[a] = y[a].value();
        left[a] += e[a] * e[a];
        alone[a] += d[a] * d[a];
      }
    }
  }
  double leftRms(std::size_t a) const { return std::sqrt(left[a] / alone[a]); }

  ActiveLoop loop;
  AxisPair left{}, alone{};
  double jump = 0.0;  // largest step of an output

 private:
  double coupling_;
  std::array<PathFilter, 2> paths_;
  AxisPair last_{};
  int now_ = 0;
};

TEST(ActiveLoop, QuietensBothAxesThoughEachHearsTheOther) {
  Coupled world(0.3);
  world.run(20000);
  world.run(5000);
  for (std::size_t a = 0; a < 2; ++a) {
    EXPECT_EQ(world.loop.gate(a).state(), ActuatorState::On);
    EXPECT_LT(world.leftRms(a), 0.05) << a;
  }
}

TEST(ActiveLoop, TellsWhatItEarnsLineByLine) {
  Coupled world(0.0);
  world.run(25000);
  std::array<ActiveAxis, kActiveAxes> told;
  world.loop.tell(told);
  const double alone = std::sqrt(0.5 * (1.0 + 0.25));
  EXPECT_NEAR(told[0].uncontrolledRms, alone, 0.02 * alone);
  EXPECT_LT(told[0].errorRms, 0.05 * alone);
  ASSERT_EQ(told[0].lineCount, 2);  // the third lies above half the rate
  for (const LineAttenuation& line : {told[0].lines[0], told[0].lines[1], told[1].lines[1]}) {
    EXPECT_TRUE(line.known);
    EXPECT_GT(line.gain_dB, 26.0) << line.frequency.value;
  }
  EXPECT_GT(told[0].strokePeak, 0.01);
  EXPECT_LT(told[0].strokePeak, 1.0);
  EXPECT_LT(told[0].strokeRms, told[0].strokePeak);
  EXPECT_EQ(told[0].limitedFraction, 0.0);
}

// The loop without control, with the meter on its own: a tenth of the amplitude is 20 dB.
TEST(LineMeter, MeasuresTheRatioOfALineBesideALouderOne) {
  LineMeter meter;
  const std::array<Hertz, 2> lines{Hertz(471.0), Hertz(339.0)};
  meter.prepare(lines, Hertz(kRate));
  EXPECT_FALSE(meter.line(0).known);
  for (int n = 0; n < 6000; ++n) {
    meter.add(0.1 * tone(471.0, n) + 3.0 * tone(339.0, n), tone(471.0, n) + 3.0 * tone(339.0, n));
  }
  EXPECT_NEAR(meter.line(0).gain_dB, 20.0, 0.1);
  EXPECT_NEAR(meter.line(1).gain_dB, 0.0, 0.01);
}

TEST(ActiveLoop, StepAndLeakChangeWithoutAClick) {
  Coupled still(0.0), changed(0.0);
  for (Coupled* world : {&still, &changed}) {
    world->run(15000);
    world->jump = 0.0;
  }
  changed.loop.setStep(0.02);
  changed.loop.setLeak(0.9999);
  still.run(200);
  changed.run(200);
  EXPECT_LT(changed.jump, 1.02 * still.jump);
}

TEST(ActiveLoop, StartsAndStopsByRampsAndLearnsAnewEachTime) {
  Coupled world(0.0);
  world.run(10000);
  const double loud = world.jump;
  world.loop.release();
  world.jump = 0.0;
  world.run(100);
  EXPECT_TRUE(world.loop.off());
  EXPECT_EQ(world.loop.gate(0).why(), ActuatorRelease::Asked);
  EXPECT_LT(world.jump, loud + 0.1);  // 5 ms to zero, no step
  world.loop.engage();
  world.run(1);
  EXPECT_EQ(world.loop.gate(0).state(), ActuatorState::RampIn);
  for (int k = 0; k < 35; ++k) EXPECT_EQ(world.loop.controller(0).weights()[k], 0.0);
  world.run(10000);
  world.run(2000);
  EXPECT_LT(world.leftRms(0), 0.1);
}

TEST(ActiveLoop, ALostBlockMeansZeroAtOnce) {
  Coupled world(0.0);
  world.run(10000);
  world.loop.cut();
  EXPECT_TRUE(world.loop.off());
  EXPECT_EQ(world.loop.gate(0).why(), ActuatorRelease::DeviceFault);
  const CommandPair y = world.loop.step({1.0, 1.0});
  EXPECT_EQ(y[0].value(), 0.0);
  EXPECT_EQ(y[1].value(), 0.0);
}

TEST(ActiveLoop, RefusesWhatItCannotRunOn) {
  ActiveLoop loop;
  auto none = options();
  none[1].path = {};
  const Status refused = loop.prepare(none, Hertz(kRate));
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("along y"), std::string::npos);
  auto late = options();
  late[0].online.rms = 0.1;
  late[0].path.delay = late[0].online.lags;
  EXPECT_FALSE(loop.prepare(late, Hertz(kRate)).ok());
  late[0].online.rms = 0.0;
  EXPECT_TRUE(loop.prepare(late, Hertz(kRate)).ok());
  auto open = options();
  open[0].limits.amplitude = 0.0;
  EXPECT_FALSE(loop.prepare(open, Hertz(kRate)).ok());
}

TEST(ActiveLoop, AFrameAsksForNoMemoryAndTakesNoLock) {
  if (!test::PathCounter::works()) GTEST_SKIP() << "the sanitizer counts";
  Coupled world(0.0);
  std::array<ActiveAxis, kActiveAxes> told;
  const test::PathCounter counter;
  world.run(5000);
  world.loop.tell(told);
  world.loop.cut();
  EXPECT_TRUE(counter.counts().none());
}

}  // namespace
}  // namespace stillcut::active
