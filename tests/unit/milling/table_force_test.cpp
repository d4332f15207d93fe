// What a table that moves by a few micrometres can do to the cutting force: the bound of force feedback on Ford's
// stable cut (his figure: 6 dB at the spindle and the tooth-passing line).
//
// A tooth cuts h = f + u(t) - u(t - T): its own place less what the tooth before left. A motion of the table at the
// tooth-passing frequency or a multiple of it is the same at every tooth, u(t) = u(t - T), and takes nothing off any
// chip: 1 - exp(-j w T) = 0. So no controller and no stroke changes that line of the cutting force; what little is seen
// comes from the teeth that enter and leave meanwhile. At the spindle frequency of Z = 8 teeth the same factor is
// 2 sin(pi / 8) = 0.77, and a table that turns with the tool takes its eccentricity out: here 1.1 of the 3 um.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <iostream>
#include <numbers>

#include "core/milling/simulation/scenario.h"
#include "core/milling/simulation/simulated_cut.h"

namespace stillcut::milling {
namespace {

using Complex = std::complex<double>;
constexpr double kStroke = 3e-6;
constexpr int kTurns = 16;  // of the spindle that are heard

struct Motion {
  double frequency = 0.0;   // [Hz]
  Complex amplitude = 0.0;  // of x [m]
  Complex along = 0.0;      // y over x: -j turns with the tool or against it, 0: x alone
};
struct Force {
  Complex x, y;  // [N], at a frequency
  double size() const { return std::hypot(std::abs(x), std::abs(y)); }
};

Scenario quietFord() {
  auto scenario = loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/ford-stable.toml");
  EXPECT_TRUE(scenario.ok());
  scenario->programme.randomForce = 0.0;
  scenario->programme.unevenness = 0.0;
  for (SensorSettings& s : scenario->sensors) s.noise = 0.0;
  return *scenario;
}

// The cutting force at `at` while the table moves, over whole turns after the depth is reached.
Force forceAt(const Scenario& scenario, const Motion& motion, double at) {
  SimulatedCut plant(scenario);
  SampleBlock frame;
  frame.allocate(static_cast<int>(scenario.sensors.size()), 1);
  const double rate = scenario.rate.value;
  const auto from = static_cast<long>(4.0 * rate);
  const auto length = static_cast<long>(std::lround(kTurns * 60.0 / scenario.programme.speed.value * rate));
  Force force{};
  for (long n = 0; n < from + length; ++n) {
    const Complex turn = std::polar(1.0, kTwoPi * motion.frequency * static_cast<double>(n) / rate);
    plant.setWorkHolder((motion.amplitude * turn).real(), (motion.amplitude * motion.along * turn).real());
    EXPECT_TRUE(plant.fill(frame));
    if (n < from) continue;
    const Complex back = std::polar(2.0 / static_cast<double>(length), -kTwoPi * at * static_cast<double>(n) / rate);
    force.x += back * (frame.channel(2)[0] / scenario.sensors[2].gain);
    force.y += back * (frame.channel(3)[0] / scenario.sensors[3].gain);
  }
  return force;
}

TEST(TableForce, NoStrokeChangesTheToothPassingLine) {
  const Scenario scenario = quietFord();
  const double tooth = scenario.programme.speed.value / 60.0 * scenario.model.tool.teeth;
  const Force alone = forceAt(scenario, {}, tooth);
  for (const Complex along : {Complex(0.0), Complex(0.0, -1.0), Complex(0.0, 1.0)}) {
    const Force moved = forceAt(scenario, {tooth, kStroke, along}, tooth);
    const double change = Force{moved.x - alone.x, moved.y - alone.y}.size() / alone.size();
    std::cout << "whole stroke at " << tooth << " Hz: force there changes by " << 100.0 * change << " %\n";
    EXPECT_LT(change, 0.1);  // 6 dB would take 50 %
  }
}

TEST(TableForce, TheSpindleLineFallsBySixDecibelsWithinTheStroke) {
  const Scenario scenario = quietFord();
  const double spindle = scenario.programme.speed.value / 60.0;
  const Force alone = forceAt(scenario, {}, spindle);
  const double trial = 0.5e-6;
  double best = 0.0;
  for (const Complex along : {Complex(0.0, -1.0), Complex(0.0, 1.0)}) {
    const Force moved = forceAt(scenario, {spindle, trial, along}, spindle);
    const Complex gx = (moved.x - alone.x) / trial, gy = (moved.y - alone.y) / trial;
    // Least squares over both axes.
    const Complex amplitude = -(std::conj(gx) * alone.x + std::conj(gy) * alone.y) / (std::norm(gx) + std::norm(gy));
    if (std::abs(amplitude) > kStroke) continue;
    const Force held = forceAt(scenario, {spindle, amplitude, along}, spindle);
    const double decibels = 20.0 * std::log10(alone.size() / held.size());
    std::cout << "turning with " << 1e6 * std::abs(amplitude) << " um at " << spindle << " Hz: " << decibels
              << " dB less force\n";
    best = std::max(best, decibels);
  }
  EXPECT_GT(best, 6.0);
}

}  // namespace
}  // namespace stillcut::milling
