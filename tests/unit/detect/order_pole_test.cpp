// An order that runout drives on a mode, in a cut whose load rises towards its limit and beyond: E' = p E + f b, with a
// pole p that the load moves.
#include "core/detect/growth/order_pole.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <utility>
#include <vector>

#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

constexpr double kRate = 4096.0;
constexpr double kSpindle = 15.3;
constexpr int kTeeth = 3;
constexpr int kOrder = 16;
constexpr double kTurn = kRate / kSpindle;

struct Made {
  double from = 0.6, to = 0.95;  // load, over its limit
  double begin = 30.0;           // turns, of the rise
  double turns = 30.0;           // ... that it takes
  double real = 0.0;             // of the pole at the limit, per turn
  double moves = 2.0;            // of the pole by the load, per turn: a mode damped by 3 % or so
  double beside = -0.06;         // orders, of the pole
  double runout = 0.06;
  double wander = 0.0;  // of the spindle's speed, relative
  double length = 90.0;
};

double loadAt(const Made& made, double turns) {
  const double u = std::clamp((turns - made.begin) / made.turns, 0.0, 1.0);
  return made.from + (made.to - made.from) * u * u * (3.0 - 2.0 * u);
}

Recording make(const Made& made) {
  Recording r;
  r.rate = kRate;
  r.channels.assign(1, {});
  std::mt19937 engine(91);
  std::normal_distribution<double> noise;
  std::complex<double> e = 0.0;
  const auto frames = static_cast<std::size_t>(made.length * kTurn);
  for (std::size_t i = 0; i < frames; ++i) {
    const double turns = static_cast<double>(i) / kTurn;
    const double angle = turns + made.wander * 5.0 * std::sin(turns / 5.0);
    const double load = loadAt(made, turns);
    const std::complex<double> pole(made.real + made.moves * (load - 1.0), kTwoPi * made.beside);
    e += (pole * e + made.runout * load) / kTurn;
    if (std::abs(e) > 3.0) e *= 3.0 / std::abs(e);
    double x = std::real(e * std::polar(1.0, kTwoPi * kOrder * angle)) + 0.02 * noise(engine);
    for (int k = 1; k <= 8; ++k) x += load / k * std::cos(kTwoPi * kTeeth * k * angle + 0.7 * k * k);
    r.channels[0].push_back(static_cast<float>(x));
  }
  return r;
}

// Its newest turns.
NewLine remembered(const Made& made) {
  const Recording r = make(made);
  const std::vector<double> x(r.channels[0].begin(), r.channels[0].end());
  NewLine vibration;
  vibration.prepare(1, static_cast<int>(static_cast<double>(NewLine::kTurnsBack) * kTurn), Hertz(kRate));
  vibration.push(x.data(), 0, x.size());
  return vibration;
}

RunResult hear(const Made& made) {
  RunOptions o;
  o.teeth = kTeeth;
  o.rpm = 60.0 * kSpindle;
  return run(make(made), o);
}

// A pole that stays where it is, while the load rises by a third of itself in thirty turns.
TEST(OrderPole, IsFoundWhileTheLoadRises) {
  for (const double real : {-0.1, 0.15}) {
    const Made made{.from = 1.0,
                    .to = 1.3,
                    .begin = 6.0,
                    .real = real,
                    .moves = 0.0,
                    .runout = 0.01,
                    .wander = 5e-4,
                    .length = 26.0};
    const NewLine vibration = remembered(made);
    OrderPole found;
    ASSERT_TRUE(found.fit(vibration, 0, {kTeeth, 40}, kOrder, Hertz(kSpindle)));
    EXPECT_NEAR(found.pole.real(), real, 0.06);
    EXPECT_LT(found.doubt, 0.1);
  }
}

// A load that brings the pole nearer to the limit makes it look like one beyond, unless its motion is fitted as well.
TEST(OrderPole, OfNowIsFoundWhileTheLoadMovesIt) {
  const auto fits = [](double to, double until) {
    const Made made{.to = to, .begin = 6.0, .turns = 20.0, .beside = 0.03, .runout = 0.3, .length = until};
    const NewLine vibration = remembered(made);
    OrderPole standing;
    OrderPole moving;
    EXPECT_TRUE(standing.fit(vibration, 0, {kTeeth, 40}, kOrder, Hertz(kSpindle)));
    EXPECT_TRUE(moving.fitMoving(vibration, 0, {kTeeth, 40}, kOrder, Hertz(kSpindle)));
    return std::pair(standing, moving);
  };
  const auto [standing, stable] = fits(0.95, 28.0);
  EXPECT_GT(standing.pole.real(), 0.0);
  EXPECT_NEAR(stable.pole.real(), -0.1, 0.06);
  EXPECT_TRUE(stable.settles(Hertz(kSpindle)));
  EXPECT_FALSE(fits(1.1, 25.0).second.settles(Hertz(kSpindle)));
}

// An e-fold in thirty turns is none to wait for at a hundred turns a second; at five hundred it is chatter of 70 ms.
TEST(OrderPole, SettlesByTheTimeThatItTakes) {
  OrderPole of;
  of.doubt = 1e-3;
  of.pole = 0.03;
  EXPECT_TRUE(of.settles(Hertz(100.0)));
  EXPECT_FALSE(of.settles(Hertz(500.0)));
  of.pole = 0.015;
  EXPECT_TRUE(of.settles(Hertz(500.0)));
  of.doubt = 0.02;
  EXPECT_FALSE(of.settles(Hertz(100.0))) << "it is not sure";
}

// However near its limit, and however quickly it comes there.
TEST(OrderPole, OfAStableCutRaisesNoAlarm) {
  for (const double to : {0.9, 0.97}) {
    for (const double turns : {12.0, 20.0, 30.0}) {
      EXPECT_LT(hear({.to = to, .turns = turns}).firstAlarm, 0.0) << to << " of the limit in " << turns << " turns";
    }
  }
}

// So near to an order, chatter that grows out of runout turns by a hundredth of a turn a turn at first, as runout does
// that a mode amplifies; by that turning it is known some four turns later.
TEST(OrderPole, OfAnUnstableCutIsHeardWhileChatterGrowsOutOfRunout) {
  for (const double beside : {-0.03, 0.02, 0.05}) {
    const Made made{.to = 1.1, .turns = 20.0, .beside = beside, .wander = 2e-4};
    double limit = made.begin;
    while (loadAt(made, limit) < 1.0) limit += 0.1;
    const RunResult r = hear(made);
    ASSERT_GT(r.firstAlarm, limit / kSpindle) << beside;
    EXPECT_LT(r.firstAlarm, (limit + 7.0) / kSpindle) << beside;
  }
}

}  // namespace
}  // namespace stillcut::detect::testing
