#include "core/milling/stability/crossing_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/milling/stability/any_tool/circle_surface.h"
#include "core/milling/stability/argument_principle.h"

namespace stillcut::milling {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInjective = 0.35;  // second order against the smallest stretch of the linear map: one-to-one below
constexpr double kEdge = 1e-7;       // a zero may lie this far outside its cell, in cells
constexpr int kMostCells = 500000;
constexpr int kDeepest = 26;  // halvings: two zeros closer than 1e-7 of the box are taken as one tangency

struct Cell {
  double angle, depth;  // centre
  double a, w;          // half widths
  int level;
};

// Solves J (da, dw) = -f for real steps; false when J is singular.
bool newtonStep(Complex f, Complex fa, Complex fw, double& da, double& dw) {
  const double det = fa.real() * fw.imag() - fa.imag() * fw.real();
  if (det == 0.0 || !std::isfinite(det)) return false;
  da = (-f.real() * fw.imag() + f.imag() * fw.real()) / det;
  dw = (-fa.real() * f.imag() + fa.imag() * f.real()) / det;
  return std::isfinite(da) && std::isfinite(dw);
}

// Smallest singular value of the real 2x2 matrix with columns u, v.
double smallestStretch(Complex u, Complex v) {
  const double sum = std::norm(u) + std::norm(v);
  const double det = u.real() * v.imag() - u.imag() * v.real();
  const double largest2 = 0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4.0 * det * det)));
  return largest2 > 0.0 ? std::abs(det) / std::sqrt(largest2) : 0.0;
}

CircleValue valueOf(const Characteristic& f, double angle, double depth) {
  return onCircle(f, angle, depth);
}

CircleValue valueOf(const CircleSurface& f, double angle, double depth) {
  return f.at(angle, depth);
}

template <class Function>
class Search {
 public:
  Search(const Function& f, const ThetaDepthBox& box, double caution, WorkMeter& meter)
      : f_(f), box_(box), caution_(caution), meter_(meter) {}

  std::optional<std::vector<CircleCrossing>> run() {
    const int across = std::max(1, static_cast<int>(std::lround(6.0 * (box_.angle1 - box_.angle0) / kPi)));
    const double a = 0.5 * (box_.angle1 - box_.angle0) / across;
    const double w = 0.5 * (box_.depth1 - box_.depth0);
    for (int i = 0; i < across; ++i) cells_.push_back({box_.angle0 + (2 * i + 1) * a, box_.depth0 + w, a, w, 0});
    for (int visited = 0; !cells_.empty(); ++visited) {
      if (visited > kMostCells || !meter_.proceed(f_.effort())) return std::nullopt;
      const Cell cell = cells_.back();
      cells_.pop_back();
      visit(cell);
    }
    return std::move(found_);
  }

 private:
  void visit(const Cell& cell) {
    const CircleValue v = valueOf(f_, cell.angle, cell.depth);
    const double byAngle = std::abs(v.fa) * cell.a;
    const double byDepth = std::abs(v.fw) * cell.w;
    const double curveA = 0.5 * std::abs(v.faa) * cell.a * cell.a;
    const double curveW = 0.5 * std::abs(v.fww) * cell.w * cell.w;
    const double curve = curveA + std::abs(v.faw) * cell.a * cell.w + curveW;
    if (std::abs(v.f) > byAngle + byDepth + 2.0 * caution_ * curve) return;
    const double stretch = smallestStretch(v.fa * cell.a, v.fw * cell.w);
    if (caution_ * curve < kInjective * stretch || cell.level >= kDeepest) {
      settle(cell);
      return;
    }
    // Halve along the side that bends more, and both when neither stands out.
    const double alongA = byAngle + 2.0 * curveA;
    const double alongW = byDepth + 2.0 * curveW;
    const int na = alongA * 2.0 < alongW ? 1 : 2;
    const int nw = alongW * 2.0 < alongA ? 1 : 2;
    for (int i = 0; i < na; ++i) {
      for (int j = 0; j < nw; ++j) {
        const double a = cell.a / na;
        const double w = cell.w / nw;
        cells_.push_back(
            {cell.angle - cell.a + (2 * i + 1) * a, cell.depth - cell.w + (2 * j + 1) * w, a, w, cell.level + 1});
      }
    }
  }

