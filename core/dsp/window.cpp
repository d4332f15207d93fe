#include "core/dsp/window.h"

#include <cmath>

#include "core/base/units.h"

namespace stillcut::dsp {
namespace {

double windowValue(WindowKind kind, double phase) {
  switch (kind) {
    case WindowKind::Hann:
      return 0.5 - 0.5 * std::cos(phase);
    case WindowKind::FlatTop:  // ISO 18431-2
      return 0.21557895 - 0.41663158 * std::cos(phase) + 0.277263158 * std::cos(2 * phase) -
             0.083578947 * std::cos(3 * phase) + 0.006947368 * std::cos(4 * phase);
    case WindowKind::Recent: {
      constexpr double kTop = 0.9 * kTwoPi;
      const double part = phase < kTop ? phase / kTop : (kTwoPi - phase) / (kTwoPi - kTop);
      return 0.5 - 0.5 * std::cos(0.5 * kTwoPi * part);
    }
    case WindowKind::Rectangular:
      break;
  }
  return 1.0;
}

}  // namespace

WindowSums fillWindow(WindowKind kind, std::span<double> w) {
  WindowSums sums;
  const double step = kTwoPi / static_cast<double>(w.size());
  for (std::size_t n = 0; n < w.size(); ++n) {
    w[n] = windowValue(kind, step * static_cast<double>(n));
    sums.sum += w[n];
    sums.squares += w[n] * w[n];
  }
  return sums;
}

}  // namespace stillcut::dsp
