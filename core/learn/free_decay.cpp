#include "core/learn/free_decay.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace stillcut::learn {
namespace {

using Complex = std::complex<double>;

constexpr int kHankel = 50;         // rows and columns
constexpr double kPerPeriod = 3.0;  // samples kept in a period of the highest frequency
constexpr int kLeastOrder = 4;
constexpr int kMostOrder = 16;

// Third-order interpolation between samples; `at` lies inside.
double between(std::span<const double> x, double at) {
  const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(at), 1, x.size() - 3);
  const double t = at - static_cast<double>(i);
  return x[i - 1] * (-t * (t - 1.0) * (t - 2.0) / 6.0) + x[i] * ((t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0) +
         x[i + 1] * (-(t + 1.0) * t * (t - 2.0) / 2.0) + x[i + 2] * ((t + 1.0) * t * (t - 1.0) / 6.0);
}

// Each sample less the mean of the same angle in the revolutions before and after it.
std::vector<double> withoutTurning(std::span<const double> x, double samplesPerTurn, int turns) {
  const auto reach = static_cast<std::size_t>(0.5 * turns * samplesPerTurn) + 3;
  std::vector<double> rest;
  if (x.size() <= 2 * reach) return rest;
  rest.reserve(x.size() - 2 * reach);
  for (std::size_t i = reach; i + reach < x.size(); ++i) {
    double mean = 0.0;
    for (int k = 1; k <= turns / 2; ++k) {
      mean += between(x, static_cast<double>(i) - k * samplesPerTurn);
      mean += between(x, static_cast<double>(i) + k * samplesPerTurn);
    }
    rest.push_back(x[i] - mean / (2 * (turns / 2)));
  }
  return rest;
}

// Low-passed at `top` and every `step`-th sample kept.
std::vector<double> thinned(const std::vector<double>& x, double rate, double top, std::size_t step) {
  const auto half = static_cast<std::size_t>(4.0 * rate / top);
  std::vector<double> filter(2 * half + 1);
  double sum = 0.0;
  for (std::size_t i = 0; i < filter.size(); ++i) {
    const double t = static_cast<double>(i) - static_cast<double>(half);
    const double phase = kTwoPi * 1.1 * top / rate * t;
    const double window = 0.5 + 0.5 * std::cos(kTwoPi * t / (2.0 * static_cast<double>(half) + 2.0));
    sum += filter[i] = (t == 0.0 ? 1.0 : std::sin(phase) / phase) * window;
  }
  std::vector<double> out;
  for (std::size_t i = half; i + half < x.size(); i += step) {
    double y = 0.0;
    for (std::size_t k = 0; k < filter.size(); ++k) y += filter[k] * x[i + k - half];
    out.push_back(y / sum);
  }
  return out;
}

std::vector<double> autocovariance(std::span<const double> x) {
  std::vector<double> r(2 * kHankel + 1, 0.0);
  if (x.size() <= r.size()) return r;
  for (std::size_t lag = 0; lag < r.size(); ++lag) {
    for (std::size_t i = lag; i < x.size(); ++i) r[lag] += x[i] * x[i - lag];
    r[lag] /= static_cast<double>(x.size() - lag);
  }
  return r;
}

struct Pole {
  double frequency = 0.0, rate = 0.0, size = 0.0;
};

// The Hankel matrix of an autocovariance is symmetric: its eigenvectors are its singular vectors, but for signs.
class Realization {
 public:
  Realization(const std::vector<double>& r, double step_s) : step_s_(step_s) {
    Eigen::MatrixXd now(kHankel, kHankel);
    next_.resize(kHankel, kHankel);
    for (int i = 0; i < kHankel; ++i) {
      for (int k = 0; k < kHankel; ++k) {
        now(i, k) = r[static_cast<std::size_t>(i + k + 1)];
        next_(i, k) = r[static_cast<std::size_t>(std::min(i + k + 2, 2 * kHankel))];
      }
    }
    solver_.compute(now);
    for (int i = 0; i < kHankel; ++i) order_.push_back(i);
    std::ranges::sort(order_, {}, [this](int i) { return -std::abs(solver_.eigenvalues()(i)); });
  }

  // The largest pole of that order in the band; size 0: none.
  Pole largest(int order, const DecayParams& params) const {
    const double largest = std::abs(solver_.eigenvalues()(order_.front()));
    Eigen::MatrixXd u(kHankel, order);
    Eigen::MatrixXd v(kHankel, order);
    for (int k = 0; k < order; ++k) {
      const int i = order_[static_cast<std::size_t>(k)];
      const double value = solver_.eigenvalues()(i);
      const double root = std::sqrt(std::abs(value));
      if (!(std::abs(value) > 1e-12 * largest)) return {};
      u.col(k) = solver_.eigenvectors().col(i) / root;
      v.col(k) = std::copysign(1.0, value) * u.col(k);
    }
    const Eigen::EigenSolver<Eigen::MatrixXd> poles(u.transpose() * next_ * v);
    const Eigen::MatrixXcd shapes = poles.eigenvectors();
    // First row and column of the balanced factors of the Hankel matrix.
    Eigen::VectorXcd input(order);
    Eigen::RowVectorXcd output(order);
    for (int k = 0; k < order; ++k) {
      const double size = std::abs(solver_.eigenvalues()(order_[static_cast<std::size_t>(k)]));
      input(k) = size * v(0, k);
      output(k) = size * u(0, k);
    }
    const Eigen::VectorXcd start = shapes.partialPivLu().solve(input);
    const Eigen::RowVectorXcd seen = output * shapes;
    Pole best;
    for (int i = 0; i < order; ++i) {
      const Complex lambda = std::log(poles.eigenvalues()(i)) / step_s_;
      const Pole p{lambda.imag() / kTwoPi, -lambda.real(), std::abs(seen(i) * start(i))};
      const bool inside = p.frequency > params.lowest.value && p.frequency < params.highest.value;
      if (inside && p.rate > 0.0 && p.rate < 0.2 * lambda.imag() && p.size > best.size) best = p;
    }
    return best;
  }

