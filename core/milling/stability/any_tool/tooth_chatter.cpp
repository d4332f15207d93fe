#include "core/milling/stability/any_tool/tooth_chatter.h"

#include <Eigen/Dense>
#include <bit>
#include <cmath>

#include "core/milling/stability/dominant_line.h"

namespace stillcut::milling {

Hertz toothChatter(const RegenerativeSystem& system, const TransitionMatrix& transition, double angle, double depth,
                   WorkMeter& meter) {
  const int n = transition.states();
  const Complex mu = std::polar(1.0, angle);
  const Complex s = depth * (1.0 - std::conj(mu));
  Eigen::MatrixXcd psi(n, n);
  if (!transition.evaluate(std::span(&s, 1), std::span(psi.data(), static_cast<std::size_t>(psi.size())), meter)) {
    return Hertz(0.0);
  }
  psi.diagonal().array() -= mu * (1.0 + 1e-9);
  const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(psi);
  Eigen::VectorXcd state = Eigen::VectorXcd::Ones(n);
  for (int i = 0; i < 3; ++i) state = lu.solve(state).normalized();
  if (!state.allFinite()) return Hertz(0.0);

  const double period = transition.toothPeriod();
  const int lines = 2 + static_cast<int>(1.5 * system.highestOmega() / kTwoPi * period);
  const auto samples = static_cast<int>(std::bit_ceil(32U * static_cast<unsigned>(lines)));
  const auto motion = transition.tipMotion(s, std::span(state.data(), static_cast<std::size_t>(n)), samples, meter);
  return dominantLine(motion, angle, period, lines, meter);
}

}  // namespace stillcut::milling
