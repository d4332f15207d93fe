// What tells a class of orders that grows by itself from runout that the load makes louder.
#include "core/detect/growth/order_stretches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <random>

#include "core/base/units.h"

namespace stillcut::detect {
namespace {

constexpr int kTeeth = 4;
constexpr int kRest = 2;  // period doubling
using Orders = std::array<std::complex<double>, 16>;

// Tooth passings that fall off from order to order, runout on order 6.
Orders cut(double doubling, double turned = 0.0) {
  Orders a{};
  for (int k = 1; k <= 4; ++k) a[static_cast<std::size_t>(4 * k - 1)] = std::polar(1.0 / k, (0.4 + turned * k) * k);
  a[5] = doubling;
  return a;
}

struct Seen {
  bool own = false, growsOn = false, unstable = false;
};

// Over all turns from `from` on, t in seconds.
Seen over(Hertz spindle, double from, double to, const std::function<Orders(double)>& at) {
  OrderStretches s;
  s.prepare(kTeeth, Orders{}.size());
  s.setSpindle(spindle);
  Seen seen;
  for (int turn = 0; turn < to * spindle.value; ++turn) {
    const double t = turn / spindle.value;
    s.endTurn(at(t));
    if (t < from) continue;
    seen.own = seen.own || s.ownGrowth(kRest);
    seen.growsOn = seen.growsOn || s.growsOn(kRest);
    seen.unstable = seen.unstable || s.unstableGrowth(kRest);
  }
  return seen;
}

class OrderStretch : public ::testing::TestWithParam<double> {};

TEST_P(OrderStretch, AnInstabilityGrowsByItselfAndFast) {
  const Seen seen = over(Hertz(GetParam()), 1.1, 1.2,
                         [](double t) { return cut(t < 1.0 ? 0.1 : 0.1 + 0.01 * std::exp((t - 1.0) / 0.04)); });
  EXPECT_TRUE(seen.own);
  EXPECT_TRUE(seen.growsOn);
  EXPECT_TRUE(seen.unstable);
}

// What runout becomes on its way through a ramp may stand for a moment and go on: that is no growth out of nothing.
TEST_P(OrderStretch, RunoutThatPausesOnItsWayIsNotUnstable) {
  const Seen seen = over(Hertz(GetParam()), 1.0, 1.4, [](double t) {
    const double u = std::max(0.0, t - 0.9);
    return cut(0.1 + 1.7 * (0.55 * u + 0.45 * 0.4 / kTwoPi * std::sin(kTwoPi / 0.4 * u)));
  });
  EXPECT_TRUE(seen.own);
  EXPECT_FALSE(seen.unstable);
}

// The depth goes from half to nine tenths of the limit in 0.3 s; runout is amplified from twice to ten times.
TEST_P(OrderStretch, RunoutNearTheLimitGrowsAsSlowlyAsTheLoad) {
  const auto depth = [](double t) {
    const double u = std::clamp((t - 1.0) / 0.3, 0.0, 1.0);
    return 0.5 + 0.4 * u * u * (3.0 - 2.0 * u);
  };
  const auto amplified = [&](double t) { return 0.1 / (1.0 - depth(t)); };
  double twice = 1.0;
  while (amplified(twice) < 2.0 * amplified(0.0)) twice += 1e-3;
  const Seen seen = over(Hertz(GetParam()), twice, 2.0, [&](double t) { return cut(amplified(t)); });
  EXPECT_TRUE(seen.own);
  EXPECT_FALSE(seen.unstable);
}

// The tool widens its cut: the tooth passings change against each other by more than what runout leaves.
TEST_P(OrderStretch, RunoutThatTheEngagementChangesDoesNotGrowByItself) {
  const Seen seen = over(Hertz(GetParam()), 0.5, 2.0, [](double t) {
    const double u = std::clamp((t - 1.0) / 0.5, 0.0, 1.0);
    return cut(0.02 + 0.3 * u * u, u);
  });
  EXPECT_FALSE(seen.own);
  EXPECT_FALSE(seen.unstable);
}

// A speed that is a thousandth off lets every order turn by itself; its size is what it was.
TEST_P(OrderStretch, AnOrderThatTurnsDoesNotGrowOn) {
  const Seen seen = over(Hertz(GetParam()), 0.5, 2.0, [](double t) {
    Orders a = cut(0.1);
    a[5] *= std::polar(1.0, 3.0 * t);
    return a;
  });
  EXPECT_TRUE(seen.own);
  EXPECT_FALSE(seen.growsOn);
}

INSTANTIATE_TEST_SUITE_P(Spindles, OrderStretch, ::testing::Values(100.0, 180.0, 500.0));

constexpr double kSpindleHertz = 140.0;
constexpr double kRunout = 0.01;  // of the tooth passings, far from the limit

// Four seconds, turn by turn, with depth(t) over the limit and doubling(t) over the tooth passings; when the class of
// doubling is first said to grow as an instability does, or -1.
template <class Depth, class Doubling>
double firstUnstable(unsigned seed, const Depth& depth, const Doubling& doubling) {
  OrderStretches stretches;
  stretches.prepare(kTeeth, Orders{}.size());
  stretches.setSpindle(Hertz(kSpindleHertz));
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0.0, 0.001);
  Orders row{};
  for (int turn = 0; turn < static_cast<int>(4.0 * kSpindleHertz); ++turn) {
    const double t = turn / kSpindleHertz;
    const double load = depth(t);
    for (std::size_t n = 1; n <= row.size(); ++n) {
      const bool tooth = n % kTeeth == 0;
      const bool alternates = n % kTeeth == kRest;
      const double share = tooth ? 1.0 : alternates ? kRunout / (1.0 - load) + doubling(t) : 0.0;
      const double re = noise(engine);
      const double im = noise(engine);
      row[n - 1] = load * (share / static_cast<double>(n) + std::complex<double>(re, im));
    }
    stretches.endTurn(row);
    if (t > 1.0 && stretches.unstableGrowth(kRest)) return t;
  }
  return -1.0;
}

// A depth that begins to rise changes everything ever faster at first. Taken by its rate alone, four in five of these
// would be an instability; that some are is noise's doing, and the evidence of the share's growth is asked for as well.
// To within a twentieth of the limit in 0.3 s, which is not here, it is as fast as one.
TEST(OrderStretches, ALoadThatBeginsToRiseIsNoInstability) {
  struct Rise {
    double high, seconds;
  };
  constexpr unsigned kSeeds = 100;
  for (const Rise rise : {Rise{0.9, 0.3}, Rise{0.9, 0.8}, Rise{0.95, 0.8}}) {
    unsigned taken = 0;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
      const auto depth = [&](double t) {
        const double u = std::clamp((t - 2.0) / rise.seconds, 0.0, 1.0);
        return 0.6 + (rise.high - 0.6) * u * u * (3.0 - 2.0 * u);
      };
      if (firstUnstable(seed, depth, [](double) { return 0.0; }) > 0.0) ++taken;
    }
    EXPECT_LE(taken, kSeeds / 4) << rise.high << " within " << rise.seconds << " s";
  }
}

