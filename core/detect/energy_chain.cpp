#include "core/detect/energy_chain.h"

namespace stillcut::detect {

void EnergyChain::prepare(const Size& size) {
  size_ = size;
  kalman_.prepare(size.channels, size.harmonics);
  bands_.prepare(size.channels, size.bands, size.rate, size.lowestSpindle * size.bandOrders);
  rest_.assign(static_cast<std::size_t>(size.channels), 0.0);
  reset();
}

void EnergyChain::reset() noexcept {
  kalman_.reset();
  bands_.reset();
}

void EnergyChain::tune(Hertz spindle, double gain) noexcept {
  spindle_ = spindle;
  kalman_.setActive(static_cast<int>(kUsableBand * size_.rate.value / spindle.value));
  kalman_.setGain(gain);
  bands_.tune(spindle * size_.bandOrders, spindle * 0.5);
}

void EnergyChain::process(const double* x) noexcept {
  kalman_.process(x, rest_.data());
  bands_.process(rest_.data());
}

double EnergyChain::ratio(int channel, int eta) const noexcept {
  const auto weight = [eta](double f) { return eta == 0 ? 1.0 : eta > 0 ? f * f : 1.0 / (f * f); };
  double chatter = 0.0;
  for (int m = 0; m < bands_.active(); ++m) {
    const BandEstimate& b = bands_.band(channel, m);
    if (b.power > 0.0 && b.frequency.value > 0.0) chatter += b.power * weight(b.frequency.value);
  }
  double forced = 0.0;
  for (int n = 1; n <= kalman_.active(); ++n) forced += kalman_.power(channel, n) * weight(n * spindle_.value);
  const double all = forced + chatter;
  return all > 0.0 ? chatter / all : 0.0;
}

}  // namespace stillcut::detect
