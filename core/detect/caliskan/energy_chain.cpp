#include "core/detect/caliskan/energy_chain.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {

void EnergyChain::prepare(const Size& size, const dsp::kernels::Kernels& kernels) {
  size_ = size;
  if (size.fullCovariance) {
    full_.prepare(size.channels, size.harmonics, kernels);
  } else {
    harmonics_.prepare(size.channels, size.harmonics, kernels);
  }
  rest_.assign(static_cast<std::size_t>(size.channels * kMost), 0.0);
  bands_.prepare(size.channels, size.bands, size.rate, size.lowestSpindle * size.bandOrders, kernels);
  row_ = dsp::kernels::wholeLanes(static_cast<std::size_t>(size.harmonics));
  powers_.assign(static_cast<std::size_t>(size.channels) * row_, 0.0);
  for (auto& weights : weights_) weights.assign(row_, 1.0);
  for (std::size_t n = 0; n < row_; ++n) {
    const auto order = static_cast<double>(n + 1);
    weights_[0][n] = 1.0 / (order * order);
    weights_[2][n] = order * order;
  }
  reset();
}

void EnergyChain::reset() {
  if (size_.fullCovariance) {
    full_.reset();
  } else {
    harmonics_.reset();
  }
  bands_.reset();
  std::fill(powers_.begin(), powers_.end(), 0.0);
}

void EnergyChain::tune(Hertz spindle, double gain) {
  spindle_ = spindle;
  const auto usable = static_cast<int>(kUsableBand * size_.rate.value / spindle.value);
  if (size_.fullCovariance) {
    full_.setActive(usable);
    full_.setLambda(lambdaForGain(gain, full_.active()));
  } else {
    harmonics_.setActive(usable);
    harmonics_.setGain(gain);
  }
  // What forced vibration is left in is no chatter's.
  bands_.tune(spindle, size_.bandOrders, std::max(active(), 1));
}

void EnergyChain::align(double angle, double step) {
  if (size_.fullCovariance) {
    full_.align(angle, step);
  } else {
    harmonics_.align(angle, step);
  }
}

void EnergyChain::process(const double* x, std::ptrdiff_t stride, std::size_t frames) {
  for (std::size_t done = 0; done < frames;) {
    const std::size_t now = std::min(frames - done, bands_.room());
    const double* from = x + done;
    if (size_.fullCovariance) {
      full_.process(from, stride, rest_.data(), kMost, now);
    } else {
      harmonics_.process(from, stride, rest_.data(), kMost, now, harmonics_.afterCorrection());
      harmonics_.advance(now);
    }
    for (int c = 0; c < size_.channels; ++c) bands_.process(c, rest_.data() + c * kMost, now);
    bands_.advance(now);
    done += now;
  }
}

void EnergyChain::endHop() {
  bands_.estimate();
  for (int c = 0; c < size_.channels; ++c) {
    double* out = powers_.data() + static_cast<std::size_t>(c) * row_;
    for (int n = 1; n <= active(); ++n) {
      out[n - 1] = size_.fullCovariance ? full_.power(c, n) : harmonics_.power(c, n);
    }
  }
}

void EnergyChain::amplitudes(int channel, std::span<std::complex<double>> out) const {
  if (size_.fullCovariance) {
    full_.amplitudes(channel, out);
  } else {
    harmonics_.amplitudes(channel, out);
  }
}

double EnergyChain::forced(int channel, int eta) const {
  const double* weight = weights_[static_cast<std::size_t>(eta + 1)].data();
  return size_.fullCovariance ? full_.weightedPower(channel, weight) : harmonics_.weightedPower(channel, weight);
}

double EnergyChain::ratio(int channel, int eta) const {
  const double f2 = spindle_.value * spindle_.value;
  const double unit = eta == 0 ? 1.0 : eta > 0 ? f2 : 1.0 / f2;
  const double chatter = bands_.weightedPower(channel, eta);
  const double all = unit * forced(channel, eta) + chatter;
  return all > 0.0 ? chatter / all : 0.0;
}

double EnergyChain::bandPart(int channel, Hertz f) const {
  const double width = spindle_.value * size_.bandOrders;
  const int m = width > 0.0 ? static_cast<int>(f.value / width) : -1;
  const double all = bands_.weightedPower(channel, 0);
  return m >= 0 && m < bands_.active() && all > 0.0 ? bands_.band(channel, m).power / all : 0.0;
}

}  // namespace stillcut::detect
