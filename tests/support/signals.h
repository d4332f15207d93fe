// Synthetic signals with known truth for the detector tests. Deterministic.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/units.h"
#include "tests/support/recording_runner.h"

namespace stillcut::detect::testing {

// A milling cut as the growth test of the specification describes it: spindle harmonics with wandering speed and
// amplitudes, white noise 20 dB below the main tooth harmonic, and a chatter line that grows from growthStart.
struct CutSignal {
  double rate = 25600.0;
  double spindle = 100.0;  // Hz, mean
  int teeth = 4;
  int harmonics = 32;
  double seconds = 3.0;
  double speedSd = 1e-3;      // relative, 1 s correlation
  double amplitudeSd = 0.05;  // relative, 0.5 s correlation
  double noise = 0.1;         // rms over the rms of the main tooth harmonic
  double chatterHertz = 1234.0;
  double chatterOrder = 0.0;     // above 0: locked to the spindle at this order instead, as period doubling is
  double growthStart = -1.0;     // s; -1: no chatter
  double growthConstant = 0.02;  // s
  double startAmplitude = 0.02;  // of the main tooth harmonic
  double cap = 3.0;              // of the main tooth harmonic
  // From then on every harmonic has another size and phase, as when the tool's arc of engagement is cut short; s, -1:
  // never.
  double newLoad = -1.0;
  // A lightly damped mode shaken by noise: stable, yet narrow-band.
  double modeHertz = 922.0;
  double modeDamping = 0.02;
  double modeRms = 0.0;  // of the main tooth harmonic's amplitude
  unsigned seed = 1;
};

// A steady cut at the spindle angle `turn` [rad]: five tooth passings that fall off from 1, and a little runout.
inline double steadyCutAt(double turn, int teeth) {
  double x = 0.0;
  for (int k = 1; k <= 5; ++k) x += std::cos(k * teeth * turn + k) / k;
  for (int k = 1; k <= 4; ++k) x += 0.05 * std::cos(k * turn + 2.0 * k);
  return x;
}

inline Recording makeCut(const CutSignal& s) {
  std::mt19937 engine(s.seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0.0, kTwoPi);
  const auto n = static_cast<std::size_t>(s.seconds * s.rate);
  const double dt = 1.0 / s.rate;
  std::vector<double> amplitude(static_cast<std::size_t>(s.harmonics));
  std::vector<double> start(amplitude.size());
  std::vector<double> wander(amplitude.size(), 0.0);
  for (std::size_t h = 0; h < amplitude.size(); ++h) {
    const int order = static_cast<int>(h) + 1;
    // Tooth harmonics fall off from 1; runout puts a tenth on the other orders.
    const int tooth = order / s.teeth;
    amplitude[h] = order % s.teeth == 0 ? 1.0 / tooth : 0.1;
    start[h] = phase(engine);
  }
  const auto step = [&](double& x, double sd, double memory) {  // Ornstein-Uhlenbeck
    const double keep = std::exp(-dt / memory);
    x = keep * x + sd * std::sqrt(1.0 - keep * keep) * normal(engine);
  };
  // Two poles; the gain makes the stationary rms 1.
  const double radius = std::exp(-s.modeDamping * kTwoPi * s.modeHertz * dt);
  const double a1 = 2.0 * radius * std::cos(kTwoPi * s.modeHertz * dt);
  const double a2 = -radius * radius;
  const double gain = std::sqrt((1.0 + a2) * ((1.0 - a2) * (1.0 - a2) - a1 * a1) / (1.0 - a2));
  double mode = 0.0;
  double modeBefore = 0.0;
  double speed = 0.0;
  double angle = 0.0;
  Recording r;
  r.rate = s.rate;
  r.channels.assign(1, std::vector<float>(n));
  const auto loadChange = s.newLoad < 0.0 ? n : static_cast<std::size_t>(s.newLoad * s.rate);
  for (std::size_t k = 0; k < n; ++k) {
    if (k == loadChange) {
      for (std::size_t h = 0; h < amplitude.size(); ++h) {
        amplitude[h] *= (h + 1) % static_cast<std::size_t>(s.teeth) == 0 ? 0.7 : 2.0;
        start[h] = phase(engine);
      }
    }
    step(speed, s.speedSd, 1.0);
    angle += kTwoPi * s.spindle * (1.0 + speed) * dt;
    double x = s.noise * std::sqrt(0.5) * normal(engine);
    if (s.modeRms > 0.0) {
      const double next = a1 * mode + a2 * modeBefore + gain * normal(engine);
      modeBefore = mode;
      mode = next;
      x += s.modeRms * mode;
    }
    const double t = static_cast<double>(k) * dt;
    for (std::size_t h = 0; h < amplitude.size(); ++h) {
      if (k % 32 == 0)
        wander[h] = std::exp(-32 * dt / 0.5) * wander[h] +
                    s.amplitudeSd * std::sqrt(1.0 - std::exp(-64 * dt / 0.5)) * normal(engine);
      x += amplitude[h] * (1.0 + wander[h]) * std::cos((static_cast<double>(h) + 1.0) * angle + start[h]);
    }
    if (s.growthStart >= 0.0 && t >= s.growthStart) {
      const double a = std::min(s.cap, s.startAmplitude * std::exp((t - s.growthStart) / s.growthConstant));
      x += a * std::sin(s.chatterOrder > 0.0 ? s.chatterOrder * angle : kTwoPi * s.chatterHertz * t);
    }
    r.channels[0][k] = static_cast<float>(x);
  }
  return r;
}

}  // namespace stillcut::detect::testing
