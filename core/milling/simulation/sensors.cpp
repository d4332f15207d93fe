#include "core/milling/simulation/sensors.h"

#include <algorithm>
#include <cmath>

namespace stillcut::milling {

Sensor::Sensor(const SensorSettings& settings, Hertz rate, int oversampling, std::uint64_t seed)
    : settings_(settings),
      axis_(settings.axis == "y" ? 1 : 0),
      noise_(seed),
      finePerMinute_(60.0 * rate.value * oversampling),
      samplesPerMinute_(60.0 * rate.value) {
  const double fine = rate.value * oversampling;
  const double most = 0.45 * rate.value;
  const double cut = settings.bandwidth.value > 0.0 ? std::min(settings.bandwidth.value, most) : most;
  lowPass_.prepare(Hertz(cut), Hertz(fine));
  std::size_t longest = 0;
  for (const Echo& e : settings.echoes) {
    const auto delay = static_cast<std::size_t>(std::llround(std::max(0.0, e.delay.value) * fine));
    taps_.push_back({delay, e.gain});
    longest = std::max(longest, delay);
  }
  line_.assign(longest + 1, 0.0);
}

double Sensor::weight(int mode) const noexcept {
  const auto i = static_cast<std::size_t>(mode);
  return settings_.place.empty() ? 1.0 : settings_.place[i];
}

double Sensor::quantity(const RegenerativeCut& cut, const SpindleDrive& drive) const noexcept {
  switch (settings_.quantity) {
    case SensorQuantity::Force:
      return cut.force()[static_cast<std::size_t>(axis_)];
    case SensorQuantity::Current:
      return drive.current();
    case SensorQuantity::SpindleSpeed:
      return drive.speed().value;
    default:
      break;
  }
  double sum = 0.0;
  for (int i = 0; i < cut.modes(); ++i) {
    const auto d = cut.direction(i);
    switch (settings_.quantity) {
      case SensorQuantity::Acceleration:
        sum += weight(i) * d[static_cast<std::size_t>(axis_)] * cut.acceleration(i);
        break;
      case SensorQuantity::Velocity:
        sum += weight(i) * d[static_cast<std::size_t>(axis_)] * cut.velocity(i);
        break;
      case SensorQuantity::Displacement:
        sum += weight(i) * d[static_cast<std::size_t>(axis_)] * cut.displacement(i);
        break;
      default:
        sum += weight(i) * (d[0] + d[1]) * cut.velocity(i);
        break;  // sound: what radiates is surface velocity
    }
  }
  return sum;
}

// It was there before the recording began.
void Sensor::settle(double si) noexcept {
  settled_ = true;
  lowPass_.settle(si);
}

void Sensor::push(double si) noexcept {
  if (!taps_.empty()) {
    line_[head_] = si;
    si = 0.0;
    for (const Tap& t : taps_) si += t.gain * line_[(head_ + line_.size() - t.delay) % line_.size()];
    head_ = (head_ + 1) % line_.size();
  }
  if (!settled_) settle(si);
  filtered_ = lowPass_.run(si);
  turned_ += filtered_ / finePerMinute_;
}

// Whole places passed since the last sample, the last of them as uncertain as any converter's last bit: white in the
// angle, and the higher the frequency the more of it in the speed. Errors within a line of the encoder are left out.
double Sensor::counted() noexcept {
  const double before = place_;
  place_ = std::floor(turned_ * settings_.counts + 0.5 * noise_.normal());
  const bool first = !counting_;
  counting_ = true;
  return first ? filtered_ : (place_ - before) / settings_.counts * samplesPerMinute_;
}

double Sensor::withFault(double value, double seconds) noexcept {
  if (settings_.fault == SensorFault::None || seconds < settings_.faultFrom.value) return value;
  if (settings_.fault == SensorFault::Dead) return 0.0;
  // A loose sensor: its contact changes a few hundred times a second, and it knocks against its seat.
  if (noise_.uniform() < 0.01) looseGain_ = 0.1 + 0.9 * noise_.uniform();
  const double knock = noise_.uniform() < 0.002 ? 3.0 * noise_.normal() : 0.0;
  return looseGain_ * value + knock * (std::abs(value) + 20.0 * settings_.noise);
}

float Sensor::take(double seconds) noexcept {
  double v = settings_.gain * (settings_.counts > 0.0 ? counted() : filtered_);
  v = withFault(v, seconds) + settings_.noise * noise_.normal();
  clipped_ = settings_.fullScale > 0.0 && std::abs(v) > settings_.fullScale;
  if (clipped_) v = std::copysign(settings_.fullScale, v);
  if (settings_.step > 0.0) v = std::round(v / settings_.step) * settings_.step;
  return static_cast<float>(v);
}

}  // namespace stillcut::milling