// At a load that stands, growth is seen before it holds a tenth of what the teeth do, even where the stretch before
// was all noise.
TEST(OrderStretches, GrowthAtASteadyLoadIsAnInstability) {
  for (const double constant : {0.015, 0.03, 0.05}) {
    for (const unsigned seed : {1U, 2U, 3U}) {
      const auto doubling = [&](double t) { return t < 2.0 ? 0.0 : 1e-3 * std::exp((t - 2.0) / constant); };
      const double seen = firstUnstable(
          seed, [](double) { return 0.8; }, doubling);
      EXPECT_GT(seen, 2.0) << constant << ' ' << seed;
      EXPECT_LT(seen, 2.0 + constant * std::log(0.1 / 1e-3)) << constant << ' ' << seed;
    }
  }
}

// After a gap, or a speed that is found anew, the angle that phases are told against is another one, and the cut the
// same.
TEST(OrderStretches, AnEngagementIsKnownByItsSizesWhateverTheAngle) {
  const Hertz spindle(50.0);
  const auto isOther = [&](const std::function<Orders(Orders)>& change) {
    OrderStretches s;
    s.prepare(kTeeth, Orders{}.size());
    s.setSpindle(spindle);
    for (int turn = 0; turn < 50; ++turn) s.endTurn(cut(0.1));
    s.learnEngagement();
    for (int turn = 0; turn < 50; ++turn) s.endTurn(change(cut(0.1)));
    return s.otherEngagement();
  };
  EXPECT_FALSE(isOther([](Orders a) { return a; }));
  EXPECT_FALSE(isOther([](Orders a) {
    for (std::size_t n = 0; n < a.size(); ++n) a[n] *= std::polar(3.0, 0.7 * static_cast<double>(n + 1));
    return a;
  })) << "louder, and the spindle elsewhere by 40 degrees";
  EXPECT_TRUE(isOther([](Orders a) {
    a[7] *= 0.5;
    return a;
  })) << "the second tooth passing half as large";
}

}  // namespace
}  // namespace stillcut::detect
