#include "core/detect/phase_tracker.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kMemoryTurns = 16.0;  // of the references and their scatter
// A spindle under load wanders by about 0.1 % with one second of memory; this is that, as a random walk.
constexpr double kWander = 1.0e-3;
constexpr double kWanderSeconds = 1.0;
constexpr double kLargestStep = 0.3;  // rad of the highest order in use; beyond it the phase may have slipped

}  // namespace

void PhaseTracker::prepare(int channels, Hertz rate, int teeth) {
  channels_ = std::clamp(channels, 1, kChannels);
  rate_ = rate.value;
  stride_ = std::max(teeth, 1);
  start(Hertz(0.0), Hertz(0.0));
}

void PhaseTracker::start(Hertz spindle, Hertz sd) noexcept {
  omega_ = kTwoPi * spindle.value;
  p00_ = 0.0;
  p01_ = 0.0;
  p11_ = kTwoPi * sd.value * kTwoPi * sd.value;
  frames_ = 0;
  turns_ = 0;
  scatter_ = 0.0;
  sums_ = {};
  if (spindle.value > 0.0) {
    orders_ = std::clamp(static_cast<int>(0.45 * rate_ / (spindle.value * stride_)), 1, kOrders);
  }
}

void PhaseTracker::nudge(Hertz spindle) noexcept {
  const double change = kTwoPi * spindle.value - omega_;
  omega_ += change;
  p11_ += 0.01 * change * change;  // a machine's read-back is good to a tenth of the change
}

Hertz PhaseTracker::sd() const noexcept {
  return Hertz(std::sqrt(std::max(p11_, 0.0)) / kTwoPi);
}

double PhaseTracker::measure(double* information) noexcept {
  double sum = 0.0;
  double info = 0.0;
  for (int c = 0; c < channels_; ++c) {
    for (int k = 0; k < orders_; ++k) {
      const auto i = static_cast<std::size_t>(c * kOrders + k);
      const double order = (k + 1.0) * stride_;
      const double power = std::norm(reference_[i]);
      const double noise = std::max(variance_[i], 0.25 * std::norm(now_[i] - reference_[i])) + 1e-4 * power + 1e-300;
      sum += order * (std::conj(reference_[i]) * now_[i]).imag() / noise;
      info += order * order * power / noise;
    }
  }
  *information = info;
  return info > 0.0 ? sum / info : 0.0;
}

void PhaseTracker::learn(double delta) noexcept {
  const double rate = 1.0 / std::min(static_cast<double>(turns_ + 1), kMemoryTurns);
  double off = 0.0;
  double on = 0.0;
  for (int c = 0; c < channels_; ++c) {
    for (int k = 0; k < orders_; ++k) {
      const auto i = static_cast<std::size_t>(c * kOrders + k);
      const std::complex<double> turned = now_[i] * std::polar(1.0, -(k + 1.0) * stride_ * delta);
      const std::complex<double> error = turned - reference_[i];
      off += std::norm(error);
      on += std::norm(reference_[i]);
      reference_[i] += rate * error;
      variance_[i] += rate * (std::norm(error) - variance_[i]);
    }
  }
  scatter_ = on > 0.0 ? std::sqrt(std::min(off / on, 1.0)) : 1.0;
}

double PhaseTracker::completeTurn() noexcept {
  if (frames_ < 4) return 0.0;
  const double seconds = static_cast<double>(frames_) / rate_;
  for (std::size_t i = 0; i < sums_.size(); ++i) now_[i] = sums_[i] * (2.0 / static_cast<double>(frames_));
  sums_ = {};
  frames_ = 0;
  if (turns_ == 0) {
    reference_ = now_;
    for (std::size_t i = 0; i < now_.size(); ++i) variance_[i] = 0.01 * std::norm(now_[i]);
    ++turns_;
    return 0.0;
  }
  // Predict over the turn.
  const double q = 2.0 * kWander * kWander * omega_ * omega_ / kWanderSeconds;
  p00_ += 2.0 * seconds * p01_ + seconds * seconds * p11_ + q * seconds * seconds * seconds / 3.0;
  p01_ += seconds * p11_ + 0.5 * q * seconds * seconds;
  p11_ += q * seconds;
  double information = 0.0;
  const double limit = kLargestStep / (orders_ * stride_);
  const double delta = std::clamp(measure(&information), -limit, limit);
  double step = 0.0;
  if (information > 0.0) {
    const double noise = 1.0 / information;
    const double gain0 = p00_ / (p00_ + noise);
    const double gain1 = p01_ / (p00_ + noise);
    step = gain0 * delta;
    omega_ += gain1 * delta;
    p11_ -= gain1 * p01_;
    p01_ *= 1.0 - gain0;
    p00_ *= 1.0 - gain0;
  }
  learn(delta);
  ++turns_;
  return step;
}

}  // namespace stillcut::detect
