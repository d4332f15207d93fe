#include "core/learn/speed_variation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/milling/regenerative_cut.h"

namespace stillcut::learn {
namespace {

constexpr int kSteps = 960;  // of the simulation in a revolution
constexpr int kStepsAtOneSpeed = 12;
constexpr int kPeriods = 3;  // simulated; the first one settles
constexpr double kLargestRise = 3.0;
constexpr std::array<double, 4> kAmplitudes{0.05, 0.10, 0.15, 0.20};

double sizeOf(const milling::RegenerativeCut& cut, const milling::CutModel& model) {
  double energy = 0.0;
  for (int i = 0; i < cut.modes(); ++i) {
    const milling::Mode& m = model.modes[static_cast<std::size_t>(i)];
    energy += m.stiffness * cut.displacement(i) * cut.displacement(i) + m.mass() * cut.velocity(i) * cut.velocity(i);
  }
  return std::sqrt(energy);
}

}  // namespace

VariationTrial tryVariation(const milling::CutModel& model, Rpm speed, Metres depth, const SpeedVariation& variation) {
  milling::CutNumerics numerics;
  numerics.stepsPerRevolution = kSteps;
  numerics.deepest = depth;
  numerics.mayLeaveCut = false;
  milling::RegenerativeCut cut(model, numerics);
  const milling::AngularWindow window{model.engagement.startAngle(), model.engagement.exitAngle()};
  cut.setWindows({&window, 1});
  cut.setAxialDepth(depth.value);
  cut.setSpeed(speed.value * kTwoPi / 60.0);
  for (int i = 0; i < cut.modes(); ++i) cut.disturb(i, 1e-6 * (i + 1), 0.0);
  const double period = variation.amplitude.value > 0.0 ? variation.period.value : 40.0 * 60.0 / speed.value;
  double grown = 0.0;    // ln of the size, with what was scaled away
  double settled = 0.0;  // the same after the first period
  double least = 1e300;
  VariationTrial trial;
  while (cut.time() < kPeriods * period) {
    double size = 0.0;
    for (int i = 0; i < kSteps / kStepsAtOneSpeed; ++i) {
      const double now = 1.0 + variation.amplitude.value * std::sin(kTwoPi * cut.time() / period);
      cut.setSpeed(speed.value * now * kTwoPi / 60.0);
      cut.advance(kStepsAtOneSpeed);
      size += sizeOf(cut, model) * kStepsAtOneSpeed / kSteps;
    }
    if (!(size > 0.0)) break;
    cut.scaleMotion(1e-6 / size);
    grown += std::log(size / 1e-6);
    if (cut.time() < period) {
      settled = grown;
      continue;
    }
    least = std::min(least, grown);
    trial.largestRise = std::max(trial.largestRise, grown - least);
  }
  trial.growth = (grown - settled) / ((kPeriods - 1) * period);
  return trial;
}

std::optional<SpeedVariation> helpfulVariation(const milling::CutModel& model, Rpm speed, Metres depth,
                                               const VariationLimits& limits) {
  double room = std::min(1.0 - limits.lowest.value, limits.highest.value - 1.0);
  if (limits.lowestSpeed.value > 0.0) room = std::min(room, 1.0 - limits.lowestSpeed / speed);
  if (limits.highestSpeed.value > 0.0) room = std::min(room, limits.highestSpeed / speed - 1.0);
  for (const double amplitude : kAmplitudes) {
    if (amplitude > room + 1e-9) break;
    // The steepest part of the sine is what the spindle must follow.
    const double steepest = kTwoPi * amplitude * speed.value / limits.acceleration;
    const SpeedVariation variation{Ratio(amplitude), Seconds(std::max(limits.shortestPeriod.value, steepest))};
    const VariationTrial trial = tryVariation(model, speed, depth, variation);
    if (trial.growth < 0.0 && trial.largestRise < kLargestRise) return variation;
  }
  return std::nullopt;
}

}  // namespace stillcut::learn
