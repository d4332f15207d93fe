#include "core/detect/forced_resonance.h"

#include <cmath>

#include "core/detect/energy_growth.h"

namespace stillcut::detect {
namespace {

constexpr double kAbove = 4.0;  // in energy
constexpr double kMost = 0.5;
constexpr double kMemoryTurns = 8.0;

}  // namespace

void ForcedResonance::prepare(int teeth, int eta) noexcept {
  teeth_ = teeth;
  eta_ = eta;
  reset();
}

void ForcedResonance::reset() noexcept {
  part_ = 0.0;
}

bool ForcedResonance::standsOut(const EnergyChain& chain, int channel) const noexcept {
  const auto power = [&](int n) {
    const double weight = eta_ == 0 ? 1.0 : eta_ > 0 ? 1.0 * n * n : 1.0 / (1.0 * n * n);
    return n <= chain.active() ? weight * chain.harmonicPower(channel, n) : 0.0;
  };
  double all = 0.0;
  for (int n = 1; n <= chain.active(); ++n) all += power(n);
  for (int n = 2 * teeth_; n <= chain.active(); n += teeth_) {
    const double here = power(n);
    if (here > kMost * all && here > kAbove * power(n - teeth_) && here > kAbove * power(n + teeth_)) return true;
  }
  return false;
}

void ForcedResonance::endHop(const EnergyChain& chain, int channel) noexcept {
  if (teeth_ < 1) return;
  part_ += 1.0 / (kMemoryTurns * kHopsPerTurn) * ((standsOut(chain, channel) ? 1.0 : 0.0) - part_);
}

}  // namespace stillcut::detect
