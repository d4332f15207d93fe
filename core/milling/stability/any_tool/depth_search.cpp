#include "core/milling/stability/any_tool/depth_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::milling {

namespace {

using Complex = std::complex<double>;

constexpr double kPi = std::numbers::pi;
constexpr double kRealAngle = 1e-6;       // closer to 0 or pi than this a multiplier is real and alone
constexpr double kMostWork = 2e10;        // operations spent on one speed: some ten seconds
constexpr double kHopelessGrowth = 80.0;  // e-foldings no expansion survives
constexpr double kRefined = 1e-5;         // a step of Newton below this is the last
constexpr double kThinnest = 1e-3;        // band over the deepest depth at which halving ends
constexpr int kHopeless = 12;             // with so many multipliers outside: not searched deeper

bool isReal(double angle) {
  return angle < kRealAngle || kPi - angle < kRealAngle;
}

int multipliers(const CircleCrossing& c) {
  return (c.outward > 0.0 ? 1 : -1) * (isReal(c.angle) ? 1 : 2);
}

}  // namespace

DepthSearch::DepthSearch(const CircleFunction& f, Rpm speed, const LimitOptions& options, WorkMeter& meter)
    : f_(f), options_(options), meter_(meter) {
  limits_.speed = speed;
  limits_.verified = true;
}

SpeedLimits DepthSearch::run() {
  const double top = options_.maxAxialDepth.value;
  double from = 0.0;
  double to = top;
  if (options_.firstOnly) to = options_.hint.value > 0.0 ? std::min(top, 1.2 * options_.hint.value) : top / 8;
  while (f_.growthAt(to) > kHopelessGrowth) to *= 0.5;
  while (from < top && !meter_.stopped() && meter_.total() < kMostWork && outside_ < kHopeless) {
    const auto surface = CircleSurface::build(f_, from, to, meter_);
    if (!surface || !addBand(from, to, *surface)) {
      if (to - from < kThinnest * top) break;
      to = from + 0.5 * (to - from);
      continue;
    }
    if (options_.firstOnly && limits_.hasLimit()) break;
    const double next = std::min(top, to + 2.0 * (to - from));
    from = to;
    to = next;
  }
  if (limits_.searchedTo.value < top && !(options_.firstOnly && limits_.hasLimit())) limits_.verified = false;
  if (options_.firstOnly && limits_.crossings.size() > 1) limits_.crossings.resize(1);
  if (options_.frequencies) {
    for (StabilityLimit& l : limits_.crossings) {
      l.frequency = f_.chatterFrequency(l.angle.value, l.depth.value, meter_);
    }
  }
  return std::move(limits_);
}

// False: not searched, or what was found cannot be distinguished.
bool DepthSearch::addBand(double from, double to, const CircleSurface& surface) {
  const ThetaDepthBox box{0.0, kPi, from, to};
  const double change = argumentChange(surface, to, 0.0, kPi, meter_);
  for (double caution : {1.0, 4.0, 16.0}) {
    auto found = findCrossings(surface, box, caution, meter_);
    if (!found || meter_.stopped()) return false;
    int outside = outside_;
    for (const CircleCrossing& c : *found) outside += multipliers(c);
    const bool agrees = std::isnan(change) || outside == f_.states() - std::lround(change / kPi);
    if (!agrees && caution < 16.0) continue;
    if (!agrees) limits_.verified = false;
    refine(*found);
    append(*found);
    limits_.searchedTo = Metres(to);
    return !meter_.stopped();
  }
  return false;
}

// Newton in (theta, w) on the fine function, with the derivatives of the surface.
void DepthSearch::refine(std::vector<CircleCrossing>& crossings) const {
  for (CircleCrossing& x : crossings) {
    const double det = x.byAngle.real() * x.byDepth.imag() - x.byAngle.imag() * x.byDepth.real();
    double angle = x.angle, depth = x.depth;
    for (int i = 0; i < 3 && det != 0.0; ++i) {
      Complex f;
      if (!f_.sample(depth, std::span(&angle, 1), Fineness::Fine, std::span(&f, 1), meter_)) return;
      const double da = isReal(x.angle) ? 0.0 : (-f.real() * x.byDepth.imag() + f.imag() * x.byDepth.real()) / det;
      const double dw = isReal(x.angle) ? -f.real() / x.byDepth.real()
                                        : (-x.byAngle.real() * f.imag() + x.byAngle.imag() * f.real()) / det;
      if (!(std::abs(da) < 0.05) || !(std::abs(dw) < 0.05 * depth)) break;  // the surface's value is better
      angle += da;
      depth += dw;
      x.angle = std::clamp(angle, 0.0, kPi);
      x.depth = depth;
      if (std::abs(da) < kRefined && std::abs(dw) < kRefined * depth) break;
      angle = x.angle;
    }
  }
}

void DepthSearch::append(std::vector<CircleCrossing>& crossings) {
  std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.depth < b.depth; });
  for (const CircleCrossing& c : crossings) {
    StabilityLimit limit;
    limit.speed = limits_.speed;
    limit.crossing = static_cast<int>(limits_.crossings.size());
    limit.depth = Metres(c.depth);
    limit.kind = kPi - c.angle < kRealAngle ? CrossingKind::Flip
                 : c.angle < kRealAngle     ? CrossingKind::Fold
                                            : CrossingKind::Hopf;
    limit.angle = Radians(c.angle);
    limit.before = outside_;
    outside_ = std::max(0, outside_ + multipliers(c));
    limit.after = outside_;
    limits_.crossings.push_back(limit);
  }
}

}  // namespace stillcut::milling
