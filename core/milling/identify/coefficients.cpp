#include "core/milling/identify/coefficients.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace stillcut::identify {
namespace {

struct Integrals {
  double sc = 0.0, ss = 0.0, s = 0.0, c = 0.0, angle = 0.0;
};

Integrals integralsOf(const milling::Engagement& engagement) {
  const double st = engagement.startAngle();
  const double ex = engagement.exitAngle();
  Integrals i;
  i.sc = 0.5 * (std::pow(std::sin(ex), 2) - std::pow(std::sin(st), 2));
  i.ss = 0.5 * (ex - st) - 0.25 * (std::sin(2.0 * ex) - std::sin(2.0 * st));
  i.s = std::cos(st) - std::cos(ex);
  i.c = std::sin(ex) - std::sin(st);
  i.angle = ex - st;
  return i;
}

// Mean force of one axis against feed: force = slope feed + edge, with variances.
struct Line {
  double slope = 0.0;
  double edge = 0.0;
  double slopeVariance = 0.0;
  double edgeVariance = 0.0;
  double residual = 0.0;  // sum of squares [N^2]
};

// Weighted by the standard errors where all are known. With three means or more the scatter about the line widens the
// deviations, never narrows them.
Line fitLine(const std::vector<MeanForce>& means, std::size_t axis) {
  const bool weighted = std::all_of(means.begin(), means.end(), [&](auto& m) { return m.standardError[axis] > 0.0; });
  double w = 0.0, wx = 0.0, wy = 0.0;
  const auto weight = [&](const MeanForce& m) { return weighted ? std::pow(m.standardError[axis], -2) : 1.0; };
  for (const MeanForce& m : means) {
    w += weight(m);
    wx += weight(m) * m.feedPerTooth;
    wy += weight(m) * m.mean[axis];
  }
  const double x0 = wx / w;
  const double y0 = wy / w;
  double xx = 0.0, xy = 0.0;
  for (const MeanForce& m : means) {
    xx += weight(m) * (m.feedPerTooth - x0) * (m.feedPerTooth - x0);
    xy += weight(m) * (m.feedPerTooth - x0) * (m.mean[axis] - y0);
  }
  Line line;
  line.slope = xy / xx;
  line.edge = y0 - line.slope * x0;
  double chi = 0.0;
  for (const MeanForce& m : means) {
    const double r = m.mean[axis] - line.edge - line.slope * m.feedPerTooth;
    line.residual += r * r;
    chi += weight(m) * r * r;
  }
  const double freedom = static_cast<double>(means.size()) - 2.0;
  const double scatter = freedom > 0.0 ? chi / freedom : 0.0;
  const double unit = weighted ? std::max(1.0, scatter) : scatter;
  line.slopeVariance = unit / xx;
  line.edgeVariance = unit * (1.0 / w + x0 * x0 / xx);
  return line;
}

struct Lines {
  Line along, across, up;
};

Lines signedLines(const Lines& lines, const std::array<int, 3>& signs) {
  Lines out = lines;
  for (auto [line, sign] : {std::pair{&out.along, signs[0]}, {&out.across, signs[1]}, {&out.up, signs[2]}}) {
    line->slope *= sign;
    line->edge *= sign;
  }
  return out;
}

// a = (-c x + s y) / d, b = (-s x - c y) / d solve x = -c a - s b, y = s a - c b.
std::array<Coefficient, 2> solvePair(double x, double xVariance, double y, double yVariance, double c, double s,
                                     double p) {
  const double d = (c * c + s * s) * p;
  return {{{(-c * x + s * y) / d, std::sqrt(c * c * xVariance + s * s * yVariance) / d},
           {(-s * x - c * y) / d, std::sqrt(s * s * xVariance + c * c * yVariance) / d}}};
}

CuttingCoefficients solve(const Lines& l, const ForceTest& test) {
  const Integrals i = integralsOf(test.engagement);
  const double p = test.teeth * test.depth / kTwoPi;
  CuttingCoefficients k;
  const auto cutting =
      solvePair(l.along.slope, l.along.slopeVariance, l.across.slope, l.across.slopeVariance, i.sc, i.ss, p);
  const auto edge = solvePair(l.along.edge, l.along.edgeVariance, l.across.edge, l.across.edgeVariance, i.c, i.s, p);
  k.tangential = cutting[0];
  k.radial = cutting[1];
  k.tangentialEdge = edge[0];
  k.radialEdge = edge[1];
  k.axial = {l.up.slope / (p * i.s), std::sqrt(l.up.slopeVariance) / (p * i.s)};
  k.axialEdge = {l.up.edge / (p * i.angle), std::sqrt(l.up.edgeVariance) / (p * i.angle)};
  return k;
}

Status check(const ForceTest& test) {
  const auto bad = [&](Message what, Message why = {}) { return Error{test.source, std::move(what), std::move(why)}; };
  if (test.teeth < 1 || test.teeth > milling::kMostTeeth) {
    return bad(message("the number of teeth must be 1 to %1", std::to_string(milling::kMostTeeth)));
  }
  if (!(test.depth > 0.0 && test.depth < 1.0)) return bad(message("the axial depth must lie between 0 and 1 m"));
  const double immersion = test.engagement.radialImmersion;
  if (!(immersion > 0.0 && immersion <= 1.0)) return bad(message("the radial immersion must lie above 0 and up to 1"));
  double low = HUGE_VAL;
  double high = 0.0;
  for (const MeanForce& m : test.means) {
    if (!(m.feedPerTooth > 0.0 && m.feedPerTooth < 0.1))
      return bad(message("a feed per tooth is not between 0 and 100 mm"));
    low = std::min(low, m.feedPerTooth);
    high = std::max(high, m.feedPerTooth);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool finite = std::isfinite(m.mean[axis]) && std::isfinite(m.standardError[axis]);
      if (!finite || m.standardError[axis] < 0.0) return bad(message("a mean force is not finite"));
    }
  }
  if (test.means.size() < 2 || high < 1.02 * low) {
    return bad(message("needs mean forces at two different feeds or more"),
               message("edge and chip forces cannot be separated otherwise"));
  }
  if (test.axes.signs) {
    for (const int sign : *test.axes.signs) {
      if (sign != 1 && sign != -1) return bad(message("a sign of a force axis is neither 1 nor -1"));
    }
  }
  return Done{};
}

