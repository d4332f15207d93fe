#include "core/dsp/order.h"

namespace stillcut::dsp {

std::complex<double> toneAmplitude(std::span<const double> x, Hertz f, Hertz rate) noexcept {
  const std::complex<double> step = std::polar(1.0, -kTwoPi * f.value / rate.value);
  std::complex<double> phasor = 1.0;
  std::complex<double> sum = 0.0;
  for (const double v : x) {
    sum += v * phasor;
    phasor *= step;
  }
  return x.empty() ? 0.0 : sum * (2.0 / static_cast<double>(x.size()));
}

Hertz phaseDriftFrequency(std::span<const double> x, Hertz f, Hertz rate) noexcept {
  const std::size_t half = x.size() / 2;
  if (half == 0) return f;
  const std::complex<double> first = toneAmplitude(x.first(half), f, rate);
  const std::complex<double> second = toneAmplitude(x.subspan(half, half), f, rate);
  const double seconds = static_cast<double>(half) / rate.value;
  const double expected = kTwoPi * f.value * seconds;
  const double drift = wrapPhase(std::arg(second * std::conj(first)) - expected);
  return Hertz(f.value + drift / (kTwoPi * seconds));
}

}  // namespace stillcut::dsp
