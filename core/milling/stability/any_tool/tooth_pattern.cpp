#include "core/milling/stability/any_tool/tooth_pattern.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillcut::milling {

namespace {

constexpr double kSamePitch = 1e-9;  // [rad]
constexpr double kSameTrail = 1e-9;  // [rad/m]

bool repeatsAfter(const ToothPattern& p, std::size_t shift) {
  const std::size_t n = p.pitch.size();
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t k = (j + shift) % n;
    if (std::abs(p.pitch[j] - p.pitch[k]) > kSamePitch || std::abs(p.trail[j] - p.trail[k]) > kSameTrail) return false;
  }
  return true;
}

}  // namespace

double ToothPattern::delayAngle(int tooth, double height) const {
  const auto j = static_cast<std::size_t>(tooth);
  return pitch[j] + height * (trail[j] - trail[(j + 1) % trail.size()]);
}

Metres ToothPattern::meeting() const {
  double height = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < trail.size(); ++j) {
    const double closing = trail[(j + 1) % trail.size()] - trail[j];
    if (closing > kSameTrail) height = std::min(height, pitch[j] / closing);
  }
  return Metres(height);
}

ToothPattern toothPattern(const Tool& tool) {
  ToothPattern p;
  double angle = 0.0;
  for (int j = 0; j < tool.teeth; ++j) {
    p.angle.push_back(angle);
    p.pitch.push_back(pitchAfter(tool, j));
    p.trail.push_back(std::tan(helixOf(tool, j)) / (0.5 * tool.diameter.value));
    angle += p.pitch.back();
  }
  const auto n = static_cast<std::size_t>(tool.teeth);
  for (std::size_t shift = n; shift >= 1; --shift) {
    if (n % shift == 0 && repeatsAfter(p, shift)) p.repeats = static_cast<int>(n / shift);
  }
  p.alike = p.repeats == tool.teeth;
  p.straight = std::all_of(p.trail.begin(), p.trail.end(), [](double t) { return t == 0.0; });
  p.parallel = std::all_of(p.trail.begin(), p.trail.end(),
                           [&](double t) { return std::abs(t - p.trail.front()) <= kSameTrail; });
  return p;
}

}  // namespace stillcut::milling
