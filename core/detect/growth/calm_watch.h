// Has an alarm ended? One whose speed was changed cannot fall below its old floor, for the floor has changed as well:
// it is over when little is left and does not grow. What was learned before it is then to be learned anew. Thread:
// worker; real-time.
#pragma once

#include "core/base/units.h"

namespace stillcut::detect {

class CalmWatch {
 public:
  void reset();
  // The speed changed during an alarm: its floor means nothing any more.
  void loseFloor() { floorGone_ = true; }
  bool floorGone() const { return floorGone_; }

  // One hop. changed: E_d / E_x now; quiet: the ratio is well below that of full chatter; seconds: of an alarm, 0 while
  // there is none.
  void watch(double changed, bool quiet, double seconds);
  bool calm(Hertz spindle) const;
  // The cut was left.
  void forgetLevel() { slow_ = 0.0; }

 private:
  bool floorGone_ = false;
  double seconds_ = 0.0;  // a small rest has not grown for so long
  double level_ = 0.0;    // what it was then
  double slow_ = 0.0;     // changed, over a few turns
};

}  // namespace stillcut::detect
