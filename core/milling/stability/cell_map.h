// One period of the semi-discretized cut at one speed and depth: u_(i+1) = P_i u_i + R0_i x_(i-k) + R1_i x_(i-k+1).
// When the meter stops, what is computed is NaN.
// N is the number of states (2 or 4 at compile time, otherwise Eigen::Dynamic), A that of the axes x has (1 or 2).
// Thread: one, with its WorkMeter; not real-time.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "core/milling/stability/regenerative_system.h"
#include "core/milling/stability/work_meter.h"

namespace stillcut::milling {

// phi_0 = exp(Z), phi_1 = (exp(Z) - 1)/Z, phi_2 = (phi_1 - 1)/Z by Taylor series, scaling and doubling.
template <class Matrix>
struct PhiFunctions {
  Matrix phi0, phi1, phi2;

  explicit PhiFunctions(const Matrix& z) {
    const double size = z.cwiseAbs().rowwise().sum().maxCoeff();
    const int halvings = size > 0.7 ? static_cast<int>(std::ceil(std::log2(size / 0.7))) : 0;
    const Matrix small = z * std::ldexp(1.0, -halvings);
    const Matrix one = Matrix::Identity(z.rows(), z.cols());
    constexpr int kTerms = 12;
    phi2 = one / (kTerms + 2.0);
    for (int j = kTerms + 1; j >= 2; --j) {  // Horner on sum Z^j/(j+2)!
      const Matrix t = small * phi2;
      phi2 = (t + one) / j;
    }
    phi1 = one + small * phi2;
    phi0 = one + small * phi1;
    for (int i = 0; i < halvings; ++i) {
      const Matrix square = phi1 * phi1;
      phi2 = 0.25 * (square + 2.0 * phi2);
      const Matrix sum = phi0 + one;
      const Matrix half = 0.5 * (sum * phi1);
      const Matrix whole = phi0 * phi0;
      phi1 = half;
      phi0 = whole;
    }
  }
};

template <int N, int A>
class CellMap {
 public:
  using Real = Eigen::Matrix<double, N, N>;
  using Inject = Eigen::Matrix<double, N, A>;
  using Observe = Eigen::Matrix<double, A, N>;
  using Planar2 = Eigen::Matrix<double, A, A>;
  using Complexes = Eigen::Matrix<std::complex<double>, N, N>;

  CellMap(const RegenerativeSystem& system, Rpm speed, double depth, int cells, int order, WorkMeter& meter)
      : meter_(&meter) {
    const auto n = static_cast<Eigen::Index>(system.states());
    Real free = Real::Zero(n, n);
    Inject in = Inject::Zero(n, A);
    observe_ = Observe::Zero(A, n);
    Observe moving = Observe::Zero(A, n);  // the tip's velocity
    for (Eigen::Index i = 0; i < n / 2; ++i) {
      const auto& o = system.oscillators[static_cast<std::size_t>(i)];
      free(2 * i, 2 * i + 1) = o.omega;
      free(2 * i + 1, 2 * i) = -o.omega;
      free(2 * i + 1, 2 * i + 1) = -2.0 * o.zeta * o.omega;
      for (Eigen::Index a = 0; a < A; ++a) {
        in(2 * i + 1, a) = o.toTip[static_cast<std::size_t>(a)] / (o.mass * o.omega);
        observe_(a, 2 * i) = o.toTip[static_cast<std::size_t>(a)];
        moving(a, 2 * i + 1) = o.toTip[static_cast<std::size_t>(a)] * o.omega;
      }
    }
    const double dt = system.toothPeriod(speed) / cells;
    const PhiFunctions<Real> air(free * dt);
    cells_.reserve(static_cast<std::size_t>(cells));
    const double cube = std::pow(static_cast<double>(n), 3);
    for (int i = 0; i < cells && meter.proceed(100.0 + 60.0 * cube); ++i) {
      const double from = system.toothAngle * i / cells, to = system.toothAngle * (i + 1) / cells;
      const Planar2 force = square(system.mean(from, to));
      Cell cell{!force.isZero(0.0), air.phi0, Inject::Zero(n, A), Inject::Zero(n, A), Planar2::Zero()};
      if (!cell.cutting) {
        cells_.push_back(cell);
        continue;
      }
      const Inject push = depth * in * force;
      Real bound = free - push * observe_;
      if (!system.damping.empty()) {
        const double perSpeed = system.toothPeriod(speed) / system.toothAngle;  // 1/Omega
        bound -= depth * perSpeed * in * square(system.meanDamping(from, to)) * moving;
      }
      const PhiFunctions<Real> phi(bound * dt);
      cell.p = phi.phi0;
      if (order == 0) {
        cell.r1 = 0.5 * dt * phi.phi1 * push;
        cell.r0 = cell.r1;
      } else {
        cell.r1 = dt * phi.phi2 * push;
        cell.r0 = dt * phi.phi1 * push - cell.r1;
      }
      cell.echo = observe_ * cell.r1;
      cells_.push_back(cell);
    }
  }

