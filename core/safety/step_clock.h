// StepClock: how much time a step is worth. What must run out goes by the stream's time, what may move by the smaller
// of that and the measured time. Thread: worker. Real-time.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/realtime.h"
#include "core/base/time.h"

namespace stillcut::safety {

class StepClock {
 public:
  enum class Step {
    First,       // there is no time before it to measure from
    Good,        //
    Unmeasured,  // the measured time is no number of seconds: nothing may move
    Back,        // stream time stood still or went back
    Jump,        // past `longest`
  };

  void restart() STILLCUT_RT { started_ = false; }
  Step advance(Instant now, Seconds measured, Seconds longest) STILLCUT_RT {
    // In doubles: hostile stamps at the ends of the range must not overflow.
    passed_ = (static_cast<double>(toNs(now)) - static_cast<double>(toNs(last_))) * 1e-9;
    last_ = now;
    elapsed_ = moveTime_ = 0.0;
    if (!started_) {
      started_ = true;
      return step_ = Step::First;
    }
    if (!(passed_ > 0.0)) return step_ = Step::Back;
    if (passed_ > longest.value) return step_ = Step::Jump;
    elapsed_ = passed_;
    if (!std::isfinite(measured.value) || measured.value <= 0.0) return step_ = Step::Unmeasured;
    moveTime_ = std::min(elapsed_, measured.value);
    return step_ = Step::Good;
  }

  Step step() const STILLCUT_RT { return step_; }
  bool good() const STILLCUT_RT { return step_ == Step::Good; }
  Instant last() const STILLCUT_RT { return last_; }
  double passed() const STILLCUT_RT { return passed_; }      // [s] whatever it says
  double elapsed() const STILLCUT_RT { return elapsed_; }    // [s] for what must run out
  double moveTime() const STILLCUT_RT { return moveTime_; }  // [s] for what may move

 private:
  bool started_ = false;
  Step step_ = Step::First;
  Instant last_{};
  double passed_ = 0.0, elapsed_ = 0.0, moveTime_ = 0.0;
};

}  // namespace stillcut::safety
