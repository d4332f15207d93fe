#include "tests/support/dominant_multiplier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "core/milling/stability/argument_principle.h"
#include "core/milling/stability/characteristic.h"

namespace stillcut::test {
namespace {

using milling::Characteristic;
using milling::Complex;
using milling::TransitionMatrix;
using milling::WorkMeter;

constexpr double kSmallest = 1e-2;  // a multiplier below this is reported as this
constexpr double kLargest = 1e4;

// Multipliers outside |mu| = r; empty when that cannot be told there.
std::optional<int> countBeyond(const TransitionMatrix& transition, double depth, double r, WorkMeter& meter) {
  const auto f = Characteristic::build(transition, depth, depth / r, meter);
  if (!f) return std::nullopt;
  const auto value = [&](double angle) -> Complex {
    const Complex mu = std::polar(r, angle);
    return f->valueAt(mu, depth * (1.0 - 1.0 / mu));
  };
  const double change = milling::argumentChange(value, 0.0, std::numbers::pi, 5 + 2 * transition.states());
  if (!std::isfinite(change)) return std::nullopt;
  return transition.states() - static_cast<int>(std::lround(change / std::numbers::pi));
}

// Newton on the transition matrix itself, the derivative by a central difference in mu.
Complex refined(const TransitionMatrix& transition, double depth, Complex mu, WorkMeter& meter) {
  const auto n = static_cast<std::size_t>(transition.states());
  std::vector<Complex> psi(3 * n * n);
  std::vector<Complex> c(n);
  for (int i = 0; i < 12; ++i) {
    const double d = 1e-4 * std::abs(mu);
    const std::array<Complex, 3> at{mu, mu + d, mu - d};
    std::array<Complex, 3> s;
    std::array<Complex, 3> f;
    for (std::size_t j = 0; j < 3; ++j) s[j] = depth * (1.0 - 1.0 / at[j]);
    if (!transition.evaluate(s, psi, meter)) break;
    for (std::size_t j = 0; j < 3; ++j) {
      milling::characteristicCoefficients(std::span(psi).subspan(j * n * n, n * n), transition.states(),
                                          transition.determinant(), c);
      f[j] = 1.0;
      for (std::size_t k = n; k > 0; --k) f[j] = f[j] * at[j] + c[k - 1];
    }
    const Complex step = -f[0] * 2.0 * d / (f[1] - f[2]);
    if (!std::isfinite(std::abs(step))) break;
    mu += step;
    if (std::abs(step) < 1e-12 * std::abs(mu)) break;
  }
  return mu;
}

}  // namespace

Result<std::complex<double>> dominantMultiplier(const milling::ExactLobes& lobes, Rpm speed, Metres depth) {
  if (Status ok = lobes.checkSpeed(speed); !ok) return ok.error();
  if (!std::isfinite(depth.value) || depth.value < 0.0 || depth.value > 1.0) {
    return Error{message("depth"), message("must lie between 0 and 1 m")};
  }
  const double w = depth.value;
  WorkMeter meter;
  const TransitionMatrix rough(lobes.system(), speed, 2.0 * w, 1.0, meter);
  const TransitionMatrix fine(lobes.system(), speed, 2.0 * w, 0.3, meter);
  const Error lost{"dominant multiplier", message("the cut is too unstable for double precision"),
                   message("take a smaller depth")};
  if (w == 0.0) {
    double slowest = 0.0;
    for (const auto& o : lobes.system().oscillators) {
      slowest = std::max(slowest, std::exp(-o.zeta * o.omega * fine.toothPeriod()));
    }
    return std::complex<double>(slowest);
  }
  double inner = 1.0;
  double outer = 1.0;
  std::optional<int> beyond = countBeyond(rough, w, 1.0, meter);
  if (!beyond) return lost;
  if (*beyond > 0) {
    while (beyond && *beyond > 0 && outer < kLargest) {
      inner = outer;
      outer *= 1.5;
      beyond = countBeyond(rough, w, outer, meter);
    }
  } else {
    while (beyond && *beyond == 0 && inner > kSmallest) {
      outer = inner;
      inner /= 1.3;
      beyond = countBeyond(rough, w, inner, meter);
    }
    if (beyond && *beyond == 0) return std::complex<double>(kSmallest);
  }
  if (!beyond) return lost;
  while (outer / inner > 1.002) {
    const double middle = std::sqrt(inner * outer);
    beyond = countBeyond(rough, w, middle, meter);
    (beyond.value_or(0) > 0 ? inner : outer) = middle;
  }
  const auto f = Characteristic::build(rough, w, w / inner, meter);
  if (!f) return lost;
  Complex best = inner;
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 1024; ++i) {
    const Complex mu = std::polar(inner, std::numbers::pi * i / 1024);
    const milling::CharacteristicValue v = f->at(mu, w * (1.0 - 1.0 / mu));
    const double distance = std::abs(v.f / (v.fm + v.fs * w / (mu * mu)));
    if (distance >= smallest) continue;
    smallest = distance;
    best = mu;
  }
  return refined(fine, w, best, meter);
}

}  // namespace stillcut::test
