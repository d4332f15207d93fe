#include "core/milling/stability/any_tool/edge_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/milling/stability/any_tool/gauss_points.h"

namespace stillcut::milling {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kPerWave = 40;  // heights to a wave of the serration

struct Height {
  double z = 0.0, weight = 0.0;  // weight [m]
  double radius = 0.0, sineKappa = 1.0, cosineKappa = 0.0;
};

struct Window {
  double from, to;  // [rad]
};

// Of the work's edges at a smaller radius. `low` and `high` are their distances from the axis along y.
Window windowAt(double radius, double low, double high) {
  return {std::acos(std::clamp(high / radius, -1.0, 1.0)), std::acos(std::clamp(low / radius, -1.0, 1.0))};
}

class Heights {
 public:
  Heights(const CutModel& model, const ToothPattern& pattern, double depth, int turns)
      : radius_(0.5 * model.tool.diameter.value), corner_(model.tool.cornerRadius.value), depth_(depth) {
    low_ = radius_ * std::cos(model.engagement.exitAngle());
    high_ = radius_ * std::cos(model.engagement.startAngle());
    double steepest = 0.0;
    for (double trail : pattern.trail) steepest = std::max(steepest, std::abs(trail));
    perLength_ = 0.55 * turns * steepest;
    wave_ = model.tool.serration ? model.tool.serration->length.value : 0.0;
  }

  std::vector<Height> list() const {
    std::vector<Height> heights;
    const double round = std::min(depth_, corner_);
    if (round > 0.0) addCorner(heights, std::acos(std::max(-1.0, 1.0 - round / corner_)));
    if (depth_ > round) addStraight(heights, round);
    return heights;
  }

  double low() const { return low_; }
  double high() const { return high_; }

 private:
  int points(double length, int least) const {
    const int waves = wave_ > 0.0 ? static_cast<int>(kPerWave * length / wave_) : 0;
    return std::min(400, least + std::max(waves, static_cast<int>(perLength_ * length)));
  }

  // Between the heights at which an edge of the work begins or ends to be reached; there angles go as a square root,
  // which the cubic map of the points makes smooth.
  void addCorner(std::vector<Height>& heights, double last) const {
    std::vector<double> bounds{0.0, last};
    for (double edge : {low_, high_}) {
      const double sine = (std::abs(edge) - (radius_ - corner_)) / corner_;
      if (sine > 0.0 && sine < 1.0 && std::asin(sine) < last) bounds.push_back(std::asin(sine));
    }
    std::sort(bounds.begin(), bounds.end());
    for (std::size_t i = 1; i < bounds.size(); ++i) {
      const double span = bounds[i] - bounds[i - 1];
      if (span < 1e-12) continue;
      for (const GaussPoint& p : gaussPoints(points(corner_ * span, 10))) {
        const double kappa = bounds[i - 1] + span * p.at * p.at * (3.0 - 2.0 * p.at);
        const double step = span * 6.0 * p.at * (1.0 - p.at) * p.weight;
        Height h;
        h.sineKappa = std::sin(kappa);
        h.cosineKappa = std::cos(kappa);
        h.z = corner_ * (1.0 - h.cosineKappa);
        h.radius = radius_ - corner_ + corner_ * h.sineKappa;
        h.weight = corner_ * h.sineKappa * step;
        heights.push_back(h);
      }
    }
  }

  void addStraight(std::vector<Height>& heights, double from) const {
    const double length = depth_ - from;
    const bool even = wave_ > 0.0;  // kinks anywhere
    const int n = points(length, 8);
    std::vector<GaussPoint> along = even ? std::vector<GaussPoint>{} : gaussPoints(n);
    for (int i = 0; even && i < n; ++i) along.push_back({(i + 0.5) / n, 1.0 / n});
    for (const GaussPoint& p : along) heights.push_back({from + length * p.at, length * p.weight, radius_, 1.0, 0.0});
  }

