#include "core/milling/identify/modal_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>

namespace stillcut::identify {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr Complex kI(0.0, 1.0);

void setColumn(MatrixXd& m, Index column, const VectorXcd& v) {
  m.col(column).head(v.size()) = v.real();
  m.col(column).tail(v.size()) = v.imag();
}

VectorXd stacked(const VectorXcd& v) {
  VectorXd out(2 * v.size());
  out << v.real(), v.imag();
  return out;
}

struct ModeShape {
  VectorXcd u;  // i f / f_r
  VectorXcd g;  // 1 / (1 - u^2 + 2 i z u)
};

ModeShape shapeOf(const ModalLines& lines, const ModalPole& pole) {
  ModeShape shape;
  const VectorXd u = lines.frequency / pole.frequency;
  shape.u = u.cast<Complex>() * kI;
  shape.g = (1.0 - u.array().square() + 2.0 * pole.damping * u.array().cast<Complex>() * kI).inverse().matrix();
  return shape;
}

// Columns of the linear problem, in units of the largest measured value so that all are of order one.
MatrixXd columnsOf(const ModalLines& lines, const std::vector<ModalPole>& poles, ModalConstants kind) {
  const Index perMode = kind == ModalConstants::Complex ? 2 : 1;
  const Index modes = static_cast<Index>(poles.size());
  const Index n = lines.frequency.size();
  MatrixXd columns(2 * n, perMode * modes + 4);
  for (Index i = 0; i < modes; ++i) {
    const ModeShape shape = shapeOf(lines, poles[static_cast<std::size_t>(i)]);
    setColumn(columns, perMode * i, shape.g);
    if (perMode == 2) setColumn(columns, perMode * i + 1, shape.u.cwiseProduct(shape.g));
  }
  const double middle = 0.5 * (lines.from + lines.to);
  const VectorXcd one = VectorXcd::Ones(n);
  const VectorXcd mass = (middle / lines.frequency.array()).square().matrix().cast<Complex>();
  const Index at = perMode * modes;
  setColumn(columns, at, one);
  setColumn(columns, at + 1, kI * one);
  setColumn(columns, at + 2, -mass);
  setColumn(columns, at + 3, -kI * mass);
  return columns;
}

// d model / d (ln f_r, ln z_r) for fixed constants.
MatrixXd poleJacobian(const ModalLines& lines, const std::vector<ModalPole>& poles, const VectorXd& constants) {
  const Index modes = static_cast<Index>(poles.size());
  MatrixXd jacobian(2 * lines.frequency.size(), 2 * modes);
  for (Index i = 0; i < modes; ++i) {
    const ModalPole& pole = poles[static_cast<std::size_t>(i)];
    const auto [iu, g] = shapeOf(lines, pole);
    const double a = constants[2 * i];
    const double b = constants[2 * i + 1];
    // D = 1 + (iu)^2 + 2 z iu;  dD/dln f = -2 (iu)^2 - 2 z iu;  dD/dln z = 2 z iu;  d(iu)/dln f = -iu.
    const auto u = iu.array();
    const auto numerator = (a + b * u).eval();
    const auto g2 = g.array().square().eval();
    const VectorXcd byFrequency = (numerator * g2 * (2.0 * u.square() + 2.0 * pole.damping * u) - b * u * g.array());
    const VectorXcd byDamping = (-numerator * g2 * (2.0 * pole.damping * u));
    setColumn(jacobian, 2 * i, byFrequency);
    setColumn(jacobian, 2 * i + 1, byDamping);
  }
  return jacobian;
}

struct Solved {
  VectorXd constants;
  VectorXd residual;  // model - measured
  MatrixXd basis;     // orthonormal, of the columns
};

Solved solve(const MatrixXd& columns, const VectorXd& measured) {
  Solved out;
  const Eigen::HouseholderQR<MatrixXd> qr(columns);
  out.basis = qr.householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
  const VectorXd inside = out.basis.transpose() * measured;
  out.constants = qr.matrixQR().topRows(columns.cols()).triangularView<Eigen::Upper>().solve(inside);
  out.residual = out.basis * inside - measured;
  return out;
}

std::vector<ModalPole> stepped(const std::vector<ModalPole>& poles, const VectorXd& step) {
  std::vector<ModalPole> out = poles;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Index k = 2 * static_cast<Index>(i);
    out[i].frequency *= std::exp(std::clamp(step[k], -0.03, 0.03));
    out[i].damping = std::clamp(out[i].damping * std::exp(std::clamp(step[k + 1], -0.7, 0.7)), 1e-5, 0.5);
  }
  return out;
}

}  // namespace

