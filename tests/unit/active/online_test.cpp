// On-line identification: a path that drifts away under a loud line is followed while the control is on.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/active/active_loop.h"
#include "core/active/path_filter.h"
#include "tests/support/path_counter.h"
#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

const Hertz kRate(5000.0);
const Hertz kLine(471.0);
const PathModel kPath{{0.0, 0.5, 0.3, -0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, {0.8, -0.5, 0.0, 0.0}};

// A path that becomes later: kPath, then a delay that grows.
class Drifting {
 public:
  Drifting() { path_.prepare(kPath); }
  double arrive(double late) {
    const double now = path_.arrive();
    past_.insert(past_.begin(), now);
    past_.resize(16);
    const auto whole = static_cast<std::size_t>(late);
    const double part = late - static_cast<double>(whole);
    return (1.0 - part) * past_[whole] + part * past_[whole + 1];
  }
  void push(double y) { path_.push(y); }

 private:
  PathFilter path_;
  std::vector<double> past_ = std::vector<double>(16, 0.0);
};

struct Course {
  int relinquish = -1;
  int renewals = 0;
  double left = 0.0;    // rms of the error at the end, over that of the disturbance
  double turned = 0.0;  // phase of the path at the line at the end against the beginning [rad]
};

// A tone and a little noise; the path becomes `late` samples later within `samples`.
Course run(double auxiliary, double late, int samples, double wander = 0.02, double tone = 1.0) {
  AxisOptions axis;
  axis.controller.filter = {.taps = 35, .step = 0.02, .normalised = true};
  axis.path = kPath;
  axis.limits.amplitude = 10.0;
  axis.limits.slew = 1e6;
  axis.lines = {kLine};
  axis.online.rms = 10.0 * auxiliary;
  axis.online.window = Seconds(2.0);
  axis.online.lags = 64;
  AxisOptions other = axis;
  other.online = {};
  ActiveLoop loop;
  EXPECT_TRUE(loop.prepare({axis, other}, kRate).ok());
  loop.engage();
  Drifting path;
  const auto noise = whiteNoise(static_cast<std::size_t>(samples), 3, wander);
  Course course;
  double left = 0.0, alone = 0.0;
  for (int n = 0; n < samples; ++n) {
    const double d = tone * std::sin(kTwoPi * kLine.value / kRate.value * n) + noise[static_cast<std::size_t>(n)];
    const double e = d - path.arrive(late * n / samples);
    loop.begin();
    path.push(loop.step({e, 0.0})[0].value());
    if (n % 500 == 0) loop.renewModels();
    if (course.relinquish < 0 && loop.gate(0).why() != ActuatorRelease::None) course.relinquish = n;
    if (n < samples * 9 / 10) continue;
    left += e * e;
    alone += d * d;
  }
  course.left = std::sqrt(left / alone);
  course.renewals = loop.renewals(0);
  course.turned = kTwoPi * kLine.value / kRate.value * late;
  return course;
}

TEST(Online, WithoutItADriftBeyondNinetyDegreesIsLetGo) {
  const Course course = run(0.0, 3.6, 300000);
  EXPECT_GT(course.turned, 0.5 * std::numbers::pi);
  EXPECT_GE(course.relinquish, 0);
}

TEST(Online, WithItTheDriftIsFollowed) {
  const Course course = run(0.01, 3.6, 300000);
  EXPECT_EQ(course.relinquish, -1);
  EXPECT_GE(course.renewals, 2);
  EXPECT_LT(course.left, 0.3);
}

// In air the noise is louder than all that is heard: it is ours, and no reason to let go.
TEST(Online, ItsOwnNoiseIsNoFaultOfTheControl) {
  const Course course = run(0.03, 0.0, 30000, 0.02, 0.0);
  EXPECT_EQ(course.relinquish, -1);
}

// Too little noise for good estimates: whatever is taken over, the control stays as good.
TEST(Online, FaintNoiseDoesNoHarm) {
  const Course course = run(0.003, 0.0, 150000);
  EXPECT_EQ(course.relinquish, -1);
  EXPECT_LT(course.left, 0.1);
}

TEST(Online, RefusesAnEstimateThatNothingConfirmsOrThatTurnsTooFar) {
  ModelRenewal renewal;
  renewal.prepare(kPath, {kLine}, kRate);
  PathModel later = kPath;
  later.delay = 1;
  PathModel muchLater = kPath;
  muchLater.delay = 3;  // 102 degrees
  const auto truth = kPath.impulse(64);
  EXPECT_FALSE(renewal.judge(later.impulse(64)).has_value());  // the first of its kind
  EXPECT_FALSE(renewal.judge(truth).has_value());              // speaks against it
  EXPECT_FALSE(renewal.judge(muchLater.impulse(64)).has_value());
  EXPECT_FALSE(renewal.judge(muchLater.impulse(64)).has_value());
  EXPECT_FALSE(renewal.judge(later.impulse(64)).has_value());
  const auto taken = renewal.judge(later.impulse(64));
  ASSERT_TRUE(taken.has_value());
  EXPECT_LT(std::abs(phaseError(*taken, later.response(kLine, kRate), kLine, kRate)), 0.1);
}

TEST(Online, TheLoopWithItAsksForNoMemoryAndTakesNoLock) {
  if (!test::PathCounter::works()) GTEST_SKIP() << "the sanitizer counts";
  OnlineIdentifier online;
  online.prepare({.rms = 0.1, .lags = 64, .window = Seconds(0.5)}, kRate);
  const test::PathCounter counter;
  for (int n = 0; n < 20000; ++n) {
    online.hear(std::sin(0.6 * n));
    online.wrote(online.next());
  }
  EXPECT_TRUE(counter.counts().none());
}

}  // namespace
}  // namespace stillcut::active
