#include "core/milling/stability/transition_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stillcut::milling {

namespace {

// A splitting: `kicks` and `moves` alternate, kicks outermost, both symmetric; each list holds its first half, the
// middle one follows from the sum, which is 1.
struct Splitting {
  std::span<const double> kicks, moves;
  std::size_t stages;  // moves; there is one kick more
};

double weightOf(std::span<const double> half, std::size_t i, std::size_t count) {
  const std::size_t mirrored = std::min(i, count - 1 - i);
  if (mirrored < half.size()) return half[mirrored];
  double sum = 0.0;
  for (double v : half) sum += v;
  return count % 2 == 1 ? 1.0 - 2.0 * sum : 0.5 - sum;
}

// Blanes and Moan, order 6, 11 stages, for kicks that are nilpotent.
constexpr std::array<double, 5> kNilpotentKicks{0.0414649985182624, 0.198128671918067, -0.0400061921041533,
                                                0.0752539843015807, -0.0115113874206879};
constexpr std::array<double, 5> kNilpotentMoves{0.123229775946271, 0.290553797799558, -0.127049212625417,
                                                -0.246331761062075, 0.357208872795928};
// The same, 10 stages, for any kicks.
constexpr std::array<double, 5> kAnyKicks{0.0502627644003922, 0.413514300428344, 0.0450798897943977, -0.188054853819569,
                                          0.541960678450780};
constexpr std::array<double, 4> kAnyMoves{0.148816447901042, -0.132385865767784, 0.067307604692185, 0.432666402578175};

const Splitting kNilpotent{kNilpotentKicks, kNilpotentMoves, 11};
const Splitting kAny{kAnyKicks, kAnyMoves, 10};

constexpr double kStageSetUp = 60.0;   // operations to prepare a stage, most of them in two trigonometric functions
constexpr double kBetweenLooks = 2e6;  // operations after which the meter is asked again
constexpr std::size_t kLanes = 8;      // values of s that run together, so that the compiler can use vector registers

Planar scaled(Planar h, double by) {
  for (double& v : h) v *= by;
  return h;
}

// The impulse J of a kick under f = -H x - D v, v' = B f, x held over a time t: J = phi(-D B t) (-H x - D v) t with
// phi(z) = (exp(z) - 1)/z, whose series ends soon. `drag` is D t, `mobility` B.
Planar held(const Planar& drag, const Planar& mobility, int axes) {
  const Planar z{-(drag[0] * mobility[0] + drag[1] * mobility[2]), -(drag[0] * mobility[1] + drag[1] * mobility[3]),
                 -(drag[2] * mobility[0] + drag[3] * mobility[2]), -(drag[2] * mobility[1] + drag[3] * mobility[3])};
  Planar sum{1.0, 0.0, 0.0, axes == 2 ? 1.0 : 0.0};
  Planar term = sum;
  for (int k = 2; k < 24; ++k) {
    term = scaled({term[0] * z[0] + term[1] * z[2], term[0] * z[1] + term[1] * z[3], term[2] * z[0] + term[3] * z[2],
                   term[2] * z[1] + term[3] * z[3]},
                  1.0 / k);
    for (std::size_t i = 0; i < 4; ++i) sum[i] += term[i];
  }
  return sum;
}

Planar product(const Planar& a, const Planar& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}

// What a force does to the tip's acceleration: the sum of a a^T/m.
Planar mobilityOf(const RegenerativeSystem& system) {
  Planar b{};
  for (const auto& o : system.oscillators) {
    b[0] += o.toTip[0] * o.toTip[0] / o.mass;
    b[1] += o.toTip[0] * o.toTip[1] / o.mass;
    b[3] += o.toTip[1] * o.toTip[1] / o.mass;
  }
  b[2] = b[1];
  return b;
}

}  // namespace

