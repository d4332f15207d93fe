// Does a vibration end faster than anything that vibrates can?
#include "core/sensing/abrupt_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "core/base/units.h"

namespace stillcut::detect {
namespace {

constexpr int kHop = 25;  // frames of a millisecond
constexpr double kRate = 25000.0;
constexpr std::size_t kWindow = 2500;

// Two windows of a tenth of a second; `size` by the time since the end, which lies in the second one.
bool ends(double endsAt, double hertz, const std::function<double(double)>& size, double mean = 0.0) {
  std::vector<double> before(kWindow);
  std::vector<double> now(kWindow);
  for (std::size_t f = 0; f < 2 * kWindow; ++f) {
    const double t = static_cast<double>(f) / kRate;
    const double since = t - endsAt;
    const double x = (since < 0.0 ? 1.0 : size(since)) * std::sin(kTwoPi * hertz * t) + (since < 0.0 ? 0.0 : mean);
    (f < kWindow ? before[f] : now[f - kWindow]) = x;
  }
  return endsAbruptly(before, now, kHop);
}

double gone(double) {
  return 0.0;
}

std::function<double(double)> ringing(double hertz, double damping) {
  return [=](double since) { return std::exp(-kTwoPi * hertz * damping * since); };
}

TEST(AbruptEnd, ACableThatBreaksEndsAtOnce) {
  for (const double hertz : {700.0, 937.0, 2000.0}) {
    for (const double at : {0.11, 0.1433, 0.19}) EXPECT_TRUE(ends(at, hertz, gone)) << hertz << " Hz at " << at;
  }
}

TEST(AbruptEnd, AToolThatLeavesRingsDown) {
  // 54.6 damping f dB a second: much for a tool is 5 % at 2 kHz, 5.5 dB in a millisecond.
  for (const double damping : {0.01, 0.03, 0.05}) {
    for (const double hertz : {400.0, 937.0, 2000.0}) {
      EXPECT_FALSE(ends(0.12, hertz, ringing(hertz, damping))) << hertz << " Hz, " << damping;
    }
  }
}

TEST(AbruptEnd, WhatTheFiltersBeforeItLetGoOfSlowlyIsNotHeard) {
  EXPECT_TRUE(ends(0.13, 937.0, gone, 0.5));
}

TEST(AbruptEnd, WithoutAnEndThereIsNone) {
  EXPECT_FALSE(ends(1.0, 937.0, gone));                         // goes on
  EXPECT_FALSE(ends(0.1995, 937.0, gone));                      // too late in the window to be sure
  EXPECT_FALSE(ends(0.12, 937.0, [](double) { return 0.1; }));  // becomes quieter by 20 dB
}

TEST(AbruptEnd, MillisecondsOfFewFramesSayNothing) {
  std::vector<double> loud(800);
  for (std::size_t f = 0; f < loud.size(); ++f) loud[f] = std::sin(0.9 * static_cast<double>(f));
  const std::vector<double> silent(800, 0.0);
  EXPECT_TRUE(endsAbruptly(loud, silent, 8));
  EXPECT_FALSE(endsAbruptly(loud, silent, 7));
}

}  // namespace
}  // namespace stillcut::detect
