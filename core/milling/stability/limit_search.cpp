#include "core/milling/stability/limit_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/milling/stability/any_tool/tooth_chatter.h"

namespace stillcut::milling {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRoughPhase = 1.0;  // six to seven digits: the place of a crossing
constexpr double kFinePhase = 0.25;  // ten digits: its value
constexpr double kFlipAngle = 1e-6;  // closer to pi than this is a flip; a pair merging with pi is one within 1e-12
constexpr double kThinBand = 1.2;    // top over bottom of a band that is split by angle
constexpr double kNodesPerPanel = 48.0;
constexpr double kMostBandEffort = 4e8;   // of it on bands split by angle, which get ever thinner
constexpr double kMostWork = 2e10;        // operations spent on one speed: some ten seconds
constexpr double kHopelessGrowth = 80.0;  // e-foldings no expansion survives
constexpr int kMostSplits = 8;
constexpr int kHopeless = 6;  // with so many multipliers outside and digits running short: not searched deeper

struct Disc {
  Complex centre;
  double radius;
};

// A disc that holds s = w (1 - exp(-i theta)) for the box.
Disc enclose(const ThetaDepthBox& box) {
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
  std::vector<Complex> edge;
  for (int i = 0; i <= 8; ++i) {
    const double angle = box.angle0 + (box.angle1 - box.angle0) * i / 8;
    for (double w : {box.depth0, box.depth1}) edge.push_back(w * (1.0 - std::polar(1.0, -angle)));
  }
  for (Complex s : edge) {
    x0 = std::min(x0, s.real());
    x1 = std::max(x1, s.real());
    y0 = std::min(y0, s.imag());
    y1 = std::max(y1, s.imag());
  }
  const Complex centre(0.5 * (x0 + x1), 0.5 * (y0 + y1));
  double radius = 0.0;
  for (Complex s : edge) radius = std::max(radius, std::abs(s - centre));
  return {centre, 1.02 * radius};
}

}  // namespace

LimitSearch::LimitSearch(const RegenerativeSystem& system, Rpm speed, const LimitOptions& options, WorkMeter& meter)
    : system_(system), options_(options), meter_(meter), cutting_(cuttingFraction(system) * system.toothPeriod(speed)) {
  limits_.speed = speed;
  limits_.verified = true;
}

// How many e-foldings a mode can gain over the time in the cut at a depth; an upper estimate, from the imaginary part
// of the stiffened natural frequency.
double LimitSearch::growthAt(double depth) const {
  double fastest = 0.0;
  for (const auto& o : system_.oscillators) {
    fastest = std::max(fastest, std::sqrt(Complex(o.omega * o.omega, depth * system_.stiffening())).imag());
  }
  return fastest * cutting_;
}

std::optional<Characteristic> LimitSearch::expandTo(double depth) {
  rough_.emplace(system_, limits_.speed, 2.0 * depth, kRoughPhase, meter_);
  fine_.emplace(system_, limits_.speed, 2.0 * depth, kFinePhase, meter_);
  return Characteristic::build(*rough_, depth, depth, meter_);
}

SpeedLimits LimitSearch::run() {
  const double top = options_.maxAxialDepth.value;
  double from = 0.0;
  double to = top;
  if (options_.firstOnly) to = options_.hint.value > 0.0 ? std::min(top, 1.2 * options_.hint.value) : top / 8;
  while (growthAt(to) > kHopelessGrowth) to *= 0.5;
  double growth = 2.0;
  while (from < top && !meter_.stopped() && meter_.total() < kMostWork) {
    std::optional<Characteristic> whole = expandTo(to);
    if (!whole && to > kThinBand * from) {
      to = std::max(0.5 * (from + to), 0.999 * kThinBand * from);
      growth = 1.5;
      if (to < 1e-9 * top) break;
      continue;
    }
    if (!whole && outside_ >= kHopeless) break;
    addBand(from, to, whole);
    if (limits_.searchedTo.value < to || (options_.firstOnly && limits_.hasLimit())) break;
    from = to;
    to = std::min(top, (whole ? growth : kThinBand) * to);
  }
  if (limits_.searchedTo.value < top && !(options_.firstOnly && limits_.hasLimit())) limits_.verified = false;
  if (options_.firstOnly && limits_.crossings.size() > 1) limits_.crossings.resize(1);
  if (options_.frequencies) {
    for (StabilityLimit& l : limits_.crossings)
      l.frequency = toothChatter(system_, *rough_, l.angle.value, l.depth.value, meter_);
  }
  return std::move(limits_);
}