ConstantsFit fitConstants(const ModalLines& lines, const std::vector<ModalPole>& poles, ModalConstants kind) {
  const double scale = lines.value.cwiseAbs().maxCoeff();
  const VectorXd measured = stacked(lines.value / scale);
  const MatrixXd columns = columnsOf(lines, poles, kind);
  const Solved solved = solve(columns, measured);
  ConstantsFit fit;
  fit.constants = scale * solved.constants;
  fit.misfit = solved.residual.norm() / measured.norm();
  const VectorXd model = scale * (solved.residual + measured);
  const Index n = lines.value.size();
  fit.fitted = model.head(n).cast<Complex>() + kI * model.tail(n).cast<Complex>();
  return fit;
}

double refinePoles(const ModalLines& lines, std::vector<ModalPole>& poles, int iterations) {
  const VectorXd measured = stacked(lines.value / lines.value.cwiseAbs().maxCoeff());
  const double norm = measured.norm();
  Solved now = solve(columnsOf(lines, poles, ModalConstants::Complex), measured);
  double misfit = now.residual.norm() / norm;
  double damping = 1e-3;
  for (int k = 0; k < iterations; ++k) {
    MatrixXd jacobian = poleJacobian(lines, poles, now.constants);
    jacobian -= now.basis * (now.basis.transpose() * jacobian).eval();
    MatrixXd normal = jacobian.transpose() * jacobian;
    const VectorXd gradient = jacobian.transpose() * now.residual;
    const double before = misfit;
    for (int attempt = 0; attempt < 8; ++attempt) {
      MatrixXd damped = normal;
      damped.diagonal() *= 1.0 + damping;
      damped.diagonal().array() += 1e-14 * normal.diagonal().maxCoeff();
      const VectorXd step = -damped.ldlt().solve(gradient);
      if (!step.allFinite()) break;
      std::vector<ModalPole> trial = stepped(poles, step);
      Solved next = solve(columnsOf(lines, trial, ModalConstants::Complex), measured);
      const double reached = next.residual.norm() / norm;
      if (reached < misfit) {
        poles = std::move(trial);
        now = std::move(next);
        misfit = reached;
        damping = std::max(damping * 0.2, 1e-9);
        break;
      }
      damping *= 6.0;
    }
    if (misfit > before * (1.0 - 1e-5)) break;
  }
  return misfit;
}

Eigen::MatrixX3d relativeDeviations(const ModalLines& lines, const std::vector<ModalPole>& poles) {
  const double scale = lines.value.cwiseAbs().maxCoeff();
  const VectorXd measured = stacked(lines.value / scale);
  const MatrixXd columns = columnsOf(lines, poles, ModalConstants::Complex);
  const Solved solved = solve(columns, measured);
  const Index modes = static_cast<Index>(poles.size());
  MatrixXd all(columns.rows(), columns.cols() + 2 * modes);
  all << columns, poleJacobian(lines, poles, solved.constants);
  const double freedom = std::max<double>(1.0, static_cast<double>(all.rows() - all.cols()));
  const double variance = solved.residual.squaredNorm() / freedom;
  const MatrixXd covariance = variance * (all.transpose() * all).completeOrthogonalDecomposition().pseudoInverse();
  Eigen::MatrixX3d out(modes, 3);
  for (Index i = 0; i < modes; ++i) {
    const Index pole = columns.cols() + 2 * i;
    const auto deviation = [&](Index k) { return std::sqrt(std::max(0.0, covariance(k, k))); };
    out(i, 0) = deviation(pole);
    out(i, 1) = deviation(pole + 1);
    out(i, 2) = deviation(2 * i) / std::abs(solved.constants[2 * i]);
  }
  return out;
}

}  // namespace stillcut::identify