// Signs under which all three cutting coefficients are positive; a sensor turned as a whole (all alike in the plane)
// is likelier than one turned axis.
std::optional<std::array<int, 3>> findSigns(const Lines& lines, const ForceTest& test) {
  const int up = lines.up.slope < 0.0 ? -1 : 1;
  static constexpr std::array<std::array<int, 2>, 4> kPlane = {{{-1, -1}, {1, 1}, {1, -1}, {-1, 1}}};
  for (const auto& [along, across] : kPlane) {
    const std::array<int, 3> signs{along, across, up};
    const CuttingCoefficients k = solve(signedLines(lines, signs), test);
    if (k.tangential.value > 0.0 && k.radial.value > 0.0) return signs;
  }
  return std::nullopt;
}

double misfitOf(const Lines& lines, const std::vector<MeanForce>& means) {
  double total = 0.0;
  for (const MeanForce& m : means) {
    for (const double f : m.mean) total += f * f;
  }
  const double residual = lines.along.residual + lines.across.residual + lines.up.residual;
  return total > 0.0 ? std::sqrt(residual / total) : 0.0;
}

void remarkOn(CuttingCoefficients& k, const ForceTest& test) {
  if (k.radial.value > k.tangential.value) {
    k.remarks.emplace_back("K_r exceeds K_t: the dynamometer's axes along and across the feed may be swapped");
  }
  if (k.tangentialEdge.value < 0.0 || k.radialEdge.value < 0.0) {
    k.remarks.emplace_back("an edge coefficient is negative: a drifting zero, or a force not linear in the feed");
  }
  if (k.feeds == 2) k.remarks.emplace_back("two feeds only: whether the force is linear in the feed was not tested");
  const Coefficient& t = k.tangential;
  if (t.deviation > 0.2 * t.value) k.remarks.emplace_back("K_t is uncertain by more than a fifth");
  if (!test.axes.signs) k.remarks.emplace_back("signs of the force axes found from the coefficients being positive");
}

}  // namespace

milling::Material CuttingCoefficients::material() const {
  milling::Material m;
  m.tangential = tangential.value;
  m.radial = radial.value;
  m.tangentialEdge = tangentialEdge.value;
  m.radialEdge = radialEdge.value;
  m.exponent = 1.0;
  // As bands take it: of K_t and K_r together, so that of the larger one.
  constexpr double kMost = 0.5;
  if (tangential.value > 0.0) m.spread = std::min(kMost, tangential.deviation / tangential.value);
  return m;
}

Result<CuttingCoefficients> identifyCoefficients(const ForceTest& test) {
  Status sane = check(test);
  if (!sane) return sane.error();
  const bool feedX = test.axes.feed == FeedAxis::X;
  const Lines lines{fitLine(test.means, feedX ? 0 : 1), fitLine(test.means, feedX ? 1 : 0), fitLine(test.means, 2)};
  const auto signs = test.axes.signs ? test.axes.signs : findSigns(lines, test);
  if (!signs) {
    return Error{test.source, message("no orientation of the force axes gives positive cutting coefficients"),
                 message("check the engagement and which axis lies along the feed")};
  }
  CuttingCoefficients k = solve(signedLines(lines, *signs), test);
  if (k.tangential.value <= 0.0) {
    return Error{test.source, message("K_t comes out negative"), message("the signs of the force axes are wrong")};
  }
  k.signs = *signs;
  std::vector<double> feeds;
  for (const MeanForce& m : test.means) feeds.push_back(m.feedPerTooth);
  std::sort(feeds.begin(), feeds.end());
  const auto same = [](double a, double b) { return b < 1.02 * a; };
  k.feeds = static_cast<int>(std::unique(feeds.begin(), feeds.end(), same) - feeds.begin());
  k.misfit = misfitOf(lines, test.means);
  remarkOn(k, test);
  return k;
}

}  // namespace stillcut::identify
