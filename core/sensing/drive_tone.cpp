#include "core/sensing/drive_tone.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kFollows = 0.02;   // s, time constant of the amplitude
constexpr double kSettles = 4.0;    // of them, until what is left is 2 %
constexpr double kPulls = 0.008;    // s from one correction of the frequency to the next
constexpr double kPull = 0.3;       // of what the amplitude rotated, so that noise does not pull it away
constexpr double kExpected = 60.0;  // s: a part has a feed move more often
constexpr double kArrives = 0.3;    // s, in which it may creep on
constexpr double kNotch = 6.0;      // Hz, to which the amplitude follows by itself
constexpr double kLeft = 0.05;      // of the power it arrived with: it leaves, or beats with a line beside it
constexpr double kLouder = 6.0;     // ... of which it is something else: 8 dB
constexpr double kLeaves = 0.06;    // s in all, after which it has left

}  // namespace

void DriveTone::prepare(Hertz rate) {
  rate_ = rate.value;
  watch_.prepare(rate);
  reset();
}

void DriveTone::reset() noexcept {
  watch_.reset();
  standing_ = false;
  unsettled_ = expected_ = 0;
  frequency_ = arrived_ = 0.0;
}

void DriveTone::arrive() noexcept {
  standing_ = true;
  frequency_ = watch_.frequency().value;
  since_ = weak_ = 0;
  arrived_ = watch_.power(watch_.frequency());
  rotor_ = 1.0;
  amplitude_ = before_ = 0.0;
  sinceBefore_ = 0;
}

void DriveTone::process(std::span<double> x, bool entering) noexcept {
  unsettled_ = std::max(0L, unsettled_ - static_cast<long>(x.size()));
  expected_ = std::max(0L, expected_ - static_cast<long>(x.size()));
  watch_.push(x, entering);
  if (watch_.glides()) {
    unsettled_ = settles();
    expected_ = static_cast<long>(kExpected * rate_);
  }
  if (watch_.takeArrived()) {
    arrive();
    unsettled_ = settles();
  }
  if (!standing_) return;
  since_ += static_cast<long>(x.size());
  creep();
  watchPower(static_cast<long>(x.size()));
  if (standing_) cancel(x);
}

// A drive rounds its acceleration off before it moves steadily.
void DriveTone::creep() noexcept {
  if (static_cast<double>(since_) > kArrives * rate_) return;
  const double line = watch_.lineNear(Hertz(frequency_)).value;
  arrived_ = std::max(arrived_, watch_.power(Hertz(line)));
  if (std::abs(line - frequency_) < kNotch) return;
  frequency_ = line;
  unsettled_ = settles();
}

// What is much louder there than the drive was is the cut's, and is left alone.
void DriveTone::watchPower(long samples) noexcept {
  const double power = watch_.power(Hertz(frequency_));
  if (power < kLeft * arrived_) {
    if (weak_ == 0) unsettled_ = settles();
    weak_ += samples;
  }
  standing_ = static_cast<double>(weak_) < kLeaves * rate_ && power < kLouder * arrived_;
}

long DriveTone::settles() const noexcept {
  return static_cast<long>(kSettles * kFollows * rate_);
}

void DriveTone::cancel(std::span<double> x) noexcept {
  const double mu = 1.0 / (kFollows * rate_);
  std::complex<double> step = std::polar(1.0, kTwoPi * frequency_ / rate_);
  const auto pulls = static_cast<long>(kPulls * rate_);
  for (double& v : x) {
    v -= 2.0 * (amplitude_ * rotor_).real();
    amplitude_ += mu * v * std::conj(rotor_);
    rotor_ *= step;
    if (++sinceBefore_ < pulls) continue;
    if (std::abs(before_) > 0.0) {
      const double turned = std::arg(amplitude_ * std::conj(before_));
      frequency_ += kPull * turned / kTwoPi * rate_ / static_cast<double>(sinceBefore_);
      step = std::polar(1.0, kTwoPi * frequency_ / rate_);
    }
    before_ = amplitude_;
    sinceBefore_ = 0;
    rotor_ /= std::abs(rotor_);
  }
}

}  // namespace stillcut::detect
