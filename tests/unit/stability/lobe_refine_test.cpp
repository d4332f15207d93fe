// A refined sweep: between its speeds the limit is what a straight line says, and the edges of the pockets are found.
#include "core/milling/stability/lobe_refine.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stillcut::milling {
namespace {

CutModel cut() {
  CutModel m;
  m.modes = {{Hertz(780.0), 0.025, 1.4e7, {1.0, 0.0}}, {Hertz(820.0), 0.02, 1.2e7, {0.0, 1.0}}};
  m.tool.teeth = 4;
  m.engagement = {0.5, MillingDirection::Down};
  return m;
}

struct Refined {
  LobeSweep coarse, fine;
  SweepOptions options;
};

Refined refined(Rpm from, Rpm to, Metres edgesAt) {
  Refined r;
  r.options.limits = {Metres(10e-3), false, false, {}};
  const auto speeds = speedsAcross(cut(), Rpm(3000), Rpm(15000), 100);
  r.coarse = sweepLobes(cut(), speeds, r.options, "test").value();
  RefineOptions refine;
  refine.from = from;
  refine.to = to;
  refine.edgesAt = edgesAt;
  r.fine = refineLobes(r.coarse, cut(), r.options, refine, "test").value();
  return r;
}

double straight(const LobeSweep& sweep, Rpm speed) {
  for (std::size_t i = 0; i + 1 < sweep.speeds.size(); ++i) {
    const SpeedLimits &a = sweep.speeds[i], &b = sweep.speeds[i + 1];
    if (speed < a.speed || speed > b.speed) continue;
    const double part = (speed - a.speed) / (b.speed - a.speed);
    return limitingDepth(a).value * (1.0 - part) + limitingDepth(b).value * part;
  }
  return 0.0;
}

// Worst share by which the straight lines are off, over odd speeds.
double worst(const LobeSweep& sweep, const SweepOptions& options, double from, double to) {
  double most = 0.0;
  for (double rpm = from; rpm < to; rpm += 37.3) {
    const Rpm speed(rpm);
    const auto exact = sweepLobes(cut(), {&speed, 1}, options, "test").value();
    const double limit = limitingDepth(exact.speeds.front()).value;
    most = std::max(most, std::abs(straight(sweep, speed) / limit - 1.0));
  }
  return most;
}

TEST(LobeRefine, TheDepthBetweenTwoSpeedsIsGoodToAPercent) {
  const Refined r = refined(Rpm(3000), Rpm(15000), {});
  EXPECT_TRUE(r.fine.finished);
  EXPECT_GT(worst(r.coarse, r.options, 3001, 14999), 0.05) << "nothing to refine: the test is idle";
  EXPECT_LT(worst(r.fine, r.options, 3001, 14999), 0.01);
  EXPECT_LT(r.fine.speeds.size(), 1500U);
  EXPECT_TRUE(std::is_sorted(r.fine.speeds.begin(), r.fine.speeds.end(),
                             [](const auto& a, const auto& b) { return a.speed < b.speed; }));
}

TEST(LobeRefine, OnlyTheStretchAskedForIsRefined) {
  const Refined r = refined(Rpm(6000), Rpm(9000), {});
  const auto count = [](const LobeSweep& sweep, double from, double to) {
    return std::count_if(sweep.speeds.begin(), sweep.speeds.end(),
                         [&](const auto& s) { return s.speed.value > from && s.speed.value < to; });
  };
  EXPECT_EQ(count(r.fine, 9200, 15000), count(r.coarse, 9200, 15000));
  EXPECT_GT(count(r.fine, 6000, 9000), count(r.coarse, 6000, 9000));
  EXPECT_LT(worst(r.fine, r.options, 6001, 8999), 0.01);
}

TEST(LobeRefine, EdgesOfPocketsAreFoundToOneRevolutionPerMinute) {
  std::vector<double> limits;
  for (const SpeedLimits& at : refined(Rpm(3000), Rpm(15000), {}).coarse.speeds)
    limits.push_back(limitingDepth(at).value);
  std::ranges::sort(limits);
  const Metres depth(limits[limits.size() / 2]);
  const Refined r = refined(Rpm(3000), Rpm(15000), depth);
  int edges = 0;
  for (std::size_t i = 0; i + 1 < r.fine.speeds.size(); ++i) {
    const SpeedLimits &a = r.fine.speeds[i], &b = r.fine.speeds[i + 1];
    if ((limitingDepth(a) > depth) == (limitingDepth(b) > depth)) continue;
    ++edges;
    EXPECT_LE((b.speed - a.speed).value, 1.0) << a.speed.value;
  }
  EXPECT_GE(edges, 4);
}

}  // namespace
}  // namespace stillcut::milling
