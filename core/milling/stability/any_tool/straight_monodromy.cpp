#include "core/milling/stability/any_tool/straight_monodromy.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/milling/stability/any_tool/gauss_points.h"

namespace stillcut::milling {

namespace {

using Complex = std::complex<double>;

constexpr double kStiffened = 1.3;  // what the cut makes of the highest frequency

// How finely a stretch is divided: `longest` radians of the highest mode, and so many points.
struct Division {
  double longest, points, pointsPerRadian;
  bool afterwards;  // stretches also end where the end of one is met again a pitch later
};
constexpr Division kRough{12.0, 4.0, 0.75, false};
constexpr Division kFine{10.0, 6.0, 0.95, true};

double within(double value, double period) {
  const double rest = std::fmod(value, period);
  return rest < 0.0 ? rest + period : rest;
}

// Times at which teeth enter or leave, within one period, rising; with `afterwards` also those a pitch after them.
std::vector<double> ends(const ToothPattern& pattern, const ToothCut& cut, double speed, double period,
                         bool afterwards) {
  std::vector<double> times;
  for (const double angle : pattern.angle) {
    for (const double edge : {cut.start, cut.exit}) times.push_back(within((edge - angle) / speed, period));
  }
  if (afterwards) {
    const std::size_t count = times.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (const double pitch : pattern.pitch) times.push_back(within(times[i] + pitch / speed, period));
    }
  }
  std::sort(times.begin(), times.end());
  const double same = 1e-9 * period;
  times.erase(std::unique(times.begin(), times.end(), [same](double a, double b) { return b - a < same; }),
              times.end());
  if (times.size() > 1 && times.front() + period - times.back() < same) times.pop_back();
  return times;
}

// Weights of the polynomial through the values at `nodes` for its value at `at`.
Eigen::VectorXd lagrange(const Eigen::VectorXd& nodes, double at) {
  Eigen::VectorXd weights(nodes.size());
  for (Eigen::Index b = 0; b < nodes.size(); ++b) {
    double product = 1.0;
    for (Eigen::Index k = 0; k < nodes.size(); ++k) {
      if (k != b) product *= (at - nodes[k]) / (nodes[b] - nodes[k]);
    }
    weights[b] = product;
  }
  return weights;
}

// An oscillator's q and p = q'/omega a time after q = 1, p = 0, and after q = 0, p = 1.
struct Swing {
  double qq, qp, pq, pp;
};
Swing swing(const RegenerativeSystem::Oscillator& o, double time) {
  const double ratio = std::sqrt(1.0 - o.zeta * o.zeta);
  const double decay = std::exp(-o.zeta * o.omega * time);
  const double c = decay * std::cos(o.omega * ratio * time);
  const double s = decay * std::sin(o.omega * ratio * time) / ratio;
  return {c + o.zeta * s, s, -s, c - o.zeta * s};
}

// Most of the past says nothing new: a matrix as small as the rank of U, with the same eigenvalues but for zeros.
Eigen::MatrixXd condensed(const Eigen::MatrixXd& u) {
  constexpr double kNothing = 1e-15;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(u);
  qr.setThreshold(kNothing);
  const Eigen::Index rank = std::max<Eigen::Index>(qr.rank(), 1);
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(u.rows(), rank);
  const Eigen::MatrixXd r = qr.matrixR().topRows(rank).triangularView<Eigen::Upper>();
  return r * (qr.colsPermutation().transpose() * q);
}

// det(mu - H) of an upper Hessenberg matrix.
Complex determinantAt(const Eigen::MatrixXd& h, Complex mu, Eigen::MatrixXcd& work) {
  const Eigen::Index n = h.rows();
  work = -h.cast<Complex>();
  work.diagonal().array() += mu;
  Complex det = 1.0;
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    if (std::norm(work(k + 1, k)) > std::norm(work(k, k))) {
      work.row(k).tail(n - k).swap(work.row(k + 1).tail(n - k));
      det = -det;
    }
    if (work(k, k) == 0.0) return 0.0;
    det *= work(k, k);
    const Complex factor = work(k + 1, k) / work(k, k);
    work.row(k + 1).tail(n - k) -= factor * work.row(k).tail(n - k);
  }
  return det * work(n - 1, n - 1);
}

}  // namespace

