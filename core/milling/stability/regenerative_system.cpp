#include "core/milling/stability/regenerative_system.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::milling {

namespace {

constexpr double kSameAngle = 1e-12;   // events closer than this are one event [rad]
constexpr double kStraightLag = 1e-7;  // below it the mean over the lag loses more digits than it gains [rad]

// a + b phi + c cos(2 phi) + d sin(2 phi), which is what H of one tooth and its integral are made of.
struct Trigonometric {
  double one = 0.0, slope = 0.0, cosine = 0.0, sine = 0.0;
};

Planar combine(const ForceInterval& arc, const Trigonometric& t) {
  Planar h{};
  for (std::size_t i = 0; i < h.size(); ++i) {
    h[i] = t.one * arc.steady[i] + t.slope * arc.slope[i] + t.cosine * arc.cosine[i] + t.sine * arc.sine[i];
  }
  return h;
}

// H of a tooth at phi.
ForceInterval toothForce(double kt, double kr) {
  ForceInterval h;
  h.steady = {kr / 2, kt / 2, -kt / 2, kr / 2};
  h.cosine = {-kr / 2, kt / 2, kt / 2, kr / 2};
  h.sine = {kt / 2, kr / 2, kr / 2, -kt / 2};
  return h;
}

// Adds one tooth that runs `lead` ahead of the reference tooth.
void addTooth(ForceInterval& arc, const ForceInterval& tooth, double lead) {
  const double c = std::cos(2 * lead);
  const double s = std::sin(2 * lead);
  for (std::size_t i = 0; i < tooth.steady.size(); ++i) {
    arc.steady[i] += tooth.steady[i];
    arc.cosine[i] += tooth.cosine[i] * c + tooth.sine[i] * s;
    arc.sine[i] += tooth.sine[i] * c - tooth.cosine[i] * s;
  }
}

// Adds `sign` times the integral of a tooth's H up to its angle less `behind`, which moves with the reference tooth.
void addMoving(ForceInterval& arc, const ForceInterval& tooth, double lead, double behind, double sign) {
  const double shift = lead - behind;
  const double c = std::cos(2 * shift);
  const double s = std::sin(2 * shift);
  for (std::size_t i = 0; i < tooth.steady.size(); ++i) {
    arc.slope[i] += sign * tooth.steady[i];
    arc.steady[i] += sign * tooth.steady[i] * shift;
    arc.sine[i] += 0.5 * sign * (tooth.cosine[i] * c + tooth.sine[i] * s);
    arc.cosine[i] += 0.5 * sign * (tooth.cosine[i] * s - tooth.sine[i] * c);
  }
}

// The same up to an edge of the cut, which stands.
void addStanding(ForceInterval& arc, const ForceInterval& tooth, double edge, double sign) {
  const Trigonometric t{edge, 0.0, 0.5 * std::sin(2 * edge), -0.5 * std::cos(2 * edge)};
  const Planar h = combine(tooth, t);
  for (std::size_t i = 0; i < h.size(); ++i) arc.steady[i] += sign * h[i];
}

struct Window {
  double enter, leave;  // [rad]
  double lag;           // of the top of the edge behind its tip [rad]; may be below zero
};

// Mean over the lag of a tooth that stands at `middle` + lead, over the part of its edge in the window.
void addHelix(ForceInterval& arc, const ForceInterval& tooth, const Window& w, double middle, double lead) {
  const double front = w.lag > 0.0 ? 0.0 : w.lag;  // of the edge's leading end behind the tip
  const double back = w.lag > 0.0 ? w.lag : 0.0;
  const double per = 1.0 / (back - front);
  const double first = middle + lead - back;
  const double last = middle + lead - front;
  if (last <= w.enter || first >= w.leave) return;
  if (last < w.leave) {
    addMoving(arc, tooth, lead, front, per);
  } else {
    addStanding(arc, tooth, w.leave, per);
  }
  if (first > w.enter) {
    addMoving(arc, tooth, lead, back, -per);
  } else {
    addStanding(arc, tooth, w.enter, -per);
  }
  arc.cutting = true;
}

std::vector<double> eventsOf(const Window& w, double toothAngle) {
  std::vector<double> events{0.0, toothAngle};
  for (double e : {w.enter, w.leave, w.enter + w.lag, w.leave + w.lag}) {
    events.push_back(e - toothAngle * std::floor(e / toothAngle));
  }
  std::sort(events.begin(), events.end());
  return events;
}

std::vector<ForceInterval> makeArcs(const Window& w, const ForceInterval& tooth, double toothAngle) {
  const std::vector<double> events = eventsOf(w, toothAngle);
  const bool straight = std::abs(w.lag) < kStraightLag;
  const int from = static_cast<int>(std::floor(std::min(0.0, w.lag) / toothAngle)) - 1;
  const int to = static_cast<int>(std::ceil((kTwoPi + std::max(0.0, w.lag)) / toothAngle)) + 1;
  std::vector<ForceInterval> intervals;
  for (std::size_t i = 1; i < events.size(); ++i) {
    if (events[i] - events[i - 1] < kSameAngle) continue;
    ForceInterval arc;
    arc.from = intervals.empty() ? 0.0 : intervals.back().to;
    arc.to = events[i];
    const double middle = 0.5 * (arc.from + arc.to);
    for (int j = from; j < to; ++j) {
      if (!straight) {
        addHelix(arc, tooth, w, middle, j * toothAngle);
      } else if (const double angle = middle + j * toothAngle; angle > w.enter && angle < w.leave) {
        addTooth(arc, tooth, j * toothAngle);
        arc.cutting = true;
      }
    }
    intervals.push_back(arc);
  }
  intervals.back().to = toothAngle;
  return intervals;
}

void projectOnOneAxis(RegenerativeSystem& system) {
  const std::array<double, 2> first = system.oscillators.front().toTip;
  const double size = std::hypot(first[0], first[1]);
  const std::array<double, 2> e{first[0] / size, first[1] / size};
  for (const auto& o : system.oscillators) {
    if (std::abs(o.toTip[0] * e[1] - o.toTip[1] * e[0]) > 1e-12 * std::hypot(o.toTip[0], o.toTip[1])) return;
  }
  system.axes = 1;
  system.direction = e;
  for (auto& o : system.oscillators) o.toTip = {o.toTip[0] * e[0] + o.toTip[1] * e[1], 0.0};
  for (auto* arcs : {&system.intervals, &system.damping}) {
    for (ForceInterval& arc : *arcs) {
      for (Planar* m : {&arc.steady, &arc.slope, &arc.cosine, &arc.sine}) {
        const Planar p = *m;
        *m = {e[0] * (p[0] * e[0] + p[1] * e[1]) + e[1] * (p[2] * e[0] + p[3] * e[1]), 0.0, 0.0, 0.0};
      }
    }
  }
}

}  // namespace

