// One line that holds most of the vibration, window after window, and can be no tooth passing at any speed that was
// told. Forced vibration is strongest at multiples of the teeth: what holds most of the vibration elsewhere is no part
// of it, whatever the exact speed, and needs no comb to be told apart. A comb takes longer where chatter fills the cut.
//
// Where nothing quieter was heard before, it may be a tone of the machine as well. How it beats tells little: bearings,
// motors and two tones beat too, and chatter under strong runout beats at any order of the spindle.
// Thread: worker; real-time.
#pragma once

#include "core/spindle/speed_search.h"

namespace stillcut::detect {

class LoneLine {
 public:
  void prepare(int teeth, Hertz rate);
  // Another cut.
  void reset() noexcept;
  // The windows seen so far belong to something else; what is known of the cut stays.
  void forget() noexcept {
    strongest_ = line_ = Hertz(0.0);
    missed_ = kMostMissed;
  }

  static constexpr double kReadBack = 2e-3;  // doubt of a measured speed, while it stands

  // After each window that `search` was given. told: 0 where nobody says a speed; range: its doubt, as a ratio;
  // measured: by the machine. followed: the speed that a spindle was found at which nobody measures, 0: none. It may
  // have run away further than what was told is in doubt, and then has its own comb: with runout on a mode its
  // strongest line need be no tooth passing.
  void watch(const SpeedSearch& search, Hertz told, double range, bool measured, Hertz followed) noexcept;
  // Now; 0: none.
  Hertz line() const noexcept { return line_; }
  // The last one of this cut, where it is now: the comb that it lies on is not the spindle's. 0: none.
  Hertz suspect() const noexcept { return suspect_; }
  void followSuspect(const SpeedSearch& search) noexcept;
  // The strongest line of one of the last windows was the suspect, however strong it is now.
  bool heard() const noexcept { return missed_ < kMostMissed; }

 private:
  static constexpr int kMostMissed = 6;  // looks, as many as there are quick ones in a window
  int teeth_ = 0;
  double rate_ = 0.0;
  Hertz strongest_{};  // of the last window
  Hertz line_{};
  Hertz suspect_{};
  int missed_ = kMostMissed;  // looks since it was the strongest line
};

}  // namespace stillcut::detect
