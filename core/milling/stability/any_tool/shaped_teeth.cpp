#include "core/milling/stability/any_tool/shaped_teeth.h"

#include <algorithm>
#include <cmath>

#include "core/milling/stability/argument_principle.h"

namespace stillcut::milling {

namespace {

using Complex = std::complex<double>;

constexpr double kSameDelay = 1e-9;  // [rad]

std::vector<RegenerativeSystem::Oscillator> oscillators(const CutModel& model) {
  std::vector<RegenerativeSystem::Oscillator> list;
  for (const Mode& m : model.modes) {
    list.push_back({kTwoPi * m.frequency.value, m.damping, m.mass(), m.direction});
  }
  return list;
}

// Integrals of exp(i p phi) over a window for p = -2 - n .. 2 - n, n = multiples of the pattern's repeats, one after
// the other without a sine or cosine each time.
class Turning5 {
 public:
  Turning5(double from, double to, int n, int step) : from_(from), to_(to), n_(n), step_(step) {
    atFrom_ = std::polar(1.0, -n * from);
    atTo_ = std::polar(1.0, -n * to);
    stepFrom_ = std::polar(1.0, -step * from);
    stepTo_ = std::polar(1.0, -step * to);
    for (int p = -2; p <= 2; ++p) {
      shiftFrom_[static_cast<std::size_t>(p + 2)] = std::polar(1.0, p * from);
      shiftTo_[static_cast<std::size_t>(p + 2)] = std::polar(1.0, p * to);
    }
  }
  Complex at(int p) const {
    const int power = p - n_;
    if (power == 0) return to_ - from_;
    const auto k = static_cast<std::size_t>(p + 2);
    return (shiftTo_[k] * atTo_ - shiftFrom_[k] * atFrom_) * Complex(0.0, -1.0 / power);
  }
  void next() {
    n_ += step_;
    atFrom_ *= stepFrom_;
    atTo_ *= stepTo_;
  }

