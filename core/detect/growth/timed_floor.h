// A floor under a share of the vibration, and one under its energy, that follow them down but up by time alone. What
// grows slowly, or in few turns of a slow spindle, becomes a floor that learns by turns (onset_test.h); it does not
// become these. Thread: worker; real-time.
#pragma once

#include "core/base/units.h"

namespace stillcut::detect {

class TimedFloor {
 public:
  void reset() { share_ = energy_ = 0.0; }
  void learn(double share, double energy) {
    share_ = share;
    energy_ = energy;
  }
  bool learned() const { return share_ > 0.0; }
  // What was learned may be so much larger now without having grown.
  void raise(double factor) {
    share_ *= factor;
    energy_ *= factor;
  }
  // So many turns of a cut that is stable, as far as anybody knows.
  void follow(double share, double energy, double turns, Hertz spindle);

  double share() const { return share_; }
  double energy() const { return energy_; }

 private:
  double share_ = 0.0;
  double energy_ = 0.0;
};

}  // namespace stillcut::detect
