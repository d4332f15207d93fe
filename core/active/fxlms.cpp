#include "core/active/fxlms.h"

#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::active {

namespace {

// Centre of gravity of the energy of the impulse response [samples].
double delayOf(const PathModel& model, ErrorWeighting weighting) {
  double energy = 0.0;
  double moment = 0.0;
  const std::vector<double> impulse = model.impulse(4 * kMostTaps);
  for (std::size_t n = 0; n < impulse.size(); ++n) {
    const double r = weighting.process(impulse[n]);
    energy += r * r;
    moment += static_cast<double>(n + 1) * r * r;
  }
  return energy > 0.0 ? moment / energy : 0.0;
}

}  // namespace

void FxlmsController::prepare(const FxlmsOptions& options, const PathModel& model, Hertz rate) {
  options_ = options;
  kernels_ = dsp::kernels::bestKernels();
  const auto taps = static_cast<std::size_t>(options.filter.taps);
  reference_.prepare(taps);
  filtered_.prepare(taps);
  weights_.assign(reference_.size(), 0.0);
  heard_.prepare(model);
  shaped_.prepare(model);
  errorWeight_.prepare(options.emphasis, rate);
  referenceWeight_.prepare(options.emphasis, rate);
  delay_ = delayOf(model, errorWeight_);
  forget_ = 1.0 / (8.0 * static_cast<double>(taps));
  reset();
}

void FxlmsController::reset() noexcept {
  std::fill(weights_.begin(), weights_.end(), 0.0);
  reference_.reset();
  filtered_.reset();
  heard_.reset();
  shaped_.reset();
  errorWeight_.reset();
  referenceWeight_.reset();
  power_ = errorPower_ = disturbance_ = wanted_ = error_ = 0.0;
}

double FxlmsController::largestStep() const noexcept {
  constexpr double kSilence = 1e-30;
  return power_ > kSilence ? 1.0 / (power_ * (options_.filter.taps + delay_)) : 0.0;
}

double FxlmsController::process(double error, double reference) STILLCUT_RT {
  error_ = errorWeight_.process(error);
  disturbance_ = error + heard_.arrive();
  const double x = options_.reference == Reference::Feedforward     ? reference
                   : options_.reference == Reference::ErrorFeedback ? error
                                                                    : disturbance_;
  const double filtered = referenceWeight_.process(shaped_.arrive());
  shaped_.push(x);
  filtered_.push(filtered);
  reference_.push(x);
  // Follows a rise at once, so that a step taken from it is never too large, and a fall slowly.
  const double inFilter = kernels_.tapSum(filtered_.data(), filtered_.data(), filtered_.size()) / options_.filter.taps;
  power_ = std::max(inFilter, power_ + forget_ * (filtered * filtered - power_));
  wanted_ = kernels_.tapSum(weights_.data(), reference_.data(), weights_.size());
  return wanted_;
}

void FxlmsController::written(double output) STILLCUT_RT {
  heard_.push(output);
  const bool limited = output != wanted_;
  const double step = options_.filter.normalised ? options_.filter.step * largestStep() : options_.filter.step;
  // The filtered reference follows a sudden rise later than the error does: until it has, a step taken from its power
  // would be too large by as much as the vibration rose. So the error counts up to thrice its own size before.
  double error = error_;
  if (options_.filter.normalised) {
    const double usual = 3.0 * std::sqrt(errorPower_);
    error = std::clamp(error_, -usual, usual);
    errorPower_ += forget_ * (error_ * error_ - errorPower_);
  }
  kernels_.tapSteer(weights_.data(), options_.filter.leak, limited ? 0.0 : 2.0 * step * error, filtered_.data(),
                    weights_.size());
  std::fill(weights_.begin() + options_.filter.taps, weights_.end(), 0.0);
}

}  // namespace stillcut::active