 private:
  double step_s_;
  Eigen::MatrixXd next_;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver_;
  std::vector<int> order_;
};

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// The pole that most orders agree on.
Pole agreed(const std::vector<double>& r, double step_s, const DecayParams& params) {
  const Realization realization(r, step_s);
  std::vector<double> frequencies, rates;
  for (int order = kLeastOrder; order <= kMostOrder; order += 2) {
    const Pole p = realization.largest(order, params);
    if (p.size == 0.0) continue;
    frequencies.push_back(p.frequency);
    rates.push_back(p.rate);
  }
  if (frequencies.size() < 4) return {};
  const double middle = medianOf(frequencies);
  std::vector<double> near;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (std::abs(frequencies[i] - middle) < 0.03 * middle) near.push_back(rates[i]);
  }
  if (2 * near.size() <= frequencies.size()) return {};
  return {middle, medianOf(near), 1.0};
}

DecayAnswer silent(Message why) {
  return {std::nullopt, std::move(why)};
}

}  // namespace

DecayAnswer freeDecay(std::span<const double> samples, Hertz rate, Rpm spindle, const DecayParams& params) {
  if (!(spindle.value > 0.0) || !(rate.value > 2.5 * params.highest.value)) {
    return silent(message("the speed is not known or the sampling rate too low"));
  }
  if (static_cast<double>(samples.size()) < params.shortest_s * rate.value) {
    return silent(message("the steady cut is too short"));
  }
  const std::vector<double> rest = withoutTurning(samples, 60.0 * rate.value / spindle.value, params.turnsAveraged);
  const auto step = static_cast<std::size_t>(std::max(1.0, rate.value / (kPerPeriod * params.highest.value)));
  const std::vector<double> thin = thinned(rest, rate.value, params.highest.value, step);
  const auto part = thin.size() / static_cast<std::size_t>(params.parts);
  if (part < static_cast<std::size_t>(6 * kHankel)) return silent(message("the steady cut is too short"));
  std::vector<std::vector<double>> covariances;
  std::vector<double> sum(2 * kHankel + 1, 0.0);
  for (std::size_t p = 0; p < static_cast<std::size_t>(params.parts); ++p) {
    covariances.push_back(autocovariance(std::span(thin).subspan(p * part, part)));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += covariances.back()[i];
  }
  const double step_s = static_cast<double>(step) / rate.value;
  const Pole whole = agreed(sum, step_s, params);
  if (whole.size == 0.0) return silent(message("no free vibration stands out of the noise"));
  // Jackknife.
  double rates = 0.0;
  double frequencies = 0.0;
  for (const std::vector<double>& left : covariances) {
    std::vector<double> others = sum;
    for (std::size_t i = 0; i < others.size(); ++i) others[i] -= left[i];
    const Pole p = agreed(others, step_s, params);
    if (p.size == 0.0 || std::abs(p.frequency - whole.frequency) > 0.05 * whole.frequency) {
      return silent(message("the free vibration is not the same throughout the cut"));
    }
    rates += (p.rate - whole.rate) * (p.rate - whole.rate);
    frequencies += (p.frequency - whole.frequency) * (p.frequency - whole.frequency);
  }
  const double spread = (params.parts - 1.0) / params.parts;
  FreeDecay decay;
  decay.frequency = Hertz(whole.frequency);
  decay.frequencySd = Hertz(std::sqrt(spread * frequencies));
  decay.rate = whole.rate;
  decay.rateSd = std::sqrt(spread * rates);
  if (decay.rateSd > params.mostDoubt * decay.rate) return silent(message("its decay is too uncertain"));
  return {decay, {}};
}

DecayAnswer slowestDecay(std::span<const std::vector<double>> channels, Hertz rate, Rpm spindle,
                         const DecayParams& params) {
  constexpr double kHeard = 2.6;  // samples in a period of the highest frequency, at least
  DecayParams within = params;
  within.highest = Hertz(std::min(params.highest.value, rate.value / kHeard));
  DecayAnswer slowest;
  for (const std::vector<double>& channel : channels) {
    DecayAnswer now = freeDecay(channel, rate, spindle, within);
    const bool better = now.decay && (!slowest.decay || now.decay->rate < slowest.decay->rate);
    if (better || (!slowest.decay && slowest.why.empty())) slowest = std::move(now);
  }
  return slowest;
}

}  // namespace stillcut::learn
