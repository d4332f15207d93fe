#include "core/detect/harmonic_kalman.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr double kSameAngle = 1e-9;  // rad; the sums of angles differ by roundings

}  // namespace

double harmonicGain(double lambda, int harmonics) noexcept {
  const double n = harmonics;
  const double p = lambda * n + std::sqrt(lambda * lambda * n * n + 2.0 * lambda);
  return p / (n * p + 1.0);
}

double lambdaForGain(double gain, int harmonics) noexcept {
  const double n = harmonics;
  const double p = gain / std::max(1.0 - n * gain, 1e-3);
  return p * p / (2.0 * (n * p + 1.0));
}

void HarmonicKalman::prepare(int channels, int harmonics, const dsp::kernels::Kernels& kernels) {
  kernels_ = kernels;
  channels_ = channels;
  harmonics_ = harmonics;
  padded_ = dsp::kernels::wholeLanes(static_cast<std::size_t>(std::max(harmonics, 1)));
  for (auto* v : {&turnRe_, &turnIm_, &jumpRe_, &jumpIm_}) v->assign(padded_, 0.0);
  for (auto* v : {&re_, &im_}) v->assign(row(channels), 0.0);
  active_ = 0;
  step_ = 0.0;
  setActive(harmonics);
}

void HarmonicKalman::reset() noexcept {
  std::fill(re_.begin(), re_.end(), 0.0);
  std::fill(im_.begin(), im_.end(), 0.0);
}

void HarmonicKalman::setActive(int count) noexcept {
  const int clamped = std::clamp(count, 0, harmonics_);
  if (clamped == active_) return;
  active_ = clamped;
  const auto n = static_cast<std::size_t>(active_);
  used_ = std::max(dsp::kernels::wholeLanes(n), dsp::kernels::kLanes);
  for (int c = 0; c < channels_; ++c) {
    const auto from = static_cast<std::ptrdiff_t>(row(c) + n);
    const auto to = static_cast<std::ptrdiff_t>(row(c + 1));
    std::fill(re_.begin() + from, re_.begin() + to, 0.0);
    std::fill(im_.begin() + from, im_.begin() + to, 0.0);
  }
  std::fill(turnRe_.begin(), turnRe_.end(), 0.0);
  std::fill(turnIm_.begin(), turnIm_.end(), 0.0);
  kernels_.powers(std::cos(step_), std::sin(step_), n, turnRe_.data(), turnIm_.data());
}

void HarmonicKalman::align(double angle, double step) noexcept {
  const auto n = static_cast<std::size_t>(active_);
  const double jump = dsp::wrapPhase(angle - angle_);
  angle_ = angle;
  if (std::abs(jump) > kSameAngle) {
    kernels_.powers(std::cos(jump), std::sin(jump), n, jumpRe_.data(), jumpIm_.data());
    for (int c = 0; c < channels_; ++c) {
      kernels_.turn(re_.data() + row(c), im_.data() + row(c), jumpRe_.data(), jumpIm_.data(), used_);
    }
  }
  if (step == step_) return;
  step_ = step;
  kernels_.powers(std::cos(step), std::sin(step), n, turnRe_.data(), turnIm_.data());
}

void HarmonicKalman::process(int channel, const double* x, double* rest, std::size_t frames) noexcept {
  double* re = re_.data() + row(channel);
  double* im = im_.data() + row(channel);
  // eq. 22 subtracts the corrected estimate: H q = H q^- + H K e, and H K = g N.
  kernels_.harmonics({x, rest, frames, used_, re, im, turnRe_.data(), turnIm_.data(), gain_, 1.0 - gain_ * active_});
  if (frames == 0 || std::isfinite(rest[frames - 1])) return;
  std::fill_n(re, padded_, 0.0);
  std::fill_n(im, padded_, 0.0);
  std::fill_n(rest, frames, 0.0);
}

void HarmonicKalman::advance(std::size_t frames) noexcept {
  angle_ = dsp::wrapPhase(angle_ + static_cast<double>(frames) * step_);
}

double HarmonicKalman::power(int channel, int n) const noexcept {
  const std::size_t i = row(channel) + static_cast<std::size_t>(n - 1);
  return re_[i] * re_[i] + im_[i] * im_[i];
}

double HarmonicKalman::weightedPower(int channel, const double* weight) const noexcept {
  return kernels_.weightedPower(re_.data() + row(channel), im_.data() + row(channel), weight, used_);
}

}  // namespace stillcut::detect
