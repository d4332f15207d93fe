#include "core/active/lms.h"

#include "core/dsp/kernels/choose.h"

namespace stillcut::active {

void Lms::prepare(const LmsOptions& options) {
  options_ = options;
  kernels_ = dsp::kernels::bestKernels();
  line_.prepare(static_cast<std::size_t>(options.taps));
  weights_.assign(line_.size(), 0.0);
}

void Lms::reset() noexcept {
  line_.reset();
  std::fill(weights_.begin(), weights_.end(), 0.0);
}

double Lms::process(double x, double wanted) STILLCUT_RT {
  line_.push(x);
  const auto taps = static_cast<std::size_t>(options_.taps);
  const double error = wanted - kernels_.tapSum(weights_.data(), line_.data(), weights_.size());
  double step = options_.step;
  if (options_.normalised) {
    const std::size_t whole = taps - taps % dsp::kernels::kLanes;
    double power = kernels_.tapSum(line_.data(), line_.data(), whole);
    for (std::size_t k = whole; k < taps; ++k) power += line_.data()[k] * line_.data()[k];
    step = normalisedStep(options_.step, power);
  }
  kernels_.tapSteer(weights_.data(), options_.leak, 2.0 * step * error, line_.data(), taps);
  return error;
}

}  // namespace stillcut::active