StraightMonodromy::StraightMonodromy(const RegenerativeSystem& system, const ToothPattern& pattern, const ToothCut& cut,
                                     double speed, Fineness fineness)
    : system_(system), pattern_(pattern), cut_(cut), speed_(speed), period_(kTwoPi / (speed * pattern.repeats)) {
  divide(fineness);
  const double furthest =
      begin_ + period_ - *std::max_element(pattern_.pitch.begin(), pattern_.pitch.end()) / speed_ - 1e-9 * period_;
  for (Stretch& stretch : stretches_) {
    if (stretch.points > 0 && stretch.to > furthest) {
      stretch.unknown = size_;
      size_ += stretch.points * system_.axes;
    }
    respond(stretch);
  }
  size_ += system_.states();
  for (Stretch& stretch : stretches_) {
    cutWith(stretch);
    const auto points = static_cast<double>(stretch.points * system_.axes);
    const auto teeth = static_cast<double>(stretch.teeth.size());
    effort_ += 2.0 * size_ * points * (2.0 * points + static_cast<double>(stretch.points) * teeth + 2.0 * teeth);
  }
}

double StraightMonodromy::phaseOf(double seconds) const {
  return seconds * std::max(kStiffened * system_.highestOmega(), 2.0 * speed_);
}

double StraightMonodromy::expectedSize(const RegenerativeSystem& system, const ToothPattern& pattern,
                                       const ToothCut& cut, double speed) {
  const double longest = *std::max_element(pattern.pitch.begin(), pattern.pitch.end());
  const double cutting = std::min(longest, (cut.exit - cut.start) * (1.0 + std::floor(longest / kTwoPi)));
  const double radians = cutting / speed * kStiffened * system.highestOmega();
  const double stretches = std::ceil(radians / kRough.longest) + 1.0;
  return system.states() + system.axes * (kRough.pointsPerRadian * radians + kRough.points * stretches);
}

void StraightMonodromy::divide(Fineness fineness) {
  const Division& division = fineness == Fineness::Rough ? kRough : kFine;
  std::vector<double> times = ends(pattern_, cut_, speed_, period_, division.afterwards);
  begin_ = times.front();
  times.push_back(begin_ + period_);
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double length = times[i + 1] - times[i], middle = times[i] + 0.5 * length;
    std::vector<int> teeth;
    for (int j = 0; j < pattern_.teeth(); ++j) {
      const double angle = within(speed_ * middle + pattern_.angle[static_cast<std::size_t>(j)], kTwoPi);
      if (angle > cut_.start && angle < cut_.exit) teeth.push_back(j);
    }
    const int parts = teeth.empty() ? 1 : std::max(1, static_cast<int>(std::ceil(phaseOf(length) / division.longest)));
    for (int part = 0; part < parts; ++part) {
      Stretch stretch;
      stretch.from = times[i] + length * part / parts;
      stretch.to = times[i] + length * (part + 1) / parts;
      stretch.teeth = teeth;
      if (!teeth.empty()) {
        stretch.points =
            static_cast<int>(std::ceil(division.points + division.pointsPerRadian * phaseOf(length / parts)));
        stretch.first = points_;
        points_ += stretch.points;
        stretch.nodes.resize(stretch.points);
        const std::vector<GaussPoint> gauss = gaussPoints(stretch.points);
        for (int a = 0; a < stretch.points; ++a)
          stretch.nodes[a] = stretch.from + (stretch.to - stretch.from) * gauss[static_cast<std::size_t>(a)].at;
      }
      stretches_.push_back(std::move(stretch));
    }
  }
}

