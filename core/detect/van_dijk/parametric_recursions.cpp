#include "core/detect/van_dijk/parametric_recursions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stillcut::detect {

void ParametricRecursions::prepare(int channels, int harmonics, const Noise& noise,
                                   const dsp::kernels::Kernels& kernels) {
  kernels_ = kernels;
  noise_ = noise;
  harmonics_.prepare(channels, harmonics, kernels);
  ar_.assign(static_cast<std::size_t>(channels), {});
  reset();
}

void ParametricRecursions::reset() {
  harmonics_.reset();
  for (auto& ar : ar_) restart(ar);
}

void ParametricRecursions::restart(dsp::kernels::ArState& ar) const {
  ar = {};
  for (std::size_t i = 0; i < kArOrder; ++i) ar.p[i * (kArOrder + 1)] = noise_.startVariance;
}

void ParametricRecursions::tune(int active, double mu, double lambda) {
  harmonics_.setActive(active);
  harmonics_.setGain(2.0 * mu / std::max(harmonics_.active(), 1), lambda);
}

void ParametricRecursions::process(int channel, const double* x, double* rest, std::size_t frames, double scale,
                                   ArCoefficients& thetaSum) {
  auto& ar = ar_[static_cast<std::size_t>(channel)];
  const ArCoefficients before = thetaSum;
  kernels_.parametric(
      {harmonics_.run(channel, x, rest, frames, 1.0), scale, noise_.rv, noise_.rw, &ar, thetaSum.data()});
  const bool sound = harmonics_.finished(channel, rest, frames);
  if (sound && std::isfinite(std::accumulate(std::begin(ar.p), std::end(ar.p), thetaSum[0] + ar.past[0]))) return;
  restart(ar);
  thetaSum = before;
}

ArCoefficients ParametricRecursions::theta(int channel) const {
  ArCoefficients theta{};
  std::copy_n(ar_[static_cast<std::size_t>(channel)].theta, kArOrder, theta.begin());
  return theta;
}

void ParametricRecursions::setTheta(int channel, const ArCoefficients& theta) {
  std::copy(theta.begin(), theta.end(), ar_[static_cast<std::size_t>(channel)].theta);
}

}  // namespace stillcut::detect