  // At most one zero here: Newton finds it, or leaves the cell.
  void settle(const Cell& cell) {
    double angle = cell.angle;
    double depth = cell.depth;
    for (int i = 0; i < 12 && meter_.proceed(f_.effort()); ++i) {
      const CircleValue v = valueOf(f_, angle, depth);
      double da = 0.0;
      double dw = 0.0;
      if (!newtonStep(v.f, v.fa, v.fw, da, dw)) return;
      angle += da;
      depth += dw;
      if (std::abs(angle - cell.angle) > 3.0 * cell.a || std::abs(depth - cell.depth) > 3.0 * cell.w) return;
      if (std::abs(da) < 1e-10 && std::abs(dw) < 1e-10 * (box_.depth1 + std::abs(depth))) break;
    }
    const double slackA = kEdge * cell.a + 1e-9;
    const double slackW = kEdge * cell.w + 1e-9 * box_.depth1;
    if (std::abs(angle - cell.angle) > cell.a + slackA || std::abs(depth - cell.depth) > cell.w + slackW) return;
    keep(angle, depth);
  }

  void keep(double angle, double depth) {
    for (const CircleCrossing& c : found_) {
      if (std::abs(c.angle - angle) < 1e-8 && std::abs(c.depth - depth) < 1e-8 * box_.depth1) return;
    }
    const CircleValue v = valueOf(f_, angle, depth);
    // Along the branch mu(w) = exp(i (theta + i eta)): f_a (theta' + i eta') + f_w = 0 and |mu| = exp(-eta), f being
    // analytic in theta.
    const Complex slope = -v.fw / v.fa;
    found_.push_back({angle, depth, -slope.imag(), v.fa, v.fw});
  }

  const Function& f_;
  ThetaDepthBox box_;
  double caution_;
  WorkMeter& meter_;
  std::vector<Cell> cells_;
  std::vector<CircleCrossing> found_;
};

Complex circleValue(const Characteristic& f, double angle, double depth) {
  const Complex mu = std::polar(1.0, angle);
  return f.valueAt(mu, depth * (1.0 - std::conj(mu)));
}

Complex circleValue(const CircleSurface& f, double angle, double depth) {
  return f.valueAt(angle, depth);
}

template <class Function>
double changeAlong(const Function& f, double depth, double a, double b, WorkMeter& meter) {
  const int pieces = 1 + static_cast<int>((5 + 2 * f.states()) * (b - a) / kPi);
  const auto value = [&](double angle) -> Complex {
    if (!meter.proceed(f.effort() / 3.0)) return std::numeric_limits<double>::quiet_NaN();
    return circleValue(f, angle, depth);
  };
  return argumentChange(value, a, b, pieces);
}

}  // namespace

CircleValue onCircle(const Characteristic& characteristic, double angle, double depth) {
  const Complex mu = std::polar(1.0, angle);
  const Complex inverse = std::conj(mu);
  const Complex i(0.0, 1.0);
  const CharacteristicValue v = characteristic.at(mu, depth * (1.0 - inverse));
  const Complex sw = 1.0 - inverse;
  const Complex sa = i * depth * inverse;
  const Complex ma = i * mu;
  CircleValue r;
  r.f = v.f;
  r.fa = v.fm * ma + v.fs * sa;
  r.fw = v.fs * sw;
  r.fww = v.fss * sw * sw;
  r.faw = (v.fsm * ma + v.fss * sa) * sw + v.fs * i * inverse;
  r.faa = v.fmm * ma * ma - v.fm * mu + 2.0 * v.fsm * ma * sa + v.fss * sa * sa + v.fs * depth * inverse;
  return r;
}

std::optional<std::vector<CircleCrossing>> findCrossings(const Characteristic& characteristic, const ThetaDepthBox& box,
                                                         double caution, WorkMeter& meter) {
  return Search<Characteristic>(characteristic, box, caution, meter).run();
}

std::optional<std::vector<CircleCrossing>> findCrossings(const CircleSurface& surface, const ThetaDepthBox& box,
                                                         double caution, WorkMeter& meter) {
  return Search<CircleSurface>(surface, box, caution, meter).run();
}

double argumentChange(const Characteristic& characteristic, double depth, double a, double b, WorkMeter& meter) {
  return changeAlong(characteristic, depth, a, b, meter);
}

double argumentChange(const CircleSurface& surface, double depth, double a, double b, WorkMeter& meter) {
  return changeAlong(surface, depth, a, b, meter);
}

}  // namespace stillcut::milling
