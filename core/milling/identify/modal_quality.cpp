#include "core/milling/identify/modal_quality.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/base/units.h"

namespace stillcut::identify {
namespace {

constexpr double kDepthWorthSaying = 0.02;  // of the deepest negative real part
constexpr double kDepthOff = 0.15;          // relative: as much as the stability limits are off

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

// Two constants by their normal equations: the columns are 1 and -(at / f)^2.
Residual residualOf(const std::vector<double>& frequency, const std::vector<std::complex<double>>& rest, double at) {
  double ones = 0.0, cross = 0.0, squares = 0.0;
  std::complex<double> first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    const double mass = -(at / frequency[i]) * (at / frequency[i]);
    ones += 1.0;
    cross += mass;
    squares += mass * mass;
    first += rest[i];
    second += mass * rest[i];
  }
  const double determinant = ones * squares - cross * cross;
  Residual residual;
  if (!(determinant > 1e-12 * ones * squares)) return residual;
  residual.at = at;
  residual.upper = (squares * first - cross * second) / determinant;
  residual.lower = (ones * second - cross * first) / determinant;
  return residual;
}

}  // namespace

double coherenceAt(const Frf& frf, const milling::Mode& mode) {
  if (frf.coherence.empty()) return 0.0;
  const double half = std::max(mode.damping * mode.frequency.value, 1.0);
  double sum = 0.0;
  int lines = 0;
  for (std::size_t i = 0; i < frf.frequency.size(); ++i) {
    if (std::abs(frf.frequency[i] - mode.frequency.value) > half) continue;
    sum += frf.coherence[i];
    ++lines;
  }
  return lines > 0 ? sum / lines : 0.0;
}

void judgeWritten(ModalFit& fit, const std::vector<Resonance>& resonances, double addedDecay) {
  double off = 0.0;
  std::vector<std::complex<double>> rest;  // what the modes leave
  double whole = 0.0;
  for (std::size_t i = 0; i < fit.frequency.size(); ++i) {
    const std::complex<double> s(addedDecay, kTwoPi * fit.frequency[i]);
    std::complex<double> written = 0.0;
    for (const IdentifiedMode& m : fit.modes) {
      const double w = kTwoPi * m.mode.frequency.value;
      written += w * w / m.mode.stiffness / (s * s + 2.0 * m.mode.damping * w * s + w * w);
    }
    off += std::norm(written - fit.measured[i]);
    rest.push_back(fit.measured[i] - written);
    whole += std::norm(fit.measured[i]);
    fit.measuredDepth = std::max(fit.measuredDepth, -fit.measured[i].real());
    fit.writtenDepth = std::max(fit.writtenDepth, -written.real());
  }
  for (const Resonance& r : resonances) {
    const bool inside = r.frequency >= fit.from && r.frequency <= fit.to;
    if (r.reached && !inside) fit.measuredDepth = std::max(fit.measuredDepth, r.depth);
  }
  fit.writtenMisfit = whole > 0.0 ? std::sqrt(off / whole) : 0.0;
  fit.residual = residualOf(fit.frequency, rest, 0.5 * (fit.from + fit.to));
  double left = 0.0;
  for (std::size_t i = 0; i < rest.size(); ++i) left += std::norm(rest[i] - fit.residual.value(fit.frequency[i]));
  fit.residualMisfit = whole > 0.0 ? std::sqrt(left / whole) : 0.0;
  const double ratio = fit.writtenDepth / std::max(fit.measuredDepth, 1e-30);
  if (std::abs(ratio - 1.0) > kDepthOff) {
    fit.remarks.push_back(
        message("the deepest negative real part of these modes is %1 % of the measured one: limits "
                "computed from them are off by as much",
                std::lround(100.0 * ratio)));
  }
}

namespace {

bool standsFor(const IdentifiedMode& m, const Resonance& r) {
  const double f = m.mode.frequency.value;
  return std::abs(f - r.frequency) < std::max(0.03, 1.5 * m.mode.damping) * f;
}

Message leftOut(const Resonance& r, double deepest) {
  const long hertz = std::lround(r.frequency), percent = std::lround(100.0 * r.depth / deepest);
  if (r.noise == PeakNoise::Clear) {
    return message("left out: a resonance at %1 Hz, its negative real part of %2 m/N is %3 % of the deepest", hertz,
                   shortNumber(r.depth), percent);
  }
  return message(
      "left out: a noisy peak at %1 Hz, its negative real part of about %2 m/N is %3 % of the deepest: hit "
      "harder, or average more hits",
      hertz, shortNumber(r.depth), percent);
}

}  // namespace

void nameLeftOut(ModalFit& fit, const std::vector<Resonance>& resonances, double usableTo) {
  double deepest = 0.0, fitted = 0.0;
  for (const Resonance& r : resonances) deepest = std::max(deepest, r.reached ? r.depth : 0.0);
  for (const IdentifiedMode& m : fit.modes) fitted = std::max(fitted, m.depth);
  for (const Resonance& r : resonances) {
    const auto stands = [&](const IdentifiedMode& m) { return standsFor(m, r); };
    const bool stoodFor = std::any_of(fit.modes.begin(), fit.modes.end(), stands);
    if (r.depth < kDepthWorthSaying * deepest) continue;
    if (!stoodFor && !r.reached) {
      fit.remarks.push_back(
          message("not looked at: a peak at %1 Hz of about %2 m/N lies above %3 Hz, where the hit has no force left: "
                  "take a harder tip",
                  std::lround(r.frequency), shortNumber(r.depth), std::lround(usableTo)));
    } else if (!stoodFor) {
      fit.remarks.push_back(leftOut(r, deepest));
      if (r.depth > fitted) {
        if (r.noise != PeakNoise::Clear) fit.missing = r.frequency;
        fit.remarks.push_back(
            message("what was left out at %1 Hz is deeper than every mode found: limits computed from these modes are "
                    "too high",
                    std::lround(r.frequency)));
      }
    } else if (r.noise != PeakNoise::Clear) {
      fit.remarks.push_back(
          message("the peak at %1 Hz is noisy: hit harder, or average more hits", std::lround(r.frequency)));
    }
  }
}

}  // namespace stillcut::identify