// What the structure does over the stretch: by itself, and under a force that is a polynomial.
void StraightMonodromy::respond(Stretch& stretch) const {
  const auto axes = static_cast<Eigen::Index>(system_.axes);
  const auto states = static_cast<Eigen::Index>(system_.states());
  const Eigen::Index points = stretch.points;
  stretch.leave = Eigen::MatrixXd::Zero(states, states);
  stretch.free = Eigen::MatrixXd::Zero(points * axes, states);
  stretch.moves = Eigen::MatrixXd::Zero(points * axes, points * axes);
  stretch.pushes = Eigen::MatrixXd::Zero(states, points * axes);
  const std::vector<GaussPoint> gauss = points > 0 ? gaussPoints(stretch.points + 8) : std::vector<GaussPoint>{};
  // Of each time (the points, then the end): where the force is taken, and its polynomials there.
  for (Eigen::Index a = 0; a <= points; ++a) {
    const bool end = a == points;
    const double time = (end ? stretch.to : stretch.nodes[a]) - stretch.from;
    for (Eigen::Index i = 0; i < states / 2; ++i) {
      const auto& o = system_.oscillators[static_cast<std::size_t>(i)];
      const Swing own = swing(o, time);
      if (end) stretch.leave.block<2, 2>(2 * i, 2 * i) << own.qq, own.qp, own.pq, own.pp;
      for (Eigen::Index x = 0; !end && x < axes; ++x) {
        const double to = o.toTip[static_cast<std::size_t>(x)];
        stretch.free(a * axes + x, 2 * i) = to * own.qq;
        stretch.free(a * axes + x, 2 * i + 1) = to * own.qp;
      }
    }
    for (const GaussPoint& g : gauss) {
      const double at = g.at * time;
      const Eigen::VectorXd force = g.weight * time * lagrange(stretch.nodes, stretch.from + at);
      for (Eigen::Index i = 0; i < states / 2; ++i) {
        const auto& o = system_.oscillators[static_cast<std::size_t>(i)];
        const Swing after = swing(o, time - at);
        const double mobility = 1.0 / (o.mass * o.omega);
        for (Eigen::Index y = 0; y < axes; ++y) {
          const double by = mobility * o.toTip[static_cast<std::size_t>(y)];
          for (Eigen::Index b = 0; b < points; ++b) {
            if (end) {
              stretch.pushes(2 * i, b * axes + y) += after.qp * by * force[b];
              stretch.pushes(2 * i + 1, b * axes + y) += after.pp * by * force[b];
            }
            for (Eigen::Index x = 0; !end && x < axes; ++x) {
              stretch.moves(a * axes + x, b * axes + y) +=
                  o.toTip[static_cast<std::size_t>(x)] * after.qp * by * force[b];
            }
          }
        }
      }
    }
  }
}

// H of a tooth at an angle, on the axes that move.
Eigen::MatrixXd StraightMonodromy::toothForce(double angle) const {
  const double s = std::sin(angle), c = std::cos(angle);
  const double alongX = cut_.tangential * c + cut_.radial * s, alongY = cut_.radial * c - cut_.tangential * s;
  Eigen::Matrix2d h;
  h << alongX * s, alongX * c, alongY * s, alongY * c;
  if (system_.axes == 2) return h;
  const Eigen::Vector2d e(system_.direction[0], system_.direction[1]);
  return Eigen::MatrixXd::Constant(1, 1, e.dot(h * e));
}

StraightMonodromy::Lookup StraightMonodromy::lookUp(double time) const {
  Lookup found;
  found.before = time < begin_;
  if (found.before) time += period_;
  double nearest = period_;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    const Stretch& stretch = stretches_[i];
    if (stretch.points == 0) continue;
    const double apart = std::max({stretch.from - time, time - stretch.to, 0.0});
    if (apart >= nearest) continue;
    nearest = apart;
    found.stretch = i;
  }
  found.weights = lagrange(stretches_[found.stretch].nodes, time);
  return found;
}

