// An independent beam to check against: finite elements with cubic shape functions (Euler and Bernoulli) or
// Przemieniecki's shear-flexible ones with consistent masses and rotary inertia (Timoshenko).
#pragma once

#include <Eigen/Dense>
#include <complex>

#include "core/base/units.h"

namespace stillcut::coupling::test {

struct Round {
  double length, diameter, young, density, poisson;
};

struct Elements {
  Eigen::MatrixXd stiffness, mass;  // w1, phi1, w2, phi2, ...
};

// J. Przemieniecki, Theory of Matrix Structural Analysis, sec. 5.6 and 11.3.
inline Elements assemble(const Round& beam, int count, bool timoshenko) {
  const double l = beam.length / count;
  const double d = beam.diameter;
  const double area = 0.125 * kTwoPi * d * d;
  const double inertia = kTwoPi * d * d * d * d / 128.0;
  const double shear =
      beam.young / (2.0 * (1.0 + beam.poisson)) * 6.0 * (1.0 + beam.poisson) / (7.0 + 6.0 * beam.poisson);
  const double phi = timoshenko ? 12.0 * beam.young * inertia / (shear * area * l * l) : 0.0;
  Eigen::Matrix4d k;
  k << 12, 6 * l, -12, 6 * l, 6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l, -12, -6 * l, 12, -6 * l, 6 * l,
      (2 - phi) * l * l, -6 * l, (4 + phi) * l * l;
  k *= beam.young * inertia / ((1 + phi) * l * l * l);
  const double p = phi;
  const double a = 13.0 / 35 + 7 * p / 10 + p * p / 3, b = (11.0 / 210 + 11 * p / 120 + p * p / 24) * l;
  const double c = 9.0 / 70 + 3 * p / 10 + p * p / 6, e = -(13.0 / 420 + 3 * p / 40 + p * p / 24) * l;
  const double g = (1.0 / 105 + p / 60 + p * p / 120) * l * l, h = -(1.0 / 140 + p / 60 + p * p / 120) * l * l;
  Eigen::Matrix4d m;
  m << a, b, c, e, b, g, -e, h, c, -e, a, -b, e, h, -b, g;
  m *= beam.density * area * l / ((1 + p) * (1 + p));
  if (timoshenko) {
    const double s = 6.0 / 5, t = (0.1 - p / 2) * l;
    const double u = (2.0 / 15 + p / 6 + p * p / 3) * l * l, v = (-1.0 / 30 - p / 6 + p * p / 6) * l * l;
    Eigen::Matrix4d r;
    r << s, t, -s, t, t, u, -t, v, -s, -t, s, -t, t, v, -t, u;
    m += r * beam.density * inertia / (l * (1 + p) * (1 + p));
  }
  Elements out{Eigen::MatrixXd::Zero(2 * count + 2, 2 * count + 2),
               Eigen::MatrixXd::Zero(2 * count + 2, 2 * count + 2)};
  for (int i = 0; i < count; ++i) {
    out.stiffness.block<4, 4>(2 * i, 2 * i) += k;
    out.mass.block<4, 4>(2 * i, 2 * i) += m;
  }
  return out;
}

// Responses of all freedoms to a unit load on the first, structural damping.
inline Eigen::VectorXcd responses(const Elements& e, double frequency, double lossFactor) {
  const double w = kTwoPi * frequency;
  const Eigen::MatrixXcd dynamic = e.stiffness.cast<std::complex<double>>() * std::complex<double>(1.0, lossFactor) -
                                   w * w * e.mass.cast<std::complex<double>>();
  return dynamic.partialPivLu().solve(Eigen::VectorXcd::Unit(dynamic.rows(), 0));
}

// Receptance of all freedoms at one frequency.
inline Eigen::MatrixXcd receptance(const Elements& e, double frequency, double lossFactor) {
  const double w = kTwoPi * frequency;
  const Eigen::MatrixXcd dynamic = e.stiffness.cast<std::complex<double>>() * std::complex<double>(1.0, lossFactor) -
                                   w * w * e.mass.cast<std::complex<double>>();
  return dynamic.inverse();
}

}  // namespace stillcut::coupling::test
