#include "core/milling/stability/transition_matrix.h"

#include <algorithm>
#include <cmath>

namespace stillcut::milling {

namespace {

// Blanes and Moan, order 6, 11 stages: kicks 12 (outer), free motions 11, both symmetric.
constexpr std::size_t kStages = 11;
constexpr std::array<double, 5> kKick{0.0414649985182624, 0.198128671918067, -0.0400061921041533, 0.0752539843015807,
                                      -0.0115113874206879};
constexpr std::array<double, 5> kMove{0.123229775946271, 0.290553797799558, -0.127049212625417, -0.246331761062075,
                                      0.357208872795928};

double kickWeight(std::size_t j) {  // j = 0 .. 11
  const std::size_t i = std::min(j, kStages - j);
  return i < 5 ? kKick[i] : 0.5 - (kKick[0] + kKick[1] + kKick[2] + kKick[3] + kKick[4]);
}

double moveWeight(std::size_t j) {  // j = 0 .. 10
  const std::size_t i = std::min(j, kStages - 1 - j);
  return i < 5 ? kMove[i] : 1.0 - 2.0 * (kMove[0] + kMove[1] + kMove[2] + kMove[3] + kMove[4]);
}

constexpr double kStageSetUp = 60.0;   // operations to prepare a stage, most of them in two trigonometric functions
constexpr double kBetweenLooks = 2e6;  // operations after which the meter is asked again
constexpr std::size_t kLanes = 8;      // values of s that run together, so that the compiler can use vector registers

Planar scaled(Planar h, double by) {
  for (double& v : h) v *= by;
  return h;
}

}  // namespace

TransitionMatrix::TransitionMatrix(const RegenerativeSystem& system, Rpm speed, double largestS, double phasePerStep,
                                   WorkMeter& meter)
    : system_(system), states_(system.states()), period_(system.toothPeriod(speed)) {
  spindle_ = kTwoPi * toHertz(speed).value;
  const double omega = system.highestOmega();
  const double fastest = std::sqrt(omega * omega + 0.5 * largestS * system.stiffening());
  for (const ForceInterval& arc : system.intervals) addArc(arc, spindle_, phasePerStep, fastest, meter);
  double damping = 0.0;
  for (const auto& o : system.oscillators) damping += o.zeta * o.omega;
  determinant_ = std::exp(-2.0 * damping * period_);
}

double TransitionMatrix::effort() const {
  return static_cast<double>(stages_.size()) * stageEffort();
}

std::size_t TransitionMatrix::addDrift(double time) {
  const std::size_t row = drifts_.size();
  for (const auto& o : system_.oscillators) {
    const double decay = std::exp(-o.zeta * o.omega * time);
    const double ratio = std::sqrt(1.0 - o.zeta * o.zeta);
    const double c = decay * std::cos(o.omega * ratio * time);
    const double s = decay * std::sin(o.omega * ratio * time) / ratio;
    drifts_.push_back({c + o.zeta * s, s, -s, c - o.zeta * s});
  }
  return row;
}

void TransitionMatrix::addArc(const ForceInterval& arc, double spindle, double phasePerStep, double fastest,
                              WorkMeter& meter) {
  const double time = (arc.to - arc.from) / spindle;
  if (!arc.cutting) {
    stages_.push_back({false, addDrift(time), {}});
    return;
  }
  // A step also stays below a third of a radian of the tooth's way, for the force turns with 2 phi.
  const double wanted = std::max(fastest * time / phasePerStep, (arc.to - arc.from) / 0.35);
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(wanted)));
  const double h = time / static_cast<double>(steps);
  std::array<std::size_t, 6> drift{};
  for (std::size_t j = 0; j < drift.size(); ++j) drift[j] = addDrift(h * moveWeight(j));
  const std::size_t stay = addDrift(0.0);
  double t = 0.0;
  double carried = 0.0;  // the last kick of a step and the first of the next happen at the same time
  for (std::size_t n = 0; n < steps; ++n) {
    if (!meter.proceed(kStages * kStageSetUp)) return;
    t = static_cast<double>(n) * h;
    for (std::size_t j = 0; j < kStages; ++j) {
      const double weight = h * kickWeight(j) + (j == 0 ? carried : 0.0);
      stages_.push_back({true, drift[std::min(j, kStages - 1 - j)], scaled(arc.at(arc.from + spindle * t), weight)});
      t += h * moveWeight(j);
    }
    carried = h * kickWeight(kStages);
  }
  stages_.push_back({true, stay, scaled(arc.at(arc.to), carried)});
}

bool TransitionMatrix::evaluate(std::span<const Complex> s, std::span<Complex> psi, WorkMeter& meter) const {
  std::vector<double> scratch;
  const auto size = static_cast<std::size_t>(states_) * static_cast<std::size_t>(states_);
  for (std::size_t i = 0; i < s.size(); i += kLanes) {
    if (!run(s.data() + i, std::min(kLanes, s.size() - i), scratch, psi.data() + i * size, meter)) return false;
  }
  return true;
}

