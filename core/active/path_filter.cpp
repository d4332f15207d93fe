#include "core/active/path_filter.h"

#include <algorithm>

#include "core/dsp/kernels/choose.h"

namespace stillcut::active {
namespace {

dsp::kernels::LaneValues padded(const std::vector<double>& coefficients) {
  dsp::kernels::LaneValues all(coefficients.begin(), coefficients.end());
  all.resize(dsp::kernels::wholeLanes(all.size()), 0.0);
  return all;
}

}  // namespace

void PathPair::prepare(const PathModel& model) {
  kernels_ = dsp::kernels::bestKernels();
  forward_ = padded(model.forward);
  backward_ = padded(model.backward);
  const std::size_t taps = std::max(forward_.size(), backward_.size());
  forward_.resize(taps, 0.0);
  backward_.resize(taps, 0.0);
  delay_ = static_cast<std::size_t>(model.delay);
  run_ = {.forward = forward_.data(), .backward = backward_.data(), .taps = taps};
  for (std::size_t i = 0; i < 2; ++i) {
    states_[i].resize(taps + dsp::kernels::kLanes);
    run_.state[i] = states_[i].data();
    waiting_[i].resize(delay_);
  }
  reset();
}

void PathPair::reset() noexcept {
  for (auto& state : states_) std::ranges::fill(state, 0.0);
  for (auto& ring : waiting_) std::ranges::fill(ring, 0.0);
  pushed_ = {};
  run_.in[0] = run_.in[1] = run_.out[0] = run_.out[1] = 0.0;
  at_ = 0;
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

void PathFilter::renew(const PathModel& model) STILLCUT_RT {
  std::copy(model.forward.begin(), model.forward.end(), forward_.begin());
  std::copy(model.backward.begin(), model.backward.end(), backward_.begin());
}

void PathFilter::reset() noexcept {
  inputs_.reset();
  outputs_.reset();
}

}  // namespace stillcut::active