void LimitSearch::addBand(double from, double to, const std::optional<Characteristic>& whole) {
  const ThetaDepthBox box{0.0, kPi, from, to};
  for (double caution : {1.0, 4.0, 16.0}) {
    Band band;
    if (whole) {
      searchPanel(*whole, box, caution, band);
    } else {
      cover(box, caution, 0, band);
    }
    if (!band.complete || meter_.stopped()) return;  // searchedTo stays below this band
    refine(band.crossings);
    int outside = outside_;
    for (const CircleCrossing& c : band.crossings) {
      outside += (c.outward > 0.0 ? 1 : -1) * (kPi - c.angle < kFlipAngle ? 1 : 2);
    }
    const bool agrees = std::isnan(band.change) || outside == rough_->states() - std::lround(band.change / kPi);
    if (!agrees && caution < 16.0) continue;
    if (!agrees) limits_.verified = false;
    append(band.crossings);
    limits_.searchedTo = Metres(to);
    return;
  }
}

void LimitSearch::searchPanel(const Characteristic& expansion, const ThetaDepthBox& box, double caution, Band& band) {
  const auto found = findCrossings(expansion, box, caution, meter_);
  if (!found) {
    band.complete = false;
    return;
  }
  for (const CircleCrossing& c : *found) {
    const bool known = std::any_of(band.crossings.begin(), band.crossings.end(), [&](const CircleCrossing& k) {
      return std::abs(k.angle - c.angle) < 1e-6 && std::abs(k.depth - c.depth) < 1e-6 * box.depth1;
    });
    if (!known) band.crossings.push_back(c);
  }
  band.change += argumentChange(expansion, box.depth1, box.angle0, box.angle1, meter_);
}

// The whole half circle does not fit one expansion: split it by angle.
void LimitSearch::cover(const ThetaDepthBox& box, double caution, int level, Band& band) {
  if (!band.complete) return;
  if (meter_.stopped() || bandEffort_ > kMostBandEffort || level > kMostSplits) {
    band.complete = false;
    return;
  }
  if (level > 0) {
    const Disc disc = enclose(box);
    bandEffort_ += kNodesPerPanel * rough_->effort();
    if (const auto expansion = Characteristic::build(*rough_, disc.centre, disc.radius, meter_)) {
      searchPanel(*expansion, box, caution, band);
      return;
    }
  }
  const double middle = 0.5 * (box.angle0 + box.angle1);
  cover({box.angle0, middle, box.depth0, box.depth1}, caution, level + 1, band);
  cover({middle, box.angle1, box.depth0, box.depth1}, caution, level + 1, band);
}

// Newton in (theta, w) on det(Psi - mu I) of the accurate transition matrix, with the derivatives of the expansion.
void LimitSearch::refine(std::vector<CircleCrossing>& crossings) const {
  const int n = fine_->states();
  std::vector<Complex> psi(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  std::vector<Complex> c(static_cast<std::size_t>(n));
  for (CircleCrossing& x : crossings) {
    const double det = x.byAngle.real() * x.byDepth.imag() - x.byAngle.imag() * x.byDepth.real();
    for (int i = 0; i < 8 && det != 0.0; ++i) {
      const Complex mu = std::polar(1.0, x.angle);
      const Complex s = x.depth * (1.0 - std::conj(mu));
      if (!fine_->evaluate(std::span(&s, 1), psi, meter_)) return;
      characteristicCoefficients(psi, n, fine_->determinant(), c);
      Complex f = 1.0;
      for (std::size_t k = c.size(); k > 0; --k) f = f * mu + c[k - 1];
      const double da = (-f.real() * x.byDepth.imag() + f.imag() * x.byDepth.real()) / det;
      const double dw = (-x.byAngle.real() * f.imag() + x.byAngle.imag() * f.real()) / det;
      if (!(std::abs(da) < 0.05) || !(std::abs(dw) < 0.05 * x.depth)) break;  // the expansion's value is better
      x.angle += da;
      x.depth += dw;
      if (std::abs(da) < 1e-9 && std::abs(dw) < 1e-10 * x.depth) break;
    }
  }
}

void LimitSearch::append(std::vector<CircleCrossing>& crossings) {
  std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.depth < b.depth; });
  for (const CircleCrossing& c : crossings) {
    StabilityLimit limit;
    limit.speed = limits_.speed;
    limit.crossing = static_cast<int>(limits_.crossings.size());
    limit.depth = Metres(c.depth);
    limit.kind = kPi - c.angle < kFlipAngle ? CrossingKind::Flip : CrossingKind::Hopf;
    limit.angle = Radians(limit.kind == CrossingKind::Flip ? kPi : c.angle);
    limit.before = outside_;
    outside_ = std::max(0, outside_ + (c.outward > 0.0 ? 1 : -1) * (limit.kind == CrossingKind::Flip ? 1 : 2));
    limit.after = outside_;
    limits_.crossings.push_back(limit);
  }
}

}  // namespace stillcut::milling
