#include "core/active/path_model.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/active/lms.h"

namespace stillcut::active {

std::complex<double> PathModel::response(Hertz frequency, Hertz rate) const {
  const std::complex<double> back = std::polar(1.0, -kTwoPi * frequency.value / rate.value);
  const auto polynomial = [&](const std::vector<double>& c) {
    std::complex<double> sum = 0.0;
    for (std::size_t k = c.size(); k > 0; --k) sum = (sum + c[k - 1]) * back;
    return sum;
  };
  return polynomial(forward) / (1.0 - polynomial(backward)) * std::pow(back, delay);
}

std::vector<double> PathModel::impulse(int samples) const {
  std::vector<double> r(static_cast<std::size_t>(samples), 0.0);
  const auto late = static_cast<std::size_t>(delay);
  for (std::size_t n = 0; n < r.size(); ++n) {
    r[n] = n >= late && n - late < forward.size() ? forward[n - late] : 0.0;
    for (std::size_t k = 0; k < std::min(n, backward.size()); ++k) r[n] += backward[k] * r[n - 1 - k];
  }
  return r;
}

double PathModel::largestPole() const {
  if (backward.empty()) return 0.0;
  const auto n = static_cast<Eigen::Index>(backward.size());
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k) companion(0, k) = backward[static_cast<std::size_t>(k)];
  companion.diagonal(-1).setOnes();
  if (!companion.allFinite()) return HUGE_VAL;
  return Eigen::EigenSolver<Eigen::MatrixXd>(companion, false).eigenvalues().cwiseAbs().maxCoeff();
}

int leadingDelay(const PathModel& model) {
  constexpr double kHeard = 0.01;  // of the energy
  const std::vector<double> impulse = model.impulse(model.delay + 4 * kMostTaps);
  double whole = 0.0;
  for (const double r : impulse) whole += r * r;
  double come = 0.0;
  std::size_t n = 0;
  while (n + 1 < impulse.size() && (come += impulse[n] * impulse[n]) < kHeard * whole) ++n;
  return static_cast<int>(n) + 1;
}

Status checkPath(const PathModel& model, const std::string& where) {
  const auto finite = [](const std::vector<double>& c) {
    return std::all_of(c.begin(), c.end(), [](double v) { return std::isfinite(v); });
  };
  if (model.empty())
    return Error{where, message("no model of the path from actuator to sensor"), message("identify it first")};
  if (model.forward.size() > kMostTaps || model.backward.size() > kMostTaps) {
    return Error{where, message("the path's model has more than %1 taps", std::to_string(kMostTaps))};
  }
  if (model.delay < 0 || model.delay > kMostDelay) {
    return Error{where, message("the path's model is delayed by more than %1 samples", std::to_string(kMostDelay))};
  }
  if (!finite(model.forward) || !finite(model.backward)) {
    return Error{where, message("the path's model holds a number that is not finite")};
  }
  if (std::all_of(model.forward.begin(), model.forward.end(), [](double v) { return v == 0.0; })) {
    return Error{where, message("the path's model says that the actuator does nothing")};
  }
  if (model.largestPole() >= 1.0)
    return Error{where, message("the path's model is unstable"), message("identify it again")};
  return Done{};
}

double phaseError(const PathModel& model, std::complex<double> measured, Hertz frequency, Hertz rate) {
  return std::arg(model.response(frequency, rate) / measured);
}

}  // namespace stillcut::active