Planar ForceInterval::at(double angle) const {
  return combine(*this, {1.0, angle, std::cos(2 * angle), std::sin(2 * angle)});
}

Planar ForceInterval::integral(double a, double b) const {
  return combine(*this, {b - a, 0.5 * (b * b - a * a), 0.5 * (std::sin(2 * b) - std::sin(2 * a)),
                         0.5 * (std::cos(2 * a) - std::cos(2 * b))});
}

double RegenerativeSystem::highestOmega() const {
  double highest = 0.0;
  for (const auto& o : oscillators) highest = std::max(highest, o.omega);
  return highest;
}

namespace {

// Largest entry of H over an arc, or somewhat more. With a lag its parts are large and all but cancel.
double largestForce(const ForceInterval& arc) {
  double force = 0.0;
  if (arc.slope == Planar{}) {
    for (std::size_t i = 0; i < arc.steady.size(); ++i) {
      force = std::max(force, std::abs(arc.steady[i]) + std::hypot(arc.cosine[i], arc.sine[i]));
    }
    return force;
  }
  constexpr int kLooks = 8;
  for (int k = 0; k <= kLooks; ++k) {
    for (double h : arc.at(arc.from + (arc.to - arc.from) * k / kLooks)) force = std::max(force, 1.2 * std::abs(h));
  }
  return force;
}

}  // namespace

