#include "tests/support/known_cuts/doubling.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "tests/support/known_cuts/tools.h"

namespace stillcut::bench {
namespace {

constexpr double kStep = 1e-3;  // s
constexpr double kFull = 0.5;   // an energy ratio of 20 % and more

// Is the cut of a moment unstable, by the exact lobes?
class Limit {
 public:
  explicit Limit(const milling::Scenario& scenario) : now_(scenario) { find(); }
  bool passedAt(double time) {
    const milling::Programme& programme = now_.programme;
    double& immersion = now_.model.engagement.radialImmersion;
    const double wide = programme.immersion.at(time, 0.0, immersion);
    if (wide != immersion) {
      immersion = wide;
      find();
    }
    return limit_ && limit_->depth.value < programme.depth.at(time, 0.0, 0.0);
  }

 private:
  void find() { limit_ = limitOf(now_); }
  milling::Scenario now_;
  std::optional<milling::StabilityLimit> limit_;
};

using Row = std::vector<std::complex<double>>;

double power(const Row& row) {
  double sum = 0.0;
  for (const auto& a : row) sum += std::norm(a);
  return sum;
}

// The orders (k + 1/2) of the tooth passing, of all channels, over any stretch of whole pairs of teeth.
class Alternation {
 public:
  Alternation(const KnownCut& cut, double tooth) : tooth_(tooth), window_(tooth * std::max(cut.teeth, 4)) {
    const std::size_t frames = cut.recording.frames();
    energy_.assign(frames + 1, 0.0);
    for (const auto& x : cut.recording.channels) {
      for (std::size_t i = 0; i < frames; ++i) energy_[i + 1] += static_cast<double>(x[i]) * static_cast<double>(x[i]);
      for (int k = 0; (k + 0.5) / tooth < 0.5; ++k) {
        auto& sums = sums_.emplace_back(frames + 1);
        const double perFrame = kTwoPi * (k + 0.5) / tooth;
        for (std::size_t i = 0; i < frames; ++i)
          sums[i + 1] = sums[i] + static_cast<double>(x[i]) * std::polar(1.0, -perFrame * static_cast<double>(i));
      }
    }
    for (std::size_t i = 0; i < frames; ++i) energy_[i + 1] += energy_[i];
  }

  double window() const { return window_; }
  // Over the window that ends there, over the amplitude of all else.
  Row at(std::size_t end) const {
    const std::size_t from = end - static_cast<std::size_t>(std::lround(window_));
    Row row;
    for (const auto& sums : sums_) row.push_back(std::sqrt(2.0) / window_ * (sums[end] - sums[from]));
    const double rest = std::sqrt(std::max(0.0, (energy_[end] - energy_[from]) / window_ - power(row)));
    for (auto& a : row) a /= rest;
    return row;
  }
  // The strongest of those orders over a longer stretch, in orders of the tooth passing.
  double strongest(std::size_t from, std::size_t to) const {
    const std::size_t lines = static_cast<std::size_t>(std::ceil(0.5 * tooth_ - 0.5));
    std::vector<double> powers(lines, 0.0);
    for (std::size_t i = 0; i < sums_.size(); ++i) powers[i % lines] += std::norm(sums_[i][to] - sums_[i][from]);
    return static_cast<double>(std::max_element(powers.begin(), powers.end()) - powers.begin()) + 0.5;
  }

 private:
  double tooth_, window_;       // frames
  std::vector<double> energy_;  // up to a frame
  std::vector<std::vector<std::complex<double>>> sums_;
};

double departure(const Row& row, const Row& before) {
  double sum = 0.0;
  for (std::size_t i = 0; i < row.size(); ++i) sum += std::norm(row[i] - before[i]);
  return sum;
}

}  // namespace

std::optional<Doubling> doublingOf(const KnownCut& cut, const SimulationOrder& order) {
  const double rate = cut.recording.rate;
  const double tooth = 60.0 * rate / (cut.rpm * cut.teeth);
  const Alternation alternation(cut, tooth);
  const std::size_t frames = cut.recording.frames();
  const auto frame = [&](double t) { return std::min(frames, static_cast<std::size_t>(t * rate)); };
  // Forced vibration is what is beside it, and what alternated before.
  const auto ratio = [&](double t, const Row& before) {
    return std::sqrt(departure(alternation.at(frame(t)), before) / (1.0 + power(before)));
  };
  const double end = static_cast<double>(frames) / rate;
  Limit limit(order.scenario);
  if (limit.passedAt(order.quietTo)) return std::nullopt;
  bool ever = false;
  Row before;
  double passed = kNever;
  double full = kNever;
  for (double t = order.quietTo; t < end && std::isnan(full); t += kStep) {
    const bool unstable = limit.passedAt(t);
    if (unstable && std::isnan(passed)) {
      ever = true;
      passed = t;
      before = alternation.at(frame(t));
    } else if (!unstable) {
      passed = kNever;
    } else if (ratio(t, before) >= kFull) {
      full = t;
    }
  }
  if (!ever) return std::nullopt;
  if (std::isnan(full)) return Doubling{};
  const auto below = [&](double mark) {
    double t = full;
    while (t > passed && ratio(t, before) >= mark) t -= kStep;
    return t;
  };
  const Row quiet = alternation.at(frame(order.quietTo));
  double last = end;
  while (last > full && ratio(last, quiet) < 0.2) last -= kStep;
  Doubling found{below(0.01), below(0.2), last - 0.5 * alternation.window() / rate, 0.0};
  // The strongest over the time to full chatter and as long after.
  const std::size_t from = frame(found.at20);
  const double pairs =
      std::floor(static_cast<double>(std::min(frame(full + 8.0 * tooth / rate), frames) - from) / (2.0 * tooth));
  found.hertz = alternation.strongest(from, from + static_cast<std::size_t>(2.0 * tooth * pairs)) * rate / tooth;
  return found;
}

}  // namespace stillcut::bench
