// ChatterJudge: whether an alarm is worth moving the spindle for. A detector answers within a few revolutions; a move
// costs a second and marks the part, so a little more is asked of the verdicts first:
// - the frequency stands still as a fraction of the tooth-passing frequency. Members f_c + k f_tp of one chatter share
//   that fraction, so a detector that changes between them is not held against it; a rattling sensor has none.
// - after a move of ours, what rings down or stands is not taken for chatter: full chatter must not be falling, and an
//   onset must grow.
// Thread: worker. Real-time.
#pragma once

#include "core/base/realtime.h"
#include "core/model/verdict.h"

namespace stillcut::control {

class ChatterJudge {
 public:
  struct Options {
    Seconds first{0.03};      // that an alarm lasts before the first move
    Seconds after{0.25};      // ... before another one
    Seconds smoothing{0.05};  // of the frequency
  };

  void prepare(const Options& options) {
    options_ = options;
    forget();
  }
  void forget() STILLCUT_RT;

  // One verdict. `moved`: a move of ours came before, and the spindle has settled since.
  void hear(const Verdict& verdict, Seconds dt, Hertz toothPass, bool moved) STILLCUT_RT;

  bool confirmed() const STILLCUT_RT { return confirmed_; }
  Hertz frequency() const STILLCUT_RT { return frequency_; }  // smoothed; 0: none
  double level() const STILLCUT_RT { return slow_; }          // severity, smoothed

 private:
  void follow(const Verdict& verdict, double dt, double toothPass) STILLCUT_RT;

  Options options_;
  Hertz frequency_{};
  double fraction_ = 0.0;  // of a tooth-passing frequency, -0.5 .. 0.5
  double standing_ = 0.0;  // [s] alarmed at one frequency
  double quiet_ = 0.0;     // [s] since the last alarm
  double fast_ = 0.0, slow_ = 0.0;
  bool confirmed_ = false;
};

}  // namespace stillcut::control
