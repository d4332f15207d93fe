#include "core/milling/stability/zeroth_order.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace stillcut::milling {

namespace {

using Complex = std::complex<double>;

using Receptance = std::array<Complex, 4>;  // xx, xy, yx, yy

Receptance ofModes(const RegenerativeSystem& system, double omega) {
  Receptance g{};
  for (const auto& o : system.oscillators) {
    const Complex r = 1.0 / (o.mass * Complex(o.omega * o.omega - omega * omega, 2.0 * o.zeta * o.omega * omega));
    g[0] += r * (o.toTip[0] * o.toTip[0]);
    g[1] += r * (o.toTip[0] * o.toTip[1]);
    g[3] += r * (o.toTip[1] * o.toTip[1]);
  }
  g[2] = g[1];
  return g;
}

// Eigenvalues of H0 G(i omega) of the two (or one) axes; `branch` 0 or 1 by the sign of the root.
Complex orientedEigenvalue(const Receptance& g, const Planar& h, int axes, int branch) {
  if (axes == 1) return branch == 0 ? h[0] * g[0] : 0.0;
  const Complex a = h[0] * g[0] + h[1] * g[2];
  const Complex b = h[0] * g[1] + h[1] * g[3];
  const Complex c = h[2] * g[0] + h[3] * g[2];
  const Complex d = h[2] * g[1] + h[3] * g[3];
  const Complex half = 0.5 * (a + d);
  const Complex root = std::sqrt(half * half - (a * d - b * c));
  return branch == 0 ? half + root : half - root;
}

// Stand for what was measured where only the directions and the range of frequencies count.
std::vector<Mode> placeholders(Hertz highest) {
  return {{highest, 0.05, 1e7, {1.0, 0.0}}, {highest, 0.05, 1e7, {0.0, 1.0}}};
}

SpeedLimits stoppedAt(Rpm speed) {
  SpeedLimits nothing;
  nothing.speed = speed;
  return nothing;
}

}  // namespace

// A depth at which the mean cut is on the border at a frequency, were the speed right; `turn` is exp(i(omega tau +
// arg(1 - s/w))), 1 where the speed is right.
struct ZerothOrder::BorderPoint {
  double omega = 0.0;
  Complex eigenvalue;
  double depth = 0.0;
  Complex turn;
  bool onBorder = false;
};

Result<ZerothOrder> ZerothOrder::make(const CutModel& model, const std::string& where) {
  Result<ExactLobes> lobes = ExactLobes::make(model, where);
  if (!lobes) return lobes.error();
  if (isShaped(model.tool)) {
    return Error{where + ": tool", message("the zeroth order takes no corner radius and no serration"),
                 message("the exact method takes any")};
  }
  if (!lobes->pattern().alike) {
    return Error{where + ": tool", message("the zeroth order needs teeth of one pitch and one helix"),
                 message("the exact method takes any")};
  }
  return ZerothOrder(std::move(lobes.value()));
}

Result<ZerothOrder> ZerothOrder::make(CutModel model, MeasuredReceptance measured, const std::string& where) {
  if (Status ok = measured.check(where); !ok) return ok.error();
  model.modes = placeholders(measured.highest());
  Result<ZerothOrder> zoa = make(model, where);
  if (zoa) zoa->measured_ = std::move(measured);
  return zoa;
}

ZerothOrder::ZerothOrder(ExactLobes lobes) : lobes_(std::move(lobes)) {
  mean_ = lobes_.system().mean(0.0, lobes_.system().toothAngle);
  if (lobes_.model().turning) return;  // nothing is averaged
  const double share = cuttingFraction(lobes_.system());
  const long percent = std::lround(100.0 * share);
  warning_ = share < 0.75 ? message(
                                "zeroth order averages the force although a tooth cuts only %1 % of the time: limits "
                                "can be far too high, flip lobes and islands are missing; use the exact method",
                                percent)
                          : message(
                                "zeroth order averages the force (a tooth cuts %1 % of the time): expect errors of "
                                "tens of percent between the lobes; the exact method has none",
                                percent);
}

ZerothOrder::BorderPoint ZerothOrder::at(double omega, double period, int branch) const {
  BorderPoint p;
  p.omega = omega;
  const Receptance g = measured_ ? measured_->at(Hertz(omega / kTwoPi)) : ofModes(lobes_.system(), omega);
  p.eigenvalue = orientedEigenvalue(g, mean_, lobes_.system().axes, branch);
  if (p.eigenvalue == 0.0) return p;
  const Complex s = -1.0 / p.eigenvalue;
  if (!(s.real() > 0.0)) return p;
  p.depth = std::norm(s) / (2.0 * s.real());
  p.turn = std::polar(1.0, omega * period) * (1.0 - s / p.depth);
  p.onBorder = std::isfinite(p.depth);
  return p;
}

