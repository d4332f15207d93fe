#include "core/detect/energy_growth.h"

namespace stillcut::detect {
namespace {

constexpr double kRisingEvidence = 1.5;  // growth that needs no spectrum is asked for more evidence
constexpr double kFastGrowth = 2.0;      // of energy from half turn to half turn
constexpr double kSlowGrowth = 1.5;      // from turn to turn

}  // namespace

void EnergyGrowth::restart() noexcept {
  sums_ = {};
  hops_ = {};
  newest_ = 0;
  changed_ = 0.0;
}

void EnergyGrowth::endHop(int windowHops) noexcept {
  newest_ = (newest_ + 1) % kLevelHops;
  hops_[static_cast<std::size_t>(newest_)] = sums_;
  sums_ = {};
  double changed = 0.0;
  double all = 0.0;
  for (int k = 0; k < kLevelHops; ++k) {
    const Energies& e = ago(k);
    if (k < windowHops) changed += e.changed;
    all += e.all;
  }
  all *= static_cast<double>(windowHops) / kLevelHops;
  changed_ = all > 0.0 ? changed / all : 0.0;
}

bool EnergyGrowth::grows(int hops, double factor) const noexcept {
  const auto sum = [this, hops](int from) {
    double e = 0.0;
    for (int k = from; k < from + hops; ++k) e += ago(k).changed;
    return e;
  };
  const double now = sum(0);
  const double before = sum(hops);
  return now > factor * before && before > factor * sum(2 * hops);
}

bool EnergyGrowth::rising() const noexcept {
  return onset_.alarm() && onset_.evidence() > kRisingEvidence * onset_.evidenceLimit() &&
         (grows(kHopsPerTurn / 2, kFastGrowth) || grows(kHopsPerTurn, kSlowGrowth));
}

}  // namespace stillcut::detect