 private:
  double from_, to_;
  int n_, step_;
  Complex atFrom_, atTo_, stepFrom_, stepTo_;
  std::array<Complex, 5> shiftFrom_{}, shiftTo_{};
};

}  // namespace

double edgeLengthBelow(const Tool& tool, double depth) {
  const double corner = tool.cornerRadius.value;
  if (depth >= corner) return 0.25 * kTwoPi * corner + depth - corner;
  return corner * std::acos(1.0 - depth / corner);
}

double depthOfLength(const Tool& tool, double length) {
  const double corner = tool.cornerRadius.value;
  const double straight = length - 0.25 * kTwoPi * corner;
  return straight >= 0.0 ? corner + straight : corner * (1.0 - std::cos(length / corner));
}

ShapedTeeth::ShapedTeeth(const CutModel& model, const ToothPattern& pattern, Rpm speed)
    : model_(model),
      pattern_(pattern),
      speed_(kTwoPi * toHertz(speed).value),
      period_(kTwoPi / (speed_ * (model.tool.serration ? 1 : pattern.repeats))),
      lines_(oscillators(model), period_) {
  if (model.tool.serration) pattern_.repeats = 1;
  std::array<bool, 3> moves{};
  for (const Mode& m : model.modes) {
    modes_.push_back({kTwoPi * m.frequency.value, m.damping, m.mass(), {m.direction[0], m.direction[1], m.directionZ}});
    for (std::size_t i = 0; i < 3; ++i) moves[i] = moves[i] || modes_.back().toTip[i] != 0.0;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (moves[i]) axes_.push_back(i);
  }
}

void ShapedTeeth::add(Sums& sums, Group& group, const EdgePiece& piece, double depth) const {
  const int r = pattern_.repeats;
  const double kt = model_.material.tangential, kr = model_.material.radial;
  const double c = model_.material.processDamping / (0.5 * model_.tool.diameter.value * speed_);
  const double sk = piece.sineKappa, ck = piece.cosineKappa;
  const double weight = depth * piece.share * r / kTwoPi;
  Turning5 turned(piece.from, piece.to, -sums.most * r, r);
  Complex lead = std::polar(weight, -sums.most * r * piece.lead);
  const Complex nextLead = std::polar(1.0, r * piece.lead), i(0.0, 1.0);
  for (std::size_t m = 0; m < group.force.size(); ++m, turned.next(), lead *= nextLead) {
    const Complex one = turned.at(0), up = turned.at(2), down = turned.at(-2), up1 = turned.at(1),
                  down1 = turned.at(-1);
    const Complex cosine2 = 0.5 * (up + down), sine2 = -0.5 * i * (up - down);
    const Complex ss = 0.5 * (one - cosine2), cc = 0.5 * (one + cosine2), sc = 0.5 * sine2;
    const Complex s = -0.5 * i * (up1 - down1), k = 0.5 * (up1 + down1);
    // (K_r n + K_t t) n^T / sin(kappa)
    Spatial& f = group.force[m];
    f[0] += lead * (kr * sk * ss + kt * sc);
    f[1] += lead * (kr * sk * sc + kt * cc);
    f[3] += lead * (kr * sk * sc - kt * ss);
    f[4] += lead * (kr * sk * cc - kt * sc);
    f[2] -= lead * ck * (kr * s + kt / sk * k);
    f[5] -= lead * ck * (kr * k - kt / sk * s);
    f[6] -= lead * ck * kr * s;
    f[7] -= lead * ck * kr * k;
    f[8] += lead * (ck * ck / sk * kr) * one;
    if (sums.drag.empty()) continue;
    Spatial& d = sums.drag[m];
    d[0] += lead * (c * sk) * ss;
    d[1] += lead * (c * sk) * sc;
    d[3] += lead * (c * sk) * sc;
    d[4] += lead * (c * sk) * cc;
    d[2] -= lead * (c * ck) * s;
    d[5] -= lead * (c * ck) * k;
    d[6] -= lead * (c * ck) * s;
    d[7] -= lead * (c * ck) * k;
    d[8] += lead * (c * ck * ck / sk) * one;
  }
}

ShapedTeeth::Sums ShapedTeeth::sumsAt(double depth, int most, WorkMeter& meter) const {
  Sums sums;
  sums.most = most;
  const auto count = static_cast<std::size_t>(2 * most + 1);
  if (model_.material.processDamping > 0.0) sums.drag.resize(count);
  std::vector<double> delays;
  for (const EdgePiece& piece : edgePieces(model_, pattern_, depth, most * pattern_.repeats)) {
    if (!meter.proceed(120.0 * static_cast<double>(count))) return sums;
    const auto same = std::find_if(delays.begin(), delays.end(),
                                   [&](double delay) { return std::abs(delay - piece.delay) < kSameDelay; });
    const auto at = static_cast<std::size_t>(same - delays.begin());
    if (same == delays.end()) {
      delays.push_back(piece.delay);
      sums.groups.push_back({piece.delay / speed_, std::vector<Spatial>(count)});
    }
    add(sums, sums.groups[at], piece, depth);
  }
  return sums;
}

Eigen::MatrixXcd ShapedTeeth::matrixAt(const std::vector<HarmonicLine>& lines, const Sums& sums) const {
  const std::size_t axes = axes_.size(), count = lines.size();
  const auto size = static_cast<Eigen::Index>(count * axes);
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Identity(size, size);
  std::vector<Complex> kept;  // 1 - exp(-i omega tau)
  for (const HarmonicLine& line : lines) {
    for (const Group& g : sums.groups) kept.push_back(1.0 - std::polar(1.0, -line.omega * g.delay));
  }
  for (std::size_t k = 0; k < count; ++k) {
    Spatial receptance{};
    const double w = lines[k].omega;
    for (const Mode3& o : modes_) {
      const Complex own = lines[k].fade / (o.mass * Complex(o.omega * o.omega - w * w, 2.0 * o.zeta * o.omega * w));
      for (std::size_t i = 0; i < 9; ++i) receptance[i] += own * (o.toTip[i / 3] * o.toTip[i % 3]);
    }
    for (std::size_t l = 0; l < count; ++l) {
      const auto m = static_cast<std::size_t>(lines[k].number - lines[l].number + sums.most);
      Spatial a{};
      for (std::size_t g = 0; g < sums.groups.size(); ++g) {
        const Spatial& h = sums.groups[g].force[m];
        const Complex through = kept[l * sums.groups.size() + g];
        for (std::size_t row : axes_) {
          for (std::size_t column : axes_) a[3 * row + column] += through * h[3 * row + column];
        }
      }
      for (std::size_t i = 0; !sums.drag.empty() && i < 9; ++i) a[i] += Complex(0.0, lines[l].omega) * sums.drag[m][i];
      for (std::size_t row = 0; row < axes; ++row) {
        for (std::size_t column = 0; column < axes; ++column) {
          Complex sum = 0.0;
          for (std::size_t via : axes_) sum += receptance[3 * axes_[row] + via] * a[3 * via + axes_[column]];
          matrix(static_cast<Eigen::Index>(k * axes + row), static_cast<Eigen::Index>(l * axes + column)) += sum;
        }
      }
    }
  }
  return matrix;
}

bool ShapedTeeth::sample(double length, std::span<const double> angles, Fineness fineness, std::span<Complex> out,
                         WorkMeter& meter) const {
  const double depth = depthOfLength(model_.tool, length);
  if (!(depth > 0.0)) {
    for (std::size_t i = 0; i < angles.size(); ++i) out[i] = lines_.structure(angles[i]);
    return true;
  }
  const Sums sums = sumsAt(depth, lines_.count(fineness) + 2, meter);
  for (std::size_t i = 0; i < angles.size() && !meter.stopped(); ++i) {
    out[i] = valueAt(angles[i], fineness, sums, meter);
  }
  return !meter.stopped();
}

Complex ShapedTeeth::valueAt(double angle, Fineness fineness, const Sums& sums, WorkMeter& meter) const {
  const std::vector<HarmonicLine> lines = lines_.at(angle, fineness);
  const double n = static_cast<double>(lines.size()), a = static_cast<double>(axes_.size());
  const double effort = 2.7 * std::pow(n * a, 3) + 8.0 * n * n * a * a * (a + static_cast<double>(sums.groups.size()));
  if (!meter.proceed(effort)) return 1.0;
  return lines_.structure(angle) * matrixAt(lines, sums).partialPivLu().determinant();
}

std::optional<int> ShapedTeeth::outside(double length, WorkMeter& meter) const {
  const Sums sums = sumsAt(depthOfLength(model_.tool, length), lines_.count(Fineness::Rough) + 2, meter);
  const auto value = [&](double angle) { return valueAt(angle, Fineness::Rough, sums, meter); };
  const double change = argumentChange(value, 0.0, 0.5 * kTwoPi, 8 + states());
  if (meter.stopped() || !std::isfinite(change)) return std::nullopt;
  return states() - static_cast<int>(std::lround(change / (0.5 * kTwoPi)));
}

double ShapedTeeth::closestAngle(double length, WorkMeter& meter) const {
  constexpr int kLooks = 400;
  const Sums sums = sumsAt(depthOfLength(model_.tool, length), lines_.count(Fineness::Rough) + 2, meter);
  double best = 0.0, smallest = 1e300;
  for (int i = 0; i <= kLooks && !meter.stopped(); ++i) {
    const double angle = 0.5 * kTwoPi * i / kLooks;
    const double size = std::abs(valueAt(angle, Fineness::Rough, sums, meter));
    if (!(size < smallest)) continue;
    smallest = size;
    best = angle;
  }
  return best;
}

Hertz ShapedTeeth::chatterFrequency(double angle, double length, WorkMeter& meter) const {
  const double depth = depthOfLength(model_.tool, length);
  const std::vector<HarmonicLine> lines = lines_.at(angle, Fineness::Rough);
  const auto axes = static_cast<Eigen::Index>(axes_.size());
  const auto size = static_cast<double>(lines.size()) * static_cast<double>(axes);
  const Sums sums = sumsAt(depth, static_cast<int>(lines.size()), meter);
  if (!meter.proceed(8.0 * size * size * size) || meter.stopped()) return Hertz(0.0);
  const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(matrixAt(lines, sums));
  Eigen::VectorXcd motion = Eigen::VectorXcd::Ones(lu.rows());
  for (int i = 0; i < 3; ++i) motion = lu.solve(motion).normalized().eval();
  double largest = -1.0, frequency = 0.0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double power = motion.segment(static_cast<Eigen::Index>(k) * axes, axes).squaredNorm();
    if (!(power > largest)) continue;
    largest = power;
    frequency = std::abs(lines[k].omega) / kTwoPi;
  }
  return Hertz(frequency);
}

double ShapedTeeth::growthAt(double length) const {
  const double depth = depthOfLength(model_.tool, length);
  const double force = model_.tool.teeth * (model_.material.tangential + std::abs(model_.material.radial));
  double fastest = 0.0, mobility = 0.0;
  for (const Mode3& o : modes_) {
    mobility =
        std::max(mobility, (o.toTip[0] * o.toTip[0] + o.toTip[1] * o.toTip[1] + o.toTip[2] * o.toTip[2]) / o.mass);
  }
  for (const Mode3& o : modes_) {
    fastest = std::max(fastest, std::sqrt(Complex(o.omega * o.omega, 0.5 * depth * force * mobility)).imag());
  }
  return fastest * period_;
}

}  // namespace stillcut::milling