  double radius_, corner_, depth_;
  double low_ = 0.0, high_ = 0.0, perLength_ = 0.0, wave_ = 0.0;
};

// How far out tooth j stands at a height [m].
double reachOf(const Serration& s, int tooth, int teeth, double z) {
  const double phase = s.phase.empty() ? kTwoPi * tooth / teeth : s.phase[static_cast<std::size_t>(tooth)];
  return s.amplitude.value * std::sin(kTwoPi * z / s.length.value - phase);
}

// The chip over sin(phi), as a line: what the tooth k places ahead left.
struct Meeting {
  double slope, at0, delay;
  double chip(double sine) const { return slope * sine + at0; }
};

std::vector<Meeting> meetings(const CutModel& model, const ToothPattern& pattern, int tooth, const Height& h) {
  const Serration& s = *model.tool.serration;
  const int teeth = pattern.teeth();
  const double perRadian = s.feedPerTooth.value * teeth / kTwoPi * h.sineKappa;
  const double own = reachOf(s, tooth, teeth, h.z);
  std::vector<Meeting> list;
  double delay = 0.0;
  for (int k = 1; k <= teeth; ++k) {
    delay += pattern.delayAngle((tooth + k - 1) % teeth, h.z);
    list.push_back({perRadian * delay, own - reachOf(s, (tooth + k) % teeth, teeth, h.z), delay});
  }
  return list;
}

// Splits a window where another tooth becomes the last to have cut there.
void addSerrated(std::vector<EdgePiece>& pieces, EdgePiece piece, const std::vector<Meeting>& list) {
  std::vector<double> bounds{piece.from, piece.to};
  const auto bound = [&](double sine) {
    if (!(sine > 0.0) || !(sine < 1.0)) return;
    for (double angle : {std::asin(sine), kPi - std::asin(sine)}) {
      if (angle > piece.from && angle < piece.to) bounds.push_back(angle);
    }
  };
  for (std::size_t a = 0; a < list.size(); ++a) {
    bound(-list[a].at0 / list[a].slope);
    for (std::size_t b = a + 1; b < list.size(); ++b) {
      bound((list[a].at0 - list[b].at0) / (list[b].slope - list[a].slope));
    }
  }
  std::sort(bounds.begin(), bounds.end());
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    if (bounds[i] - bounds[i - 1] < 1e-12) continue;
    const double sine = std::sin(0.5 * (bounds[i] + bounds[i - 1]));
    const auto least = std::min_element(
        list.begin(), list.end(), [&](const Meeting& a, const Meeting& b) { return a.chip(sine) < b.chip(sine); });
    if (!(least->chip(sine) > 0.0)) continue;
    piece.from = bounds[i - 1];
    piece.to = bounds[i];
    piece.delay = least->delay;
    pieces.push_back(piece);
  }
}

}  // namespace

std::vector<EdgePiece> edgePieces(const CutModel& model, const ToothPattern& pattern, double depth, int turns) {
  const Heights heights(model, pattern, depth, turns);
  // Serrated teeth stand differently each, unless told otherwise.
  const int teeth = model.tool.serration ? pattern.teeth() : pattern.teeth() / pattern.repeats;
  std::vector<EdgePiece> pieces;
  for (const Height& h : heights.list()) {
    const Window window = windowAt(h.radius, heights.low(), heights.high());
    if (!(window.to > window.from)) continue;
    for (int j = 0; j < teeth; ++j) {
      const auto tooth = static_cast<std::size_t>(j);
      EdgePiece piece;
      piece.share = h.weight / depth;
      piece.from = window.from;
      piece.to = window.to;
      piece.lead = pattern.angle[tooth] - pattern.trail[tooth] * h.z;
      piece.delay = pattern.delayAngle(j, h.z);
      piece.sineKappa = h.sineKappa;
      piece.cosineKappa = h.cosineKappa;
      if (model.tool.serration) {
        addSerrated(pieces, piece, meetings(model, pattern, j, h));
      } else {
        pieces.push_back(piece);
      }
    }
  }
  return pieces;
}

}  // namespace stillcut::milling
