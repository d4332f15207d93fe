#include "core/detect/parametric_model.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr int kMostSteps = 100;
constexpr double kStands = 1e-13;
constexpr double kOscillates = 1e-6;  // least imaginary part

std::complex<double> polynomial(const ArCoefficients& theta, std::complex<double> q) noexcept {
  std::complex<double> value = 1.0;
  for (const double t : theta) value = value * q - t;
  return value;
}

}  // namespace

ArRoots rootsOf(const ArCoefficients& theta) noexcept {
  double radius = 0.0;
  for (const double t : theta) radius = std::max(radius, std::abs(t));
  ArRoots roots;
  // Start on a circle of the roots' own size, turned so that no start is real or a conjugate of another.
  const double size = std::clamp(std::pow(std::abs(theta[3]), 0.25), 0.1, 1.0 + radius);
  for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = std::polar(size, 0.4 + kTwoPi * static_cast<double>(i) / 4);
  for (int step = 0; step < kMostSteps; ++step) {
    double moved = 0.0;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      std::complex<double> others = 1.0;
      for (std::size_t j = 0; j < roots.size(); ++j) {
        if (j != i) others *= roots[i] - roots[j];
      }
      if (std::norm(others) < 1e-280) others = 1e-140;
      const std::complex<double> shift = polynomial(theta, roots[i]) / others;
      roots[i] -= shift;
      moved = std::max(moved, std::abs(shift));
    }
    if (moved < kStands) break;
  }
  return roots;
}

ArCoefficients thetaOf(const ArRoots& roots) noexcept {
  std::array<std::complex<double>, kArOrder + 1> c{};
  c[0] = 1.0;
  for (const auto& root : roots) {
    for (std::size_t i = c.size() - 1; i > 0; --i) c[i] -= root * c[i - 1];
  }
  ArCoefficients theta{};
  for (std::size_t i = 0; i < theta.size(); ++i) theta[i] = -c[i + 1].real();
  return theta;
}

bool reflect(ArRoots& roots, double delta) noexcept {
  bool any = false;
  for (auto& root : roots) {
    const double size = std::abs(root);
    if (size <= 1.0) continue;
    root *= (1.0 - delta) / size;
    any = true;
  }
  return any;
}

std::complex<double> dominantRoot(const ArRoots& roots) noexcept {
  std::complex<double> oscillating = 0.0;
  std::complex<double> any = 0.0;
  for (const auto& root : roots) {
    if (std::abs(root) > std::abs(any)) any = root;
    if (std::abs(root.imag()) > kOscillates && std::abs(root) > std::abs(oscillating)) oscillating = root;
  }
  const std::complex<double> found = oscillating == 0.0 ? any : oscillating;
  return {found.real(), std::abs(found.imag())};
}

Hertz rootFrequency(std::complex<double> root, Hertz rate) noexcept {
  return rate * (std::arg(root) / kTwoPi);
}

double modelDensity(const ArCoefficients& theta, Hertz frequency, Hertz rate) noexcept {
  std::complex<double> d = 1.0;
  for (std::size_t n = 0; n < theta.size(); ++n) {
    d -= theta[n] * std::polar(1.0, -kTwoPi * (frequency / rate) * static_cast<double>(n + 1));
  }
  return 1.0 / std::max(std::norm(d), 1e-300);
}

}  // namespace stillcut::detect
