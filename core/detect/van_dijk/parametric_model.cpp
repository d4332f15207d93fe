#include "core/detect/van_dijk/parametric_model.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr int kMostSteps = 100;
constexpr int kFewSteps = 8;  // from near by; a pair that has become two real roots is never reached from there
constexpr double kTogether = 1e-280;
constexpr double kStands = 1e-8;      // the step after such a one would be of its square
constexpr double kOscillates = 1e-6;  // least imaginary part

// Finite numbers only: spares the checks for infinite ones that a product otherwise makes.
std::complex<double> times(std::complex<double> a, std::complex<double> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

std::complex<double> polynomial(const ArCoefficients& theta, std::complex<double> q) {
  std::complex<double> value = 1.0;
  for (const double t : theta) value = times(value, q) - t;
  return value;
}

// Weierstrass, until they stand. False: they do not after so many steps, or two stand together.
bool polish(const ArCoefficients& theta, ArRoots& roots, int steps) {
  for (int step = 0; step < steps; ++step) {
    double moved = 0.0;
    bool apart = true;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      std::complex<double> others = 1.0;
      for (std::size_t j = 0; j < roots.size(); ++j) {
        if (j != i) others = times(others, roots[i] - roots[j]);
      }
      if (!(std::norm(others) > kTogether)) {
        others = 1e-140;
        apart = false;
      }
      const std::complex<double> shift = times(polynomial(theta, roots[i]), std::conj(others)) / std::norm(others);
      roots[i] -= shift;
      moved = std::max(moved, std::norm(shift));
    }
    if (moved < kStands * kStands) return apart;
  }
  return false;
}

}  // namespace

ArRoots rootsOf(const ArCoefficients& theta) {
  double radius = 0.0;
  for (const double t : theta) radius = std::max(radius, std::abs(t));
  ArRoots roots;
  // Start on a circle of the roots' own size, turned so that no start is real or a conjugate of another.
  const double size = std::clamp(std::pow(std::abs(theta[3]), 0.25), 0.1, 1.0 + radius);
  for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = std::polar(size, 0.4 + kTwoPi * static_cast<double>(i) / 4);
  polish(theta, roots, kMostSteps);
  return roots;
}

ArRoots rootsOf(const ArCoefficients& theta, const ArRoots& near) {
  ArRoots roots = near;
  return polish(theta, roots, kFewSteps) ? roots : rootsOf(theta);
}

bool unstable(const ArCoefficients& theta) {
  ArCoefficients a{};
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = -theta[i];
  for (std::size_t n = a.size(); n-- > 0;) {
    const double k = a[n];
    if (!(std::abs(k) < 1.0)) return true;
    ArCoefficients lower{};
    for (std::size_t i = 0; i < n; ++i) lower[i] = (a[i] - k * a[n - 1 - i]) / (1.0 - k * k);
    a = lower;
  }
  return false;
}

ArCoefficients thetaOf(const ArRoots& roots) {
  std::array<std::complex<double>, kArOrder + 1> c{};
  c[0] = 1.0;
  for (const auto& root : roots) {
    for (std::size_t i = c.size() - 1; i > 0; --i) c[i] -= times(root, c[i - 1]);
  }
  ArCoefficients theta{};
  for (std::size_t i = 0; i < theta.size(); ++i) theta[i] = -c[i + 1].real();
  return theta;
}

bool reflect(ArRoots& roots, double delta) {
  bool any = false;
  for (auto& root : roots) {
    const double square = std::norm(root);
    if (square <= 1.0) continue;
    root *= (1.0 - delta) / std::sqrt(square);
    any = true;
  }
  return any;
}

std::complex<double> dominantRoot(const ArRoots& roots) {
  std::complex<double> oscillating = 0.0;
  std::complex<double> any = 0.0;
  for (const auto& root : roots) {
    if (std::norm(root) > std::norm(any)) any = root;
    if (std::abs(root.imag()) > kOscillates && std::norm(root) > std::norm(oscillating)) oscillating = root;
  }
  const std::complex<double> found = oscillating == 0.0 ? any : oscillating;
  return {found.real(), std::abs(found.imag())};
}

Hertz rootFrequency(std::complex<double> root, Hertz rate) {
  return rate * (std::arg(root) / kTwoPi);
}

double modelDensity(const ArCoefficients& theta, Hertz frequency, Hertz rate) {
  const std::complex<double> turn = std::polar(1.0, -kTwoPi * (frequency / rate));
  std::complex<double> turned = turn;
  std::complex<double> d = 1.0;
  for (const double t : theta) {
    d -= t * turned;
    turned = times(turned, turn);
  }
  return 1.0 / std::max(std::norm(d), 1e-300);
}

}  // namespace stillcut::detect
