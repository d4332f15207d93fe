#include "core/detect/load_watch.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <span>

#include "core/detect/turn_difference.h"

namespace stillcut::detect {
namespace {

constexpr double kSure = 3.0;           // standard deviations of such a change by noise alone
constexpr double kMostAmplified = 5.0;  // of the load's relative change: a mode's at 80 % of the limit

// Relative change of an amplitude, over the mean of both.
double change(double now, double before) noexcept {
  const double sum = std::sqrt(now) + std::sqrt(before);
  return sum > 0.0 ? 2.0 * (std::sqrt(now) - std::sqrt(before)) / sum : 0.0;
}

template <class Powers>
double total(const Powers& powers) noexcept {
  return std::accumulate(powers.begin(), powers.end(), 0.0);
}

}  // namespace

void LoadWatch::prepare(int teeth) noexcept {
  teeth_ = teeth;
  reset();
}

void LoadWatch::reset() noexcept {
  before_ = {};
  changes_ = {};
  bends_ = {};
  newest_ = 0;
}

// Two passings left out at a time; noise: power in one of them.
double LoadWatch::least(const Powers& now, const Powers& before, double noise) noexcept {
  double found = 2.0;
  for (std::size_t skip = 0; skip + 1 < kTeeth; ++skip) {
    double sum = 0.0;
    double sumBefore = 0.0;
    for (std::size_t i = 0; i < kTeeth; ++i) {
      if (i == skip || i == skip + 1) continue;
      sum += now[i];
      sumBefore += before[i];
    }
    const double changed = std::abs(change(sum, sumBefore));
    const bool sure = changed * changed * sum > kSure * kSure * noise;
    found = std::min(found, sure ? changed : 0.0);
  }
  return found;
}

void LoadWatch::endTurn(const EnergyChain& chain, const NewLine& vibration, int channel, Hertz spindle,
                        double noise) noexcept {
  if (teeth_ < 1) return;
  const std::span<const double> powers = chain.harmonicPowers(channel);
  Powers now{};
  for (std::size_t i = 0; i < kTeeth; ++i) {
    const std::size_t n = (i + 1) * static_cast<std::size_t>(teeth_);
    now[i] = n <= powers.size() ? powers[n - 1] : 0.0;
  }
  double found = least(now, before_, noise * chain.forced(channel, 0));
  before_ = now;
  if (found > kQuickly) {
    Powers newer{};
    Powers older{};
    for (std::size_t i = 0; i < kTeeth; ++i) {
      const std::size_t n = (i + 1) * static_cast<std::size_t>(teeth_);
      std::array<std::complex<double>, 2> turns{};
      if (n > powers.size() || !vibration.turnsOf(channel, spindle * static_cast<double>(n), spindle, turns)) continue;
      newer[i] = std::norm(turns[0]);
      older[i] = std::norm(turns[1]);
    }
    // Noise is known by the filter's powers, and the windows hold each by the same factor.
    const double scale = total(newer) / std::max(total(now), 1e-300);
    found = least(newer, older, noise * scale * chain.forced(channel, 0));
  }
  const double before = changes_[newest_];
  newest_ = (newest_ + 1) % kTurns;
  changes_[newest_] = found;
  bends_[newest_] = std::abs(found - before);
}

double LoadWatch::most() const noexcept {
  return *std::max_element(changes_.begin(), changes_.end());
}

double LoadWatch::mostBent() const noexcept {
  return *std::max_element(bends_.begin(), bends_.end());
}

double LoadWatch::mostOfAnOrder() const noexcept {
  return kMostAmplified * most();
}

// An order that changes by the same c in each turn leaves 1.5 c of itself before the news is scaled.
bool LoadWatch::explainsNews(double news) const noexcept {
  const double change = 1.5 * mostOfAnOrder();
  return news < change * change * TurnDifference::kNewsArrival;
}

bool LoadWatch::explainsDifference(double difference) const noexcept {
  const double bend = kMostAmplified * mostBent();
  return difference < bend * bend * TurnDifference::kDifferenceArrival;
}

bool LoadWatch::explains(const NewLine& vibration, int channel, double order, Hertz spindle) const noexcept {
  if (!changesQuickly() || !(order > 0.0)) return false;
  std::array<std::complex<double>, 2> turns{};
  if (!vibration.turnsOf(channel, spindle * std::max(1.0, std::round(order)), spindle, turns)) return false;
  return std::abs(turns[0] - turns[1]) < mostOfAnOrder() * std::abs(turns[0]);
}

}  // namespace stillcut::detect
