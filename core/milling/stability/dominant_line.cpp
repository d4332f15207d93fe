#include "core/milling/stability/dominant_line.h"

#include <cmath>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace stillcut::milling {

namespace {

using Complex = std::complex<double>;

// Fourier lines of one axis of the motion with exp(i angle t/period) taken out.
std::vector<Complex> lineSizes(std::span<const Complex> motion, std::size_t axis, double angle) {
  std::vector<Complex> periodic(motion.size() / 2);
  for (std::size_t i = 0; i < periodic.size(); ++i) {
    const double turned = angle * static_cast<double>(i) / static_cast<double>(periodic.size());
    periodic[i] = motion[2 * i + axis] * std::polar(1.0, -turned);
  }
  std::vector<Complex> spectrum;
  Eigen::FFT<double>().fwd(spectrum, periodic);
  return spectrum;
}

}  // namespace

Hertz dominantLine(std::span<const Complex> motion, double angle, double period, int lines, WorkMeter& meter) {
  const std::size_t samples = motion.size() / 2;
  const auto n = static_cast<double>(samples);
  const double effort = n * (40.0 + 10.0 * std::log2(n + 1.0));
  if (samples == 0 || !meter.proceed(effort)) return Hertz(0.0);
  const std::vector<Complex> x = lineSizes(motion, 0, angle);
  if (!meter.proceed(effort)) return Hertz(0.0);
  const std::vector<Complex> y = lineSizes(motion, 1, angle);
  double largest = -1.0;
  double frequency = 0.0;
  for (int k = -lines; k <= lines; ++k) {
    const auto bin = static_cast<std::size_t>(k < 0 ? k + static_cast<int>(samples) : k) % samples;
    const double size = std::norm(x[bin]) + std::norm(y[bin]);
    if (size <= largest) continue;
    largest = size;
    frequency = std::abs(angle + kTwoPi * k) / (kTwoPi * period);
  }
  return Hertz(frequency);
}

}  // namespace stillcut::milling
