// Does the spindle's speed change? By the word of a machine that measures it, or else by the vibration itself.
// Thread: worker; real-time.
#pragma once

#include "core/base/units.h"

namespace stillcut::detect {

class SpeedMotion {
 public:
  // told: Hz, 0: nobody says.
  void reset(double told) noexcept;
  // Another kind of word is no change of speed.
  void retell(double told) noexcept { turning_ = recent_ = told; }
  // A lock on the vibration begins at this speed.
  void startHearing(double hertz) noexcept { heard_ = hertz; }

  // What a machine that measures the speed says, good to `sd`. True: a change that went on has come to its end.
  bool followMachine(double told, double sd, double seconds) noexcept;
  // There is no such machine.
  void noMachine() noexcept { riding_ = toldMoving_ = moving_ = false; }
  // What the vibration that is followed says, while the machine's word is not; drift: relative, per second, of the
  // speed.
  void followSignal(double hertz, double drift, double seconds) noexcept;

  // Two windows of the vibration, so far apart, hold combs whose speeds differ by so much of themselves. Chatter that
  // grows pulls the phases that are followed, and not the comb.
  void followCombs(double change, double seconds) noexcept;
  // Nobody looks for them any more.
  void forgetCombs() noexcept { stands_ = false; }

  // The machine says that the speed changes, faster than the vibration can be followed.
  bool riding() const noexcept { return riding_; }
  // ... or than turns can be compared, whoever says so.
  bool moving() const noexcept { return toldMoving_ || (moving_ && !stands_); }
  // ... or the phases that are followed, whatever the combs say.
  bool phasesMove() const noexcept { return moving_; }
  // Told now, or over the last turn of a slow spindle.
  double told() const noexcept { return turning_; }
  // Heard on average, recently, led along its drift.
  double heard() const noexcept { return heard_; }

 private:
  double turning_ = 0.0;  // Hz, as told()
  double recent_ = 0.0;   // Hz, told over the last while
  double heard_ = 0.0;    // Hz, of the vibration over the last while
  bool riding_ = false;
  bool toldMoving_ = false;
  bool moving_ = false;
  bool stands_ = false;  // by the combs
};

}  // namespace stillcut::detect
