#include "core/active/path_identifier.h"

#include "core/active/lms.h"
#include "core/dsp/kernels/choose.h"

namespace stillcut::active {

void PathIdentifier::prepare(const IdentifierOptions& options) {
  options_ = options;
  kernels_ = dsp::kernels::bestKernels();
  forward_.assign(dsp::kernels::wholeLanes(static_cast<std::size_t>(options.forward)), 0.0);
  backward_.assign(dsp::kernels::wholeLanes(static_cast<std::size_t>(options.backward)), 0.0);
  outputs_.prepare(forward_.size() + static_cast<std::size_t>(options.delay));
  predictions_.prepare(backward_.size());
}

double PathIdentifier::reading(double r) STILLCUT_RT {
  const double* outputs = outputs_.data() + options_.delay;
  const double* predictions = predictions_.data();
  const double predicted = kernels_.tapSum(forward_.data(), outputs, forward_.size()) +
                           kernels_.tapSum(backward_.data(), predictions, backward_.size());
  const double error = r - predicted;
  double step = options_.step;
  if (options_.normalised) {
    const double power = kernels_.tapSum(outputs, outputs, forward_.size()) +
                         kernels_.tapSum(predictions, predictions, backward_.size());
    step = normalisedStep(options_.step, power);
  }
  kernels_.tapSteer(forward_.data(), 1.0, 2.0 * step * error, outputs, static_cast<std::size_t>(options_.forward));
  kernels_.tapSteer(backward_.data(), 1.0, 2.0 * step * error, predictions,
                    static_cast<std::size_t>(options_.backward));
  predictions_.push(predicted);
  return error;
}

PathModel PathIdentifier::model() const {
  return {{forward_.begin(), forward_.begin() + options_.forward},
          {backward_.begin(), backward_.begin() + options_.backward},
          options_.delay};
}

}  // namespace stillcut::active
