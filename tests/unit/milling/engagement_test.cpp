// Which angles cut, and what surface is left there: against the geometry drawn point by point.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/base/units.h"
#include "core/milling/engagement_windows.h"
#include "core/milling/surface_history.h"

namespace stillcut::milling {
namespace {

constexpr double kPi = std::numbers::pi;

bool inside(const EngagedAngles& angles, double phi) {
  for (int i = 0; i < angles.count; ++i) {
    const AngularWindow& w = angles.windows[static_cast<std::size_t>(i)];
    if (phi >= w.from && phi <= w.to) return true;
  }
  return false;
}

// A tooth at phi cuts where it is within the immersion, past the face it entered through, and before the end.
TEST(EngagedAngles, AgreeWithTheDrawingAtEveryAngle) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> way(-0.2, 1.6), angle(0.0, kPi);
  for (int trial = 0; trial < 2000; ++trial) {
    double a = angle(random), b = angle(random);
    const AngularWindow full{std::min(a, b), std::max(a, b)};
    const double entered = way(random), remaining = way(random);
    const EngagedAngles angles = engagedAngles(full, entered, remaining);
    for (int k = 0; k < 100; ++k) {
      const double phi = kPi * (k + 0.37) / 100.0;
      const bool cuts = phi > full.from && phi < full.to && entered > 0.0 && std::sin(phi) > 1.0 - entered &&
                        std::sin(phi) < remaining;
      // With an end that is still a radius away nothing is left out, whatever the sine.
      const bool drawn =
          remaining >= 1.0 ? phi > full.from && phi < full.to && entered > 0.0 && std::sin(phi) > 1.0 - entered : cuts;
      EXPECT_EQ(inside(angles, phi), drawn) << phi << " " << entered << " " << remaining;
    }
  }
}

TEST(EngagedAngles, GrowOnTheWayInAndShrinkOnTheWayOut) {
  const AngularWindow slot{0.0, kPi};
  const auto width = [](const EngagedAngles& a) {
    double sum = 0.0;
    for (int i = 0; i < a.count; ++i) {
      sum += a.windows[static_cast<std::size_t>(i)].to - a.windows[static_cast<std::size_t>(i)].from;
    }
    return sum;
  };
  double before = 0.0;
  for (int i = 1; i <= 100; ++i) {
    const double now = width(engagedAngles(slot, 0.01 * i, 2.0));
    EXPECT_GT(now, before);
    before = now;
  }
  EXPECT_NEAR(before, kPi, 1e-12);
  for (int i = 1; i <= 100; ++i) {
    const double now = width(engagedAngles(slot, 2.0, 1.0 - 0.01 * i));
    EXPECT_LT(now, before);
    before = now;
  }
  EXPECT_EQ(before, 0.0);
}

double sumOf(const SurfaceHistory& surface) {
  double sum = 0.0;
  for (int m = 0; m < surface.cells(); ++m) sum += surface.weight()[m];
  return sum;
}

TEST(SurfaceHistory, WeightsAddUpToTheWindow) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(0.0, kPi);
  SurfaceHistory surface(512, 1);
  for (int trial = 0; trial < 500; ++trial) {
    double a = angle(random), b = angle(random);
    const AngularWindow window{std::min(a, b), std::max(a, b)};
    surface.setWindows({&window, 1});
    EXPECT_NEAR(sumOf(surface) * kTwoPi / 512.0, window.to - window.from, 1e-12);
    for (int m = 0; m < 512; ++m) {
      EXPECT_GE(surface.weight()[m], 0.0);
      EXPECT_LE(surface.weight()[m], 1.0 + 1e-12);
      EXPECT_TRUE(surface.weight()[m] == 0.0 || surface.live()[m] == 1) << m;
    }
  }
}

TEST(SurfaceHistory, TwoWindowsAreTheirSum) {
  SurfaceHistory both(256, 1), one(256, 1), other(256, 1);
  const AngularWindow windows[] = {{0.1, 0.7}, {1.9, 2.6}};
  both.setWindows(windows);
  one.setWindows({windows, 1});
  other.setWindows({windows + 1, 1});
  for (int m = 0; m < 256; ++m) EXPECT_DOUBLE_EQ(both.weight()[m], one.weight()[m] + other.weight()[m]);
}

TEST(SurfaceHistory, WhatComesNewlyIntoTheMaterialIsFreshAndTheRestIsKept) {
  SurfaceHistory surface(128, 2);
  const AngularWindow narrow{0.5, 1.0}, wide{0.5, 2.0};
  surface.setWindows({&narrow, 1});
  for (int s = 0; s < 2; ++s) {
    for (int m = 0; m < 128; ++m) {
      EXPECT_EQ(SurfaceHistory::isFresh(surface.slice(s)[m]), surface.live()[m] != 0);
      if (surface.live()[m] != 0) surface.slice(s)[m] = 1e-6 * m;
    }
  }
  surface.setWindows({&wide, 1});
  int kept = 0, fresh = 0;
  for (int m = 0; m < 128; ++m) {
    if (surface.live()[m] == 0) continue;
    if (SurfaceHistory::isFresh(surface.slice(0)[m])) {
      ++fresh;
    } else {
      EXPECT_DOUBLE_EQ(surface.slice(0)[m], 1e-6 * m);
      ++kept;
    }
  }
  EXPECT_GT(kept, 8);
  EXPECT_GT(fresh, 15);
}

TEST(SurfaceHistory, ScalingLeavesFreshCellsFresh) {
  SurfaceHistory surface(64, 1);
  const AngularWindow window{0.0, kPi};
  surface.setWindows({&window, 1});
  surface.slice(0)[5] = 2e-6;
  surface.scale(1e-9);
  EXPECT_DOUBLE_EQ(surface.slice(0)[5], 2e-15);
  EXPECT_TRUE(SurfaceHistory::isFresh(surface.slice(0)[6]));
  surface.restartSlice(0);
  EXPECT_TRUE(SurfaceHistory::isFresh(surface.slice(0)[5]));
}

TEST(SurfaceHistory, AnglesAreThoseOfTheCells) {
  SurfaceHistory surface(360, 1);
  for (int m = 0; m < 360; ++m) {
    EXPECT_NEAR(surface.sine()[m], std::sin(kTwoPi * m / 360.0), 1e-15);
    EXPECT_NEAR(surface.cosine()[m], std::cos(kTwoPi * m / 360.0), 1e-15);
  }
}

}  // namespace
}  // namespace stillcut::milling