TransitionMatrix::TransitionMatrix(const RegenerativeSystem& system, Rpm speed, double largestS, double phasePerStep,
                                   WorkMeter& meter)
    : system_(system),
      states_(system.states()),
      period_(system.toothPeriod(speed)),
      spindle_(kTwoPi * toHertz(speed).value),
      damped_(!system.damping.empty() && system.depth > 0.0) {
  const double omega = system.highestOmega();
  const double fastest = std::sqrt(omega * omega + 0.5 * largestS * system.stiffening());
  for (std::size_t i = 0; i < system.intervals.size(); ++i) addArc(i, phasePerStep, fastest, meter);
  double damping = 0.0;
  for (const auto& o : system.oscillators) damping += o.zeta * o.omega;
  double dragged = 0.0;  // the determinant of the damped kicks
  for (const ForceInterval& arc : damped_ ? system.damping : std::vector<ForceInterval>{}) {
    const Planar z = product(arc.integral(arc.from, arc.to), mobilityOf(system));
    dragged += (z[0] + z[3]) * system.depth / (spindle_ * spindle_);
  }
  determinant_ = std::exp(-2.0 * damping * period_ - dragged);
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

TransitionMatrix::Stage TransitionMatrix::kickAt(std::size_t index, double angle, double weight,
                                                 std::size_t drift) const {
  Stage stage{true, drift, scaled(system_.intervals[index].at(angle), weight), {}};
  if (!damped_) return stage;
  const Planar drag = scaled(system_.damping[index].at(angle), weight * system_.depth / spindle_);
  const Planar hold = held(drag, mobilityOf(system_), system_.axes);
  stage.force = product(hold, stage.force);
  stage.drag = product(hold, drag);
  return stage;
}

void TransitionMatrix::addArc(std::size_t index, double phasePerStep, double fastest, WorkMeter& meter) {
  const ForceInterval& arc = system_.intervals[index];
  const double time = (arc.to - arc.from) / spindle_;
  if (!arc.cutting) {
    stages_.push_back({false, addDrift(time), {}, {}});
    return;
  }
  // A step also stays below a third of a radian of the tooth's way, for the force rotates with 2 phi.
  const Splitting& splitting = damped_ ? kAny : kNilpotent;
  const double wanted = std::max(fastest * time / phasePerStep, (arc.to - arc.from) / 0.35);
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(wanted)));
  const double h = time / static_cast<double>(steps);
  const std::size_t moves = splitting.stages;
  std::array<std::size_t, 6> drift{};
  for (std::size_t j = 0; j < (moves + 1) / 2; ++j) drift[j] = addDrift(h * weightOf(splitting.moves, j, moves));
  const std::size_t stay = addDrift(0.0);
  double t = 0.0;
  double carried = 0.0;  // the last kick of a step and the first of the next happen at the same time
  for (std::size_t n = 0; n < steps; ++n) {
    if (!meter.proceed(static_cast<double>(moves) * kStageSetUp)) return;
    t = static_cast<double>(n) * h;
    for (std::size_t j = 0; j < moves; ++j) {
      const double weight = h * weightOf(splitting.kicks, j, moves + 1) + (j == 0 ? carried : 0.0);
      stages_.push_back(kickAt(index, arc.from + spindle_ * t, weight, drift[std::min(j, moves - 1 - j)]));
      t += h * weightOf(splitting.moves, j, moves);
    }
    carried = h * weightOf(splitting.kicks, moves, moves + 1);
  }
  stages_.push_back(kickAt(index, arc.to, carried, stay));
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
  scratch.assign((n + 7) * row, 0.0);
  double* const motion = scratch.data();
  double* const x = motion + n * row;
  double* const y = x + row;
  double* const fx = y + row;
  double* const fy = fx + row;
  double* const sr = fy + row;
  double* const si = sr + half;
  double* const vx = si + half;
  double* const vy = vx + row;
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
  double ahead = 0.0;  // operations that were announced to the meter and that are still to be done
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
      if (damped_) {
        std::fill(vx, vx + (planar ? 2 : 1) * row, 0.0);
        for (std::size_t i = 0; i < modes; ++i) {
          const auto& o = system_.oscillators[i];
          const double* const p = motion + (2 * i + 1) * row;
          for (std::size_t k = 0; k < row; ++k) vx[k] += o.toTip[0] * o.omega * p[k];
          for (std::size_t k = 0; planar && k < row; ++k) vy[k] += o.toTip[1] * o.omega * p[k];
        }
        for (std::size_t k = 0; k < row; ++k) fx[k] -= stage.drag[0] * vx[k] + (planar ? stage.drag[1] * vy[k] : 0.0);
        for (std::size_t k = 0; planar && k < row; ++k) fy[k] -= stage.drag[2] * vx[k] + stage.drag[3] * vy[k];
      }
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
