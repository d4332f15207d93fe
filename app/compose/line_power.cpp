#include "app/compose/line_power.h"

#include <cmath>

#include "core/dsp/spectrum.h"

namespace stillcut::app {

double linePower(std::span<const double> x, double frequency, Hertz rate) {
  const int length = static_cast<int>(rate.value);
  if (static_cast<int>(x.size()) < length) return 0.0;
  dsp::Spectrum spectrum;
  spectrum.prepare(length, rate, dsp::WindowKind::Hann);
  spectrum.transform(x.last(static_cast<std::size_t>(length)));
  double sum = 0.0;
  for (int k = 0; k < spectrum.bins(); ++k) {
    if (std::abs(k * spectrum.binWidth() - frequency) <= 5.0) sum += spectrum.density(k);
  }
  return sum;
}

}  // namespace stillcut::app
