#include "core/milling/stability/any_tool/unlike_teeth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/milling/stability/any_tool/gauss_points.h"

namespace stillcut::milling {

namespace {

using Complex = std::complex<double>;

// Integral of exp(i p phi) over [a, b].
Complex turned(int p, double a, double b) {
  if (p == 0) return b - a;
  return (std::polar(1.0, p * b) - std::polar(1.0, p * a)) / Complex(0.0, p);
}

// The n-th harmonic of a tooth's directional matrix over a revolution.
std::array<Complex, 4> harmonic(int n, double kt, double kr, double start, double exit) {
  const Complex one = turned(-n, start, exit);
  const Complex up = turned(2 - n, start, exit);
  const Complex down = turned(-2 - n, start, exit);
  const Complex c = 0.5 * (up + down);
  const Complex s = (up - down) / Complex(0.0, 2.0);
  const double per = 0.5 / kTwoPi;
  return {per * kr * (one - c) + per * kt * s, per * kt * (one + c) + per * kr * s,
          -per * kt * (one - c) + per * kr * s, per * kr * (one + c) - per * kt * s};
}

// Of both axes, or projected on the one.
void keep(const std::array<Complex, 4>& h, const RegenerativeSystem& system, std::vector<Planar>& re,
          std::vector<Planar>& im) {
  std::array<Complex, 4> kept = h;
  if (system.axes == 1) {
    const auto& e = system.direction;
    kept = {e[0] * (h[0] * e[0] + h[1] * e[1]) + e[1] * (h[2] * e[0] + h[3] * e[1]), 0.0, 0.0, 0.0};
  }
  Planar a{}, b{};
  for (std::size_t i = 0; i < 4; ++i) {
    a[i] = kept[i].real();
    b[i] = kept[i].imag();
  }
  re.push_back(a);
  im.push_back(b);
}

// Mean of exp(-i x z/w) over the depth.
Complex meanOver(double x) {
  if (std::abs(x) < 1e-6) return {1.0 - x * x / 6.0, -0.5 * x};
  return (1.0 - std::polar(1.0, -x)) / Complex(0.0, x);
}

bool isStraight(const CutModel& model, const ToothPattern& pattern) {
  return pattern.straight && model.material.processDamping == 0.0 && !model.turning;
}

ToothCut cutOf(const CutModel& model) {
  return {model.engagement.startAngle(), model.engagement.exitAngle(), model.material.tangential,
          model.material.radial};
}

}  // namespace

UnlikeTeeth::UnlikeTeeth(const CutModel& model, const ToothPattern& pattern, Rpm speed)
    : pattern_(pattern),
      speed_(kTwoPi * toHertz(speed).value),
      period_(kTwoPi / (speed_ * pattern.repeats)),
      start_(model.engagement.startAngle()),
      exit_(model.engagement.exitAngle()),
      tangential_(model.material.tangential),
      radial_(model.material.radial),
      damping_(model.material.processDamping / (0.5 * model.tool.diameter.value)),
      straight_(systemAt(model, Metres(0.0))),
      lines_(straight_.oscillators, period_) {
  if (!isStraight(model, pattern_)) return;
  rough_.emplace(straight_, pattern_, cutOf(model), speed_, Fineness::Rough);
  fine_.emplace(straight_, pattern_, cutOf(model), speed_, Fineness::Fine);
}

UnlikeTeeth::Sums UnlikeTeeth::sumsAt(double depth, int most) const {
  Sums sums;
  sums.most = most;
  const int teeth = pattern_.teeth(), r = pattern_.repeats;
  std::vector<GaussPoint> heights{{0.0, 1.0}};
  if (!pattern_.parallel) {
    const auto [low, high] = std::minmax_element(pattern_.trail.begin(), pattern_.trail.end());
    const double turns = most * r * depth * std::max(std::abs(*low), std::abs(*high));
    heights = gaussPoints(std::min(200, 8 + static_cast<int>(0.55 * turns)));
  }
  for (int j = 0; j < teeth; ++j) {
    for (const GaussPoint& p : heights) sums.delays.push_back(pattern_.delayAngle(j, p.at * depth) / speed_);
  }
  for (int m = -most; m <= most; ++m) {
    const int n = m * r;
    const Complex trailing = pattern_.parallel ? meanOver(n * pattern_.trail.front() * depth) : Complex(1.0);
    for (int j = 0; j < teeth; ++j) {
      for (const GaussPoint& p : heights) {
        const auto k = static_cast<std::size_t>(j);
        const double behind = pattern_.parallel ? 0.0 : pattern_.trail[k] * p.at * depth;
        sums.phases.push_back(p.weight * trailing * std::polar(1.0, n * (pattern_.angle[k] - behind)));
      }
    }
    keep(harmonic(n, tangential_, radial_, start_, exit_), straight_, sums.re, sums.im);
    if (damping_ > 0.0) keep(harmonic(n, 0.0, damping_ / speed_, start_, exit_), straight_, sums.dre, sums.dim);
  }
  return sums;
}

Eigen::MatrixXcd UnlikeTeeth::matrixAt(const std::vector<HarmonicLine>& lines, const Sums& sums, double depth) const {
  const auto count = lines.size(), per = sums.delays.size();
  const auto axes = static_cast<std::size_t>(straight_.axes);
  std::vector<Complex> kept(count * per);  // 1 - exp(-i omega tau)
  for (std::size_t l = 0; l < count; ++l) {
    for (std::size_t e = 0; e < per; ++e) {
      kept[l * per + e] = 1.0 - std::polar(1.0, -lines[l].omega * sums.delays[e]);
    }
  }
  Eigen::MatrixXcd matrix =
      Eigen::MatrixXcd::Identity(static_cast<Eigen::Index>(count * axes), static_cast<Eigen::Index>(count * axes));
  for (std::size_t k = 0; k < count; ++k) {
    std::array<Complex, 4> g{};
    const double w = lines[k].omega;
    for (const auto& o : straight_.oscillators) {
      const Complex receptance =
          lines[k].fade / (o.mass * Complex(o.omega * o.omega - w * w, 2.0 * o.zeta * o.omega * w));
      for (std::size_t i = 0; i < 4; ++i) g[i] += receptance * (o.toTip[i / 2] * o.toTip[i % 2]);
    }
    for (std::size_t l = 0; l < count; ++l) {
      const auto m = static_cast<std::size_t>(lines[k].number - lines[l].number + sums.most);
      const Complex* const phase = sums.phases.data() + m * per;
      Complex regenerated = 0.0, all = 0.0;
      for (std::size_t e = 0; e < per; ++e) regenerated += phase[e] * kept[l * per + e];
      const bool dragged = !sums.dre.empty();
      for (std::size_t e = 0; dragged && e < per; ++e) all += phase[e];
      std::array<Complex, 4> a{};
      for (std::size_t i = 0; i < 4; ++i) {
        a[i] = depth * Complex(sums.re[m][i], sums.im[m][i]) * regenerated;
        if (dragged) a[i] += depth * Complex(sums.dre[m][i], sums.dim[m][i]) * all * Complex(0.0, lines[l].omega);
      }
      for (std::size_t row = 0; row < axes; ++row) {
        for (std::size_t column = 0; column < axes; ++column) {
          const Complex sum = g[2 * row] * a[column] + g[2 * row + 1] * a[2 + column];
          matrix(static_cast<Eigen::Index>(k * axes + row), static_cast<Eigen::Index>(l * axes + column)) += sum;
        }
      }
    }
  }
  return matrix;
}

bool UnlikeTeeth::possible(const CutModel& model, const ToothPattern& pattern, Rpm speed) {
  constexpr double kMostUnknowns = 260.0;
  constexpr int kMostLines = 140;
  const RegenerativeSystem system = systemAt(model, Metres(0.0));
  const double turning = kTwoPi * toHertz(speed).value;
  if (isStraight(model, pattern))
    return StraightMonodromy::expectedSize(system, pattern, cutOf(model), turning) <= kMostUnknowns;
  return HarmonicLines(system.oscillators, kTwoPi / (turning * pattern.repeats)).count(Fineness::Rough) <= kMostLines;
}

bool UnlikeTeeth::sample(double depth, std::span<const double> angles, Fineness fineness, std::span<Complex> out,
                         WorkMeter& meter) const {
  if (rough_) return (fineness == Fineness::Rough ? *rough_ : *fine_).sample(depth, angles, out, meter);
  return sampleLines(depth, angles, fineness, out, meter);
}

bool UnlikeTeeth::sampleLines(double depth, std::span<const double> angles, Fineness fineness, std::span<Complex> out,
                              WorkMeter& meter) const {
  const int most = lines_.count(fineness) + 2;
  const Sums sums = sumsAt(depth, most);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const std::vector<HarmonicLine> lines = lines_.at(angles[i], fineness);
    const auto n = static_cast<double>(lines.size());
    const double size = n * straight_.axes;
    if (!meter.proceed(2.7 * size * size * size + 8.0 * n * n * static_cast<double>(sums.delays.size()))) return false;
    out[i] = lines_.structure(angles[i]) * matrixAt(lines, sums, depth).partialPivLu().determinant();
  }
  return true;
}

