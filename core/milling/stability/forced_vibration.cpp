#include "core/milling/stability/forced_vibration.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "core/milling/stability/any_tool/tooth_pattern.h"

namespace stillcut::milling {

namespace {

using Complex = std::complex<double>;

constexpr double kReach = 12.0;  // lines up to so many frequencies of the highest mode
constexpr int kLeastLines = 24;
constexpr int kMostLines = 4000;
constexpr int kHeights = 32;

// Integral of exp(i p phi) over [a, b].
Complex turned(double p, double a, double b) {
  if (std::abs(p) < 1e-12) return b - a;
  return (std::polar(1.0, p * b) - std::polar(1.0, p * a)) / Complex(0.0, p);
}

// Mean of exp(-i x z/w) over the depth.
Complex meanOver(double x) {
  if (std::abs(x) < 1e-6) return {1.0 - x * x / 6.0, -0.5 * x};
  return (1.0 - std::polar(1.0, -x)) / Complex(0.0, x);
}

struct PlanarLine {
  Complex x, y;
};

// Line n of the force on the tool over a revolution, all teeth together, per depth [N/m]; n is a multiple of the teeth.
PlanarLine forceLine(const CutModel& model, int n, double feedPerTooth) {
  const double a = model.engagement.startAngle(), b = model.engagement.exitAngle();
  const Complex i(0.0, 1.0);
  const auto shifted = [&](double p) { return turned(p - n, a, b); };
  const Complex sine = (shifted(1) - shifted(-1)) / (2.0 * i), cosine = 0.5 * (shifted(1) + shifted(-1));
  const Complex sine2 = (shifted(2) - shifted(-2)) / (2.0 * i), cosine2 = 0.5 * (shifted(2) + shifted(-2));
  const Complex one = shifted(0);
  const Material& m = model.material;
  const Complex across = 0.5 * sine2, square = 0.5 * (one - cosine2);  // sin cos and sin^2
  const double per = model.tool.teeth / kTwoPi;
  return {-per * (feedPerTooth * (m.tangential * across + m.radial * square) + m.tangentialEdge * cosine +
                  m.radialEdge * sine),
          per * (feedPerTooth * (m.tangential * square - m.radial * across) + m.tangentialEdge * sine -
                 m.radialEdge * cosine)};
}

PlanarLine motionLine(const CutModel& model, const PlanarLine& force, double omega) {
  PlanarLine x{};
  for (const Mode& mode : model.modes) {
    const double own = kTwoPi * mode.frequency.value;
    const Complex receptance =
        1.0 / (mode.mass() * Complex(own * own - omega * omega, 2.0 * mode.damping * own * omega));
    const Complex q = receptance * (mode.direction[0] * force.x + mode.direction[1] * force.y);
    x.x += mode.direction[0] * q;
    x.y += mode.direction[1] * q;
  }
  return x;
}

// `outwards` is 1 where a deflection along +y cuts too much. Edges pass the wall the later the higher they are.
SurfaceError wall(const std::vector<Complex>& y, int teeth, double angle, double trailing, double outwards) {
  SurfaceError error{Metres(1e300), Metres(-1e300)};
  for (int h = 0; h <= kHeights; ++h) {
    const double turn = teeth * (angle + trailing * h / kHeights);
    double deflection = y[0].real();
    for (std::size_t k = 1; k < y.size(); ++k) {
      deflection += 2.0 * (y[k] * std::polar(1.0, turn * static_cast<double>(k))).real();
    }
    error.least = std::min(error.least, Metres(-outwards * deflection));
    error.greatest = std::max(error.greatest, Metres(-outwards * deflection));
  }
  return error;
}

}  // namespace

std::optional<ForcedVibration> forcedVibration(const CutModel& model, Rpm speed, Metres depth, Metres feedPerTooth) {
  if (changesWithSpeed(model)) return forcedVibration(modelAt(model, speed), speed, depth, feedPerTooth);
  const ToothPattern pattern = toothPattern(model.tool);
  const bool runs =
      std::all_of(model.tool.runout.begin(), model.tool.runout.end(), [](Metres r) { return r.value == 0.0; });
  if (!pattern.alike || !runs || model.turning || isShaped(model.tool)) return std::nullopt;
  const int teeth = model.tool.teeth;
  const double spindle = kTwoPi * toHertz(speed).value, trailing = pattern.trail.front() * depth.value;
  double highest = 0.0;
  for (const Mode& m : model.modes) highest = std::max(highest, kTwoPi * m.frequency.value);
  const int lines = std::clamp(static_cast<int>(kReach * highest / (teeth * spindle)), kLeastLines, kMostLines);
  ForcedVibration result;
  std::vector<Complex> y;
  double acceleration = 0.0, displacement = 0.0;
  for (int k = 0; k <= lines; ++k) {
    PlanarLine force = forceLine(model, k * teeth, feedPerTooth.value);
    const Complex along = depth.value * meanOver(k * teeth * trailing);
    force = {along * force.x, along * force.y};
    const double omega = k * teeth * spindle;
    const PlanarLine x = motionLine(model, force, omega);
    y.push_back(x.y);
    const double power = k == 0 ? 0.0 : 2.0 * (std::norm(x.x) + std::norm(x.y));
    displacement += power;
    acceleration += power * std::pow(omega, 4);
  }
  result.acceleration = std::sqrt(acceleration);
  result.displacement = std::sqrt(displacement);
  if (model.engagement.startAngle() < 1e-9) result.upWall = wall(y, teeth, 0.0, trailing, 1.0);
  if (model.engagement.exitAngle() > std::numbers::pi - 1e-9) {
    result.downWall = wall(y, teeth, std::numbers::pi, trailing, -1.0);
  }
  return result;
}

}  // namespace stillcut::milling
