// ChatterConfirmation: whether an alarm is worth moving the spindle for. A detector answers within a few revolutions; a
// move costs a second and marks the part, so a little more is asked of the verdicts first:
// - the frequency stands still as a fraction of the spindle frequency. Members f_c + k f_sp of one chatter share
//   that fraction, so a detector that changes between them is not held against it; a rattling sensor has none.
// - after a move of ours, what rings down or stands is not taken for chatter: full chatter must not be falling, and an
//   onset must grow. A line on a harmonic of the measured tooth passing is then the cut's own: the move has just put
//   one where the chatter was, and a detector whose comb still follows the old speed leaves it in the rest. On another
//   harmonic of the spindle only full chatter that is louder than what was struck at counts: it can lock there.
//   An alarm that neither grows nor falls is chatter all the same where the vibration is as loud as the chatter was and
//   several times what it was before: chatter that has grown to its end stands still. Full chatter that lasts louder
//   than what was struck at needs no standing frequency either: grown until the tool leaves the cut it may have two
//   lines, or none that stands, and a rattling sensor rattled before the move too.
// - chatter that goes on through a move may be taken for the cut's own by a detector that learns its floor anew, and is
//   no alarm then. Forced vibration repeats, though, however loud a resonance makes it: where the part that does not
//   repeat (severity) is for long louder than all the vibration of the cut that was stable, it is the old chatter.
// Thread: worker. Real-time.
#pragma once

#include "core/base/realtime.h"
#include "core/model/verdict.h"

namespace stillcut::control {

class ChatterConfirmation {
 public:
  struct Options {
    Seconds first{0.05};      // that an alarm lasts before the first move
    Seconds after{0.25};      // ... before another one
    Seconds smoothing{0.05};  // of the frequency
  };

  void configure(const Options& options) STILLCUT_RT { options_ = options; }
  // The alarm in hand. What was heard of the cut's level stays.
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
  double struck_ = 0.0;  // ... when the first alarm was believed
  double loud_ = 0.0;    // ... now
  Hertz believed_{};     // of the last alarm that was
  bool confirmed_ = false;
};

}  // namespace stillcut::control
