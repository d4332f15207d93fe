// Growth of a small perturbation against the exact Floquet multiplier, over random cuts: 1 to 4 modes in random
// directions, 1 to 8 teeth, any immersion, up and down, near the limit on both sides of it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <iostream>
#include <vector>

#include "core/milling/regenerative_cut.h"
#include "core/milling/simulation/growth_probe.h"
#include "core/milling/simulation/noise.h"
#include "core/milling/stability/exact_lobes.h"
#include "tests/support/dominant_multiplier.h"

namespace stillcut::milling {
namespace {

struct RandomCut {
  CutModel model;
  Rpm speed{};
  Metres depth{};
  std::complex<double> multiplier;  // exact, over a tooth period
};

CutModel randomModel(NoiseSource& random) {
  CutModel m;
  const int modes = 1 + static_cast<int>(4.0 * random.uniform());
  for (int i = 0; i < modes; ++i) {
    Mode mode;
    mode.frequency = Hertz(400.0 + 800.0 * random.uniform());
    mode.damping = 0.01 + 0.04 * random.uniform();
    mode.stiffness = 1e6 * std::pow(10.0, random.uniform());
    const double angle = kTwoPi * random.uniform();
    mode.direction = {std::cos(angle), std::sin(angle)};
    m.modes.push_back(mode);
  }
  m.tool.teeth = 1 + static_cast<int>(8.0 * random.uniform());
  m.engagement = {0.1 + 0.9 * random.uniform(), random.uniform() < 0.5 ? MillingDirection::Up : MillingDirection::Down};
  return m;
}

// The depth lies between 0.9 and 1.2 times the limit; cuts without one are not used.
std::vector<RandomCut> randomCuts(int count) {
  NoiseSource random(2718);
  std::vector<RandomCut> cuts;
  while (static_cast<int>(cuts.size()) < count) {
    RandomCut c;
    c.model = randomModel(random);
    double highest = 0.0;
    for (const Mode& m : c.model.modes) highest = std::max(highest, m.frequency.value);
    // At most 20 periods of the highest mode a revolution: 100 steps each at 2048.
    c.speed = Rpm(60.0 * highest / (6.0 + 14.0 * random.uniform()));
    const auto lobes = ExactLobes::make(c.model, "random");
    if (!lobes) continue;
    const auto limits =
        lobes->limits(c.speed, {.maxAxialDepth = Metres(0.02), .firstOnly = true, .frequencies = false, .hint = {}});
    if (!limits || !limits->hasLimit()) continue;
    c.depth = Metres(limits->crossings.front().depth.value * (0.9 + 0.3 * random.uniform()));
    const auto mu = test::dominantMultiplier(*lobes, c.speed, c.depth);
    if (!mu) continue;
    c.multiplier = *mu;
    cuts.push_back(c);
  }
  return cuts;
}

int stepsFor(const CutModel& m, int wanted) {
  return (wanted + m.tool.teeth - 1) / m.tool.teeth * m.tool.teeth;
}

// |mu| from what the motion is once per tooth: two terms, y(n+2) = a y(n+1) + b y(n), by least squares over the second
// half of `periods`, after the weaker multipliers have died.
double measured(const RandomCut& c, int steps, int periods) {
  CutNumerics n;
  n.stepsPerRevolution = stepsFor(c.model, steps);
  n.mayLeaveCut = false;
  RegenerativeCut cut(c.model, n);
  cut.setSpeed(c.speed.value * kTwoPi / 60.0);
  const AngularWindow window{c.model.engagement.startAngle(), c.model.engagement.exitAngle()};
  cut.setWindows({&window, 1});
  cut.setAxialDepth(c.depth.value);
  for (int i = 0; i < cut.modes(); ++i) cut.disturb(i, 1e-6 * (i + 1), 0.0);
  const int tooth = n.stepsPerRevolution / c.model.tool.teeth;
  double s11 = 0.0, s12 = 0.0, s22 = 0.0, r1 = 0.0, r2 = 0.0;
  std::array<std::vector<double>, 2> y;
  for (int k = 0; k < periods; ++k) {
    cut.advance(tooth);
    if (k == periods / 2) cut.scaleMotion(1e-6 / std::hypot(cut.tip()[0], cut.tip()[1]));
    if (k < periods / 2) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) y[axis].push_back(cut.tip()[axis]);
  }
  for (const std::vector<double>& v : y) {
    for (std::size_t k = 0; k + 2 < v.size(); ++k) {
      // Every equation at the size of its own terms, so that a growing motion counts alike from beginning to end.
      const double w = 1.0 / std::max(1e-300, v[k + 1] * v[k + 1] + v[k] * v[k]);
      s11 += w * v[k + 1] * v[k + 1];
      s12 += w * v[k + 1] * v[k];
      s22 += w * v[k] * v[k];
      r1 += w * v[k + 1] * v[k + 2];
      r2 += w * v[k] * v[k + 2];
    }
  }
  const double det = s11 * s22 - s12 * s12;
  if (det < 1e-9 * s11 * s22) return std::abs(r1 / s11);  // one real multiplier: both terms are the same
  const double a = (r1 * s22 - r2 * s12) / det, b = (r2 * s11 - r1 * s12) / det;
  const std::complex<double> root = std::sqrt(std::complex<double>(0.25 * a * a + b));
  return std::max(std::abs(0.5 * a + root), std::abs(0.5 * a - root));
}

TEST(RandomGrowth, EqualsTheExactMultiplierAndConvergesInSecondOrder) {
  double coarse = 0.0, fine = 0.0, worst = 0.0;
  int number = 0;
  for (const RandomCut& c : randomCuts(24)) {
    const double exact = std::abs(c.multiplier);
    const double at1024 = measured(c, 1024, 1600) - exact, at2048 = measured(c, 2048, 1600) - exact;
    EXPECT_LT(std::abs(at2048), 5e-4) << "cut " << number << ": " << c.model.modes.size() << " modes, "
                                      << c.model.tool.teeth << " teeth, |mu| " << exact << ", at 1024 " << at1024;
    coarse += at1024 * at1024;
    fine += at2048 * at2048;
    worst = std::max(worst, std::abs(at2048));
    ++number;
  }
  const double order = 0.5 * std::log2(coarse / fine);
  std::cout << "24 random cuts: largest error of |mu| " << worst << ", order " << order << "\n";
  EXPECT_GT(order, 1.5);
}

// What judges chatter in a simulation says the same as the lobes, cut by cut.
TEST(RandomGrowth, TheProbeOfTheTruthAgrees) {
  for (const RandomCut& c : randomCuts(24)) {
    CutNumerics n;
    n.stepsPerRevolution = 32 * c.model.tool.teeth;
    while (n.stepsPerRevolution < 2048) n.stepsPerRevolution += 32 * c.model.tool.teeth;
    GrowthProbe probe(c.model, n, 8, Metres(1e-4));
    probe.cut().setSpeed(c.speed.value * kTwoPi / 60.0);
    const AngularWindow window{c.model.engagement.startAngle(), c.model.engagement.exitAngle()};
    probe.cut().setWindows({&window, 1});
    probe.cut().setAxialDepth(c.depth.value);
    const double perSecond = c.speed.value / 60.0 * c.model.tool.teeth;
    double sum = 0.0;
    const int perRevolution = n.stepsPerRevolution / 8, settle = 400, looks = 200;
    for (int r = 0; r < settle + looks; ++r) {
      for (int i = 0; i < perRevolution; ++i) probe.advance();
      if (r >= settle) sum += probe.growth() / looks;
    }
    const double exact = std::log(std::abs(c.multiplier)) * perSecond;
    EXPECT_NEAR(sum, exact, 0.002 * perSecond);
    const double turn = std::arg(c.multiplier) * c.model.tool.teeth;
    EXPECT_NEAR(probe.gain(1), 2.0 - 2.0 * std::cos(turn), 0.2);
  }
}

}  // namespace
}  // namespace stillcut::milling
