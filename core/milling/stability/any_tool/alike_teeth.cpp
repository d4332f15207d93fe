#include "core/milling/stability/any_tool/alike_teeth.h"

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "core/milling/stability/any_tool/tooth_chatter.h"
#include "core/milling/stability/transition_matrix.h"

namespace stillcut::milling {

namespace {

constexpr double kRoughPhase = 1.0;
constexpr double kFinePhase = 0.4;

}  // namespace

AlikeTeeth::AlikeTeeth(const CutModel& model, Rpm speed)
    : model_(model), speed_(speed), straight_(systemAt(model, Metres(0.0))), states_(straight_.states()) {}

bool AlikeTeeth::sample(double depth, std::span<const double> angles, Fineness fineness,
                        std::span<std::complex<double>> out, WorkMeter& meter) const {
  const RegenerativeSystem system = systemAt(model_, Metres(depth));
  const double phase = fineness == Fineness::Rough ? kRoughPhase : kFinePhase;
  const TransitionMatrix transition(system, speed_, 2.0 * depth, phase, meter);
  const auto n = static_cast<std::size_t>(states_);
  std::vector<Complex> s;
  for (double angle : angles) s.push_back(depth * (1.0 - std::polar(1.0, -angle)));
  std::vector<Complex> psi(s.size() * n * n);
  if (meter.stopped() || !transition.evaluate(s, psi, meter)) return false;
  if (!meter.proceed(8.0 * static_cast<double>(n * n * n * s.size()))) return false;
  for (std::size_t i = 0; i < s.size(); ++i) {
    Eigen::MatrixXcd m = Eigen::Map<Eigen::MatrixXcd>(psi.data() + i * n * n, states_, states_);
    m.diagonal().array() -= std::polar(1.0, angles[i]);
    out[i] = n == 2 ? m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0) : m.partialPivLu().determinant();
  }
  return true;
}

Hertz AlikeTeeth::chatterFrequency(double angle, double depth, WorkMeter& meter) const {
  const RegenerativeSystem system = systemAt(model_, Metres(depth));
  const TransitionMatrix transition(system, speed_, 2.0 * depth, kRoughPhase, meter);
  return toothChatter(system, transition, angle, depth, meter);
}

// From the imaginary part of the stiffened natural frequency, over the time in the cut.
double AlikeTeeth::growthAt(double depth) const {
  double fastest = 0.0;
  for (const auto& o : straight_.oscillators) {
    fastest = std::max(fastest, std::sqrt(Complex(o.omega * o.omega, depth * straight_.stiffening())).imag());
  }
  return fastest * straight_.toothPeriod(speed_);
}

}  // namespace stillcut::milling
