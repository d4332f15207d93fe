// Psi(s): the transition matrix over one tooth period of the ordinary periodic equation that remains when the delayed
// motion is x(t - tau) = x(t)/mu. The depth w and the multiplier mu enter only through s = w (1 - 1/mu) [m, complex]:
//   q_i'' + 2 zeta_i omega_i q_i' + omega_i^2 q_i = -(s/m_i) a_i . H(phi(t)) x
// mu is a Floquet multiplier of the cut exactly where det(Psi(s) - mu I) = 0.
//
// Numerics: free motion of every mode is exact; the cutting force is a kick q -> q', which is nilpotent, so the
// sixth-order Runge-Kutta-Nystroem splitting with 11 stages of Blanes and Moan (J. Comput. Appl. Math. 142, 2002,
// table 3, order 6) applies. Arcs out of the cut are one exact step. States are (q_i, q_i'/omega_i).
// With process damping the kick depends on q' too and is no longer nilpotent: it is then the exact solution of
// q'' = -(H q + D q')/m with q held, and the splitting is the one with 10 stages of the same paper (table 2, order 6).
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/milling/stability/regenerative_system.h"
#include "core/milling/stability/work_meter.h"

namespace stillcut::milling {

using Complex = std::complex<double>;

class TransitionMatrix {
 public:
  // `phasePerStep`: how far the fastest mode (stiffened by the largest |s| expected) rotates within a step of 11 stages
  // [rad]. About 2 gives six digits, 1 about nine.
  // Of no use when the meter has stopped, and then to be thrown away.
  TransitionMatrix(const RegenerativeSystem& system, Rpm speed, double largestS, double phasePerStep, WorkMeter& meter);

  int states() const { return states_; }
  double toothPeriod() const { return period_; }
  double effort() const;                               // arithmetic operations of one evaluation, roughly
  double determinant() const { return determinant_; }  // of Psi: the same for every s

  // Writes count matrices of states x states, column major, one after another; false when stopped. Any thread;
  // allocates scratch.
  bool evaluate(std::span<const Complex> s, std::span<Complex> psi, WorkMeter& meter) const;
  // Tip motion x (one or two axes, interleaved) at `samples` equal times over the period when it starts from `state`.
  // Steps across the edges of the cut: good to see which harmonic is largest, not for limits.
  // Ends early when stopped.
  std::vector<Complex> tipMotion(Complex s, std::span<const Complex> state, int samples, WorkMeter& meter) const;

 private:
  struct Stage {
    bool kick = false;
    std::size_t drift = 0;  // index into drifts_
    Planar force{};         // H times the time weight [N s/m^2]
    Planar drag{};          // of the tip's velocity, likewise [N s/m]; only with process damping
  };
  // Free motion of one mode over a time: q <- qq q + qp p, p <- pq q + pp p.
  struct Drift {
    double qq = 1.0, qp = 0.0, pq = 0.0, pp = 1.0;
  };

  std::size_t addDrift(double time);
  void addArc(std::size_t index, double phasePerStep, double fastest, WorkMeter& meter);
  Stage kickAt(std::size_t index, double angle, double weight, std::size_t drift) const;
  double stageEffort() const { return states_ * (8.0 * states_ + 16.0); }
  bool run(const Complex* s, std::size_t lanes, std::vector<double>& scratch, Complex* psi, WorkMeter& meter) const;

  RegenerativeSystem system_;
  int states_ = 0;
  double period_ = 0.0;
  double spindle_ = 0.0;  // [rad/s]
  bool damped_ = false;   // with process damping
  double determinant_ = 1.0;
  std::vector<Stage> stages_;
  std::vector<Drift> drifts_;  // one row of oscillators per distinct time
};

}  // namespace stillcut::milling
