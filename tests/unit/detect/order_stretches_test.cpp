// What tells a class of orders that grows by itself from runout that the load makes louder.
#include "core/detect/order_stretches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

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
    seen.unstable = seen.unstable || s.unstableGrowth(kRest, 1.0);
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

}  // namespace
}  // namespace stillcut::detect
