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

template <class Passings>
double total(const Passings& passings) noexcept {
  return std::accumulate(passings.begin(), passings.end(), 0.0,
                         [](double sum, const auto& a) { return sum + std::norm(a); });
}

}  // namespace

void LoadWatch::prepare(int teeth) {
  teeth_ = teeth;
  now_.assign(kTeeth * static_cast<std::size_t>(std::max(teeth, 0)), {});
  reset();
}

void LoadWatch::reset() noexcept {
  before_ = {};
  changes_ = {};
  bends_ = {};
  newest_ = 0;
}

// Two passings left out at a time; noise: power in one of them. What they turn by as a speed that is a little off makes
// them turn, the k-th k times as much, does not count.
double LoadWatch::least(const Passings& now, const Passings& before, double noise) noexcept {
  double found = 2.0;
  for (std::size_t skip = 0; skip + 1 < kTeeth; ++skip) {
    const auto sum = [&](const auto& of) {
      double all = 0.0;
      for (std::size_t i = 0; i < kTeeth; ++i) all += i == skip || i == skip + 1 ? 0.0 : of(i);
      return all;
    };
    const auto k = [](std::size_t i) { return static_cast<double>(i + 1); };
    const auto product = [&](std::size_t i) { return now[i] * std::conj(before[i]); };
    const double weight = sum([&](std::size_t i) { return k(i) * k(i) * std::abs(product(i)); });
    const double angle = weight > 0.0 ? sum([&](std::size_t i) { return k(i) * std::imag(product(i)); }) / weight : 0.0;
    const double moved =
        sum([&](std::size_t i) { return std::norm(now[i] * std::polar(1.0, -angle * k(i)) - before[i]); });
    const double mean = sum([&](std::size_t i) { return 0.5 * (std::norm(now[i]) + std::norm(before[i])); });
    const bool sure = moved > 2.0 * kSure * kSure * noise;
    found = std::min(found, sure && mean > 0.0 ? std::sqrt(moved / mean) : 0.0);
  }
  return found;
}

// With one tooth every order is a tooth passing, and chatter anywhere turns all of them.
void LoadWatch::endTurn(const EnergyChain& chain, const NewLine& vibration, int channel, Hertz spindle,
                        double noise) noexcept {
  if (teeth_ < 2) return;
  const std::size_t count = std::min(static_cast<std::size_t>(chain.active()), now_.size());
  chain.amplitudes(channel, std::span(now_).first(count));
  Passings now{};
  for (std::size_t i = 0; i < kTeeth; ++i) {
    const std::size_t n = (i + 1) * static_cast<std::size_t>(teeth_);
    now[i] = n <= count ? now_[n - 1] : 0.0;
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
