#include "tests/support/known_cuts/frequency_now.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/support/known_cuts/spindle_turns.h"

namespace stillcut::bench {
namespace {

constexpr double kTurns = 8.0;
constexpr double kLeastSeconds = 0.05;
constexpr double kOnOrder = 0.02;  // there it repeats from turn to turn
constexpr double kLocked = 1e-3;   // ... and goes where the order goes
constexpr double kReach = 0.02;
constexpr double kMost = 0.5;  // of the power
constexpr double kAsLoud = 0.5;
// ... of all of it: what else there is has half the line's amplitude at most. Two as large, nearer than the stretch
// tells apart, make one peak between them.
constexpr double kMostOfAll = 0.8;
constexpr double kCame = 4.0;  // in power, over what was there before

// Under a Hann window, the vibration or its difference x(t) - 2 x(t - T) + x(t - 2T), T where the spindle stood a turn
// and two turns before: what it carries round all but goes, also while its speed changes.
struct Stretch {
  std::vector<std::vector<double>> channels;
  double power = 0.0;
};

// The frame, to a fraction, at which the spindle stood `back` turns before frame `at`.
double before(const std::vector<double>& turns, std::size_t at, double back) {
  const auto next = std::upper_bound(turns.begin(), turns.begin() + static_cast<std::ptrdiff_t>(at), turns[at] - back);
  if (next == turns.begin()) return 0.0;
  const double from = *(next - 1);
  return static_cast<double>(next - 1 - turns.begin()) + (turns[at] - back - from) / (*next - from);
}

// Between two frames, by a sinc under a Hann window.
double between(const std::vector<float>& x, double at) {
  constexpr int kHalf = 12;
  const auto whole = static_cast<std::ptrdiff_t>(std::floor(at));
  const double part = at - std::floor(at);
  const double sine = std::sin(std::numbers::pi * part) / std::numbers::pi;
  if (part < 1e-9 || whole < kHalf || whole + kHalf >= static_cast<std::ptrdiff_t>(x.size()))
    return static_cast<double>(x[static_cast<std::size_t>(whole)]);
  double sum = 0.0;
  for (int k = 1 - kHalf; k <= kHalf; ++k) {
    const double t = k - part;  // sin(pi t) = -(-1)^k sin(pi part)
    const double window = std::cos(0.5 * std::numbers::pi * t / (kHalf + 1));
    sum +=
        (k % 2 == 0 ? -sine : sine) / t * window * window * static_cast<double>(x[static_cast<std::size_t>(whole + k)]);
  }
  return sum;
}

enum class Of { Vibration, Difference };

double lengthAt(const KnownCut& cut, double time) {
  return std::max(kTurns * 60.0 / rpmAt(cut, time), kLeastSeconds);
}

// channels: empty: all.
Stretch cutOut(const KnownCut& cut, double time, const std::vector<int>& channels, Of of = Of::Difference) {
  const double rate = cut.recording.rate;
  const double seconds = lengthAt(cut, time);
  const auto length = static_cast<std::size_t>(seconds * rate);
  const auto first = static_cast<std::size_t>(std::max(0.0, (time - 0.5 * seconds) * rate));
  Stretch s;
  if (cut.clean.empty() || first + length > cut.clean.front().size()) return s;
  const std::vector<double> turns = turnsOf(cut, first + length);
  if (turns[first] < 2.0) return s;
  std::vector<double> one(length);
  std::vector<double> two(length);
  for (std::size_t i = 0; i < length; ++i) {
    one[i] = before(turns, first + i, 1.0);
    two[i] = before(turns, first + i, 2.0);
  }
  for (std::size_t c = 0; c < cut.clean.size(); ++c) {
    if (!channels.empty() && std::find(channels.begin(), channels.end(), static_cast<int>(c)) == channels.end())
      continue;
    const auto& x = cut.clean[c];
    auto& out = s.channels.emplace_back(length);
    for (std::size_t i = 0; i < length; ++i) {
      const double u = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(length));
      double value = static_cast<double>(x[first + i]);
      if (of == Of::Difference) value += between(x, two[i]) - 2.0 * between(x, one[i]);
      out[i] = u * u * value;
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

struct Peak {
  double hz = 0.0;
  double part = 0.0;   // of the power
  double power = 0.0;  // of the line, in any unit
};

// The strongest line within reach of this frequency.
Peak strongestNear(const Stretch& s, double hz, double rate) {
  Peak peak{hz};
  if (!(s.power > 0.0)) return peak;
  double step = 0.25 * rate / static_cast<double>(s.channels.front().size());
  const auto tryAt = [&](double there) {
    const double part = partAt(s, there, rate);
    if (part <= peak.part) return;
    peak = {there, part, part * s.power};
  };
  const int steps = static_cast<int>(kReach * hz / step);
  for (int k = -steps; k <= steps; ++k) tryAt(hz + k * step);
  while (step > 1e-4 * hz) {
    const double middle = peak.hz;
    tryAt(middle - 0.5 * step);
    tryAt(middle + 0.5 * step);
    step *= 0.5;
  }
  return peak;
}

// Once most of the vibration is a line that was not there before the chatter, it says itself where it is. The
// difference weighs lines by where they lie between the orders: a faint one of another mode half way between them pulls
// one that is near an order by more than a verdict may be off.
Peak lineThatCame(const KnownCut& cut, double time) {
  const double rate = cut.recording.rate;
  const Peak now = strongestNear(cutOut(cut, time, {}, Of::Vibration), cut.chatterHz, rate);
  if (!(now.part > kMostOfAll)) return {};
  const double earlier = cut.at1 - lengthAt(cut, cut.at1);
  const Peak before = strongestNear(cutOut(cut, earlier, {}, Of::Vibration), cut.chatterHz, rate);
  return now.power > kCame * before.power ? now : Peak{};
}

}  // namespace

Hertz frequencyAt(const KnownCut& cut, Seconds time) {
  const double began = cut.chatterHz * 60.0 / rpmAt(cut, cut.at20);
  if (std::abs(began - std::round(began)) < kLocked) return Hertz(std::round(began) * rpmAt(cut, time.value) / 60.0);
  const Peak came = lineThatCame(cut, time.value);
  if (came.hz > 0.0) return Hertz(came.hz);
  const double orders = cut.chatterHz * 60.0 / rpmAt(cut, time.value);
  if (std::abs(orders - std::round(orders)) < kOnOrder) return Hertz(cut.chatterHz);
  const Peak peak = strongestNear(cutOut(cut, time.value, {}), cut.chatterHz, cut.recording.rate);
  return Hertz(peak.part > kMost ? peak.hz : cut.chatterHz);
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
