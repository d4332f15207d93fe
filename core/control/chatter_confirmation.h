// ChatterConfirmation: whether an alarm is worth moving the spindle for: a detector answers within a few revolutions, a
// move costs a second and marks the part. What more is asked of the verdicts:
// resources/manual/developers/laws.md#chatter-confirmation. Thread: worker. Real-time.
#pragma once

#include "core/base/realtime.h"
#include "core/model/verdict.h"

namespace stillcut::control {

class ChatterConfirmation {
 public:
  struct Options {
    Seconds first{0.05};      // that an alarm lasts before the first move
    Seconds after{0.25};      // that an alarm lasts before another move
    Seconds smoothing{0.05};  // of the frequency
  };

  void configure(const Options& options) STILLCUT_RT { options_ = options; }
  // The present alarm. What was measured of the cut's level stays.
  void forget() STILLCUT_RT;
  void forgetLevels() STILLCUT_RT {
    usual_ = struck_ = loud_ = 0.0;
    believed_ = {};
  }

  struct Spindle {
    Hertz measured{};
    int teeth = 1;
    bool moved = false;  // by us, and it has settled since
  };
  // `vibration`: rms, any unit; negative: unknown.
  void update(const Verdict& verdict, Seconds dt, const Spindle& spindle, double vibration = -1.0) STILLCUT_RT;

  bool confirmed() const STILLCUT_RT { return confirmed_; }
  // Smoothed; 0: none. Of chatter that nobody tells: the one that was believed last.
  Hertz frequency() const STILLCUT_RT { return frequency_; }
  double level() const STILLCUT_RT { return slow_; }  // severity, smoothed

 private:
  void listen(const Verdict& verdict, double dt, bool moved, double vibration) STILLCUT_RT;
  void hearNone(const Verdict& verdict, double dt, const Spindle& spindle) STILLCUT_RT;
  void follow(const Verdict& verdict, double dt, const Spindle& spindle) STILLCUT_RT;

  Options options_;
  Hertz frequency_{};
  double fraction_ = 0.0;  // of a spindle frequency, -0.5 .. 0.5
  double standing_ = 0.0;  // [s] alarmed at one frequency
  double full_ = 0.0;      // [s] of full chatter, whatever its frequency
  double quiet_ = 0.0;     // [s] since the last alarm
  double untold_ = 0.0;    // [s] restless without an alarm
  double fast_ = 0.0, slow_ = 0.0;
  double usual_ = 0.0;   // vibration without an alarm, at the programmed speed
  double struck_ = 0.0;  // vibration when the first alarm was believed
  double loud_ = 0.0;    // vibration now
  Hertz believed_{};     // of the last alarm that was
  bool confirmed_ = false;
};

}  // namespace stillcut::control
