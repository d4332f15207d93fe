#include "core/active/path_identifier.h"

#include "core/active/lms.h"
#include "core/dsp/kernels/choose.h"

namespace stillcut::active {

void PathIdentifier::prepare(const IdentifierOptions& options) {
  options_ = options;
  kernels_ = dsp::kernels::bestKernels();
  outputs_.prepare(static_cast<std::size_t>(options.forward));
  predictions_.prepare(static_cast<std::size_t>(options.backward));
  forward_.assign(outputs_.size(), 0.0);
  backward_.assign(predictions_.size(), 0.0);
}

void PathIdentifier::reset() noexcept {
  outputs_.reset();
  predictions_.reset();
  std::fill(forward_.begin(), forward_.end(), 0.0);
  std::fill(backward_.begin(), backward_.end(), 0.0);
}

double PathIdentifier::reading(double r) STILLCUT_RT {
  const double predicted = kernels_.tapSum(forward_.data(), outputs_.data(), forward_.size()) +
                           kernels_.tapSum(backward_.data(), predictions_.data(), backward_.size());
  const double error = r - predicted;
  double step = options_.step;
  if (options_.normalised) {
    double power = kernels_.tapSum(outputs_.data(), outputs_.data(), outputs_.size());
    if (options_.backward > 0) power += kernels_.tapSum(predictions_.data(), predictions_.data(), predictions_.size());
    step = normalisedStep(options_.step, power);
  }
  kernels_.tapSteer(forward_.data(), 1.0, 2.0 * step * error, outputs_.data(), forward_.size());
  kernels_.tapSteer(backward_.data(), 1.0, 2.0 * step * error, predictions_.data(), backward_.size());
  std::fill(forward_.begin() + options_.forward, forward_.end(), 0.0);
  std::fill(backward_.begin() + options_.backward, backward_.end(), 0.0);
  predictions_.push(predicted);
  return error;
}

PathModel PathIdentifier::model() const {
  return {{forward_.begin(), forward_.begin() + options_.forward},
          {backward_.begin(), backward_.begin() + options_.backward}};
}

}  // namespace stillcut::active
