// Period doubling in simulated cuts: what the truth says of it, and what the detector hears.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "tests/support/known_cuts/cut_families.h"
#include "tests/support/known_cuts/score.h"
#include "tests/support/known_cuts/tools.h"

namespace stillcut::bench {
namespace {

// What changes its sign from tooth to tooth over a turn that ends about then, sample by sample of a tooth, over all
// else; all channels. A tooth takes whole samples, and teeth are even.
std::vector<double> alternationAt(const KnownCut& cut, double time) {
  const auto teeth = static_cast<std::size_t>(cut.teeth);
  const auto tooth = static_cast<std::size_t>(std::lround(60.0 * cut.recording.rate / (cut.rpm * cut.teeth)));
  const std::size_t turn = teeth * tooth;
  const std::size_t end = static_cast<std::size_t>(time * cut.recording.rate) / turn * turn;
  std::vector<double> row;
  double all = 0.0;
  for (const auto& x : cut.clean) {
    for (std::size_t i = end - tooth; i < end; ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < teeth; ++k) {
        const auto now = static_cast<double>(x[i - k * tooth]);
        sum += k % 2 == 0 ? now : -now;
        all += now * now;
      }
      row.push_back(sum / std::sqrt(static_cast<double>(teeth)));
    }
  }
  const double rest = std::sqrt(all - std::inner_product(row.begin(), row.end(), row.begin(), 0.0));
  for (double& a : row) a /= rest;
  return row;
}

double lengthOf(const std::vector<double>& row) {
  return std::sqrt(std::inner_product(row.begin(), row.end(), row.begin(), 0.0));
}

double departureOf(std::vector<double> row, const std::vector<double>& from) {
  std::transform(row.begin(), row.end(), from.begin(), row.begin(), std::minus<>());
  return lengthOf(row);
}

double timeAtDepth(const SimulationOrder& order, double depth) {
  const double end = order.scenario.programme.duration.value;
  for (int step = 0; order.quietTo + 1e-3 * step < end; ++step) {
    const double t = order.quietTo + 1e-3 * step;
    if (order.scenario.programme.depth.at(t, 0.0, 0.0) >= depth) return t;
  }
  return kNever;
}

// What runout leaves on the orders of doubling grows long before the limit, by 1 / (1 - depth / limit), and stays where
// the depth does. Beyond the limit the cut departs from that, and the truth's times are of this departure. Looked at
// here in the samples themselves; one of the cuts has runout on most of what is heard.
TEST(KnownCuts, DoublingBeginsAtTheLimit) {
  for (const char* name : {"Z2-405-runout", "Z4-405-runout"}) {
    SimulationOrder order = orderOf("flip, even teeth", 9, name);
    const auto limit = limitOf(order.scenario);
    ASSERT_TRUE(limit);
    const DepthPlan plan{.risen = 1.6, .end = 2.6};
    planDepth(order.scenario, plan, 0.6 * limit->depth.value, 0.97 * limit->depth.value);
    const KnownCut below = simulate(order);
    EXPECT_TRUE(std::isnan(below.at20)) << name;
    const std::vector<double> settled = alternationAt(below, 2.2);
    EXPECT_GT(lengthOf(settled), 4.0 * lengthOf(alternationAt(below, order.quietTo))) << name;
    EXPECT_LT(departureOf(alternationAt(below, 2.6), settled) / std::hypot(1.0, lengthOf(settled)), 0.01) << name;

    planDepth(order.scenario, plan, 0.6 * limit->depth.value, 1.2 * limit->depth.value);
    const KnownCut above = simulate(order);
    EXPECT_EQ(above.kind, ChatterKind::Flip);
    const double passed = timeAtDepth(order, limit->depth.value);
    ASSERT_GT(passed, order.quietTo) << name;
    const std::vector<double> before = alternationAt(above, passed);
    const double forced = std::hypot(1.0, lengthOf(before));
    const auto chatter = [&](double time) { return departureOf(alternationAt(above, time), before) / forced; };
    EXPECT_LT(chatter(above.at1), 0.02) << name;
    EXPECT_NEAR(chatter(above.at20), 0.2, 0.05) << name;
    EXPECT_GT(chatter(2.6), 0.5) << name;
  }
}

// Three teeth: runout repeats with them and not with four; doubling changes its sign from turn to turn. From 1 to 20 %
// it takes three growth constants, from 20 to 50 % one.
TEST(KnownCuts, DoublingOfOddTeethIsSeenFromOnePerCentOn) {
  const SimulationOrder order = orderOf("flip, odd teeth", 10, "Z3-410");
  const KnownCut cut = simulate(order);
  EXPECT_EQ(cut.kind, ChatterKind::Flip);
  const auto period = static_cast<std::size_t>(std::lround(60.0 * cut.recording.rate / cut.rpm));
  const auto part = [&](double time) {
    const auto from = static_cast<std::size_t>(time * cut.recording.rate);
    double odd = 0.0;
    double even = 0.0;
    for (const auto& x : cut.clean) {
      for (std::size_t i = from; i < from + period; ++i) {
        const auto now = static_cast<double>(x[i]);
        const auto before = static_cast<double>(x[i - period]);
        odd += (now - before) * (now - before);
        even += (now + before) * (now + before);
      }
    }
    return std::sqrt(odd / even);
  };
  EXPECT_NEAR(part(cut.at1), 0.01, 0.005);
  EXPECT_NEAR(part(cut.at20), 0.2, 0.04);
}

// The depth goes to nine tenths of where the cut would double and nearer, and a mode amplifies the runout of 1 um that
// is there.
TEST(KnownCuts, RunoutBelowTheLimitOfDoublingRaisesNoAlarm) {
  for (const char* name : {"Z2-407-1um-90", "Z4-409-1um-90", "Z4-412-1um-90", "Z2-413-1um-95", "Z4-413-1um-95"}) {
    const KnownCut cut = simulate(orderOf("stable, flip", 13, name));
    ASSERT_TRUE(cut.stable) << name;
    for (const std::vector<int>& channels : kAxes) {
      const Score s = score(cut, {"energy-ratio", channels, 0.0});
      EXPECT_FALSE(s.falseAlarm) << name << ' ' << s.alarm << " s";
    }
  }
}

// An axis ten times as stiff as the one that chatters hears a fifth of the doubling and hears it late: it grows so
// slowly there that what is learned of it follows.
TEST(KnownCuts, DoublingIsHeardInTimeByTheStiffAxis) {
  for (const char* name : {"Z2-407", "Z2-409"}) {
    const KnownCut cut = simulate(orderOf("flip, even teeth", 9, name));
    const Score s = score(cut, {"energy-ratio", {1}, 0.0});
    EXPECT_TRUE(s.good()) << name << ' ' << s.after20 << " s after 20 %";
  }
}

// Doubling of a face mill at 780 rev/min, which grows for half a second: seven turns.
TEST(KnownCuts, DoublingOfASlowSpindleBeginsWithTheInstability) {
  const KnownCut cut = simulate(orderOf("slow spindle", 8, "F4-1016"));
  EXPECT_EQ(cut.kind, ChatterKind::Flip);
  EXPECT_GT(cut.at20 - cut.at1, 0.4);
  for (const std::vector<int>& channels : kAxes) {
    const Score s = score(cut, {"energy-ratio", channels, 0.0});
    EXPECT_TRUE(s.good()) << s.alarm << " s, frequency off by " << s.frequencyError;
  }
}

// Which teeth cut more once a cut doubles is chance's choice where they are alike: with other noise it may be the
// others. Where runout makes most of the vibration before the limit of such a cut already it is the runout's each time:
// there is one motion, it goes on smoothly past that limit with hardly more of what alternates, and nothing has begun.
TEST(KnownCuts, WhatRunoutDrivesPastTheLimitIsNoChatter) {
  const auto lastTurns = [](SimulationOrder order, std::uint64_t noise, bool chatters) {
    order.scenario.seed = noise;
    const KnownCut cut = simulate(order);
    EXPECT_EQ(cut.at20 > 0.0, chatters) << order.name;
    const auto turns = static_cast<std::ptrdiff_t>(10.0 * 60.0 / cut.rpm * cut.recording.rate);
    return std::vector<float>(cut.clean[0].end() - turns, cut.clean[0].end());
  };
  // What the motion differs by with other noise, over itself.
  const auto apart = [&](const SimulationOrder& order, bool chatters) {
    const std::vector<float> one = lastTurns(order, 1, chatters);
    const std::vector<float> two = lastTurns(order, 2, chatters);
    double difference = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
      const double d = static_cast<double>(one[i]) - static_cast<double>(two[i]);
      difference += d * d;
      all += static_cast<double>(one[i]) * static_cast<double>(one[i]);
    }
    return std::sqrt(difference / all);
  };
  for (const char* name : {"Z2-1104", "Z2-1105"}) EXPECT_LT(apart(orderOf("strong runout", 5, name), false), 0.1);
  EXPECT_GT(apart(orderOf("flip, even teeth", 3, "Z2-403"), true), 1.0);
}

}  // namespace
}  // namespace stillcut::bench
