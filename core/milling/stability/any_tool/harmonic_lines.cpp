#include "core/milling/stability/any_tool/harmonic_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::milling {

namespace {

constexpr double kRoughReach = 1.8;  // where lines begin to fade, in frequencies of the highest mode
constexpr double kFineReach = 4.0;
constexpr double kFade = 0.4;  // of that, until they are gone

}  // namespace

HarmonicLines::HarmonicLines(const std::vector<RegenerativeSystem::Oscillator>& oscillators, double period)
    : period_(period) {
  for (const auto& o : oscillators) {
    own_.push_back({o.omega, o.zeta});
    highest_ = std::max(highest_, o.omega);
  }
}

std::vector<HarmonicLine> HarmonicLines::at(double angle, Fineness fineness) const {
  const double spacing = kTwoPi / period_;
  const double from = (fineness == Fineness::Rough ? kRoughReach : kFineReach) * highest_ + 2.0 * spacing;
  const double width = kFade * from;
  const int most = static_cast<int>((from + width) / spacing) + 1;
  std::vector<HarmonicLine> lines;
  for (int k = -most; k <= most; ++k) {
    const double omega = angle / period_ + k * spacing;
    const double into = (std::abs(omega) - from) / width;
    if (into >= 1.0) continue;
    const double c = into > 0.0 ? std::cos(0.5 * std::numbers::pi * into) : 1.0;
    lines.push_back({omega, c * c * c * c, k});
  }
  return lines;
}

std::complex<double> HarmonicLines::structure(double angle) const {
  const std::complex<double> mu = std::polar(1.0, angle);
  std::complex<double> product = 1.0;
  for (const Own& o : own_) {
    const double size = std::exp(-o.zeta * o.omega * period_);
    const double turn = o.omega * std::sqrt(1.0 - o.zeta * o.zeta) * period_;
    product *= (mu - std::polar(size, turn)) * (mu - std::polar(size, -turn));
  }
  return product;
}

}  // namespace stillcut::milling
