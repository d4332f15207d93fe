#include "core/milling/simulation/spindle_drive.h"

#include <algorithm>
#include <cmath>

namespace stillcut::milling {

SpindleDrive::SpindleDrive(const DriveSettings& settings, Rpm start) noexcept
    : settings_(settings),
      omega_(start.value * kTwoPi / 60.0),
      reference_(omega_),
      target_(omega_),
      integral_(settings.frictionTorque),
      torque_(settings.frictionTorque) {}

void SpindleDrive::advance(Seconds dt, double cuttingTorque) noexcept {
  const double h = dt.value;
  const double w = kTwoPi * settings_.bandwidth.value;
  const double proportional = 2.0 * w * settings_.inertia, integrating = w * w * settings_.inertia;
  const double most = settings_.acceleration * kTwoPi / 60.0 * h;
  const double move = std::clamp(target_ - reference_, -most, most);
  // The move itself is fed forward; the loop is for what is left.
  const double error = reference_ - omega_;
  reference_ += move;
  const double wanted = proportional * error + integral_ + settings_.inertia * move / h;
  const double asked = std::clamp(wanted, -settings_.torqueLimit, settings_.torqueLimit);
  // The integral rests while the torque is at its limit and the error would push it further.
  if (asked == wanted || error * wanted < 0.0) integral_ += integrating * error * h;
  const double lag = kTwoPi * settings_.torqueLoop.value * h;
  torque_ += (asked - torque_) * (lag > 0.0 ? 1.0 - std::exp(-lag) : 1.0);
  omega_ += (torque_ - settings_.frictionTorque - cuttingTorque) / settings_.inertia * h;
  // A stalled spindle stays a number the model can step with.
  omega_ = std::max(omega_, 1.0);
}

}  // namespace stillcut::milling
