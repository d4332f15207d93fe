// SpindleDrive: inertia, torque limit, speed loop and torque loop of a spindle, loaded by the cutting torque.
// The reference rises at no more than `acceleration`; a PI loop (critically damped at `bandwidth`) asks for a torque,
// which the current makes with the lag of the torque loop. About a speed that is kept, with w = 2 pi bandwidth,
// w_t = 2 pi torqueLoop, J the inertia and k the torque per ampere:
//   J s Omega = T_motor - T_cutting,  T_motor = -(2 w J + w^2 J / s) Omega / (1 + s / w_t),  I = T_motor / k.
// Far above `bandwidth` both answers are integrators, Omega / T_cutting = -1 / (J s) and I / T_cutting = 2 w / (k s)
// (Caliskan 2018 section 4), and above the torque loop the current falls off once more. The winding's own answer to a
// changing speed through its back-EMF is left out: at 1 kHz it is a hundredth of what a loop of 8 Hz makes.
// Source: van Dijk 2010 section 5.2 (the slow part of the override's answer is inertia and speed loop); values are
// ours. Thread: one. Real-time safe.
#pragma once

#include "core/base/units.h"

namespace stillcut::milling {

struct DriveSettings {
  double inertia = 0.004;        // [kg m^2]
  double torqueLimit = 20.0;     // [N m]
  Hertz bandwidth{8.0};          // of the speed loop
  Hertz torqueLoop{};            // bandwidth of the torque loop; 0: the torque is there at once
  double acceleration = 1.0e5;   // of the reference [rev/min per s]
  double torquePerAmpere = 0.5;  // [N m/A]
  double frictionTorque = 0.3;   // [N m], against the rotation
  bool operator==(const DriveSettings&) const = default;
};

class SpindleDrive {
 public:
  SpindleDrive(const DriveSettings& settings, Rpm start) noexcept;

  // `dt` > 0 later, with the mean cutting torque since the last call.
  void advance(Seconds dt, double cuttingTorque) noexcept;
  void setTarget(Rpm target) noexcept { target_ = target.value * kTwoPi / 60.0; }

  double radPerSecond() const { return omega_; }
  Rpm speed() const { return Rpm(omega_ * 60.0 / kTwoPi); }
  Rpm target() const { return Rpm(target_ * 60.0 / kTwoPi); }
  double torque() const { return torque_; }                               // of the motor [N m]
  double current() const { return torque_ / settings_.torquePerAmpere; }  // [A]

 private:
  DriveSettings settings_;
  double omega_, reference_, target_;  // [rad/s]
  double integral_ = 0.0;              // [N m]
  double torque_ = 0.0;
};

}  // namespace stillcut::milling
