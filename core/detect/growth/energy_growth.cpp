#include "core/detect/growth/energy_growth.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kRisingEvidence = 1.5;  // growth that needs no spectrum is asked for more evidence
constexpr double kGrowth = 1.5;          // of energy from turn to turn
constexpr double kScatter = 2.0;         // of the half turns of such growth, squared
constexpr Seconds kFastest{3e-3};        // growth constant of the fastest chatter thought of
constexpr double kSteepest = 8.0;        // ... and its energy from hop to hop at most, on a slow spindle
constexpr double kLeap = 6.0;            // energy of a hop above that and above all hops of a turn: scatter of noise
constexpr int kNewLoadHops = 6 * kHopsPerTurn;  // what is left by then is not the leap but a new load
constexpr double kStillGrows = 1.5;             // in energy
constexpr double kBeyond = 2.0;                 // in energy, of what has grown over a leap
constexpr double kBeating = 3.0;                // a line beats with the harmonics beside it
constexpr int kHalfTurn = kHopsPerTurn / 2;
constexpr int kBumpHops = 2 * kHopsPerTurn;  // of a forced vibration that begins to change

}  // namespace

void EnergyGrowth::restart() {
  sums_ = {};
  hops_ = {};
  newest_ = 0;
  changed_ = energy_ = level_ = leap_ = 0.0;
  sinceLeap_ = kLevelHops;
}

void EnergyGrowth::add(std::span<const double> x, std::span<const double> unrepeated) {
  Energies sums = sums_;
  for (std::size_t f = 0; f < x.size(); ++f) {
    sums.all += x[f] * x[f];
    sums.changed += unrepeated[f] * unrepeated[f];
  }
  sums_ = sums;
}

void EnergyGrowth::endHop(int windowHops, Seconds length) {
  newest_ = (newest_ + 1) % kLevelHops;
  hops_[static_cast<std::size_t>(newest_)] = sums_;
  sums_ = {};
  double changed = 0.0;
  for (int k = 0; k < windowHops; ++k) changed += ago(k).changed;
  double a = 0.0;  // four sums: none waits for another
  double b = 0.0;
  double c = 0.0;
  double d = 0.0;
  for (std::size_t k = 0; k < hops_.size(); k += 4) {
    a += hops_[k].all;
    b += hops_[k + 1].all;
    c += hops_[k + 2].all;
    d += hops_[k + 3].all;
  }
  double all = (a + b) + (c + d);
  energy_ = changed / windowHops;
  level_ = all / kLevelHops;
  all *= static_cast<double>(windowHops) / kLevelHops;
  changed_ = all > 0.0 ? changed / all : 0.0;
  sinceLeap_ = leaps(length) ? 0 : std::min(sinceLeap_ + 1, kLevelHops);
  if (leapt()) leap_ = std::max(leap_, energy_);
}

void EnergyGrowth::leapWith(const EnergyGrowth& other) {
  if (other.sinceLeap_ > 0) return;
  sinceLeap_ = 0;
  leap_ = std::max(leap_, energy_);
}

void EnergyGrowth::test(int windowHops, bool learn) {
  const auto newest = statistic_.atOnce && level_ > 0.0 ? std::optional(ago(0).changed / level_) : std::nullopt;
  onset_.update(changed_, 1.0 / windowHops, learn, energy_, newest);
  watchStanding(learn);
  if (!(leap_ > 0.0) || leapt()) return;
  const bool calm = !onset_.alarm();
  const bool newLoad = learn && sinceLeap_ >= kNewLoadHops;
  if (newLoad && !calm) relearn();
  if (newLoad || calm) leap_ = 0.0;
}

void EnergyGrowth::watchStanding(bool unheard) {
  if (!unheard || !onset_.alarm()) {
    unheardTurns_ = unheardLevel_ = 0.0;
  } else if (changed_ > kStillGrows * unheardLevel_) {
    unheardTurns_ = 0.0;
    unheardLevel_ = changed_;
  } else {
    unheardTurns_ += 1.0 / kHopsPerTurn;
  }
}

double EnergyGrowth::levelTrend() const {
  double turn = 0.0;
  for (int k = 0; k < kHopsPerTurn; ++k) turn += ago(k).all;
  return level_ > 0.0 ? turn / (kHopsPerTurn * level_) : 1.0;
}

double EnergyGrowth::changedIn(int from, int hops) const {
  double e = 0.0;
  for (int k = from; k < from + hops; ++k) e += ago(k).changed;
  return e;
}

bool EnergyGrowth::grows() const {
  constexpr int kTurn = kHopsPerTurn;
  const double now = changedIn(0, kTurn);
  const double before = changedIn(kTurn, kTurn);
  return now > kGrowth * before && before > kGrowth * changedIn(2 * kTurn, kTurn) && steepens(kTurn, 1.0);
}

bool EnergyGrowth::steepens(int hops, double scatter) const {
  const double before = changedIn(hops, hops);
  return changedIn(0, hops) * changedIn(2 * hops, hops) * scatter > before * before;
}

bool EnergyGrowth::rising() const {
  return onset_.alarm() && changed_ > statistic_.risingPart * statistic_.arrival && explainsEnergy() &&
         steepens(kHalfTurn, kScatter) && onset_.evidence() > kRisingEvidence * onset_.evidenceLimit() && grows();
}

bool EnergyGrowth::explainsEnergy() const {
  double change = 0.0;
  for (int k = 0; k < kHopsPerTurn; ++k) change += ago(k).all - ago(k + kHopsPerTurn).all;
  return std::abs(change) < kBeating * changedIn(0, kHopsPerTurn) / statistic_.arrival;
}

bool EnergyGrowth::leaps(Seconds length) const {
  const double steepest = std::min(std::exp(2.0 * length.value / kFastest.value), kSteepest);
  // One that begins within a hop takes two.
  return leaps(1, kLeap * steepest) || leaps(2, kLeap * steepest * steepest);
}

bool EnergyGrowth::leaps(int hops, double limit) const {
  double most = 0.0;
  double all = 0.0;
  for (int k = hops; k < hops + kHopsPerTurn; ++k) {
    most = std::max(most, ago(k).changed);
    all += ago(k).all / kHopsPerTurn;
  }
  return onset_.learned() && ago(0).changed > limit * std::max(most, onset_.floor() * all);
}

bool EnergyGrowth::steadyGrowth() const {
  if (leapt() || energy_ < kBeyond * leap_) return false;
  const double now = changedIn(0, kHopsPerTurn);
  double most = 0.0;
  for (int ago = kHalfTurn; ago <= kBumpHops; ago += kHalfTurn) most = std::max(most, changedIn(ago, kHopsPerTurn));
  return now > most;  // or it rings down, or was such a bump
}

}  // namespace stillcut::detect