// Within the measured range: even steps that follow the delay's phase and the lines.
std::vector<double> ZerothOrder::measuredFrequencies(double period) const {
  constexpr double kMostLines = 2e5;
  const double from = kTwoPi * measured_->lowest().value, to = kTwoPi * measured_->highest().value;
  const double wanted =
      std::max({3000.0, (to - from) * period / 0.3, 4.0 * (to - from) / (kTwoPi * measured_->step().value)});
  const int steps = static_cast<int>(std::min(wanted, kMostLines));
  std::vector<double> list;
  for (int i = 0; i <= steps; ++i) list.push_back(from + (to - from) * i / steps);
  return list;
}

// Even steps that follow the delay's phase, and close ones around every resonance.
std::vector<double> ZerothOrder::frequencies(double period) const {
  if (measured_) return measuredFrequencies(period);
  const RegenerativeSystem& system = lobes_.system();
  const double highest = 2.5 * system.highestOmega();
  const int steps = std::max(3000, static_cast<int>(highest * period / 0.3));
  std::vector<double> list;
  for (int i = 1; i <= steps; ++i) list.push_back(highest * i / steps);
  for (const auto& o : system.oscillators) {
    for (int i = -150; i <= 150; ++i) {
      const double offset = o.zeta * std::sinh(6.0 * i / 150.0) / 4.0;
      if (offset > -1.0 && o.omega * (1.0 + offset) < highest) list.push_back(o.omega * (1.0 + offset));
    }
  }
  std::sort(list.begin(), list.end());
  return list;
}

Result<SpeedLimits> ZerothOrder::limit(Rpm speed, Metres maxAxialDepth, const std::stop_token& stop) const {
  WorkMeter meter(stop);
  return limit(speed, maxAxialDepth, meter);
}

Result<SpeedLimits> ZerothOrder::limit(Rpm speed, Metres maxAxialDepth, WorkMeter& meter) const {
  if (Status ok = lobes_.checkSpeed(speed); !ok) return ok.error();
  if (Status ok = ExactLobes::checkDepth(maxAxialDepth); !ok) return ok.error();
  const double period = lobes_.system().toothPeriod(speed);
  const double effort = 200.0 + 60.0 * static_cast<double>(lobes_.system().oscillators.size());
  SpeedLimits result;
  result.speed = speed;
  result.searchedTo = maxAxialDepth;
  double best = maxAxialDepth.value;
  double bestOmega = 0.0;
  const std::vector<double> omegas = frequencies(period);
  for (int branch = 0; branch < lobes_.system().axes; ++branch) {
    BorderPoint before;
    for (double omega : omegas) {
      if (!meter.proceed(effort)) return stoppedAt(speed);
      BorderPoint now = at(omega, period, branch);
      // The square root may change its sheet between two frequencies: follow the nearer eigenvalue.
      const bool swapped = lobes_.system().axes == 2 && before.onBorder &&
                           std::abs(at(omega, period, 1 - branch).eigenvalue - before.eigenvalue) <
                               std::abs(now.eigenvalue - before.eigenvalue);
      const bool turns = before.onBorder && now.onBorder && !swapped && before.turn.imag() * now.turn.imag() <= 0.0 &&
                         before.turn.real() > 0.0 && now.turn.real() > 0.0;
      if (turns && std::min(before.depth, now.depth) < 1.1 * best) {
        double low = before.omega;
        double high = omega;
        for (int i = 0; i < 50 && high - low > 1e-13 * high; ++i) {
          const double middle = 0.5 * (low + high);
          (at(middle, period, branch).turn.imag() * before.turn.imag() > 0.0 ? low : high) = middle;
        }
        const BorderPoint found = at(0.5 * (low + high), period, branch);
        if (found.onBorder && found.depth < best) {
          best = found.depth;
          bestOmega = found.omega;
        }
      }
      before = now;
    }
  }
  if (bestOmega > 0.0) {
    StabilityLimit limit;
    limit.speed = speed;
    limit.depth = Metres(best);
    limit.after = 2;
    limit.angle = Radians(std::abs(std::remainder(bestOmega * period, kTwoPi)));
    limit.frequency = Hertz(bestOmega / kTwoPi);
    result.crossings.push_back(limit);
  }
  return result;
}

}  // namespace stillcut::milling
