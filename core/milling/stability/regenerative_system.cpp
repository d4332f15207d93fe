#include "core/milling/stability/regenerative_system.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::milling {

namespace {

constexpr double kSameAngle = 1e-12;  // events closer than this are one event [rad]

Planar combine(const Planar& steady, const Planar& cosine, const Planar& sine, double one, double c, double s) {
  Planar h{};
  for (std::size_t i = 0; i < h.size(); ++i) h[i] = one * steady[i] + c * cosine[i] + s * sine[i];
  return h;
}

// Adds one tooth that runs `lead` ahead of the reference tooth.
void addTooth(ForceInterval& arc, double kt, double kr, double lead) {
  const Planar steady{kr / 2, kt / 2, -kt / 2, kr / 2};
  const Planar cosine{-kr / 2, kt / 2, kt / 2, kr / 2};
  const Planar sine{kt / 2, kr / 2, kr / 2, -kt / 2};
  const double c = std::cos(2 * lead);
  const double s = std::sin(2 * lead);
  for (std::size_t i = 0; i < steady.size(); ++i) {
    arc.steady[i] += steady[i];
    arc.cosine[i] += cosine[i] * c + sine[i] * s;
    arc.sine[i] += sine[i] * c - cosine[i] * s;
  }
}

std::vector<ForceInterval> makeArcs(const CutModel& model, double toothAngle) {
  const double enter = model.engagement.startAngle();
  const double leave = model.engagement.exitAngle();
  std::vector<double> events{0.0, toothAngle};
  for (double e : {enter, leave}) events.push_back(e - toothAngle * std::floor(e / toothAngle));
  std::sort(events.begin(), events.end());
  std::vector<ForceInterval> intervals;
  for (std::size_t i = 1; i < events.size(); ++i) {
    if (events[i] - events[i - 1] < kSameAngle) continue;
    ForceInterval arc;
    arc.from = intervals.empty() ? 0.0 : intervals.back().to;
    arc.to = events[i];
    const double middle = 0.5 * (arc.from + arc.to);
    for (int j = 0; j < model.tool.teeth; ++j) {
      const double angle = middle + j * toothAngle;
      if (angle <= enter || angle >= leave) continue;
      addTooth(arc, model.material.tangential, model.material.radial, j * toothAngle);
      arc.cutting = true;
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
  for (auto& arc : system.intervals) {
    for (Planar* m : {&arc.steady, &arc.cosine, &arc.sine}) {
      const Planar p = *m;
      *m = {e[0] * (p[0] * e[0] + p[1] * e[1]) + e[1] * (p[2] * e[0] + p[3] * e[1]), 0.0, 0.0, 0.0};
    }
  }
}

}  // namespace

Planar ForceInterval::at(double angle) const {
  return combine(steady, cosine, sine, 1.0, std::cos(2 * angle), std::sin(2 * angle));
}

Planar ForceInterval::integral(double a, double b) const {
  return combine(steady, cosine, sine, b - a, 0.5 * (std::sin(2 * b) - std::sin(2 * a)),
                 0.5 * (std::cos(2 * a) - std::cos(2 * b)));
}

double RegenerativeSystem::highestOmega() const {
  double highest = 0.0;
  for (const auto& o : oscillators) highest = std::max(highest, o.omega);
  return highest;
}

double RegenerativeSystem::stiffening() const {
  double force = 0.0;
  for (const auto& arc : intervals) {
    for (std::size_t i = 0; i < arc.steady.size(); ++i) {
      force = std::max(force, std::abs(arc.steady[i]) + std::hypot(arc.cosine[i], arc.sine[i]));
    }
  }
  double mobility = 0.0;
  for (const auto& o : oscillators) {
    mobility = std::max(mobility, (o.toTip[0] * o.toTip[0] + o.toTip[1] * o.toTip[1]) / o.mass);
  }
  return force * mobility;
}

Planar RegenerativeSystem::mean(double a, double b) const {
  Planar sum{};
  for (const auto& arc : intervals) {
    const double from = std::max(a, arc.from);
    const double to = std::min(b, arc.to);
    if (!arc.cutting || to <= from) continue;
    const Planar part = arc.integral(from, to);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i] / (b - a);
  }
  return sum;
}

Result<RegenerativeSystem> makeRegenerativeSystem(const CutModel& model, const std::string& where) {
  if (Status ok = check(model, where); !ok) return ok.error();
  const double toothAngle = kTwoPi / model.tool.teeth;
  for (double p : model.tool.pitch) {
    if (std::abs(p - toothAngle) > 1e-9) {
      return Error{where + ": tool", message("stability lobes need a regular pitch"),
                   message("simulate a variable pitch instead")};
    }
  }
  if (model.material.exponent != 1.0) {
    return Error{where + ": material", message("stability lobes need a force exponent of 1"),
                 message("linearise the force at the mean chip thickness first")};
  }
  RegenerativeSystem system;
  system.teeth = model.tool.teeth;
  system.toothAngle = toothAngle;
  for (const Mode& m : model.modes) {
    system.oscillators.push_back({kTwoPi * m.frequency.value, m.damping, m.mass(), m.direction});
  }
  system.intervals = makeArcs(model, toothAngle);
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

std::vector<Message> neglectedEffects(const CutModel& model) {
  std::vector<Message> list;
  if (model.tool.helix != 0.0) list.push_back(message("helix angle (straight teeth assumed)"));
  if (model.material.processDamping != 0.0)
    list.push_back(message("process damping (limits at low speed are too low)"));
  return list;
}

}  // namespace stillcut::milling
