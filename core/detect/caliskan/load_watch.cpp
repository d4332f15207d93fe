#include "core/detect/caliskan/load_watch.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <span>

#include "core/detect/growth/turn_difference.h"

namespace stillcut::detect {
namespace {

// Over the noise's power in one passing: by noise alone the eight parts of four passings, less the angle, move by seven
// of it on average, and by so much once in some eighty turns (chi-square).
constexpr double kSure = 18.0;
constexpr int kFits = 2;                // of an angle that is not small
constexpr double kMostAmplified = 5.0;  // of the load's relative change: a mode's at 80 % of the limit

template <class Passings>
double total(const Passings& passings) {
  return std::accumulate(passings.begin(), passings.end(), 0.0,
                         [](double sum, const auto& a) { return sum + std::norm(a); });
}

}  // namespace

void LoadWatch::prepare(int teeth) {
  teeth_ = teeth;
  orders_.assign(kTeeth * static_cast<std::size_t>(std::max(teeth, 0)), {});
  reset();
}

void LoadWatch::reset() {
  before_ = {};
  changes_ = {};
  bends_ = {};
  newest_ = 0;
  quickTurns_ = 0;
  calmTurns_ = 0;
}

// What the passings but two turn by as a speed that is a little off makes them turn, the k-th k times as much.
double LoadWatch::angleOf(const Passings& now, const Passings& before, std::size_t skip) {
  double angle = 0.0;
  for (int fit = 0; fit < kFits; ++fit) {
    double turned = 0.0;
    double weight = 0.0;
    for (std::size_t i = 0; i < kTeeth; ++i) {
      if (i == skip || i == skip + 1) continue;
      const auto k = static_cast<double>(i + 1);
      const std::complex<double> left = now[i] * std::conj(before[i]) * std::polar(1.0, -angle * k);
      turned += k * left.imag();
      weight += k * k * std::abs(left);
    }
    angle += weight > 0.0 ? turned / weight : 0.0;
  }
  return angle;
}

// Two passings left out at a time, and that angle; noise: power in one of them.
double LoadWatch::least(const Passings& now, const Passings& before, double noise) {
  double found = 2.0;
  for (std::size_t skip = 0; skip + 1 < kTeeth; ++skip) {
    const double angle = angleOf(now, before, skip);
    double moved = 0.0;
    double mean = 0.0;
    for (std::size_t i = 0; i < kTeeth; ++i) {
      if (i == skip || i == skip + 1) continue;
      moved += std::norm(now[i] * std::polar(1.0, -angle * static_cast<double>(i + 1)) - before[i]);
      mean += 0.5 * (std::norm(now[i]) + std::norm(before[i]));
    }
    found = std::min(found, moved > kSure * noise && mean > 0.0 ? std::sqrt(moved / mean) : 0.0);
  }
  return found;
}

double LoadWatch::bounded(double change) {
  if (change > kQuickly) {
    ++quickTurns_;
    calmTurns_ = 0;
  } else if (++calmTurns_ >= kTurns) {
    quickTurns_ = 0;
  }
  quickTurns_ = std::min(quickTurns_, kMostTurns + 1);
  return quickTurns_ > kMostTurns ? 0.0 : change;
}

// With one tooth every order is a tooth passing, and chatter anywhere turns all of them.
void LoadWatch::endTurn(const EnergyChain& chain, const NewLine& vibration, int channel, Hertz spindle, double noise) {
  if (teeth_ < 2) return;
  const std::size_t count = std::min(static_cast<std::size_t>(chain.active()), orders_.size());
  chain.amplitudes(channel, std::span(orders_).first(count));
  Passings now{};
  for (std::size_t i = 0; i < kTeeth; ++i) {
    const std::size_t n = (i + 1) * static_cast<std::size_t>(teeth_);
    now[i] = n <= count ? orders_[n - 1] : 0.0;
  }
  double found = least(now, before_, noise * chain.forced(channel, 0));
  before_ = now;
  if (found > kQuickly) {
    Passings newer{};
    Passings older{};
    for (std::size_t i = 0; i < kTeeth; ++i) {
      const std::size_t n = (i + 1) * static_cast<std::size_t>(teeth_);
      std::array<std::complex<double>, 2> turns{};
      if (n > count || !vibration.turnsOf(channel, spindle * static_cast<double>(n), spindle, turns)) continue;
      newer[i] = turns[0];
      older[i] = turns[1];
    }
    // Noise is known by the filter's powers, and the windows hold each by the same factor.
    const double scale = total(newer) / std::max(total(now), 1e-300);
    found = least(newer, older, noise * scale * chain.forced(channel, 0));
  }
  found = bounded(found);
  const double before = changes_[newest_];
  newest_ = (newest_ + 1) % kTurns;
  changes_[newest_] = found;
  bends_[newest_] = std::abs(found - before);
}

double LoadWatch::most() const {
  return *std::max_element(changes_.begin(), changes_.end());
}

double LoadWatch::mostBent() const {
  return *std::max_element(bends_.begin(), bends_.end());
}

double LoadWatch::mostOfAnOrder() const {
  return kMostAmplified * most();
}

// An order that changes by the same c in each turn leaves 1.5 c of itself before the news is scaled.
bool LoadWatch::explainsNews(double news) const {
  const double change = 1.5 * mostOfAnOrder();
  return news < change * change * RevolutionDifference::kNewsArrival;
}

bool LoadWatch::explainsDifference(double difference) const {
  const double bend = kMostAmplified * mostBent();
  return difference < bend * bend * RevolutionDifference::kDifferenceArrival;
}

bool LoadWatch::explains(const NewLine& vibration, int channel, double order, Hertz spindle) const {
  if (!changesQuickly() || !(order > 0.0)) return false;
  std::array<std::complex<double>, 2> turns{};
  if (!vibration.turnsOf(channel, spindle * std::max(1.0, std::round(order)), spindle, turns)) return false;
  return std::abs(turns[0] - turns[1]) < mostOfAnOrder() * std::abs(turns[0]);
}

}  // namespace stillcut::detect
