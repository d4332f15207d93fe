#include "core/active/fxlms.h"

#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::active {

namespace {

constexpr std::size_t kWritten = 0;  // signals of the pair
constexpr std::size_t kReference = 1;

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
  path_.prepare(model);
  const Emphasis emphasis = foreseen(options.emphasis, Seconds(leadingDelay(model) / rate.value));
  errorWeight_.prepare(emphasis, rate);
  referenceWeight_.prepare(emphasis, rate);
  delay_ = delayOf(model, errorWeight_);
  forget_ = 1.0 / (8.0 * static_cast<double>(taps));
  reset();
}

void FxlmsController::reset() noexcept {
  std::fill(weights_.begin(), weights_.end(), 0.0);
  reference_.reset();
  filtered_.reset();
  path_.reset();
  errorWeight_.reset();
  referenceWeight_.reset();
  filteredNow_ = power_ = inFilter_ = renewed_ = errorPower_ = disturbance_ = wanted_ = error_ = 0.0;
  sinceRenewal_ = 0;
  // The foot of a path's response is far below the rest: a step taken from its power would be thrown by what follows.
  unheard_ = options_.filter.taps + static_cast<int>(std::ceil(delay_));
}

double FxlmsController::largestStep() const noexcept {
  constexpr double kSilence = 1e-30;
  return power_ > kSilence ? 1.0 / (power_ * (options_.filter.taps + delay_)) : 0.0;
}

void FxlmsController::hear(double filtered) STILLCUT_RT {
  filtered_.push(filteredNow_);
  filteredNow_ = filtered;
  const double oldest = filtered_.data()[options_.filter.taps - 1];
  const double square = filtered * filtered;
  unheard_ = std::max(0, unheard_ - 1);
  inFilter_ += square - oldest * oldest;
  renewed_ += square;
  if (++sinceRenewal_ == options_.filter.taps) {
    inFilter_ = renewed_;
    renewed_ = 0.0;
    sinceRenewal_ = 0;
  }
  // Follows a rise at once, so that a step taken from it is never too large, and a fall slowly.
  power_ = std::max(inFilter_ / options_.filter.taps, power_ + forget_ * (square - power_));
}

double FxlmsController::process(double error, double reference) STILLCUT_RT {
  error_ = errorWeight_.process(error);
  path_.arrive();
  disturbance_ = error + path_.arrived(kWritten);
  const double x = options_.reference == Reference::Feedforward     ? reference
                   : options_.reference == Reference::ErrorFeedback ? error
                                                                    : disturbance_;
  path_.push(kReference, x);
  wanted_ = kernels_.newTapSum(weights_.data(), x, reference_.data(), weights_.size());
  reference_.push(x);
  hear(referenceWeight_.process(path_.arrived(kReference)));
  return wanted_;
}

void FxlmsController::written(double output, double added) STILLCUT_RT {
  path_.push(kWritten, output);
  const bool limited = output != wanted_ + added;
  double step = options_.filter.step;
  if (options_.filter.normalised) step *= unheard_ > 0 ? 0.0 : largestStep();
  // The filtered reference follows a sudden rise later than the error does: until it has, a step taken from its power
  // would be too large by as much as the vibration rose. So the error counts up to thrice its own size before.
  double error = error_;
  if (options_.filter.normalised) {
    const double square = error_ * error_;
    if (square > 9.0 * errorPower_) error = std::copysign(3.0 * std::sqrt(errorPower_), error_);
    errorPower_ += forget_ * (square - errorPower_);
  }
  kernels_.newTapSteer(weights_.data(), options_.filter.leak, limited ? 0.0 : 2.0 * step * error, filteredNow_,
                       filtered_.data(), static_cast<std::size_t>(options_.filter.taps));
}

}  // namespace stillcut::active
