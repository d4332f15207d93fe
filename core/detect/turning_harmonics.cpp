#include "core/detect/turning_harmonics.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

using dsp::kernels::HarmonicRun;

constexpr double kSameAngle = 1e-9;  // rad; the sums of angles differ by roundings

}  // namespace

double harmonicGain(double lambda, int harmonics) {
  const double n = harmonics;
  const double p = lambda * n + std::sqrt(lambda * lambda * n * n + 2.0 * lambda);
  return p / (n * p + 1.0);
}

double lambdaForGain(double gain, int harmonics) {
  const double n = harmonics;
  const double p = gain / std::max(1.0 - n * gain, 1e-3);
  return p * p / (2.0 * (n * p + 1.0));
}

void RotatingHarmonicFilter::prepare(int channels, int harmonics, const dsp::kernels::Kernels& kernels) {
  kernels_ = kernels;
  channels_ = channels;
  harmonics_ = harmonics;
  padded_ = dsp::kernels::wholeLanes(static_cast<std::size_t>(std::max(harmonics, 1)));
  for (auto* v : {&rotationRe_, &rotationIm_, &jumpRe_, &jumpIm_}) v->assign(padded_, 0.0);
  for (auto* v : {&re_, &im_}) v->assign(row(channels), 0.0);
  active_ = 0;
  step_ = 0.0;
  keep_ = 1.0;
  setActive(harmonics);
}

void RotatingHarmonicFilter::reset() {
  std::fill(re_.begin(), re_.end(), 0.0);
  std::fill(im_.begin(), im_.end(), 0.0);
}

void RotatingHarmonicFilter::setActive(int count) {
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
  makeTurn();
}

void RotatingHarmonicFilter::setGain(double gain, double keep) {
  gain_ = gain;
  if (keep == keep_) return;
  keep_ = keep;
  makeTurn();
}

void RotatingHarmonicFilter::makeTurn() {
  const auto n = static_cast<std::size_t>(active_);
  kernels_.powers(std::cos(step_), std::sin(step_), n, rotationRe_.data(), rotationIm_.data());
  for (std::size_t i = 0; i < padded_; ++i) {
    rotationRe_[i] = i < n ? keep_ * rotationRe_[i] : 0.0;
    rotationIm_[i] = i < n ? keep_ * rotationIm_[i] : 0.0;
  }
}

void RotatingHarmonicFilter::align(double angle, double step) {
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
  makeTurn();
}

HarmonicRun RotatingHarmonicFilter::run(int channel, const double* x, double* residual, std::size_t frames,
                                        double after) {
  return {x,
          residual,
          frames,
          used_,
          re_.data() + row(channel),
          im_.data() + row(channel),
          rotationRe_.data(),
          rotationIm_.data(),
          gain_ / keep_,
          after};
}

bool RotatingHarmonicFilter::finished(int channel, double* residual, std::size_t frames) {
  if (frames == 0 || std::isfinite(residual[frames - 1])) return true;
  std::fill_n(re_.data() + row(channel), padded_, 0.0);
  std::fill_n(im_.data() + row(channel), padded_, 0.0);
  std::fill_n(residual, frames, 0.0);
  return false;
}

void RotatingHarmonicFilter::process(int channel, const double* x, double* residual, std::size_t frames, double after) {
  kernels_.harmonics(run(channel, x, residual, frames, after));
  finished(channel, residual, frames);
}

void RotatingHarmonicFilter::process(const double* x, std::ptrdiff_t stride, double* residual,
                                     std::ptrdiff_t residualStride, std::size_t frames, double after) {
  int c = 0;
  for (; c + 1 < channels_; c += 2) {
    const HarmonicRun first = run(c, x + c * stride, residual + c * residualStride, frames, after);
    const HarmonicRun second = run(c + 1, x + (c + 1) * stride, residual + (c + 1) * residualStride, frames, after);
    kernels_.harmonicPair(first, second);
    finished(c, first.residual, frames);
    finished(c + 1, second.residual, frames);
  }
  if (c < channels_) process(c, x + c * stride, residual + c * residualStride, frames, after);
}

void RotatingHarmonicFilter::advance(std::size_t frames) {
  angle_ = dsp::wrapPhase(angle_ + static_cast<double>(frames) * step_);
}

double RotatingHarmonicFilter::power(int channel, int n) const {
  const std::size_t i = row(channel) + static_cast<std::size_t>(n - 1);
  return re_[i] * re_[i] + im_[i] * im_[i];
}

void RotatingHarmonicFilter::amplitudes(int channel, std::span<std::complex<double>> out) const {
  const double c = std::cos(angle_);
  const double s = -std::sin(angle_);
  double re = c;
  double im = s;
  for (std::size_t n = 0; n < out.size(); ++n) {
    const double r = re_[row(channel) + n];
    const double i = im_[row(channel) + n];
    out[n] = {r * re - i * im, r * im + i * re};
    const double next = re * c - im * s;
    im = re * s + im * c;
    re = next;
  }
}

double RotatingHarmonicFilter::weightedPower(int channel, const double* weight) const {
  return kernels_.weightedPower(re_.data() + row(channel), im_.data() + row(channel), weight, used_);
}

}  // namespace stillcut::detect
