#include "core/spindle/reported_speed.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr Seconds kLeastAge{5e-3};   // a younger reading is as good as of now
constexpr Seconds kMostAge{1.0};     // an older one is no measurement of now
constexpr Seconds kLeastLine{0.05};  // what changes over less is the tooth forces' and the converter's
constexpr double kLineTurns = 2.0;
constexpr int kLineReadings = 3;
constexpr double kOnLine = 3.0;    // the change along the line over the readings' scatter about it
constexpr double kLedDoubt = 0.5;  // of what a line leads to, or a changed target may have changed
constexpr double kSameTarget = 2e-3;
constexpr Seconds kStarts{0.1};  // after that the readings show what a changed target does

}  // namespace

void ReportedSpeed::remember(Reading reading) noexcept {
  const Instant last = readings_[static_cast<std::size_t>(newest_)].at;
  if (count_ > 0 && reading.at == last) return;
  if (reading.at < last) count_ = 0;  // another stream
  newest_ = (newest_ + 1) % kReadings;
  count_ = std::min(count_ + 1, kReadings);
  readings_[static_cast<std::size_t>(newest_)] = reading;
}

void ReportedSpeed::watchTarget(double hertz, Instant now) noexcept {
  if (target_ > 0.0 && std::abs(hertz / target_ - 1.0) < kSameTarget) return;
  before_ = target_ > 0.0 ? target_ : hertz;
  target_ = hertz;
  changed_ = now;
}

ReportedSpeed::Line ReportedSpeed::line(Seconds over) const noexcept {
  const Reading& newest = reading(0);
  double n = 0.0, t = 0.0, tt = 0.0, x = 0.0, tx = 0.0, xx = 0.0;
  for (int back = 0; back < count_; ++back) {
    const double ago = secondsBetween(newest.at, reading(back).at).value;  // negative
    if (n >= kLineReadings && -ago > over.value) break;
    const double y = reading(back).hertz - newest.hertz;
    n += 1.0;
    t += ago;
    tt += ago * ago;
    x += y;
    tx += ago * y;
    xx += y * y;
  }
  const double spread = tt - t * t / n;
  if (n < kLineReadings || !(spread > 0.0)) return {newest.hertz, 0.0};
  const double along = tx - t * x / n;
  const double slope = along / spread;
  const double scatter = std::sqrt(std::max(xx - x * x / n - slope * along, 0.0) / n);
  if (std::abs(slope) * std::sqrt(12.0 * spread / n) < kOnLine * scatter) return {newest.hertz, 0.0};
  return {newest.hertz + (x - slope * t) / n, slope};
}

ReportedSpeed::Word ReportedSpeed::hear(const MachineState& machine, Instant now) noexcept {
  if (!machine.valid || !machine.linkUp) return {};
  const double target = std::max(toHertz(machine.targetSpeed()).value, 0.0);
  const double read = toHertz(machine.actualSpeed).value;
  if (!(read > 0.0)) return {target, false, 0.0};
  if (machine.link.speed == Instant{}) return {read, true, 0.0};
  const Duration age = now - machine.link.speed;
  if (age > toDuration(kMostAge) && target > 0.0) return {target, false, 0.0};
  remember({machine.link.speed, read});
  watchTarget(target, now);
  if (age < toDuration(kLeastAge)) return {read, true, 0.0};
  if (machine.link.speed < changed_ + toDuration(kStarts)) {
    return {read, true, before_ > 0.0 ? kLedDoubt * std::abs(target_ / before_ - 1.0) * read : 0.0};
  }
  const double seconds = std::min(toSeconds(age).value, kMostAge.value);
  const Line led = line(Seconds(std::max({seconds, kLeastLine.value, kLineTurns / read})));
  const double change = led.slope * seconds;
  const double left = target - led.hertz;
  const bool towards = target > 0.0 && change * left > 0.0;
  const double size = std::min({std::abs(change), towards ? std::abs(left) : 0.5 * read, 0.5 * read});
  return {led.hertz + std::copysign(size, change), true, kLedDoubt * size};
}

}  // namespace stillcut::detect
