#include "core/learn/stable_margin.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace stillcut::learn {
namespace {

using Complex = std::complex<double>;

// What a foretold decay is off by besides the measurement: the mean force for the periodic one, and the free damping.
constexpr double kModelSd = 0.20;
constexpr double kFrequencySd = 0.03;
constexpr double kLeastGuesses = 0.01;  // fraction of equal weights that must agree with the measurement,
constexpr double kAgrees = 9.0;         // ... to three standard deviations, squared
constexpr double kWidest = 2.5;         // limit at 90 % over that at 10 %, above which nothing is said

// det(I + d (1 - exp(-lambda tau)) H0 G(lambda)): 0 where the cut vibrates freely.
class Characteristic {
 public:
  Characteristic(const Dynamics& machine, const ForceShape& shape, double period) : machine_(machine), period_(period) {
    for (std::size_t i = 0; i < h_.size(); ++i) {
      h_[i] = machine.tangential * (shape.tangential[i] + machine.radialRatio * shape.radial[i]);
    }
  }

  Complex at(Complex lambda, double depth) const {
    Complex xx, xy, yy;
    for (const milling::Mode& m : machine_.modes) {
      const double w = kTwoPi * m.frequency.value;
      const Complex g = w * w / m.stiffness / (lambda * lambda + 2.0 * m.damping * w * lambda + w * w);
      xx += g * (m.direction[0] * m.direction[0]);
      xy += g * (m.direction[0] * m.direction[1]);
      yy += g * (m.direction[1] * m.direction[1]);
    }
    const Complex s = depth * (1.0 - std::exp(-lambda * period_));
    const Complex a = 1.0 + s * (h_[0] * xx + h_[1] * xy);
    const Complex b = s * (h_[0] * xy + h_[1] * yy);
    const Complex c = s * (h_[2] * xx + h_[3] * xy);
    const Complex d = 1.0 + s * (h_[2] * xy + h_[3] * yy);
    return a * d - b * c;
  }

  // Newton; false where it does not settle near where it began.
  bool settle(Complex& lambda, double depth) const {
    const Complex begun = lambda;
    for (int i = 0; i < 12; ++i) {
      const Complex value = at(lambda, depth);
      const double h = 1e-5 * std::abs(lambda);
      const Complex slope = (at(lambda + h, depth) - value) / h;
      if (std::abs(slope) == 0.0) return false;
      const Complex by = value / slope;
      lambda -= by;
      if (std::abs(by) < 1e-7 * std::abs(lambda)) return std::abs(lambda - begun) < 0.2 * std::abs(begun);
    }
    return false;
  }

 private:
  const Dynamics& machine_;
  double period_;
  milling::Planar h_{};
};

struct Weighted {
  double limit = 0.0;
  double weight = 0.0;
};

double quantile(const std::vector<Weighted>& sorted, double share) {
  double total = 0.0;
  for (const Weighted& w : sorted) total += w.weight;
  double reached = 0.0;
  for (const Weighted& w : sorted) {
    reached += w.weight;
    if (reached >= share * total) return w.limit;
  }
  return sorted.back().limit;
}

}  // namespace

FreeDecay foretoldDecay(const Dynamics& machine, const ForceShape& shape, int teeth, Rpm speed, Metres depth,
                        const LimitPoint& limit) {
  const double deepest = std::exp(static_cast<double>(limit.logDepth));
  if (!(limit.frequency > 0.0F) || depth.value >= deepest) return {};
  const Characteristic characteristic(machine, shape, 60.0 / (speed.value * teeth));
  Complex lambda(0.0, kTwoPi * limit.frequency);
  constexpr int kSteps = 10;
  for (int i = 0; i <= kSteps; ++i) {
    const double now = deepest * std::pow(depth.value / deepest, static_cast<double>(i) / kSteps);
    if (!characteristic.settle(lambda, now)) return {};
  }
  FreeDecay decay;
  decay.frequency = Hertz(lambda.imag() / kTwoPi);
  decay.rate = std::max(0.0, -lambda.real());
  return decay;
}

MarginAnswer stableMargin(LobePosterior& posterior, const StableCut& cut, const FreeDecay& measured) {
  const std::size_t shape = posterior.shapeOf(cut.engagement, cut.teeth);
  const GuessCloud& guesses = posterior.guesses();
  std::vector<Weighted> agree;
  double sum = 0.0;
  double squares = 0.0;
  double near = 0.0;
  for (std::size_t i = 0; i < guesses.size(); ++i) {
    const LimitPoint limit = limitAt(guesses[i].limits[shape], posterior.grid(), cut.speed.value);
    const FreeDecay told =
        foretoldDecay(guesses.machine(i), posterior.shape(shape).force, cut.teeth, cut.speed, cut.depth, limit);
    if (!(told.rate > 0.0)) continue;
    const double rateSd = std::hypot(measured.rateSd, kModelSd * told.rate);
    const double off = (told.rate - measured.rate) / rateSd;
    const double astray = std::log(told.frequency / measured.frequency) /
                          std::hypot(kFrequencySd, measured.frequencySd / measured.frequency);
    const double weight = guesses.weights()[i] * std::exp(-0.5 * (off * off + astray * astray)) / rateSd;
    if (off * off + astray * astray < kAgrees) near += guesses.weights()[i];
    agree.push_back({std::exp(static_cast<double>(limit.logDepth)), weight});
    sum += weight;
    squares += weight * weight;
  }
  const auto count = static_cast<double>(guesses.size());
  if (!(sum > 0.0) || near < kLeastGuesses || sum * sum / squares < kLeastGuesses * count) {
    return {std::nullopt, message("its decay fits nothing that was learned so far")};
  }
  std::ranges::sort(agree, {}, &Weighted::limit);
  const double low = quantile(agree, 0.1);
  const double high = quantile(agree, 0.9);
  if (high > kWidest * low) return {std::nullopt, message("too little is known of this tool")};
  const double depth = cut.depth.value;
  return {StableMargin{Metres(quantile(agree, 0.5) - depth), Metres(low - depth), Metres(high - depth)}, {}};
}

}  // namespace stillcut::learn
