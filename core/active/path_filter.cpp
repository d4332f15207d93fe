#include "core/active/path_filter.h"

#include "core/dsp/kernels/choose.h"

namespace stillcut::active {
namespace {

std::vector<double> padded(const std::vector<double>& coefficients) {
  std::vector<double> all = coefficients;
  all.resize(dsp::kernels::wholeLanes(all.size()), 0.0);
  return all;
}

}  // namespace

void PathPair::prepare(const PathModel& model) {
  kernels_ = dsp::kernels::bestKernels();
  forward_ = padded(model.forward);
  backward_ = padded(model.backward);
  delay_ = static_cast<std::size_t>(model.delay);
  run_.forward = forward_.data();
  run_.forwardTaps = forward_.size();
  run_.backward = backward_.data();
  run_.backwardTaps = backward_.size();
  for (std::size_t i = 0; i < 2; ++i) {
    inputs_[i].prepare(forward_.size() + delay_);
    outputs_[i].prepare(backward_.size());
  }
}

void PathPair::reset() noexcept {
  for (TapLine& line : inputs_) line.reset();
  for (TapLine& line : outputs_) line.reset();
}

void PathPair::renew(const PathModel& model) STILLCUT_RT {
  std::copy(model.forward.begin(), model.forward.end(), forward_.begin());
  std::copy(model.backward.begin(), model.backward.end(), backward_.begin());
}

void PathFilter::prepare(const PathModel& model) {
  kernels_ = dsp::kernels::bestKernels();
  forward_ = padded(model.forward);
  backward_ = padded(model.backward);
  delay_ = static_cast<std::size_t>(model.delay);
  inputs_.prepare(forward_.size() + delay_);
  outputs_.prepare(backward_.size());
}

void PathFilter::reset() noexcept {
  inputs_.reset();
  outputs_.reset();
}

}  // namespace stillcut::active