double RegenerativeSystem::stiffening() const {
  double force = 0.0;
  for (const auto& arc : intervals) force = std::max(force, largestForce(arc));
  double mobility = 0.0;
  for (const auto& o : oscillators) {
    mobility = std::max(mobility, (o.toTip[0] * o.toTip[0] + o.toTip[1] * o.toTip[1]) / o.mass);
  }
  return force * mobility;
}

namespace {

Planar meanOf(const std::vector<ForceInterval>& arcs, double a, double b) {
  Planar sum{};
  for (const auto& arc : arcs) {
    const double from = std::max(a, arc.from);
    const double to = std::min(b, arc.to);
    if (!arc.cutting || to <= from) continue;
    const Planar part = arc.integral(from, to);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i] / (b - a);
  }
  return sum;
}

}  // namespace

Planar RegenerativeSystem::mean(double a, double b) const {
  return meanOf(intervals, a, b);
}

Planar RegenerativeSystem::meanDamping(double a, double b) const {
  return meanOf(damping, a, b);
}

Result<RegenerativeSystem> makeRegenerativeSystem(const CutModel& model, const std::string& where, Metres depth) {
  if (Status ok = check(model, where); !ok) return ok.error();
  if (model.material.exponent != 1.0) {
    return Error{where + ": material", message("stability lobes need a force exponent of 1"),
                 message("linearise the force at the mean chip thickness first")};
  }
  return systemAt(model, depth);
}

namespace {

// Of edges that stand: all of them cut all the time, as a tooth at 90 degrees.
std::vector<ForceInterval> standingArc(const ForceInterval& tooth, int edges, double toothAngle) {
  ForceInterval arc;
  arc.to = toothAngle;
  arc.cutting = true;
  const Planar one = combine(tooth, {1.0, 0.0, -1.0, 0.0});
  for (std::size_t i = 0; i < one.size(); ++i) arc.steady[i] = edges * one[i];
  return {arc};
}

}  // namespace

RegenerativeSystem systemAt(const CutModel& cut, Metres depth) {
  const CutModel model = standingTooth(cut);
  RegenerativeSystem system;
  system.teeth = model.tool.teeth;
  system.toothAngle = kTwoPi / model.tool.teeth;
  system.depth = depth.value;
  for (const Mode& m : model.modes) {
    if (takesPart(m)) system.oscillators.push_back({kTwoPi * m.frequency.value, m.damping, m.mass(), m.direction});
  }
  const double radius = 0.5 * model.tool.diameter.value;
  const Window window{model.engagement.startAngle(), model.engagement.exitAngle(),
                      depth.value * std::tan(helixOf(model.tool, 0)) / radius};
  const auto arcs = [&](const ForceInterval& tooth) {
    return model.turning ? standingArc(tooth, system.teeth, system.toothAngle)
                         : makeArcs(window, tooth, system.toothAngle);
  };
  system.intervals = arcs(toothForce(model.material.tangential, model.material.radial));
  if (model.material.processDamping > 0.0) {
    system.damping = arcs(toothForce(0.0, model.material.processDamping / radius));
  }
  projectOnOneAxis(system);
  return system;
}

double cuttingFraction(const RegenerativeSystem& system) {
  double cutting = 0.0;
  for (const ForceInterval& arc : system.intervals) {
    if (arc.cutting) cutting += arc.to - arc.from;
  }
  return cutting / system.toothAngle;
}

}  // namespace stillcut::milling
