#include "core/spindle/drift_watch.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kEven = 0.5;  // each step of the speed is at least so much of their mean
// Standard deviations, from the first stretch to the last: asked at every turn, three million times in
// a shift, five would be passed by chance. 3 % a second at 10 000 rev/min makes seven.
constexpr double kFurther = 6.0;

}  // namespace

void DriftWatch::add(double seconds, double angle) noexcept {
  turns_[static_cast<std::size_t>(next_)] = {seconds, angle};
  next_ = (next_ + 1) % kTurns;
  count_ = std::min(count_ + 1, kTurns);
}

// 0: the oldest.
const DriftWatch::Turn& DriftWatch::turn(int index) const noexcept {
  return turns_[static_cast<std::size_t>((next_ + index) % kTurns)];
}

// The straight line through the angles of one stretch, 0 the oldest.
DriftWatch::Stretch DriftWatch::stretch(int index) const noexcept {
  const int first = index * kStretch;
  const Turn& origin = turn(first);
  double t = 0.0;
  double a = 0.0;
  for (int i = first; i < first + kStretch; ++i) {
    t += (turn(i).seconds - origin.seconds) / kStretch;
    a += (turn(i).angle - origin.angle) / kStretch;
  }
  double tt = 0.0;
  double ta = 0.0;
  for (int i = first; i < first + kStretch; ++i) {
    const double dt = turn(i).seconds - origin.seconds - t;
    tt += dt * dt;
    ta += dt * (turn(i).angle - origin.angle - a);
  }
  if (!(tt > 0.0)) return {};
  const double omega = ta / tt;
  double beside = 0.0;
  for (int i = first; i < first + kStretch; ++i) {
    const double error = turn(i).angle - origin.angle - a - omega * (turn(i).seconds - origin.seconds - t);
    beside += error * error;
  }
  return {origin.seconds + t, omega, beside / ((kStretch - 2) * tt)};
}

std::optional<DriftWatch::Drift> DriftWatch::shown(double wander) const noexcept {
  if (count_ < kTurns) return std::nullopt;
  const Stretch first = stretch(0);
  const Stretch last = stretch(kStretches - 1);
  const double seconds = last.seconds - first.seconds;
  const double gone = last.omega - first.omega;
  const double doubt = wander * seconds + first.variance + last.variance;
  if (!(gone * gone > kFurther * kFurther * doubt)) return std::nullopt;
  double before = first.omega;
  for (int i = 1; i < kStretches; ++i) {
    const double now = stretch(i).omega;
    if ((now - before) / gone < kEven / (kStretches - 1)) return std::nullopt;
    before = now;
  }
  const double alpha = gone / seconds;
  return Drift{last.omega + alpha * (turn(kTurns - 1).seconds - last.seconds), alpha};
}

bool DriftWatch::over(double wander) const noexcept {
  if (count_ < kTurns) return false;
  const Stretch first = stretch(0);
  const Stretch last = stretch(kStretches - 1);
  const double gone = last.omega - first.omega;
  return gone * gone < wander * (last.seconds - first.seconds);
}

}  // namespace stillcut::detect
