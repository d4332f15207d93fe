#include "tests/support/field_cases/tone.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/base/units.h"

namespace stillcut::field {

void addTone(std::span<double> x, double rate, const Tone& tone, std::span<const double> envelope) {
  constexpr std::size_t kExact = 256;  // samples after which the rotating phasor is computed anew
  const double step = kTwoPi * tone.hertz / rate;
  const std::complex<double> rotation = std::polar(1.0, step);
  std::complex<double> phasor;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i % kExact == 0) phasor = std::polar(tone.amplitude, step * static_cast<double>(i) + tone.phase);
    x[i] += envelope.empty() ? phasor.real() : envelope[i] * phasor.real();
    phasor = {phasor.real() * rotation.real() - phasor.imag() * rotation.imag(),
              phasor.real() * rotation.imag() + phasor.imag() * rotation.real()};
  }
}

double ramp(double time, double at, double length) {
  return std::clamp((time - at) / length, 0.0, 1.0);
}

std::vector<float> inSinglePrecision(std::span<const double> x) {
  std::vector<float> y(x.size());
  std::transform(x.begin(), x.end(), y.begin(), [](double v) { return static_cast<float>(v); });
  return y;
}

std::vector<float> inSixteenBits(std::span<const double> x) {
  std::vector<float> y(x.size());
  std::transform(x.begin(), x.end(), y.begin(), [](double v) {
    return static_cast<float>(std::clamp(std::round(v * 32767.0), -32768.0, 32767.0) / 32768.0);
  });
  return y;
}

}  // namespace stillcut::field