  static Planar2 square(const Planar& h) {
    Planar2 m;
    for (int r = 0; r < A; ++r) {
      for (int c = 0; c < A; ++c) m(r, c) = h[static_cast<std::size_t>(2 * r + c)];
    }
    return m;
  }

  Eigen::Index states() const { return observe_.cols(); }

  // det(Psi(mu) - mu) times the determinants that make it analytic for mu != 0.
  std::complex<double> characteristic(std::complex<double> mu) const {
    std::complex<double> weight = 1.0;
    Complexes psi = period(mu, Complexes::Identity(states(), states()).eval(), &weight, nullptr);
    psi.diagonal().array() -= mu;
    if constexpr (N == 2) {
      return weight * (psi(0, 0) * psi(1, 1) - psi(0, 1) * psi(1, 0));
    } else {
      return weight * Eigen::PartialPivLU<Complexes>(psi).determinant();
    }
  }

  // Tip motion (x, y interleaved) at the start of every cell for the mode that belongs to mu.
  std::vector<std::complex<double>> tipMotion(std::complex<double> mu) const {
    Complexes psi = period(mu, Complexes::Identity(states(), states()).eval(), nullptr, nullptr);
    psi.diagonal().array() -= mu * (1.0 + 1e-9);
    using Column = Eigen::Matrix<std::complex<double>, N, 1>;
    const Eigen::PartialPivLU<Complexes> lu(psi);
    Column state = Column::Ones(states());
    for (int i = 0; i < 3; ++i) state = lu.solve(state).normalized().eval();
    std::vector<std::complex<double>> motion;
    period(mu, state, nullptr, &motion);
    return motion;
  }

 private:
  struct Cell {
    bool cutting;
    Real p;
    Inject r0, r1;
    Planar2 echo;  // observe * r1
  };

  // Carries the columns of `u` over one period. (I - R1 C/mu) u_(i+1) = (P + R0 C/mu) u_i, the inverse by Woodbury.
  template <class Columns>
  Columns period(std::complex<double> mu, Columns u, std::complex<double>* weight,
                 std::vector<std::complex<double>>* motion) const {
    using Tip = Eigen::Matrix<std::complex<double>, A, Columns::ColsAtCompileTime>;
    const std::complex<double> nu = 1.0 / mu;
    const double effort = 30.0 + 4.0 * static_cast<double>(u.size() * (u.rows() + 4 * A));
    double ahead = 0.0;  // operations that were announced to the meter and that are still to be done
    for (const Cell& cell : cells_) {
      if (ahead <= 0.0) {
        ahead = std::max(effort, 1e6);
        if (!meter_->proceed(ahead)) {
          u.setConstant(std::numeric_limits<double>::quiet_NaN());
          return u;
        }
      }
      ahead -= effort;
      Tip x = observe_ * u;
      if (motion != nullptr) {
        motion->push_back(x(0, 0));
        motion->push_back(A == 2 ? x(A - 1, 0) : 0.0);
      }
      Columns next = cell.p * u;
      if (cell.cutting) {
        x *= nu;
        next.noalias() += cell.r0 * x;
        x = nu * (observe_ * next);
        const std::complex<double> det = solveEcho(cell.echo, nu, x);
        next.noalias() += cell.r1 * x;
        if (weight != nullptr) *weight *= det;
      }
      u = next;
    }
    return u;
  }

  // x <- (I - nu echo)^-1 x; gives the determinant.
  template <class Tip>
  static std::complex<double> solveEcho(const Planar2& echo, std::complex<double> nu, Tip& x) {
    const std::complex<double> a = 1.0 - nu * echo(0, 0);
    if constexpr (A == 1) {
      x *= 1.0 / a;
      return a;
    } else {
      const std::complex<double> b = -nu * echo(0, 1);
      const std::complex<double> c = -nu * echo(1, 0);
      const std::complex<double> d = 1.0 - nu * echo(1, 1);
      const std::complex<double> det = a * d - b * c;
      const Tip y = x * (1.0 / det);
      x.row(0) = d * y.row(0) - b * y.row(1);
      x.row(1) = a * y.row(1) - c * y.row(0);
      return det;
    }
  }

  WorkMeter* meter_;
  Observe observe_;
  std::vector<Cell> cells_;
};

}  // namespace stillcut::milling
