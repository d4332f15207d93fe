// What a force, and speed and current that follow from the torque, hear of chatter: lines a tooth passing apart, of
// which the mode moves with one.
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/detect/caliskan/line_finder.h"
#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

constexpr double kRate = 10000.0;
constexpr double kSpindle = 8500.0 / 60.0;
constexpr Hertz kTooth{4.0 * kSpindle};
constexpr int kWindow = static_cast<int>(16.0 * kRate / kSpindle);

struct Line {
  double hertz, amplitude;
};

FoundLine found(LineFinder& finder, const std::vector<Line>& lines, double noise, unsigned seed = 1) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal(0.0, noise);
  std::vector<double> x(kWindow, 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) / kRate;
    x[i] = noise > 0.0 ? normal(engine) : 0.0;
    for (const Line& line : lines) x[i] += line.amplitude * std::sin(kTwoPi * line.hertz * t + line.hertz);
  }
  finder.reset();
  finder.push(x.data(), 0, x.size());
  return finder.find(Hertz(0.5 * kSpindle), Hertz(4400.0));
}

// The speed of a 4 g m2 spindle while a four-fluted tool of 922 Hz chatters, as simulated [rev/min].
const std::vector<Line> kSpeed{{939.0, 0.101},
                               {939.0 - kTooth.value, 0.109},
                               {2.0 * kTooth.value - 939.0, 0.0595},
                               {939.0 + kTooth.value, 0.0363}};
// The force on it, along x [N].
const std::vector<Line> kForce{
    {939.0, 20.0}, {939.0 + kTooth.value, 21.1}, {939.0 - kTooth.value, 11.2}, {939.0 + 2.0 * kTooth.value, 7.0}};

TEST(SideLines, AnIntegralOfTheTorqueIsUndoneBeforeTheLineIsChosen) {
  LineFinder finder;
  finder.prepare(1, kWindow, Hertz(kRate));
  EXPECT_NEAR(found(finder, kSpeed, 0.01).frequency.value, 939.0 - kTooth.value, 1.0) << "the strongest in the speed";
  finder.setSideLines(kTooth, true);
  const FoundLine line = found(finder, kSpeed, 0.01);
  EXPECT_NEAR(line.frequency.value, 939.0, 1.0);
  EXPECT_GT(line.spread.value, 0.25 * kTooth.value) << "the others leave some doubt";
}

// In the force the first side line is as strong as the chatter: which is which no force tells. It says so.
TEST(SideLines, AForceThatCannotTellThemSaysSo) {
  LineFinder finder;
  finder.prepare(1, kWindow, Hertz(kRate));
  finder.setSideLines(kTooth, false);
  const FoundLine line = found(finder, kForce, 0.5);
  EXPECT_LT(std::abs(line.frequency.value - 939.0), 2.0 * line.spread.value);
  const FoundLine alone = found(finder, {{939.0, 20.0}}, 0.5);
  EXPECT_NEAR(alone.frequency.value, 939.0, 1.0);
  EXPECT_LT(alone.spread.value, 1.0) << "one line is no doubt";
}

// Weighing by f^2 must not make a line of noise.
TEST(SideLines, NoiseIsNoSideLine) {
  LineFinder finder;
  finder.prepare(1, kWindow, Hertz(kRate));
  finder.setSideLines(kTooth, true);
  int away = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    away += std::abs(found(finder, {{372.0, 0.1}}, 0.1, seed).frequency.value - 372.0) > 2.0;
  }
  EXPECT_LE(away, 1);
}

// Chatter's own stand whole tooth passings away; what else there is does not.
TEST(SideLines, AreCountedWhereTheyBelong) {
  LineFinder finder;
  finder.prepare(1, kWindow, Hertz(kRate));
  found(finder, kForce, 0.5);
  EXPECT_EQ(finder.sideLines(Hertz(939.0), kTooth), 3);
  std::vector<Line> others = kForce;
  for (std::size_t i = 1; i < others.size(); ++i) others[i].hertz += 0.05 * kSpindle;
  found(finder, others, 0.5);
  EXPECT_EQ(finder.sideLines(Hertz(939.0), kTooth), 0);
  int byChance = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    found(finder, {{939.0, 1.0}}, 0.5, seed);
    byChance += finder.sideLines(Hertz(939.0), kTooth);
  }
  EXPECT_LE(byChance, 1);
}

double passed(SensorQuantity quantity, double hertz) {
  Recording tone;
  tone.rate = kRate;
  tone.channels.emplace_back(4000);
  for (std::size_t i = 0; i < 4000; ++i) {
    tone.channels[0][i] = static_cast<float>(std::sin(kTwoPi * hertz * static_cast<double>(i) / kRate));
  }
  RunOptions options;
  options.teeth = 4;
  options.rpm = 60.0 * kSpindle;
  options.quantity = quantity;
  double squares = 0.0;
  int frames = 0;
  options.onBlock = [&](const ConditionedBlock& block, const Verdict&) {
    if (sinceEpoch(block.end()).value < 0.2) return;
    for (const double v : block.channel(0)) squares += v * v;
    frames += block.frames;
  };
  run(tone, options);
  return std::sqrt(2.0 * squares / frames);
}

// Speed and current end where tools chatter: above, an encoder's noise rises and the torque's integral has fallen.
TEST(SideLines, SpeedAndCurrentAreHeardUpToWhereToolsChatter) {
  for (const SensorQuantity q : {SensorQuantity::SpindleSpeed, SensorQuantity::Current}) {
    EXPECT_NEAR(passed(q, 940.0), 1.0, 0.02) << name(q);
    EXPECT_LT(passed(q, 4200.0), 0.15) << name(q);
  }
  EXPECT_NEAR(passed(SensorQuantity::Acceleration, 4200.0), 1.0, 0.02);
}

// Half way between two tooth passings each place of a side line is that of the mirror image's as well.
TEST(SideLines, OfPeriodDoublingCountOnce) {
  LineFinder finder;
  finder.prepare(1, kWindow, Hertz(kRate));
  const Hertz line = kTooth * 1.5;
  found(finder, {{line.value, 1.0}, {line.value + kTooth.value, 0.3}}, 0.01);
  EXPECT_EQ(finder.sideLines(line, kTooth), 1);
  found(finder, {{line.value, 1.0}, {line.value + kTooth.value, 0.3}, {line.value - kTooth.value, 0.3}}, 0.01);
  EXPECT_EQ(finder.sideLines(line, kTooth), 2);
}

}  // namespace
}  // namespace stillcut::detect::testing
