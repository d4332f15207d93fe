// The speed of a spindle that nobody told, on signals that hold a comb which is not the spindle's.
#include "core/spindle/speed_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace stillcut::detect {
namespace {

constexpr double kRate = 8000.0;
constexpr int kStep = 80;  // frames between two looks

// Mains hum, its harmonics falling, under noise. In the first second a little fast, so that windows find it beside the
// mains, as they do where other lines stand near.
std::vector<double> hum(unsigned seed, double seconds) {
  constexpr double kMains = 50.0, kFast = 0.35, kFor = 1.0;  // Hz, Hz, s
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::vector<double> x(static_cast<std::size_t>(seconds * kRate));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) / kRate;
    const double turned = kMains * t + kFast * std::min(t, kFor);
    for (int h = 1; h <= 6; ++h) x[i] += std::sin(kTwoPi * h * turned + h) / h;
    x[i] += noise(random);
  }
  return x;
}

TEST(SpeedTracker, MainsHumIsNoSpindleThatNobodyTold) {
  int locked = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    CutSetup setup;
    setup.rate = Hertz(kRate);
    setup.teeth = 5;
    setup.channels.resize(1);
    SpeedTracker tracker;
    tracker.prepare(setup, 0.03);
    tracker.beginCut();
    const std::vector<double> x = hum(seed, 8.0);
    std::vector<double> angle(kStep), step(kStep);
    for (std::size_t i = 0; i + kStep <= x.size(); i += kStep) {
      const double* samples = &x[i];
      tracker.advance(&samples, kStep, angle.data(), step.data());
      tracker.look(Seconds(kStep / kRate), false);
      locked += tracker.locked() ? 1 : 0;
    }
    EXPECT_FALSE(tracker.known()) << "seed " << seed << ", " << 60.0 * tracker.spindle().value << " rpm";
  }
  EXPECT_GT(locked, 0);  // it was found at first: by what is followed it was given up
}

}  // namespace
}  // namespace stillcut::detect
