#include "core/milling/stability/dominant_line.h"

#include <cmath>

namespace stillcut::milling {

Hertz dominantLine(std::span<const std::complex<double>> motion, double angle, double period, int lines) {
  const auto samples = static_cast<double>(motion.size() / 2);
  double largest = -1.0;
  double frequency = 0.0;
  for (int k = -lines; k <= lines; ++k) {
    const std::complex<double> turn = std::polar(1.0, -(angle + kTwoPi * k) / samples);
    std::complex<double> phase = 1.0;
    std::complex<double> x = 0.0;
    std::complex<double> y = 0.0;
    for (std::size_t i = 0; i + 1 < motion.size(); i += 2) {
      x += motion[i] * phase;
      y += motion[i + 1] * phase;
      phase *= turn;
    }
    const double size = std::norm(x) + std::norm(y);
    if (size <= largest) continue;
    largest = size;
    frequency = std::abs(angle + kTwoPi * k) / (kTwoPi * period);
  }
  return Hertz(frequency);
}

}  // namespace stillcut::milling
