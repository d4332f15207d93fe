// ChangeBudget: how often the machine has been moved. A change is a move that starts from rest or turns back; going on
// in the same direction is the same change, so that a target that becomes more exact on the way costs nothing.
// Used up: a cool-down; used up twice: Auto is withdrawn (the caller's doing). No hunting.
// Thread: worker. Real-time.
#pragma once

#include <algorithm>
#include <array>

#include "core/base/realtime.h"
#include "core/base/units.h"

namespace stillcut::safety {

class ChangeBudget {
 public:
  static constexpr int kMost = 120;  // changes per minute that can be allowed
  static constexpr double kWindow = 60.0;

  void prepare(int perMinute, Seconds coolDown) {
    perMinute_ = std::clamp(perMinute, 1, kMost);
    coolDown_ = coolDown.value;
    clear();
  }
  void clear() STILLCUT_RT {
    made_ = 0;
    clock_ = 0.0;
    coolUntil_ = 0.0;
    timesUsedUp_ = 0;
  }
  void advance(double dt) STILLCUT_RT { clock_ += dt; }

  // Asks for one change; true and counted when it is allowed.
  bool take() STILLCUT_RT {
    if (cooling()) return false;
    if (inLastMinute() >= perMinute_) {
      coolUntil_ = clock_ + coolDown_;
      ++timesUsedUp_;
      return false;
    }
    count();
    return true;
  }
  // A change that needs nobody's leave.
  void count() STILLCUT_RT {
    times_[static_cast<std::size_t>(made_ % kMost)] = clock_;
    ++made_;
  }
  bool cooling() const STILLCUT_RT { return clock_ < coolUntil_; }
  double coolDownLeft() const STILLCUT_RT { return std::max(0.0, coolUntil_ - clock_); }
  int timesUsedUp() const STILLCUT_RT { return timesUsedUp_; }
  int perMinute() const STILLCUT_RT { return perMinute_; }
  int inLastMinute() const STILLCUT_RT {
    int count = 0;
    for (long i = made_ - 1; i >= 0 && i >= made_ - kMost; --i) {
      if (clock_ - times_[static_cast<std::size_t>(i % kMost)] >= kWindow) break;
      ++count;
    }
    return count;
  }

 private:
  int perMinute_ = 1;
  double coolDown_ = 0.0;
  double clock_ = 0.0;
  double coolUntil_ = 0.0;
  long made_ = 0;
  int timesUsedUp_ = 0;
  std::array<double, kMost> times_{};
};

}  // namespace stillcut::safety
