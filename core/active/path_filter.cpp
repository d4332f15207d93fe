#include "core/active/path_filter.h"

#include "core/dsp/kernels/choose.h"

namespace stillcut::active {

void PathFilter::prepare(const PathModel& model) {
  kernels_ = dsp::kernels::bestKernels();
  forward_ = model.forward;
  backward_ = model.backward;
  forward_.resize(wholeLanes(forward_.size()), 0.0);
  backward_.resize(wholeLanes(backward_.size()), 0.0);
  inputs_.prepare(model.forward.size());
  outputs_.prepare(model.backward.size());
}

void PathFilter::reset() noexcept {
  inputs_.reset();
  outputs_.reset();
}

}  // namespace stillcut::active
