// f(mu, s) = det(Psi(s) - mu I) as a polynomial over a disc of s. Psi is entire in s, so its values on the disc's
// circle give a Taylor expansion that converges geometrically inside; in mu f is a polynomial of degree `states`.
// Building one costs a few dozen transition matrices; afterwards f and its derivatives cost well under a microsecond,
// for every depth and every multiplier whose s = w (1 - 1/mu) lies in the disc.
// Thread: one, with its WorkMeter; not real-time.
#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "core/milling/stability/transition_matrix.h"

namespace stillcut::milling {

struct CharacteristicValue {
  Complex f, fs, fm, fss, fsm, fmm;  // f and its derivatives by s and by mu
};

class Characteristic {
 public:
  // Empty when the expansion does not reach the accuracy wanted within the terms allowed (the disc is too large for
  // it: split it), or when stopped.
  static std::optional<Characteristic> build(const TransitionMatrix& transition, Complex centre, double radius,
                                             WorkMeter& meter);

  CharacteristicValue at(Complex mu, Complex s) const;
  Complex valueAt(Complex mu, Complex s) const;
  int states() const { return states_; }
  double effort() const { return 24.0 * static_cast<double>(re_.size()); }  // operations of at(); valueAt() has a third

 private:
  Complex centre_;
  double radius_ = 1.0;
  int states_ = 0;
  std::size_t inner_ = 0;        // coefficients of mu^1 .. mu^(states-1) depend on s
  double constant_ = 0.0;        // coefficient of mu^0: det Psi
  std::vector<double> re_, im_;  // [power of s][power of mu - 1]
};

// Coefficients c_0 .. c_(n-1) of det(Psi - mu I) = sum c_k mu^k + (-mu)^n, from its values at the n-th roots of unity,
// which loses no digits on the unit circle. `psi` is column major.
void characteristicCoefficients(std::span<const Complex> psi, int states, double determinant, std::span<Complex> out);

}  // namespace stillcut::milling
