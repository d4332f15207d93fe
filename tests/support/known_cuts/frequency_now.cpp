#include "tests/support/known_cuts/frequency_now.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace stillcut::bench {
namespace {

constexpr double kTurns = 8.0;
constexpr double kLeastSeconds = 0.05;
constexpr double kOnOrder = 0.02;  // there it repeats from turn to turn
constexpr double kReach = 0.02;
constexpr double kMost = 0.5;  // of the power
constexpr double kAsLoud = 0.5;

// x(t) - 2 x(t - T) + x(t - 2T) under a Hann window, T to a sample: at an exact speed the spindle's part all but goes.
struct Stretch {
  std::vector<std::vector<double>> channels;
  double power = 0.0;
};

double rpmAt(const KnownCut& cut, double time) {
  if (cut.spindleRpm.empty()) return cut.rpm;
  const auto i = static_cast<std::size_t>(std::max(0.0, time / cut.machineStep));
  return cut.spindleRpm[std::min(i, cut.spindleRpm.size() - 1)];
}

// channels: empty: all.
Stretch cutOut(const KnownCut& cut, double time, const std::vector<int>& channels) {
  const double rate = cut.recording.rate;
  const double rpm = rpmAt(cut, time);
  const auto turn = static_cast<std::size_t>(std::lround(60.0 * rate / rpm));
  const double seconds = std::max(kTurns * 60.0 / rpm, kLeastSeconds);
  const auto length = static_cast<std::size_t>(seconds * rate);
  const auto first = static_cast<std::size_t>(std::max(0.0, (time - 0.5 * seconds) * rate));
  Stretch s;
  if (first < 2 * turn || cut.clean.empty() || first + length > cut.clean.front().size()) return s;
  for (std::size_t c = 0; c < cut.clean.size(); ++c) {
    if (!channels.empty() && std::find(channels.begin(), channels.end(), static_cast<int>(c)) == channels.end())
      continue;
    const auto& x = cut.clean[c];
    auto& out = s.channels.emplace_back(length);
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t at = first + i;
      const double u = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(length));
      out[i] = u * u *
               (static_cast<double>(x[at]) - 2.0 * static_cast<double>(x[at - turn]) +
                static_cast<double>(x[at - 2 * turn]));
      s.power += out[i] * out[i];
    }
  }
  return s;
}

// Part of the power in a line of this frequency.
double partAt(const Stretch& s, double hz, double rate) {
  double power = 0.0;
  for (const auto& x : s.channels) {
    std::complex<double> sum;
    std::complex<double> phase = 1.0;
    const std::complex<double> turn = std::polar(1.0, -kTwoPi * hz / rate);
    for (const double v : x) {
      sum += v * phase;
      phase *= turn;
    }
    // A line of amplitude A under a Hann window of n frames: A n / 4 here, and 3 A^2 n / 16 of power.
    power += std::norm(sum) * 3.0 / static_cast<double>(x.size());
  }
  return s.power > 0.0 ? power / s.power : 0.0;
}

}  // namespace

Hertz frequencyAt(const KnownCut& cut, Seconds time) {
  const double rate = cut.recording.rate;
  const double orders = cut.chatterHz * 60.0 / rpmAt(cut, time.value);
  if (std::abs(orders - std::round(orders)) < kOnOrder) return Hertz(cut.chatterHz);
  const Stretch s = cutOut(cut, time.value, {});
  if (!(s.power > 0.0)) return Hertz(cut.chatterHz);
  double step = 0.25 * rate / static_cast<double>(s.channels.front().size());
  double best = cut.chatterHz;
  double most = 0.0;
  const auto tryAt = [&](double hz) {
    const double part = partAt(s, hz, rate);
    if (part <= most) return;
    most = part;
    best = hz;
  };
  const int steps = static_cast<int>(kReach * cut.chatterHz / step);
  for (int k = -steps; k <= steps; ++k) tryAt(cut.chatterHz + k * step);
  while (step > 1e-4 * cut.chatterHz) {
    const double middle = best;
    tryAt(middle - 0.5 * step);
    tryAt(middle + 0.5 * step);
    step *= 0.5;
  }
  return Hertz(most > kMost ? best : cut.chatterHz);
}

double frequencyOffBy(const KnownCut& cut, Seconds time, Hertz told, const std::vector<int>& channels) {
  const Hertz truth = frequencyAt(cut, time);
  const double spindle = rpmAt(cut, time.value) / 60.0;
  const Stretch s = cutOut(cut, time.value, channels);
  double nearest = truth.value;
  double there = 0.0;
  double loudest = 0.0;
  const double top = 2.0 * truth.value;
  for (int k = -static_cast<int>((top + truth.value) / spindle); truth.value + k * spindle < top; ++k) {
    const double hz = std::abs(truth.value + k * spindle);
    const double part = partAt(s, hz, cut.recording.rate);
    loudest = std::max(loudest, part);
    if (std::abs(hz - told.value) > std::abs(nearest - told.value)) continue;
    nearest = hz;
    there = part;
  }
  return told.value / (there > kAsLoud * loudest ? nearest : truth.value) - 1.0;
}

}  // namespace stillcut::bench
