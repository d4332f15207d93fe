#include "core/detect/caliskan/forced_resonance.h"

#include <span>

#include "core/detect/growth/energy_growth.h"

namespace stillcut::detect {
namespace {

constexpr double kAbove = 4.0;  // in energy
constexpr double kMost = 0.5;
constexpr double kMemoryTurns = 8.0;

}  // namespace

void ForcedResonance::prepare(int teeth, int eta) {
  teeth_ = teeth;
  eta_ = eta;
  reset();
}

void ForcedResonance::reset() {
  part_ = 0.0;
}

bool ForcedResonance::standsOut(const EnergyChain& chain, int channel) const {
  const std::span<const double> powers = chain.harmonicPowers(channel);
  const std::span<const double> weights = chain.orderWeights(eta_);
  const auto power = [&](int n) {
    const auto i = static_cast<std::size_t>(n - 1);
    return n <= chain.active() ? weights[i] * powers[i] : 0.0;
  };
  const double all = chain.forced(channel, eta_);
  for (int n = 2 * teeth_; n <= chain.active(); n += teeth_) {
    const double here = power(n);
    if (here > kMost * all && here > kAbove * power(n - teeth_) && here > kAbove * power(n + teeth_)) return true;
  }
  return false;
}

void ForcedResonance::endHop(const EnergyChain& chain, int channel) {
  if (teeth_ < 1) return;
  part_ += 1.0 / (kMemoryTurns * kHopsPerTurn) * ((standsOut(chain, channel) ? 1.0 : 0.0) - part_);
}

}  // namespace stillcut::detect