void StraightMonodromy::cutWith(Stretch& stretch) const {
  const auto axes = static_cast<Eigen::Index>(system_.axes);
  const Eigen::Index points = stretch.points;
  stretch.stiffness = Eigen::MatrixXd::Zero(points * axes, points * axes);
  for (const int tooth : stretch.teeth) {
    const auto j = static_cast<std::size_t>(tooth);
    Eigen::MatrixXd own(axes, points * axes);
    std::vector<Lookup> past;
    for (Eigen::Index a = 0; a < points; ++a) {
      const Eigen::MatrixXd h = toothForce(speed_ * stretch.nodes[a] + pattern_.angle[j]);
      own.middleCols(a * axes, axes) = h;
      stretch.stiffness.block(a * axes, a * axes, axes, axes) += h;
      past.push_back(lookUp(stretch.nodes[a] - pattern_.pitch[j] / speed_));
    }
    stretch.own.push_back(std::move(own));
    stretch.past.push_back(std::move(past));
  }
}

Eigen::MatrixXd StraightMonodromy::at(double depth, WorkMeter& meter) const {
  const auto axes = static_cast<Eigen::Index>(system_.axes);
  const auto states = static_cast<Eigen::Index>(system_.states());
  if (!meter.proceed(effort_)) return {};
  Eigen::MatrixXd moved(points_ * axes, size_);  // of the period so far
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(states, size_);
  y.rightCols(states).setIdentity();
  Eigen::MatrixXd left, next;
  for (const Stretch& stretch : stretches_) {
    if (stretch.points == 0) {
      y = (stretch.leave * y).eval();
      continue;
    }
    left.setZero(stretch.points * axes, size_);  // G
    for (std::size_t t = 0; t < stretch.teeth.size(); ++t) {
      for (Eigen::Index a = 0; a < stretch.points; ++a) {
        const Lookup& past = stretch.past[t][static_cast<std::size_t>(a)];
        const Stretch& of = stretches_[past.stretch];
        const auto h = stretch.own[t].middleCols(a * axes, axes);
        for (Eigen::Index b = 0; b < of.points; ++b) {
          if (past.before) {
            left.block(a * axes, of.unknown + b * axes, axes, axes) += past.weights[b] * h;
          } else {
            left.middleRows(a * axes, axes).noalias() +=
                (past.weights[b] * h) * moved.middleRows((of.first + b) * axes, axes);
          }
        }
      }
    }
    Eigen::MatrixXd system = depth * stretch.moves * stretch.stiffness;
    system.diagonal().array() += 1.0;
    next = stretch.free * y + depth * stretch.moves * left;
    next = system.partialPivLu().solve(next).eval();
    y = (stretch.leave * y - depth * stretch.pushes * (stretch.stiffness * next - left)).eval();
    moved.middleRows(stretch.first * axes, stretch.points * axes) = next;
  }
  Eigen::MatrixXd monodromy(size_, size_);
  for (const Stretch& stretch : stretches_) {
    if (stretch.unknown < 0) continue;
    monodromy.middleRows(stretch.unknown, stretch.points * axes) =
        moved.middleRows(stretch.first * axes, stretch.points * axes);
  }
  monodromy.bottomRows(states) = y;
  return monodromy;
}

bool StraightMonodromy::sample(double depth, std::span<const double> angles, std::span<Complex> out,
                               WorkMeter& meter) const {
  const Eigen::MatrixXd monodromy = at(depth, meter);
  const double n = size_;
  if (meter.stopped() || !meter.proceed(3.0 * n * n * n)) return false;
  const Eigen::MatrixXd small = condensed(monodromy);
  const auto rank = static_cast<double>(small.rows());
  if (!meter.proceed(4.0 * rank * rank * (rank + static_cast<double>(angles.size())))) return false;
  const Eigen::MatrixXd h = Eigen::HessenbergDecomposition<Eigen::MatrixXd>(small).matrixH();
  Eigen::MatrixXcd work;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const Complex past = std::polar(1.0, (system_.states() - rank) * angles[i]);
    out[i] = past * determinantAt(h, std::polar(1.0, angles[i]), work);
  }
  return true;
}

}  // namespace stillcut::milling
