#include "core/spindle/speed_trend.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kSame = 3e-3;    // from one to the next: 10 % a second, in a sixth of 12 turns, at 4000 rev/min
constexpr double kPause = 2.5;    // times from look to look: one may be left out
constexpr double kFurther = 6.0;  // standard deviations, as drift_watch.cpp asks
constexpr double kWander = 1e-3;  // a spindle under load, relative, with one second of memory
constexpr double kWanderSeconds = 1.0;

}  // namespace

void SpeedTrend::prepare(int looks) noexcept {
  needed_ = std::min(static_cast<std::size_t>(std::max(looks, 2)) + 1, kMost);
  reset();
}

void SpeedTrend::add(Seconds middle, Hertz spindle) noexcept {
  const bool leads = count_ == 0 || std::abs(spindle.value / said_[count_ - 1].hertz - 1.0) <= kSame;
  const auto ago = [&](std::size_t back) { return middle.value - said_[count_ - back].seconds; };
  const bool paused = count_ > 1 && ago(1) > kPause * (ago(2) - ago(1));
  if (!leads || paused) reset();
  if (count_ == needed_) {
    std::copy(said_.begin() + 1, said_.begin() + static_cast<std::ptrdiff_t>(count_), said_.begin());
    --count_;
  }
  said_[count_++] = {middle.value, spindle.value};
}

double SpeedTrend::drift() const noexcept {
  if (count_ < needed_) return 0.0;
  const auto n = static_cast<double>(count_);
  double t = 0.0;
  double f = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    t += said_[i].seconds / n;
    f += said_[i].hertz / n;
  }
  double tt = 0.0;
  double tf = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    tt += (said_[i].seconds - t) * (said_[i].seconds - t);
    tf += (said_[i].seconds - t) * (said_[i].hertz - f);
  }
  if (!(tt > 0.0) || !(f > 0.0)) return 0.0;
  const double slope = tf / tt;
  double beside = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double error = said_[i].hertz - f - slope * (said_[i].seconds - t);
    beside += error * error / (n - 2.0);
  }
  const double seconds = said_[count_ - 1].seconds - said_[0].seconds;
  const double gone = slope * seconds;
  const double wander = 2.0 * kWander * kWander * f * f * seconds / kWanderSeconds;
  const double doubt = wander + beside * seconds * seconds / tt;
  return gone * gone > kFurther * kFurther * doubt ? slope / f : 0.0;
}

}  // namespace stillcut::detect
