// A load that changes within a few turns, and chatter meanwhile.
#include "core/detect/caliskan/load_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {
namespace {

constexpr double kRate = 4096.0;
constexpr Hertz kSpindle(13.7);
constexpr int kTeeth = 4;

struct Made {
  double rise = 0.0;    // per turn, of the load, from the twelfth turn on
  double line = 0.0;    // amplitude of a line beside order 15 by the end
  double teeth = 1.0;   // amplitude of the first tooth passing
  double noise = 0.0;   // standard deviation
  double moved = 0.0;   // what a mode makes of order 15 beyond its load, in radians a turn
  double bent = 0.0;    // radians a turn of the first tooth passing, k^2 times as much of the k-th: an arc that moves
  double turned = 0.0;  // ... k times as much: a speed that is off
  double beside = 0.0;  // amplitude of lines 0.15 orders beside every passing, from the twelfth turn on
  double turns = 18.0;
};

// Turns of six tooth passings and runout on a mode at order 15; then what the watch says of order 15.1.
struct Heard {
  bool quick = false, explained = false;
  LoadWatch watch;
};

Heard hear(const Made& made) {
  const double turn = kRate / kSpindle.value;
  const auto frames = static_cast<std::size_t>(made.turns * turn);
  std::vector<double> x(frames);
  std::mt19937 engine(7);
  std::normal_distribution<double> noise;
  for (std::size_t n = 0; n < frames; ++n) {
    const double turns = static_cast<double>(n) / turn;
    const double risen = std::max(0.0, turns - 12.0);
    const double load = std::exp(made.rise * risen);
    for (int k = 1; k <= 6; ++k) {
      const double by = 0.3 * k + risen * (made.bent * k * k + made.turned * k);
      x[n] += made.teeth * load / k * std::cos(kTwoPi * k * kTeeth * turns + by);
      if (risen > 0.0) x[n] += made.beside / k * std::cos(kTwoPi * (k * kTeeth + 0.15) * turns + k * k);
    }
    x[n] += load * std::cos(kTwoPi * 15.0 * turns + made.moved * risen);
    x[n] += made.noise * noise(engine);
    x[n] += made.line * std::exp(turns - made.turns) * std::cos(kTwoPi * 15.1 * turns);
  }
  EnergyChain chain;
  chain.prepare({1, 32, 8, kTeeth, Hertz(kRate), kSpindle * 0.5, false}, dsp::kernels::bestKernels());
  chain.tune(kSpindle, 1.0 / turn);
  NewLine vibration;
  vibration.prepare(1, static_cast<int>(16.0 * turn), Hertz(kRate));
  LoadWatch watch;
  watch.prepare(kTeeth);
  double angle = 0.0;
  for (std::size_t from = 0, next = 1; from < frames; from += 16) {
    const std::size_t count = std::min<std::size_t>(16, frames - from);
    chain.align(angle, kTwoPi / turn);
    chain.process(x.data() + from, 0, count);
    vibration.push(x.data() + from, 0, count);
    angle = std::fmod(angle + kTwoPi / turn * static_cast<double>(count), kTwoPi);
    if (static_cast<double>(from + count) < static_cast<double>(next) * turn) continue;
    ++next;
    chain.endHop();
    watch.endTurn(chain, vibration, 0, kSpindle, 3.0 * made.noise * made.noise / turn / chain.forced(0, 0));
  }
  return {watch.changesQuickly(), watch.explains(vibration, 0, 15.1, kSpindle), watch};
}

TEST(LoadWatch, ASteadyLoadExplainsNothing) {
  const Heard heard = hear({});
  EXPECT_FALSE(heard.quick);
  EXPECT_FALSE(heard.explained);
}

TEST(LoadWatch, ALoadThatRisesSlowlyExplainsNothing) {
  EXPECT_FALSE(hear({.rise = 0.03}).quick);
}

TEST(LoadWatch, ALoadThatRisesQuicklyExplainsWhatAModeMakesOfIt) {
  EXPECT_TRUE(hear({.rise = 0.15}).explained);
  EXPECT_TRUE(hear({.rise = 0.15, .moved = 0.2}).explained);
}

// Near its limit a mode makes four times the load's change of an order, and that order may be most of the vibration.
TEST(LoadWatch, ALoadThatRisesSlowlyExplainsNewsOfAsMuchAsAModeMakesOfIt) {
  constexpr double kRise = 0.04;
  const auto newsOf = [](double change) { return 1.5 * change * change; };
  const LoadWatch rises = hear({.rise = kRise}).watch;
  EXPECT_TRUE(rises.explainsNews(newsOf(4.0 * kRise)));
  EXPECT_FALSE(rises.explainsNews(newsOf(8.0 * kRise)));
  const LoadWatch steady = hear({}).watch;
  EXPECT_FALSE(steady.explainsNews(1e-3));
  EXPECT_FALSE(steady.explainsDifference(1e-3));
  const LoadWatch noisy = hear({.teeth = 0.05, .noise = 0.3}).watch;
  EXPECT_FALSE(noisy.explainsNews(1e-3));
}

// The line is as large as the order beside it, which it turns and changes by far more than the load does.
TEST(LoadWatch, ChatterIsNotExplainedByARiseOfTheLoad) {
  const Heard heard = hear({.rise = 0.07, .line = 6.0});
  EXPECT_TRUE(heard.quick);
  EXPECT_FALSE(heard.explained);
}

// At full immersion tooth passings cancel: what is left of them are the changes of noise.
TEST(LoadWatch, NoiseIsNoLoad) {
  EXPECT_FALSE(hear({.teeth = 0.05, .noise = 0.3}).quick);
  EXPECT_TRUE(hear({.rise = 0.15, .noise = 0.2}).quick);
}

// No passing becomes larger or smaller; what they are to each other changes.
TEST(LoadWatch, AnArcThatMovesIsALoadThatChanges) {
  EXPECT_TRUE(hear({.bent = 0.05}).quick);
  EXPECT_TRUE(hear({.moved = 0.2, .bent = 0.05}).explained);
  for (const double turned : {0.1, 0.25})
    EXPECT_FALSE(hear({.turned = turned}).quick) << "a speed that is off moves none against the other";
}

// Lines beside all passings, as chatter has that is beside one, move all of them for as long as it lasts.
TEST(LoadWatch, ChatterBesideEveryPassingIsALoadForSomeTurnsOnly) {
  EXPECT_TRUE(hear({.beside = 0.3, .turns = 24.0}).quick);
  for (const double turns : {60.0, 61.0, 62.0}) EXPECT_FALSE(hear({.beside = 0.3, .turns = turns}).quick) << turns;
}

// It lies between two passings, and they are left out.
TEST(LoadWatch, ChatterAloneIsNoLoad) {
  EXPECT_FALSE(hear({.line = 3.0}).quick);
}

}  // namespace
}  // namespace stillcut::detect