// Layout: per mode a row of q and a row of p; a row holds the real parts (column by column, lanes fastest), then the
// imaginary parts. Every loop below runs over contiguous doubles.
bool TransitionMatrix::run(const Complex* s, std::size_t lanes, std::vector<double>& scratch, Complex* psi,
                           WorkMeter& meter) const {
  const auto n = static_cast<std::size_t>(states_);
  const std::size_t modes = n / 2;
  const std::size_t half = n * lanes;
  const std::size_t row = 2 * half;
  const bool planar = system_.axes == 2;
  scratch.assign((n + 5) * row, 0.0);
  double* const motion = scratch.data();
  double* const x = motion + n * row;
  double* const y = x + row;
  double* const fx = y + row;
  double* const fy = fx + row;
  double* const sr = fy + row;
  double* const si = sr + half;
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t b = 0; b < lanes; ++b) {
      motion[c * row + c * lanes + b] = 1.0;
      sr[c * lanes + b] = s[b].real();
      si[c * lanes + b] = s[b].imag();
    }
  }
  // f = -s (h0 u + h1 v), complex s per lane
  const auto push = [&](double h0, double h1, double* f) {
    for (std::size_t k = 0; k < half; ++k) {
      const double re = planar ? h0 * x[k] + h1 * y[k] : h0 * x[k];
      const double im = planar ? h0 * x[half + k] + h1 * y[half + k] : h0 * x[half + k];
      f[k] = si[k] * im - sr[k] * re;
      f[half + k] = -(sr[k] * im + si[k] * re);
    }
  };
  const double effort = stageEffort() * static_cast<double>(lanes);
  double ahead = 0.0;  // operations the meter has been told of and that are still to be done
  for (const Stage& stage : stages_) {
    if (ahead <= 0.0) {
      ahead = std::max(effort, kBetweenLooks);
      if (!meter.proceed(ahead)) return false;
    }
    ahead -= effort;
    if (stage.kick) {
      std::fill(x, x + (planar ? 2 : 1) * row, 0.0);
      for (std::size_t i = 0; i < modes; ++i) {
        const double* const q = motion + 2 * i * row;
        const auto& to = system_.oscillators[i].toTip;
        if (to[0] != 0.0) {
          for (std::size_t k = 0; k < row; ++k) x[k] += to[0] * q[k];
        }
        if (to[1] != 0.0) {
          for (std::size_t k = 0; k < row; ++k) y[k] += to[1] * q[k];
        }
      }
      push(stage.force[0], stage.force[1], fx);
      if (planar) push(stage.force[2], stage.force[3], fy);
    }
    for (std::size_t i = 0; i < modes; ++i) {
      double* const q = motion + 2 * i * row;
      double* const p = q + row;
      const Drift d = drifts_[stage.drift + i];
      if (stage.kick) {
        const auto& o = system_.oscillators[i];
        const double gx = o.toTip[0] / (o.mass * o.omega);
        const double gy = o.toTip[1] / (o.mass * o.omega);
        if (gx != 0.0) {
          for (std::size_t k = 0; k < row; ++k) p[k] += gx * fx[k];
        }
        if (gy != 0.0) {
          for (std::size_t k = 0; k < row; ++k) p[k] += gy * fy[k];
        }
      }
      for (std::size_t k = 0; k < row; ++k) {
        const double a = q[k];
        const double v = p[k];
        q[k] = d.qq * a + d.qp * v;
        p[k] = d.pq * a + d.pp * v;
      }
    }
  }
  for (std::size_t b = 0; b < lanes; ++b) {
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t r = 0; r < n; ++r) {
        const double* const v = motion + r * row + c * lanes + b;
        psi[(b * n + c) * n + r] = Complex(v[0], v[half]);
      }
    }
  }
  return true;
}

std::vector<Complex> TransitionMatrix::tipMotion(Complex s, std::span<const Complex> state, int samples,
                                                 WorkMeter& meter) const {
  const double h = period_ / samples;
  const std::size_t modes = system_.oscillators.size();
  std::vector<Complex> now(state.begin(), state.end());
  std::vector<Complex> motion;
  motion.reserve(2 * static_cast<std::size_t>(samples));
  std::vector<Drift> step;
  for (const auto& o : system_.oscillators) {
    const double decay = std::exp(-o.zeta * o.omega * h);
    const double c = decay * std::cos(o.omega * h);
    const double v = decay * std::sin(o.omega * h);
    step.push_back({c + o.zeta * v, v, -v, c - o.zeta * v});
  }
  const double effort = 100.0 + 60.0 * static_cast<double>(modes);
  for (int k = 0; k < samples && meter.proceed(effort); ++k) {
    Complex x = 0.0;
    Complex y = 0.0;
    for (std::size_t i = 0; i < modes; ++i) {
      x += system_.oscillators[i].toTip[0] * now[2 * i];
      y += system_.oscillators[i].toTip[1] * now[2 * i];
    }
    motion.push_back(x);
    motion.push_back(y);
    const double angle = system_.toothAngle * k / samples;
    const Planar force = system_.mean(std::max(0.0, angle - 0.5 * spindle_ * h), angle + 0.5 * spindle_ * h);
    const Complex fx = -s * h * (force[0] * x + force[1] * y);
    const Complex fy = -s * h * (force[2] * x + force[3] * y);
    for (std::size_t i = 0; i < modes; ++i) {
      const auto& o = system_.oscillators[i];
      Complex& q = now[2 * i];
      Complex& p = now[2 * i + 1];
      p += (o.toTip[0] * fx + o.toTip[1] * fy) / (o.mass * o.omega);
      const Complex a = q;
      q = step[i].qq * a + step[i].qp * p;
      p = step[i].pq * a + step[i].pp * p;
    }
  }
  return motion;
}

}  // namespace stillcut::milling
