// InterventionJudge: what came of a move that was made for an alarm. One model, in this order:
//   begun     the overrides leave where they stood
//   arrived   they stand at what was asked for, and so does the spindle
//   helped    the alarm ended in time and stayed away
//   or not    it goes on, or the machine never arrived, or a fault ended the move, or the next move began
//   louder    the alarm goes on, and the cut vibrates more than it did before. Without an alarm it may: in the middle
//   of
//             a pocket the teeth beat on the mode, and a cut that is safe from chatter is there at its loudest
// Whoever lets go for another reason (operator, program, a tool that leaves the cut) ends it unjudged.
// Thread: worker. Real-time.
#pragma once

#include "core/base/realtime.h"
#include "core/model/event.h"
#include "core/safety/intervention_rules.h"
#include "core/safety/override_ramp.h"

namespace stillcut::safety {

using Outcome = MoveOutcome;

// One step, as the gate sees it.
struct InterventionStep {
  double dt = 0.0;          // [s]
  bool heard = false;       // a verdict that counts, of a tool in the cut
  bool alarming = false;    // ... and it alarms
  double vibration = -1.0;  // rms, any unit; negative: unknown
  bool arrived = false;
};

class InterventionJudge {
 public:
  void prepare(const InterventionRules& rules) {
    rules_ = rules;
    forget();
  }
  // A new grant is a new trust.
  void forget() STILLCUT_RT;
  // The vibration, and how long it has been quiet: each step, whatever is in force.
  void listen(const InterventionStep& step) STILLCUT_RT;

  // The overrides go from `before` to `after`. NotHelped: the move before this one had not. One that never arrived, or
  // has not been listened to, goes on, whatever it is after now, and one that creeps as well.
  Outcome begin(const Factors& before, const Factors& after) STILLCUT_RT;
  // The move goes on in its direction: it has not arrived.
  void goOn() STILLCUT_RT { standing_ = 0.0; }
  // One step of the move in hand. Anything but None ends it.
  Outcome judge(const InterventionStep& step) STILLCUT_RT;
  // A fault ended what is in force.
  Outcome fault() STILLCUT_RT;
  // Ended by somebody's hand or by the program.
  void leave() STILLCUT_RT { open_ = false; }

  bool open() const STILLCUT_RT { return open_; }
  // Whether an alarm is the reason of what is asked for now.
  bool alarmedLately() const STILLCUT_RT { return quiet_ < kAlarmGap; }
  int withoutHelp() const STILLCUT_RT { return withoutHelp_; }
  bool usedUp() const STILLCUT_RT { return withoutHelp_ >= rules_.most; }
  int most() const STILLCUT_RT { return rules_.most; }
  const Factors& before() const STILLCUT_RT { return before_; }
  // Vibration now over that before the move; 0: unknown.
  double timesAsLoud() const STILLCUT_RT { return levelBefore_ > 0.0 ? level_ / levelBefore_ : 0.0; }
  bool louder() const STILLCUT_RT { return timesAsLoud() > rules_.louder; }
  // A move is in hand, and the machine on its way.
  bool underWay() const STILLCUT_RT { return open_ && standing_ <= 0.0; }

 private:
  bool creeps(const Factors& from, const Factors& to) const STILLCUT_RT;

  static constexpr double kAlarmGap = 0.25;  // [s] shorter pauses are the same alarm
  static constexpr double kLevelTime = 0.1;  // [s] time constant of the level

  Outcome end(Outcome outcome) STILLCUT_RT;

  InterventionRules rules_;
  bool open_ = false;
  Factors before_;
  double levelBefore_ = 0.0;
  double since_ = 0.0;                  // [s] since it began
  double standing_ = 0.0;               // [s] where it was moved to; 0: has not arrived
  double level_ = 0.0, loudest_ = 0.0;  // now; and since the alarm began
  double quiet_ = 1e9;                  // [s] heard without an alarm
  int withoutHelp_ = 0;
};

}  // namespace stillcut::safety