Hertz UnlikeTeeth::chatterFrequency(double angle, double depth, WorkMeter& meter) const {
  const std::vector<HarmonicLine> lines = lines_.at(angle, Fineness::Rough);
  const auto size = static_cast<double>(lines.size()) * straight_.axes;
  if (!meter.proceed(8.0 * size * size * size)) return Hertz(0.0);
  const Sums sums = sumsAt(depth, static_cast<int>(lines.size()));
  const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(matrixAt(lines, sums, depth));
  Eigen::VectorXcd motion = Eigen::VectorXcd::Ones(lu.rows());
  for (int i = 0; i < 3; ++i) motion = lu.solve(motion).normalized().eval();
  double largest = -1.0, frequency = 0.0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double power = motion.segment(static_cast<Eigen::Index>(k) * straight_.axes, straight_.axes).squaredNorm();
    if (!(power > largest)) continue;
    largest = power;
    frequency = std::abs(lines[k].omega) / kTwoPi;
  }
  return Hertz(frequency);
}

double UnlikeTeeth::growthAt(double depth) const {
  double fastest = 0.0;
  for (const auto& o : straight_.oscillators) {
    fastest = std::max(fastest, std::sqrt(Complex(o.omega * o.omega, depth * straight_.stiffening())).imag());
  }
  return fastest * period_;
}

}  // namespace stillcut::milling
