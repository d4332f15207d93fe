#include "core/detect/caliskan/full_harmonic_kalman.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr double kSameAngle = 1e-9;     // rad; the sums of angles differ by roundings
constexpr std::size_t kRefresh = 4096;  // frames after which the regressors are made anew, for their roundings

}  // namespace

void FullHarmonicKalman::prepare(int channels, int harmonics, const dsp::kernels::Kernels& kernels) {
  kernels_ = kernels;
  channels_ = static_cast<std::size_t>(channels);
  harmonics_ = harmonics;
  lanes_ = dsp::kernels::wholeLanes(static_cast<std::size_t>(std::max(harmonics, 1)));
  p_.assign(4 * lanes_ * lanes_, 0.0);
  for (auto* v : {&ph_, &h_, &drift_}) v->assign(2 * lanes_, 0.0);
  for (auto* v : {&rotationRe_, &rotationIm_}) v->assign(lanes_, 0.0);
  states_.assign(2 * lanes_ * channels_, 0.0);
  scratch_.assign(4 * lanes_, 0.0);
  active_ = 0;
  step_ = 0.0;
  setActive(harmonics);
}

// P starts at I, as wide as R: nothing is known.
void FullHarmonicKalman::reset() {
  std::fill(states_.begin(), states_.end(), 0.0);
  std::fill(p_.begin(), p_.end(), 0.0);
  const auto n = static_cast<std::size_t>(active_);
  for (std::size_t i = 0; i < 2 * lanes_; ++i) {
    if (i % lanes_ < n) p_[i * 2 * lanes_ + i] = 1.0;
  }
  turned_ = kRefresh;
}

void FullHarmonicKalman::setActive(int count) {
  const int clamped = std::clamp(count, 0, harmonics_);
  if (clamped == active_) return;
  active_ = clamped;
  setLambda(lambda_);
  kernels_.powers(std::cos(step_), std::sin(step_), static_cast<std::size_t>(active_), rotationRe_.data(),
                  rotationIm_.data());
  for (std::size_t i = static_cast<std::size_t>(active_); i < lanes_; ++i) {
    rotationRe_[i] = rotationIm_[i] = h_[i] = h_[lanes_ + i] = 0.0;
  }
  reset();
}

void FullHarmonicKalman::setLambda(double lambda) {
  lambda_ = lambda;
  for (std::size_t i = 0; i < 2 * lanes_; ++i)
    drift_[i] = i % lanes_ < static_cast<std::size_t>(active_) ? lambda : 0.0;
}

void FullHarmonicKalman::align(double angle, double step) {
  const auto n = static_cast<std::size_t>(active_);
  if (turned_ >= kRefresh || std::abs(dsp::wrapPhase(angle - angle_)) > kSameAngle) {
    kernels_.powers(std::cos(angle), std::sin(angle), n, h_.data(), h_.data() + lanes_);
    kernels_.covarianceTimes(run());
    turned_ = 0;
  }
  angle_ = angle;
  if (step == step_) return;
  step_ = step;
  kernels_.powers(std::cos(step), std::sin(step), n, rotationRe_.data(), rotationIm_.data());
}

dsp::kernels::CovarianceRun FullHarmonicKalman::run() {
  dsp::kernels::CovarianceRun run;
  run.channels = channels_;
  run.lanes = lanes_;
  run.p = p_.data();
  run.ph = ph_.data();
  run.h = h_.data();
  run.rotationRe = rotationRe_.data();
  run.rotationIm = rotationIm_.data();
  run.drift = drift_.data();
  run.states = states_.data();
  run.scratch = scratch_.data();
  return run;
}

void FullHarmonicKalman::process(const double* x, std::ptrdiff_t stride, double* residual,
                                 std::ptrdiff_t residualStride, std::size_t frames) {
  dsp::kernels::CovarianceRun now = run();
  now.x = x;
  now.stride = stride;
  now.residual = residual;
  now.residualStride = residualStride;
  now.frames = frames;
  kernels_.covariance(now);
  turned_ += frames;
  angle_ = dsp::wrapPhase(angle_ + static_cast<double>(frames) * step_);
  if (frames == 0) return;
  double newest = 0.0;
  for (std::size_t c = 0; c < channels_; ++c) {
    newest += residual[static_cast<std::ptrdiff_t>(c) * residualStride + static_cast<std::ptrdiff_t>(frames) - 1];
  }
  if (std::isfinite(newest)) return;
  for (std::size_t c = 0; c < channels_; ++c)
    std::fill_n(residual + static_cast<std::ptrdiff_t>(c) * residualStride, frames, 0.0);
  reset();
}

double FullHarmonicKalman::power(int channel, int n) const {
  const double* state = states_.data() + static_cast<std::size_t>(channel) * 2 * lanes_ + n - 1;
  return state[0] * state[0] + state[lanes_] * state[lanes_];
}

void FullHarmonicKalman::amplitudes(int channel, std::span<std::complex<double>> out) const {
  const double* state = states_.data() + static_cast<std::size_t>(channel) * 2 * lanes_;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = {state[i], -state[lanes_ + i]};
}

double FullHarmonicKalman::weightedPower(int channel, const double* weight) const {
  const double* state = states_.data() + static_cast<std::size_t>(channel) * 2 * lanes_;
  return kernels_.weightedPower(state, state + lanes_, weight, lanes_);
}

}  // namespace stillcut::detect
